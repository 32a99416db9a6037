// What to do in a frame, and why: passes in execution order, the resources they use, the barriers between
// them. Plain data without Vulkan; runtime/ turns it into command buffers. All indices are 32 bit.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "graph/linked_graph.h"
#include "graph/use.h"

namespace nephrite::graph {

struct Extent {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    friend bool operator==(const Extent&, const Extent&) = default;
};

enum class NodeState : std::uint8_t { Run, Culled, Skipped };

enum class ResourceKind : std::uint8_t {
    Transient,  ///< lives within a frame, shares the heap's memory with others
    Kept,       ///< memory of its own; its contents outlast the frame, so that its pass need not run again
    History,    ///< one image of a ring; this frame's, or that of `framesBack` frames ago
    Imported,   ///< comes from outside
};

/// Levels and layers of an image. A buffer is one level and one layer.
struct Subresources {
    std::uint32_t baseMip = 0, mips = 1;
    std::uint32_t baseLayer = 0, layers = 1;
    friend bool operator==(const Subresources&, const Subresources&) = default;
};

/// An image or a buffer. Output ports that modify an input share that input's.
struct Resource {
    Index node = noIndex;  ///< and port: whose output it is; the first writer's, if others modify it
    Index port = noIndex;
    std::uint64_t bytes = 0;          ///< as CompileRequest::memory says, else tightly packed
    std::uint64_t offset = noOffset;  ///< in the heap; noOffset for what is not Transient
    Extent extent;                    ///< of level 0; a buffer: element count in width, height 1
    std::uint32_t mips = 1;
    std::uint32_t layers = 1;  ///< all iterations together
    std::uint32_t layersPerIteration = 1;
    std::uint32_t uses = 0;  ///< bit (1 << Use) for each use of the frame
    Index first = noIndex;   ///< first and last pass that uses it: inclusive indices into Plan::passes
    Index last = noIndex;
    std::uint16_t framesBack = 0;
    ResourceKind kind = ResourceKind::Transient;
    bool isBuffer = false;
    Format format = Format::rgba16f;
    bool requested = false;  ///< an output of the graph or a dump: copied out after the last pass, from its
                             ///< `final` layout or, where that does not matter, as a transfer source
    bool bySubresource = false;          ///< some pass uses only some of its levels or layers
    Layout initial = Layout::Undefined;  ///< when the frame starts; Undefined: contents do not matter
    Layout final = Layout::Undefined;    ///< when it ends; Undefined: does not matter

    std::uint32_t importedUses = 0;  ///< bits (1 << Use) that may be under way when the frame starts
    Index memoryUsedUntil =
        noIndex;  ///< the last pass that used its bytes for another resource; noIndex: none
    std::uint32_t memoryUsesBefore = 0;  ///< bits (1 << Use) of what they were used for

    static constexpr std::uint64_t noOffset = ~std::uint64_t{0};
    Subresources whole() const { return {0, mips, 0, layers}; }
};

/// What an input of a running pass reads: a resource, or a constant where it is unconnected or its source was
/// skipped.
struct InputRead {
    Index resource = noIndex;
    Extent extent;                ///< what extent(PORT) says
    std::uint16_t mip = every;    ///< the one level it shows
    std::uint16_t layer = every;  ///< the one array layer it shows
    bool perIteration =
        false;  ///< source and reader both run for each light: load() reads the iteration's own layers
    bool modified = false;  ///< an output of the same pass writes it in place
};

struct PlannedPass {
    Index node = noIndex;
    /// Runs of its shader: light views, mip levels, else 1. 0: its outputs are only cleared to neutral and it
    /// reads nothing (a skipped node whose output is requested, or a node that needs a light view where there
    /// is none).
    std::uint32_t iterations = 1;
    Extent extent;                ///< of its first output: the dispatch or render area
    Range inputs;                 ///< in Plan::inputs, in the type's order
    Range outputs;                ///< in Plan::outputs, in the type's order: index into resources
    Index firstBatch = 0;         ///< in Plan::batches: before its first iteration
    Index tileList = noIndex;     ///< the resource (a buffer) that lists the tiles to compute; noIndex: all
    Index placedAfter = noIndex;  ///< the pass that kept it from standing earlier
    ViewKind view = ViewKind::Camera;
    ForEach forEach = ForEach::Nothing;

    /// Some outputs are cleared to neutral first, between two batches of their own (isCleared): those of a
    /// pass over tiles, and those that modify an input without a source in a shader that reads what it
    /// writes.
    bool clearsFirst = false;
    bool isRaster = false;
    bool readsConstants = false;  ///< some input has no resource
    /// It writes every output whole, once, and reads no tile list: nothing of what follows needs a closer
    /// look.
    bool isPlain = false;

