// What to do in a frame, and why: passes in execution order, the resources they use, the barriers between
// them. Plain data without Vulkan; runtime/ turns it into command buffers. All indices are 32 bit.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "graph/linked_graph.h"

namespace nephrite::graph {

struct Extent {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    friend bool operator==(const Extent&, const Extent&) = default;
};

/// Why a pass touches a resource. Each use has one pipeline stage, access and layout.
enum class Use : std::uint8_t {
    None,         ///< before its first use in a frame: contents undefined
    ComputeRead,  ///< read by a pixel or compute pass
    ComputeWrite,
    RasterRead,       ///< read by a raster pass's shader
    ColorAttachment,  ///< written by a raster pass
    DepthAttachment,
    Clear,  ///< cleared to its neutral value
    Copy,   ///< copied out (a requested output or dump)
};

enum class Layout : std::uint8_t {
    Undefined,
    General,
    ShaderRead,
    ColorAttachment,
    DepthAttachment,
    TransferSource,
    TransferDestination
};

/// How shaders read images on the device at hand; decides the layout of reads (runtime/ asks gpu/).
enum class InputReads : std::uint8_t { StorageImage, SampledImage };

enum class NodeState : std::uint8_t { Run, Culled, Skipped };

/// An image or a buffer: one for each output port of a node that is used.
struct Resource {
    Index node = noIndex;
    Index port = noIndex;
    bool isBuffer = false;
    Format format = Format::rgba16f;
    Extent extent;  ///< of level 0; a buffer: element count in width, height 1
    std::uint32_t mips = 1;
    std::uint32_t layers = 1;  ///< all iterations together
    std::uint32_t layersPerIteration = 1;
    std::uint64_t bytes = 0;  ///< tightly packed size of all levels and layers
    std::uint32_t uses = 0;   ///< bit (1 << Use) for each use of the frame
    Index first = noIndex;    ///< first and last pass that uses it: inclusive indices into Plan::passes
    Index last = noIndex;
    bool requested = false;  ///< an output of the graph or a dump: copied out after the last pass
};

/// What an input of a running pass reads: a resource, or a constant where it is unconnected or its source was
/// skipped.
struct InputRead {
    Index resource = noIndex;
    std::array<double, 4> neutral{0, 0, 0, 0};
    Extent extent;  ///< what extent(PORT) says
    bool perIteration =
        false;  ///< source and reader both run for each light: load() reads the iteration's own layers
};

struct PlannedPass {
    Index node = noIndex;
    /// Light views for a forEach node, else 1. 0: its outputs are only cleared to neutral and it reads
    /// nothing (a skipped node whose output is requested, or a node that needs a light view where there is
    /// none).
    std::uint32_t iterations = 1;
    ViewKind view = ViewKind::Camera;
    Extent extent;     ///< of its first output: the dispatch or render area
    Range inputs;      ///< in Plan::inputs, in the type's order
    Range outputs;     ///< in Plan::outputs, in the type's order: index into resources
    Range parameters;  ///< in Plan::parameters, in the type's order
    Range barriers;    ///< in Plan::barriers: the batch before it
};

/// One memory barrier and layout transition, recorded in the batch before a pass.
struct Barrier {
    Index resource = noIndex;
    std::uint32_t baseMip = 0, mips = 1;
    std::uint32_t baseLayer = 0, layers = 1;
    std::uint32_t usesBefore = 0;  ///< bits (1 << Use) whose stages must be done; 0: nothing before it
    std::uint32_t usesAfter = 0;   ///< bits (1 << Use) whose stages wait
    bool writeBefore = false;      ///< what came before wrote (memory to make available), else it is only an
                                   ///< execution dependency
    Layout oldLayout = Layout::Undefined;
    Layout newLayout = Layout::General;
};

/// Why a node runs or not; whyOf() puts it into words.
enum class Reason : std::uint8_t {
    // Run
    Requested,  ///< a requested output; `other` indexes Plan::requested
    SideEffect,
    ReadByPass,  ///< `other`, which runs, reads it
    // Skipped
    WhenIsFalse,
    SkipWhenHolds,
    NoReaderNeedsIt,  ///< its running readers' neededWhen is false; `other` is one of them
    // Culled
    NothingReadsIt,
    ReadersDoNotRun,  ///< only nodes that do not run read it; `other` is one of them
};

struct NodeDecision {
    NodeState state = NodeState::Run;
    Reason reason = Reason::NothingReadsIt;
    Index other = noIndex;
};

/// A requested port and the resource that holds it.
struct RequestedOutput {
    std::string name;  ///< an output's name, or NODE.PORT for a dump
    Index resource = noIndex;
};

struct Plan {
    std::shared_ptr<const LinkedGraph> graph;
    Extent view;
    std::uint32_t lightViews = 0;
    InputReads inputReads = InputReads::StorageImage;
    std::vector<PlannedPass> passes;  ///< in execution order; every one runs
    std::vector<Resource> resources;
    std::vector<InputRead> inputs;
    std::vector<Index> outputs;
    std::vector<ParameterValue> parameters;
    std::vector<Barrier> barriers;    ///< of all batches; the last batch is finalBarriers
    Range finalBarriers;              ///< before requested outputs are copied out
    std::vector<NodeDecision> nodes;  ///< one for each node of the graph
    std::vector<RequestedOutput> requested;

    std::uint32_t barrierBatches = 0;
    std::uint32_t naiveBarriers = 0;  ///< one for each use of each resource by each pass
    std::uint64_t naiveBytes = 0;     ///< every resource in memory of its own
    std::uint64_t peakLiveBytes = 0;

    const PassType& typeOf(const PlannedPass& pass) const { return *graph->nodes[pass.node].type; }
    const std::string& nameOf(const PlannedPass& pass) const { return graph->nodeName(pass.node); }
    std::string nameOf(const Resource& resource) const {
        return graph->portName(resource.node, resource.port);
    }
};

/// The layout an image is in while it is used so.
Layout layoutOf(Use use, InputReads reads, Format format);
bool writes(Use use);
constexpr std::uint32_t bit(Use use) {
    return 1U << static_cast<std::uint32_t>(use);
}

/// Why a node runs, is skipped or is culled, as a phrase: `"dipole" reads it`.
std::string whyOf(const Plan& plan, Index node);

std::string_view name(NodeState state);  ///< "run", "culled", "skipped": the words of the JSON contract
std::string_view name(Use use);          ///< "compute read"
std::string_view name(Layout layout);    ///< "shader read"

}  // namespace nephrite::graph
