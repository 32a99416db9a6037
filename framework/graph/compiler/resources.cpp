// Phase: the resources that nodes write, numbered in execution order so that what passes use lies together in
// memory, and the images that come from outside.
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

/// Makes the resources of one node that runs, or whose outputs are only cleared.
class ResourceMaker {
  public:
    ResourceMaker(Compilation& work, Index node) : work_(work), node_(node), onlyCleared_(!work.runs(node)) {}

    void makeAll() {
        const Range ports = work_.graph.nodes[node_].formats;
        for (Index port = 0; port < ports.count; ++port) {
            const Index shared = modifiedResource(ports.first + port);
            work_.resources[ports.first + port] = shared == noIndex ? make(port) : shared;
        }
        if (work_.graph.nodes[node_].forEach == ForEach::Mips && work_.iterations[node_] > 0 &&
            ports.count > 0)
            iterateOverMips(ports);
    }

    /// Its domain may be an earlier frame's, of a node that comes later.
    void measureTileList() {
        const LinkedNode& linked = work_.graph.nodes[node_];
        Resource& resource = work_.plan.resources[work_.resources[linked.formats.first]];
        resource.extent.width = tileListLength(linked);
        measureBuffer(resource, linked.type->outputs.front());
    }

  private:
    void iterateOverMips(Range ports) {
        const std::uint32_t mips = work_.plan.resources[work_.resources[ports.first]].mips;
        work_.iterations[node_] = mips;
        for (Index port = 0; port < ports.count; ++port) {
            const Resource& resource = work_.plan.resources[work_.resources[ports.first + port]];
            const SourceLocation& where = work_.typeOf(node_).outputs[port].where;
            if (resource.mips != mips)
                fault(where, resource,
                      fmt::format(
                          "{} mip levels, expected {} like the first output: the pass runs once a level",
                          resource.mips, mips));
            const Index modified = work_.graph.modifies[ports.first + port];
            if (modified != noIndex && work_.graph.inputs[modified].mip != every)
                fault(where, resource, "one level is to be modified by a pass that runs once a level");
        }
    }

    /// The resource that the port's node writes in place, or noIndex.
    Index modifiedResource(Index port) const {
        const Index input = work_.modifiedBy(port);
        if (input == noIndex || onlyCleared_ || !work_.inputIsRead[input]) return noIndex;
        return work_.resources[work_.contentsOf(work_.graph.inputs[input])];
    }

    Index make(Index port) {
        const LinkedNode& linked = work_.graph.nodes[node_];
        const Index flat = linked.formats.first + port;
        const PortShape& shape = work_.graph.shapes[flat];
        Resource& resource = work_.plan.resources.emplace_back();
        resource.node = node_;
        resource.port = port;
        resource.format = work_.graph.formats[flat];
        resource.extent = work_.extents[flat];
        resource.isBuffer = shape.isBuffer;
        if (linked.role == NodeRole::Import) {
            importImage(resource);
        } else if (resource.isBuffer) {
            // Vulkan has no empty buffers: one without elements is given room for one, which nothing writes.
            resource.extent.width = std::max(resource.extent.width, 1U);
            measureBuffer(resource, linked.type->outputs[port]);
        } else {
            if (linked.isRaster) checkRasterExtent(resource, linked.type->outputs[port]);
            countParts(resource, shape);
            measureImage(resource);
        }
        return static_cast<Index>(work_.plan.resources.size() - 1);
    }

    void importImage(Resource& resource) {
        const Index import = work_.graph.nodes[node_].import;
        if (import >= work_.request.imports.size()) {
            work_.faults.error(work_.graph.description.imports[import].where,
                               fmt::format("no image is given for {}", work_.graph.nodeName(node_)));
            return;
        }
        const ImportedImage& image = work_.request.imports[import];
        resource.kind = ResourceKind::Imported;
        resource.mips = image.mips;
        resource.layers = resource.layersPerIteration = image.layers;
        resource.initial = image.initial;
        resource.final = image.final;
        resource.importedUses = image.usesBefore;
        resource.bytes = static_cast<std::uint64_t>(
            std::min(imageBytes(image.extent, image.mips, image.layers, info(resource.format).bytesPerPixel),
                     maxImageBytes));
    }

    /// Elements of a tile list: for each layer of the domain four words of dispatch arguments, then for each
    /// layer room for every tile.
    std::uint32_t tileListLength(const LinkedNode& linked) const {
        const LinkedInput& input = work_.graph.inputs[linked.inputs.first];
        const Index port = work_.contentsOf(input);
        const Index domain = port == noIndex ? noIndex : work_.resources[port];
        if (domain == noIndex) return 1;
        const Extent extent = input.mip == every
                                  ? work_.plan.resources[domain].extent
                                  : levelExtent(work_.plan.resources[domain].extent, input.mip);
        const std::uint32_t layers = input.layer == every ? work_.plan.resources[domain].layers : 1;
        return layers * (4 + tileCount(extent));
    }

