// Phase: the extent of every output port. It is the port's own numbers or the extent of one other port, whose
// node comes earlier in the linked graph's order.
#include <fmt/format.h>

#include <algorithm>

#include "graph/compiler/image_size.h"
#include "graph/compiler/phases.h"

namespace nephrite::graph {
namespace {

void checkView(Compilation& work) {
    const Extent view = work.request.view;
    const std::uint32_t limit = work.request.maxExtent;
    if (view.width >= 1 && view.height >= 1 && view.width <= limit && view.height <= limit) return;
    work.faults.error(
        {work.graph.description.file, 0, 0},
        fmt::format("a picture of {} x {}, expected 1 to {} each way", view.width, view.height, limit));
    work.faults.throwIfErrors();
}

bool isLiteral(const SizeRule& rule) {
    return rule.width.names().empty() && rule.height.names().empty();
}

class ExtentResolver {
  public:
    explicit ExtentResolver(Compilation& work) : work_(work) {}

    /// Of every port whose size is a number or the picture's. True if those are all there are.
    bool resolveKnown() {
        const std::uint32_t limit = work_.request.maxExtent;
        bool isAll = true;
        for (Index port = 0; port < work_.extents.size(); ++port) {
            const PortShape& shape = work_.graph.shapes[port];
            const bool isPicture = shape.size == PortShape::Size::Picture;
            work_.extents[port] = isPicture ? work_.request.view : Extent{shape.width, shape.height};
            isAll &= isKnown(shape, limit);
        }
        return isAll;
    }

    /// Of every port that expressions or other ports decide on.
    void resolveOthers() {
        for (const Index node : work_.graph.declarationOrder) {
            const Index ports = work_.graph.nodes[node].formats.count;
            for (Index port = 0; port < ports; ++port) {
                const Index flat = work_.portIndex(node, port);
                if (!isKnown(work_.graph.shapes[flat], work_.request.maxExtent))
                    work_.extents[flat] = compute(node, port);
            }
        }
    }

    /// Of the levels that an input shows.
    Extent extentOf(const LinkedInput& source) const {
        const Extent whole = work_.extents[work_.portIndex(source.sourceNode, source.sourcePort)];
        return source.mip == every ? whole : levelExtent(whole, source.mip);
    }

  private:
    static bool isKnown(const PortShape& shape, std::uint32_t limit) {
        return shape.size == PortShape::Size::Picture ||
               (shape.size == PortShape::Size::Fixed && shape.width <= limit && shape.height <= limit);
    }

    Extent compute(Index node, Index port) {
        const OutputPort& output = work_.typeOf(node).outputs[port];
        const LinkedNode& linked = work_.graph.nodes[node];
        if (linked.role == NodeRole::Import) return importedExtent(node);
        if (linked.role == NodeRole::TileList) return {0, 1};  // known when its domain's layers are
        const Index modified = work_.graph.modifies[work_.portIndex(node, port)];
        if (modified != noIndex && work_.graph.inputs[modified].sourceNode != noIndex)
            return modifiedExtent(work_.graph.inputs[modified]);
        if (!output.bufferElement.empty()) return bufferExtent(node, port);
        if (linked.hasSize) return nodeExtent(node, port);
        if (!output.size) return firstInputExtent(node);
        if (output.size->kind == SizeRule::Kind::Like) return extentLikeInput(node, output.size->like);
        return ownExtent(node, port, *output.size);
    }

    Extent importedExtent(Index node) const {
        const Index import = work_.graph.nodes[node].import;
        return import < work_.request.imports.size() ? work_.request.imports[import].extent : Extent{1, 1};
    }

    /// Written in place: the whole resource's extent, whichever level the input shows.
    Extent modifiedExtent(LinkedInput source) const {
        source.mip = every;
        return extentOf(source);
    }

    Extent nodeExtent(Index node, Index port) {
        const SizeRule& size = *work_.description(node).size;
        if (size.kind != SizeRule::Kind::Like) return ownExtent(node, port, size);
        const LinkedNode& linked = work_.graph.nodes[node];
        return work_.extents[work_.portIndex(linked.sizeLikeNode, linked.sizeLikePort)];
    }

    /// The extent of the first connected input that is an image of this frame, else the view's. An earlier
    /// frame's may be the node's own.
    Extent firstInputExtent(Index node) const {
        const auto& inputs = work_.typeOf(node).inputs;
        for (Index i = 0; i < inputs.size(); ++i) {
            const LinkedInput& source = sourceOf(node, i);
            if (isOfThisFrame(source) && inputs[i].bufferElement.empty()) return extentOf(source);
        }
        return work_.request.view;
    }

