#include "graph/plan.h"

#include <fmt/format.h>

namespace nephrite::graph {

std::string Plan::nameOf(const Resource& resource) const {
    const std::string port = graph->portName(resource.node, resource.port);
    switch (resource.framesBack) {
        case 0:
            return port;
        case 1:
            return fmt::format("previous({})", port);
        default:
            return fmt::format("previous({}, {})", port, resource.framesBack);
    }
}

std::array<double, 4> neutralOf(const Plan& plan, const PlannedPass& pass, Index port) {
    const LinkedGraph& graph = *plan.graph;
    const LinkedInput& input = graph.inputs[graph.nodes[pass.node].inputs.first + port];
    const bool sourceIsOff = input.sourceNode != noIndex &&
                             plan.nodes[input.sourceNode].state == NodeState::Skipped &&
                             plan.nodes[input.sourceNode].reason != Reason::NoReaderNeedsIt;
    if (sourceIsOff) return graph.nodes[input.sourceNode].type->outputs[input.sourcePort].neutral;
    return plan.typeOf(pass).inputs[port].neutral;
}

bool isCleared(const Plan& plan, const PlannedPass& pass, Index port) {
    if (pass.iterations == 0) return true;
    if (!pass.clearsFirst) return false;
    const Index modified = plan.typeOf(pass).outputs[port].modifiedInput;
    if (modified != noIndex) return !plan.inputs[pass.inputs.first + modified].modified;
    return pass.tileList != noIndex || plan.graph->nodes[pass.node].role == NodeRole::TileList;
}

bool keepsResults(const Plan& plan, const PlannedPass& pass) {
    bool keepsAny = false;
    for (const Index output : slice(plan.outputs, pass.outputs)) {
        const Resource& resource = plan.resources[output];
        const bool isRead = resource.requested || resource.first != resource.last;
        if (isRead && resource.kind != ResourceKind::Kept) return false;
        keepsAny = keepsAny || resource.kind == ResourceKind::Kept;
    }
    return keepsAny;
}

std::string_view name(Policy policy) {
    return policy == Policy::Barriers ? "barriers" : "memory";
}

std::string_view name(NodeState state) {
    switch (state) {
        case NodeState::Run:
            return "run";
        case NodeState::Culled:
            return "culled";
        case NodeState::Skipped:
            return "skipped";
    }
    return "";
}

std::string_view name(Use use) {
    switch (use) {
        case Use::None:
            return "nothing";
        case Use::ComputeRead:
            return "compute read";
        case Use::ComputeWrite:
            return "compute write";
        case Use::RasterRead:
            return "raster read";
        case Use::ColorAttachment:
            return "color attachment";
        case Use::DepthAttachment:
            return "depth attachment";
        case Use::Clear:
            return "clear";
        case Use::Copy:
            return "copy";
        case Use::Indirect:
            return "indirect dispatch";
        case Use::ComputeModify:
            return "compute modify";
        case Use::ComputeLevelRead:
            return "compute level read";
    }
    return "";
}

std::string_view name(Layout layout) {
    switch (layout) {
        case Layout::Undefined:
            return "undefined";
        case Layout::General:
            return "general";
        case Layout::ShaderRead:
            return "shader read";
        case Layout::ColorAttachment:
            return "color attachment";
        case Layout::DepthAttachment:
            return "depth attachment";
        case Layout::TransferSource:
            return "transfer source";
        case Layout::TransferDestination:
            return "transfer destination";
    }
    return "";
}

}  // namespace nephrite::graph
