// Phase: the resources that passes write, and what each of their inputs reads.
#include <fmt/format.h>

#include <algorithm>

#include "graph/compiler/image_size.h"
#include "graph/compiler/phases.h"

namespace nephrite::graph {
namespace {

/// No device has more memory than this for one image; it keeps all sums in 64 bits.
constexpr double maxImageBytes = 1099511627776.0;  // 2^40
/// Vulkan's maxStorageBufferRange is a 32-bit number.
constexpr std::uint64_t maxBufferBytes = 4294967295;

class ResourceMaker {
  public:
    ResourceMaker(Compilation& work, const PlannedPass& pass)
        : work_(work), pass_(pass), onlyCleared_(work.plan.nodes[pass.node].state != NodeState::Run) {}

    /// The index of the port's new resource.
    Index make(Index port) {
        const OutputPort& output = work_.typeOf(pass_.node).outputs[port];
        Resource resource;
        resource.node = pass_.node;
        resource.port = port;
        resource.isBuffer = !output.bufferElement.empty();
        resource.format = work_.graph.formats[work_.portIndex(pass_.node, port)];
        resource.extent = work_.extents[work_.portIndex(pass_.node, port)];
        if (resource.isBuffer) {
            // Vulkan has no empty buffers: one without elements is given room for one, which nothing writes.
            resource.extent.width = std::max(resource.extent.width, 1U);
            measureBuffer(resource, output);
        } else {
            shapeImage(resource, output);
        }
        work_.plan.resources.push_back(resource);
        return static_cast<Index>(work_.plan.resources.size() - 1);
    }

  private:
    void measureBuffer(Resource& resource, const OutputPort& output) {
        const std::uint64_t stride = bufferElementBytes(output.bufferElement).value();
        resource.bytes = resource.extent.width * stride;
        if (resource.bytes <= maxBufferBytes) return;
        fault(whereOf(output.bufferCount, output), resource,
              fmt::format("a buffer of {} bytes, expected at most {}", resource.bytes, maxBufferBytes));
    }

    void shapeImage(Resource& resource, const OutputPort& output) {
        const FormatInfo& format = info(resource.format);
        if (work_.typeOf(pass_.node).kind == PassKind::Raster && resource.extent != pass_.extent) {
            fault(
                output.where, resource,
                fmt::format(
                    "size {} x {}, expected {} x {} like the first output: a raster pass draws all its "
                    "outputs at once",
                    resource.extent.width, resource.extent.height, pass_.extent.width, pass_.extent.height));
        }
        const std::uint32_t fullChain = fullMipCount(resource.extent);
        const std::uint32_t mips = number(resource, output, output.mips, "mip levels", 0, 32);
        resource.mips = mips == 0 ? fullChain : std::min(mips, fullChain);
        resource.layersPerIteration =
            number(resource, output, output.layers, "layers", 1, work_.request.maxLayers);
        resource.layers = allLayers(resource, output);
        const double bytes =
            imageBytes(resource.extent, resource.mips, resource.layers, format.bytesPerPixel);
        if (bytes > maxImageBytes) {
            fault(output.where, resource,
                  fmt::format("an image of {} bytes, expected at most {}", bytes, maxImageBytes));
        } else {
            resource.bytes = static_cast<std::uint64_t>(bytes);
        }
    }

    std::uint32_t allLayers(const Resource& resource, const OutputPort& output) {
        const std::uint64_t layers =
            std::uint64_t{resource.layersPerIteration} * std::max(pass_.iterations, 1U);
        if (layers <= work_.request.maxLayers) return static_cast<std::uint32_t>(layers);
        fault(whereOf(output.layers, output), resource,
              fmt::format("{} light views of {} layers each make {} layers, expected at most {}",
                          pass_.iterations, resource.layersPerIteration, layers, work_.request.maxLayers));
        return 1;
    }

    /// The value of `expression` if it lies in the range. A pass that is only cleared takes the
    /// nearest in range.
    std::uint32_t number(const Resource& resource, const OutputPort& output, const Expression& expression,
                         std::string_view what, std::uint32_t least, std::uint32_t most) {
        const double value = work_.values.countAt(pass_.node, expression);
        if (value >= least && value <= most) return static_cast<std::uint32_t>(value);
        if (onlyCleared_) return value > most ? most : std::max(least, 1U);
        fault(whereOf(expression, output), resource,
              fmt::format("{} {}, expected {} to {}", value, what, least, most));
        return 1;
    }

    void fault(const SourceLocation& where, const Resource& resource, const std::string& what) {
        work_.faults.error(where,
                           fmt::format("{}: {}", work_.graph.portName(resource.node, resource.port), what));
    }

    Compilation& work_;
    const PlannedPass& pass_;
    bool onlyCleared_;
};

void makeOutputs(Compilation& work, PlannedPass& pass) {
    const Index count = work.graph.nodes[pass.node].formats.count;
    pass.outputs = {static_cast<Index>(work.plan.outputs.size()), count};
    pass.extent = count > 0 ? work.extents[work.portIndex(pass.node, 0)] : work.request.view;
    ResourceMaker maker(work, pass);
    for (Index port = 0; port < count; ++port) {
        const Index resource = maker.make(port);
        work.plan.outputs.push_back(resource);
        work.resources[work.portIndex(pass.node, port)] = resource;
    }
}

/// What an unread input reads as: its source's neutral value if the source is switched off, else its own.
std::array<double, 4> neutralOf(const Compilation& work, Index node, Index port) {
    const Index input = work.graph.nodes[node].inputs.first + port;
    const LinkedInput& source = work.graph.inputs[input];
    if (source.sourceNode != noIndex && work.inputIsNeutral[input]) {
        return work.typeOf(source.sourceNode).outputs[source.sourcePort].neutral;
    }
    return work.typeOf(node).inputs[port].neutral;
}

InputRead readOf(const Compilation& work, Index node, Index port) {
    const Index input = work.graph.nodes[node].inputs.first + port;
    const LinkedInput& source = work.graph.inputs[input];
    InputRead read;
    read.neutral = neutralOf(work, node, port);
    read.extent = work.request.view;
    if (source.sourceNode == noIndex) return read;
    const Index sourceIndex = work.portIndex(source.sourceNode, source.sourcePort);
    read.extent = work.extents[sourceIndex];
    if (work.inputIsRead[input]) read.resource = work.resources[sourceIndex];
    read.perIteration =
        work.description(node).forEachLight && work.description(source.sourceNode).forEachLight;
    return read;
}

void connectInputs(Compilation& work, PlannedPass& pass) {
    const Index count = work.graph.nodes[pass.node].inputs.count;
    pass.inputs = {static_cast<Index>(work.plan.inputs.size()), count};
    for (Index port = 0; port < count; ++port) work.plan.inputs.push_back(readOf(work, pass.node, port));
}

}  // namespace

void resolvePorts(Compilation& work) {
    for (PlannedPass& pass : work.plan.passes) makeOutputs(work, pass);
    for (PlannedPass& pass : work.plan.passes) connectInputs(work, pass);
    for (Index i = 0; i < work.requested.size(); ++i) {
        const LinkedOutput& output = work.requested[i];
        const Index resource = work.resources[work.portIndex(output.node, output.port)];
        work.plan.requested[i].resource = resource;
        if (resource != noIndex) work.plan.resources[resource].requested = true;
    }
}

}  // namespace nephrite::graph