    void measureBuffer(Resource& resource, const OutputPort& output) {
        const std::uint64_t stride = bufferElementBytes(output.bufferElement).value();
        resource.bytes = resource.extent.width * stride;
        if (resource.bytes <= maxBufferBytes) return;
        fault(whereOf(output.bufferCount, output), resource,
              fmt::format("a buffer of {} bytes, expected at most {}", resource.bytes, maxBufferBytes));
    }

    /// The port whose manifest says how many levels and layers there are.
    struct Declaration {
        Index node = noIndex;
        const OutputPort* port = nullptr;
    };

    /// Its own, or that of what it modifies, which may be switched off: the image has the same parts without
    /// it.
    Declaration declarationOf(Index port) const {
        Declaration declaration{node_, &work_.typeOf(node_).outputs[port]};
        Index modified = work_.graph.modifies[work_.portIndex(node_, port)];
        while (modified != noIndex && work_.graph.inputs[modified].sourceNode != noIndex) {
            const LinkedInput& source = work_.graph.inputs[modified];
            declaration = {source.sourceNode, &work_.typeOf(source.sourceNode).outputs[source.sourcePort]};
            modified = work_.graph.modifies[work_.portIndex(source.sourceNode, source.sourcePort)];
        }
        return declaration;
    }

    /// Most images have one level and one layer, and their manifest need not be looked at.
    void countParts(Resource& resource, const PortShape& shape) {
        const bool overLights = work_.graph.nodes[node_].forEach == ForEach::Lights;
        if (shape.mips == 1 && shape.layers == 1 && !overLights) return;
        const Declaration declaration = declarationOf(resource.port);
        const OutputPort& output = *declaration.port;
        if (shape.mips != 1) {
            const std::uint32_t fullChain = fullMipCount(resource.extent);
            const std::uint32_t mips = number(resource, declaration, output.mips, "mip levels", 0, 32);
            resource.mips = mips == 0 ? fullChain : std::min(mips, fullChain);
        }
        if (shape.layers != 1)
            resource.layersPerIteration =
                number(resource, declaration, output.layers, "layers", 1, work_.request.maxLayers);
        resource.layers = allLayers(resource, declaration);
    }

    void measureImage(Resource& resource) {
        const double bytes =
            imageBytes(resource.extent, resource.mips, resource.layers, info(resource.format).bytesPerPixel);
        if (bytes > maxImageBytes) {
            fault(declarationOf(resource.port).port->where, resource,
                  fmt::format("an image of {} bytes, expected at most {}", bytes, maxImageBytes));
        } else {
            resource.bytes = static_cast<std::uint64_t>(bytes);
        }
    }

    void checkRasterExtent(const Resource& resource, const OutputPort& output) {
        const Extent first = work_.extents[work_.portIndex(node_, 0)];
        if (resource.extent == first) return;
        fault(output.where, resource,
              fmt::format("size {} x {}, expected {} x {} like the first output: a raster pass draws all its "
                          "outputs at once",
                          resource.extent.width, resource.extent.height, first.width, first.height));
    }

    /// Also of a node that is switched off: a layer that is asked for is there, and neutral.
    std::uint32_t lightViews(Index node) const {
        const bool overLights = work_.graph.nodes[node].forEach == ForEach::Lights;
        return overLights ? std::max(work_.request.facts.lightViews, 1U) : 1;
    }

    std::uint32_t allLayers(const Resource& resource, const Declaration& declaration) {
        const std::uint32_t views = lightViews(declaration.node);
        const std::uint64_t layers = std::uint64_t{resource.layersPerIteration} * views;
        if (layers <= work_.request.maxLayers) return static_cast<std::uint32_t>(layers);
        fault(whereOf(declaration.port->layers, *declaration.port), resource,
              fmt::format("{} light views of {} layers each make {} layers, expected at most {}", views,
                          resource.layersPerIteration, layers, work_.request.maxLayers));
        return 1;
    }

    /// The value of `expression` if it lies in the range. A pass that is only cleared takes the
    /// nearest in range.
    std::uint32_t number(const Resource& resource, const Declaration& declaration,
                         const Expression& expression, std::string_view what, std::uint32_t least,
                         std::uint32_t most) {
        const double value = work_.values.countAt(declaration.node, expression);
        if (value >= least && value <= most) return static_cast<std::uint32_t>(value);
        if (!work_.runs(declaration.node)) return value > most ? most : std::max(least, 1U);
        fault(whereOf(expression, *declaration.port), resource,
              fmt::format("{} {}, expected {} to {}", value, what, least, most));
        return 1;
    }

