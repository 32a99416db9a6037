// See plan_words.h.
#include "graph/plan_words.h"

#include <fmt/format.h>

#include <array>

namespace nephrite::graph {
std::vector<Index> nodesInReportOrder(const Plan& plan) {
    std::vector<Index> order;
    order.reserve(plan.nodes.size());
    const std::vector<Index> passes = passOfNode(plan);
    for (const PlannedPass& pass : plan.passes) order.push_back(pass.node);
    for (const NodeState state : {NodeState::Skipped, NodeState::Culled}) {
        for (Index node = 0; node < plan.nodes.size(); ++node) {
            const bool isWritten = plan.graph->nodes[node].role == NodeRole::Pass;
            if (isWritten && passes[node] == noIndex && plan.nodes[node].state == state)
                order.push_back(node);
        }
    }
    return order;
}

std::vector<Index> passOfNode(const Plan& plan) {
    std::vector<Index> result(plan.nodes.size(), noIndex);
    for (Index i = 0; i < plan.passes.size(); ++i) result[plan.passes[i].node] = i;
    return result;
}

std::string formatName(const Plan& plan, const Resource& resource) {
    if (!resource.isBuffer) return std::string(info(resource.format).name);
    return plan.graph->nodes[resource.node].type->outputs[resource.port].bufferElement;
}

std::string declaredFormat(const LinkedGraph& graph, Index node, Index port) {
    const LinkedNode& linked = graph.nodes[node];
    const std::string& element = linked.type->outputs[port].bufferElement;
    return element.empty() ? std::string(info(graph.formats[linked.formats.first + port]).name) : element;
}

std::string sizeInWords(const Resource& resource) {
    if (resource.isBuffer) return fmt::format("{} elements", resource.extent.width);
    std::string words = fmt::format("{} x {}", resource.extent.width, resource.extent.height);
    if (resource.mips > 1) words += fmt::format(", {} mips", resource.mips);
    if (resource.layers > 1) words += fmt::format(", {} layers", resource.layers);
    return words;
}

std::string placeInWords(const Resource& resource) {
    switch (resource.kind) {
        case ResourceKind::Transient:
            return fmt::format("at byte {} of the heap", resource.offset);
        case ResourceKind::Kept:
            return "kept over frames";
        case ResourceKind::History:
            return "one of a ring over frames";
        case ResourceKind::Imported:
            return "from outside";
    }
    return "";
}

std::string bytesInWords(std::uint64_t bytes) {
    static constexpr std::array<std::string_view, 5> units{"KiB", "MiB", "GiB", "TiB", "PiB"};
    if (bytes < 1024) return fmt::format("{} B", bytes);
    double amount = static_cast<double>(bytes) / 1024;
    std::size_t unit = 0;
    for (; amount >= 1024 && unit + 1 < units.size(); ++unit) amount /= 1024;
    return fmt::format("{:.2f} {}", amount, units[unit]);
}

std::string transitionInWords(const Plan& plan, const Barrier& barrier) {
    if (plan.resources[barrier.resource].isBuffer) return "";
    if (barrier.oldLayout == barrier.newLayout) return fmt::format("stays {}", name(barrier.newLayout));
    return fmt::format("{} -> {}", name(barrier.oldLayout), name(barrier.newLayout));
}

std::string usesInWords(std::uint32_t uses) {
    std::string words;
    for (Use use = Use::ComputeRead; use <= Use::ComputeLevelRead;
         use = static_cast<Use>(static_cast<int>(use) + 1)) {
        if ((uses & bit(use)) == 0) continue;
        if (!words.empty()) words += " and ";
        words += name(use);
    }
    return words;
}

std::string passInWords(const Plan& plan, Index pass) {
    return fmt::format("pass {} \"{}\"", pass, plan.nameOf(plan.passes[pass]));
}

std::string protectionInWords(const Plan& plan, const Barrier& barrier) {
    const std::string after = barrier.passAfter < plan.passes.size()
                                  ? passInWords(plan, barrier.passAfter)
                                  : std::string(barrier.usesAfter == 0 ? "the next frame" : "the copy out");
    if (barrier.passBefore == noIndex) {
        return barrier.oldLayout == Layout::Undefined ? fmt::format("{} does not need what was there", after)
                                                      : fmt::format("as {} needs it", after);
    }
    const std::string before = passInWords(plan, barrier.passBefore);
    if (barrier.aliases)
        return fmt::format("{} must be done with the memory they share before {} writes", before, after);
    if (barrier.writeBefore) return fmt::format("what {} wrote becomes visible to {}", before, after);
    return fmt::format("{} must have read it before {} changes it", before, after);
}

std::string partInWords(const Plan& plan, const Barrier& barrier) {
    if (barrier.range == plan.resources[barrier.resource].whole()) return "";
    const Subresources& range = barrier.range;
    return fmt::format("levels {} to {}, layers {} to {}", range.baseMip, range.baseMip + range.mips - 1,
                       range.baseLayer, range.baseLayer + range.layers - 1);
}

std::string dependencyInWords(const Barrier& barrier) {
    const std::string after =
        barrier.usesAfter == 0 ? std::string("for the next frame") : "for " + usesInWords(barrier.usesAfter);
    if (barrier.usesBefore == 0) return after + ", nothing to wait for";
    return fmt::format("{}, after {}{}", after, usesInWords(barrier.usesBefore),
                       barrier.aliases ? " of what had the memory before" : "");
}

}  // namespace nephrite::graph