    /// Batch points: before the clears, if any; then one before each iteration over mips, else one before all
    /// iterations.
    Index batchCount() const {
        return (clearsFirst ? 1 : 0) + (forEach == ForEach::Mips && iterations > 0 ? iterations : 1);
    }
};

/// Width and height in texels of the tiles of a domain.
inline constexpr std::uint32_t tileSide = 8;

/// One memory barrier and layout transition of a batch.
struct Barrier {
    Index resource = noIndex;
    Subresources range;
    std::uint32_t usesBefore = 0;  ///< bits (1 << Use) whose stages must be done; 0: nothing before it
    std::uint32_t usesAfter = 0;   ///< bits (1 << Use) whose stages wait
    Index passBefore = noIndex;    ///< the last pass it waits for; noIndex: none of this frame
    Index passAfter = noIndex;     ///< the first pass that waits for it; passes.size(): the copies out
    Layout oldLayout = Layout::Undefined;
    Layout newLayout = Layout::General;
    bool writeBefore = false;  ///< what came before wrote (memory to make available), else it is only an
                               ///< execution dependency
    bool aliases = false;      ///< what came before used other resources in the same memory
};

/// The barriers of one frame. `before[i]` is recorded before batch point i (PlannedPass::firstBatch and the
/// iterations after it); the last one comes after all passes, before requested outputs are copied out.
struct BarrierSchedule {
    std::vector<Barrier> barriers;
    std::vector<Range> batches;    ///< in `barriers`
    std::uint32_t batchCount = 0;  ///< that are not empty
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
    std::string name;  ///< an output's name, or a dump as it was written
    Index resource = noIndex;
    std::uint16_t mip = every;    ///< the one level wanted
    std::uint16_t layer = every;  ///< the one array layer wanted
};

/// How passes are ordered and placed in memory where dependencies leave a choice.
enum class Policy : std::uint8_t {
    Barriers,  ///< a barrier batch for each link of the longest chain of dependent passes, and few more
    Memory,    ///< as small a heap as can be found in reasonable time
};

/// What a policy costs and gains.
struct PolicyFigures {
    Policy policy = Policy::Barriers;
    std::uint32_t barrierBatches = 0;
    std::uint64_t heapBytes = 0;
};

/// Passes of which each layer of skipping leaves out something (docs/architecture.md).
struct SkipCounts {
    std::uint32_t notNeeded = 0;    ///< layer 1: nodes no requested output needs
    std::uint32_t neutral = 0;      ///< layer 2: nodes whose outputs are constants, or that nobody needs now
    std::uint32_t keepable = 0;     ///< layer 3: passes whose results outlast the frame
    std::uint32_t tiled = 0;        ///< layer 4: passes that compute only the tiles of their domain
    std::uint32_t specialized = 0;  ///< layer 5: passes compiled without an input or for a constant parameter
};

struct Plan {
    std::shared_ptr<const LinkedGraph> graph;
    Extent view;
    std::uint32_t lightViews = 0;
    InputReads inputReads = InputReads::StorageImage;
    Policy policy = Policy::Barriers;
    std::vector<PlannedPass> passes;  ///< in execution order; every one runs
    std::vector<Resource> resources;
    std::vector<InputRead> inputs;
    std::vector<Index> outputs;
    std::vector<Index> tileLists;     ///< resources of TileList nodes that run
    BarrierSchedule schedule;         ///< when every pass runs
    std::vector<NodeDecision> nodes;  ///< one for each node of the graph
    std::vector<RequestedOutput> requested;
    SkipCounts skips;
    std::optional<PolicyFigures> otherPolicy;  ///< for comparison, where somebody compiled for both

    std::uint32_t naiveBarriers = 0;  ///< one for each use of each resource by each pass
    std::uint64_t heapBytes = 0;      ///< of the memory that Transient resources share
    std::uint64_t naiveBytes = 0;     ///< every resource in memory of its own
    std::uint64_t peakLiveBytes = 0;  ///< of Transient resources, the most alive at once
    std::uint32_t heapUses = 0;       ///< bits (1 << Use) of all Transient resources

    PolicyFigures figures() const { return {policy, schedule.batchCount, heapBytes}; }
    const PassType& typeOf(const PlannedPass& pass) const { return *graph->nodes[pass.node].type; }
    const std::string& nameOf(const PlannedPass& pass) const { return graph->nodeName(pass.node); }
    /// "gbuffer.position", "previous(taa.color)", "import(table)".
    std::string nameOf(const Resource& resource) const;
};

/// What a pass's input reads as where InputRead::resource is noIndex: the neutral value of its skipped
/// source, else its own.
std::array<double, 4> neutralOf(const Plan& plan, const PlannedPass& pass, Index port);

/// True if the pass clears the output to its neutral value: instead of running, or before (clearsFirst).
bool isCleared(const Plan& plan, const PlannedPass& pass, Index port);

/// True if what the pass writes, as far as anybody reads it, outlasts the frame: the pass need not run while
/// nothing it reads changes.
bool keepsResults(const Plan& plan, const PlannedPass& pass);

/// The barriers of a frame in which only some passes run (by index into Plan::passes, 1: runs; empty: all).
/// What a pass that does not run would write must be Kept, and holds its contents since an earlier frame.
BarrierSchedule scheduleBarriers(const Plan& plan, std::span<const std::uint8_t> runs);

/// Why a node runs, is skipped or is culled, as a phrase: `"dipole" reads it`.
std::string whyOf(const Plan& plan, Index node);

std::string_view name(Policy policy);    ///< "barriers", "memory": as on the command line
std::string_view name(NodeState state);  ///< "run", "culled", "skipped": the words of the JSON contract

}  // namespace nephrite::graph
