// Phase: the extent of every output port. It is the port's own numbers or the extent of one other port, whose
// node comes earlier in the linked graph's order.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

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

    Extent resolve(Index node, Index port) {
        const OutputPort& output = work_.typeOf(node).outputs[port];
        if (!output.bufferElement.empty()) return bufferExtent(node, port);
        const auto& nodeSize = work_.description(node).size;
        if (nodeSize && nodeSize->kind == SizeRule::Kind::Like) {
            const LinkedNode& linked = work_.graph.nodes[node];
            return work_.extents[work_.portIndex(linked.sizeLikeNode, linked.sizeLikePort)];
        }
        if (nodeSize) return ownExtent(node, port, *nodeSize);
        if (!output.size) return firstInputExtent(node);
        if (output.size->kind == SizeRule::Kind::Like) return extentLikeInput(node, output.size->like);
        return ownExtent(node, port, *output.size);
    }

  private:
    /// The extent of the first connected input that is an image, else the view's.
    Extent firstInputExtent(Index node) const {
        const auto& inputs = work_.typeOf(node).inputs;
        for (Index i = 0; i < inputs.size(); ++i) {
            const LinkedInput& source = sourceOf(node, i);
            if (source.sourceNode != noIndex && inputs[i].bufferElement.empty()) return extentOf(source);
        }
        return work_.request.view;
    }

    /// The extent of the input of that name; if nothing is connected to it, as if there were no rule.
    Extent extentLikeInput(Index node, const std::string& name) const {
        const auto& inputs = work_.typeOf(node).inputs;
        for (Index i = 0; i < inputs.size(); ++i) {
            const LinkedInput& source = sourceOf(node, i);
            if (source.sourceNode != noIndex && inputs[i].name == name) return extentOf(source);
        }
        return firstInputExtent(node);
    }

    const LinkedInput& sourceOf(Index node, Index input) const {
        return work_.graph.inputs[work_.graph.nodes[node].inputs.first + input];
    }
    Extent extentOf(const LinkedInput& source) const {
        return work_.extents[work_.portIndex(source.sourceNode, source.sourcePort)];
    }

    Extent ownExtent(Index node, Index port, const SizeRule& rule) {
        const Extent view = work_.request.view;
        const double width = work_.values.at(node, rule.width);
        if (rule.kind == SizeRule::Kind::ScaleOfView) {
            if (!(width > 0))
                return refuse(node, port, rule, fmt::format("scale {}, expected more than 0", width));
            return checked(node, port, rule, std::max(1.0, std::round(width * view.width)),
                           std::max(1.0, std::round(width * view.height)));
        }
        const double height = work_.values.at(node, rule.height);
        return checked(node, port, rule, width == 0 ? view.width : width, height == 0 ? view.height : height);
    }

    Extent checked(Index node, Index port, const SizeRule& rule, double width, double height) {
        const std::uint32_t limit = work_.request.maxExtent;
        const auto isValid = [&](double size) { return std::round(size) >= 1 && std::round(size) <= limit; };
        if (isValid(width) && isValid(height)) {
            return {static_cast<std::uint32_t>(std::round(width)),
                    static_cast<std::uint32_t>(std::round(height))};
        }
        return refuse(node, port, rule,
                      fmt::format("size {} x {}, expected 1 to {} each way", width, height, limit));
    }

    /// A node that does not run may have a size only its condition makes nonsense of; a literal one is wrong
    /// anyway. A node's size is reported once, not for each of its ports.
    Extent refuse(Index node, Index port, const SizeRule& rule, const std::string& what) {
        const auto& faults = work_.faults.errors();
        const bool isKnown = !faults.empty() && faults.back().where == rule.where;
        if (!isKnown && (runs(node) || isLiteral(rule))) {
            work_.faults.error(rule.where, fmt::format("{}: {}", work_.graph.portName(node, port), what));
        }
        return {1, 1};
    }

    /// Elements in width. Whether they fit is checked with the element's size, in resolvePorts().
    Extent bufferExtent(Index node, Index port) {
        const OutputPort& output = work_.typeOf(node).outputs[port];
        const double count = work_.values.countAt(node, output.bufferCount);
        constexpr double limit = 4294967295.0;
        if (count >= 0 && count <= limit) return {static_cast<std::uint32_t>(count), 1};
        if (runs(node)) {
            work_.faults.error(whereOf(output.bufferCount, output),
                               fmt::format("{}: a buffer of {} elements, expected 0 to {}",
                                           work_.graph.portName(node, port), count, limit));
        }
        return {0, 1};
    }

    bool runs(Index node) const { return work_.plan.nodes[node].state == NodeState::Run; }

    Compilation& work_;
};

}  // namespace

void resolveExtents(Compilation& work) {
    checkView(work);
    ExtentResolver resolver(work);
    for (const Index node : work.graph.declarationOrder) {
        const Index ports = work.graph.nodes[node].formats.count;
        for (Index port = 0; port < ports; ++port) {
            work.extents[work.portIndex(node, port)] = resolver.resolve(node, port);
        }
    }
}

}  // namespace nephrite::graph