    /// The extent of the input of that name; if nothing is connected to it, as if there were no rule.
    Extent extentLikeInput(Index node, const std::string& name) const {
        const auto& inputs = work_.typeOf(node).inputs;
        for (Index i = 0; i < inputs.size(); ++i) {
            const LinkedInput& source = sourceOf(node, i);
            if (isOfThisFrame(source) && inputs[i].name == name) return extentOf(source);
        }
        return firstInputExtent(node);
    }

    static bool isOfThisFrame(const LinkedInput& source) {
        return source.sourceNode != noIndex && source.framesBack == 0;
    }
    const LinkedInput& sourceOf(Index node, Index input) const {
        return work_.graph.inputs[work_.graph.nodes[node].inputs.first + input];
    }

    Extent ownExtent(Index node, Index port, const SizeRule& rule) {
        const Extent view = work_.request.view;
        const double width = work_.values.at(node, rule.width);
        if (rule.kind == SizeRule::Kind::ScaleOfView) {
            if (!(width > 0))
                return refuse(node, port, rule, fmt::format("scale {}, expected more than 0", width));
            return checked(node, port, rule, std::max(1.0, width * view.width),
                           std::max(1.0, width * view.height));
        }
        const double height = work_.values.at(node, rule.height);
        return checked(node, port, rule, width == 0 ? view.width : width, height == 0 ? view.height : height);
    }

    Extent checked(Index node, Index port, const SizeRule& rule, double width, double height) {
        const double limit = work_.request.maxExtent + 0.5;
        const auto isValid = [&](double size) { return size >= 0.5 && size < limit; };
        if (isValid(width) && isValid(height))
            return {static_cast<std::uint32_t>(width + 0.5), static_cast<std::uint32_t>(height + 0.5)};
        return refuse(
            node, port, rule,
            fmt::format("size {} x {}, expected 1 to {} each way", width, height, work_.request.maxExtent));
    }

    /// A node that does not run may have a size only its condition makes nonsense of; a literal one is wrong
    /// anyway. A node's size is reported once, not for each of its ports.
    Extent refuse(Index node, Index port, const SizeRule& rule, const std::string& what) {
        const auto& refused = work_.refusedExtents;
        if (refused.empty() || refused.back().fault.where != rule.where) refuse(node, port, rule.where, what);
        if (isLiteral(rule)) work_.refusedExtents.back().node = noIndex;
        return {1, 1};
    }

    void refuse(Index node, Index port, const SourceLocation& where, const std::string& what) {
        work_.refusedExtents.push_back(
            {node, {where, fmt::format("{}: {}", work_.graph.portName(node, port), what)}});
    }

    /// Elements in width. Whether they fit is checked with the element's size, in resolvePorts().
    Extent bufferExtent(Index node, Index port) {
        const OutputPort& output = work_.typeOf(node).outputs[port];
        const double count = work_.values.countAt(node, output.bufferCount);
        constexpr double limit = 4294967295.0;
        if (count >= 0 && count <= limit) return {static_cast<std::uint32_t>(count), 1};
        refuse(node, port, whereOf(output.bufferCount, output),
               fmt::format("a buffer of {} elements, expected 0 to {}", count, limit));
        return {0, 1};
    }

    Compilation& work_;
};

/// A domain can name the tiles to compute only if its texels are those of the pass.
bool canUseTileList(const Compilation& work, const ExtentResolver& resolver, Index node) {
    const LinkedNode& linked = work.graph.nodes[node];
    constexpr std::uint32_t mostTiles = 65535;  // groups of a dispatch that every device allows
    if (linked.tileList == noIndex || linked.forEach == ForEach::Mips || work.iterations[node] == 0)
        return false;
    const Index domain = linked.inputs.first + linked.type->domainInput;
    if (!work.inputIsRead[domain] || linked.formats.count == 0) return false;
    const Extent extent = work.extents[linked.formats.first];
    return resolver.extentOf(work.graph.inputs[domain]) == extent && tileCount(extent) <= mostTiles;
}

void findTiled(Compilation& work, const ExtentResolver& resolver) {
    if (!work.request.skip || !work.graph.hasDomains) return;
    work.isTiled.assign(work.graph.nodes.size(), 0);
    for (Index node = 0; node < work.graph.nodes.size(); ++node)
        work.isTiled[node] = canUseTileList(work, resolver, node);
}

}  // namespace

void resolveExtents(Compilation& work) {
    checkView(work);
    ExtentResolver resolver(work);
    if (!resolver.resolveKnown()) resolver.resolveOthers();
    findTiled(work, resolver);
}

}  // namespace nephrite::graph
