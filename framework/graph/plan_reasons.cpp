// Puts the compiler's decisions into words, when somebody asks.
#include <fmt/format.h>

#include <algorithm>

#include "graph/plan.h"

namespace nephrite::graph {
namespace {

std::string whyItDoesNothing(const Plan& plan, Index node) {
    const LinkedNode& linked = plan.graph->nodes[node];
    const bool needsLight = linked.forEach == ForEach::Lights || linked.view == ViewKind::Light;
    if (!needsLight || plan.lightViews > 0) return "";
    return "; the scene has no light, so its outputs are only cleared to their neutral value";
}

std::string_view wordOf(NodeState state) {
    return state == NodeState::Run      ? "runs without reading"
           : state == NodeState::Culled ? "is culled"
                                        : "is skipped";
}

/// The condition by which `reader` does without `node`.
std::string unneedingCondition(const Plan& plan, Index node, Index reader) {
    const LinkedNode& linked = plan.graph->nodes[reader];
    const auto inputs = slice(plan.graph->inputs, linked.inputs);
    for (Index port = 0; port < inputs.size(); ++port) {
        const auto& neededWhen = linked.type->inputs[port].neededWhen;
        if (inputs[port].sourceNode == node && neededWhen) {
            return fmt::format("\"{}\" needs its input \"{}\" only when \"{}\", which is false",
                               plan.graph->nodeName(reader), linked.type->inputs[port].name,
                               neededWhen->text());
        }
    }
    return fmt::format("\"{}\" does not need it", plan.graph->nodeName(reader));
}

std::string whyReaderDoesNotRun(const Plan& plan, Index reader) {
    return fmt::format("nothing that runs reads it: \"{}\" {}", plan.graph->nodeName(reader),
                       wordOf(plan.nodes[reader].state));
}

}  // namespace

std::string whyOf(const Plan& plan, Index node) {
    const NodeDecision& decision = plan.nodes[node];
    const LinkedGraph& graph = *plan.graph;
    switch (decision.reason) {
        case Reason::Requested:
            return fmt::format("the output \"{}\" is requested", plan.requested[decision.other].name) +
                   whyItDoesNothing(plan, node);
        case Reason::SideEffect:
            return "it has a side effect" + whyItDoesNothing(plan, node);
        case Reason::ReadByPass:
            return fmt::format("\"{}\" reads it", graph.nodeName(decision.other)) +
                   whyItDoesNothing(plan, node);
        case Reason::WhenIsFalse:
            return fmt::format("its \"when\" is false: {}", graph.description.nodes[node].when->text());
        case Reason::SkipWhenHolds:
            return fmt::format("its skipWhen holds: {}", graph.nodes[node].type->skipWhen->text());
        case Reason::NoReaderNeedsIt:
            return "no reader needs it: " + unneedingCondition(plan, node, decision.other);
        case Reason::NothingReadsIt:
            return "nothing reads it and none of its outputs is requested";
        case Reason::ReadersDoNotRun:
            return whyReaderDoesNotRun(plan, decision.other);
    }
    return "";
}

}  // namespace nephrite::graph