    void fault(const SourceLocation& where, const Resource& resource, const std::string& what) {
        work_.faults.error(where,
                           fmt::format("{}: {}", work_.graph.portName(resource.node, resource.port), what));
    }

    Compilation& work_;
    Index node_;
    bool onlyCleared_;
};

/// The resources of frames ago that running nodes read, one for each frame back to the oldest.
class HistoryMaker {
  public:
    explicit HistoryMaker(Compilation& work) : work_(work) {}

    void makeAll() {
        for (Index node = 0; node < work_.graph.nodes.size(); ++node) {
            if (!work_.runs(node)) continue;
            const Range inputs = work_.graph.nodes[node].inputs;
            for (Index i = inputs.first; i < inputs.first + inputs.count; ++i) {
                if (work_.inputIsRead[i]) require(work_.graph.inputs[i]);
            }
        }
        for (const LinkedOutput* output : work_.requested)
            require({output->node, output->port, output->framesBack});
    }

  private:
    void require(const LinkedInput& input) {
        if (input.framesBack == 0) return;
        const Index port = work_.contentsOf(input);
        Index current = port == noIndex ? noIndex : work_.resources[port];
        if (current == noIndex || !work_.runs(work_.plan.resources[current].node)) return;
        work_.older.resize(work_.plan.resources.size(), noIndex);
        work_.plan.resources[current].kind = ResourceKind::History;
        for (std::uint16_t back = 1; back <= input.framesBack; ++back) {
            if (work_.older[current] == noIndex) {
                work_.older[current] = makeOlder(current, back);
                work_.older.push_back(noIndex);
            }
            current = work_.older[current];
        }
    }

    Index makeOlder(Index newer, std::uint16_t framesBack) {
        Resource resource = work_.plan.resources[newer];
        resource.framesBack = framesBack;
        resource.requested = false;
        work_.plan.resources.push_back(resource);
        return static_cast<Index>(work_.plan.resources.size() - 1);
    }

    Compilation& work_;
};

/// The one level or layer that is wanted must be there.
void checkParts(Compilation& work, const LinkedOutput& output, const Resource& resource) {
    const auto check = [&](std::uint16_t index, std::uint32_t count, std::string_view what) {
        if (index == every || index < count) return;
        work.faults.error(output.where,
                          fmt::format("{} has {} {}{}, found {} (the first is 0)", work.plan.nameOf(resource),
                                      count, what, count == 1 ? "" : "s", index));
    };
    check(output.mip, resource.mips, "level");
    check(output.layer, resource.layers, "layer");
}

/// What is only cleared has no past: an earlier frame of it is as neutral as this one.
void findRequestedResources(Compilation& work) {
    for (std::size_t i = 0; i < work.requested.size(); ++i) {
        const LinkedOutput& output = *work.requested[i];
        Index port = work.contentsOf({output.node, output.port});
        if (port == noIndex) port = work.portIndex(output.node, output.port);
        Index resource = work.resources[port];
        const bool isCleared = resource != noIndex && !work.runs(work.plan.resources[resource].node);
        for (std::uint16_t back = 0; back < output.framesBack && resource != noIndex && !isCleared; ++back)
            resource = resource < work.older.size() ? work.older[resource] : noIndex;
        work.plan.requested[i].resource = resource;
        if (resource == noIndex) continue;
        work.plan.resources[resource].requested = true;
        checkParts(work, output, work.plan.resources[resource]);
    }
}

void reportExtents(Compilation& work) {
    for (const RefusedExtent& refused : work.refusedExtents) {
        if (refused.node == noIndex || work.runs(refused.node))
            work.faults.error(refused.fault.where, refused.fault.message);
    }
}

/// Nothing comes before an image from outside, and nothing is run for it.
void makeImported(Compilation& work) {
    if (work.graph.description.imports.empty()) return;
    for (Index node = 0; node < work.graph.nodes.size(); ++node) {
        if (work.graph.nodes[node].role == NodeRole::Import && work.runs(node))
            ResourceMaker(work, node).makeAll();
    }
}

void measureTileLists(Compilation& work) {
    for (const Index node : work.order) {
        if (work.graph.nodes[node].role == NodeRole::TileList) ResourceMaker(work, node).measureTileList();
    }
}

}  // namespace

void makeResources(Compilation& work) {
    reportExtents(work);
    std::size_t count = work.graph.description.imports.size();
    for (const Index node : work.order) count += work.graph.nodes[node].formats.count;
    work.plan.resources.reserve(count);
    makeImported(work);
    for (const Index node : work.order) ResourceMaker(work, node).makeAll();
    if (work.graph.hasDomains) measureTileLists(work);
    if (work.graph.hasHistory) HistoryMaker(work).makeAll();
    findRequestedResources(work);
}

}  // namespace nephrite::graph
