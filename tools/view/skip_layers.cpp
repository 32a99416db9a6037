// Sorting nodes into layers of skipping.
#include "view/skip_layers.h"

#include <algorithm>

namespace nephrite::view {
namespace {

bool hasSpecializedParameter(const graph::PassType& type) {
    return std::any_of(type.parameters.begin(), type.parameters.end(),
                       [](const graph::ParameterDeclaration& parameter) { return parameter.specialize; });
}

}  // namespace

std::array<SkipLayer, 5> skipLayers(const graph::Plan& plan, const runtime::FrameTimes& last) {
    std::array<SkipLayer, 5> layers{{{"1  not needed", "no requested output needs these nodes", {}},
                                     {"2  neutral", "switched off, or nobody needs them now: constants", {}},
                                     {"3  kept", "nothing they read has changed since they last ran", {}},
                                     {"4  tiles", "only the tiles of their domain are computed", {}},
                                     {"5  specialised", "compiled without what they do not need", {}}}};
    for (graph::Index node = 0; node < plan.nodes.size(); ++node) {
        const graph::NodeState state = plan.nodes[node].state;
        if (state == graph::NodeState::Run) continue;
        const std::size_t layer = state == graph::NodeState::Culled ? 0 : 1;
        layers[layer].nodes.push_back({plan.graph->nodeName(node), graph::whyOf(plan, node)});
    }
    for (std::size_t i = 0; i < plan.passes.size(); ++i) {
        const graph::PlannedPass& pass = plan.passes[i];
        const std::string& name = plan.nameOf(pass);
        if (last.passes.size() == plan.passes.size() && !last.passes[i].ran)
            layers[2].nodes.push_back({name, "its result of an earlier frame is still right"});
        if (pass.tileList != graph::noIndex)
            layers[3].nodes.push_back({name, "domain: " + plan.nameOf(plan.resources[pass.tileList])});
        if (pass.iterations > 0 && (pass.readsConstants || hasSpecializedParameter(plan.typeOf(pass))))
            layers[4].nodes.push_back(
                {name, pass.readsConstants ? "some input is a constant" : "some parameter is compiled in"});
    }
    return layers;
}

}  // namespace nephrite::view
