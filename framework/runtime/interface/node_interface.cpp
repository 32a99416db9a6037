// Generates the GLSL interface of a node, part by part; node_interface.h says what it is for.
#include "runtime/interface/node_interface.h"

#include "runtime/interface/draft.h"

namespace nephrite::runtime {
namespace {

constexpr std::string_view dispatch = R"(layout(push_constant) uniform Dispatch {
    uint iteration; uint width; uint height; uint layer;
} dispatch;
uint iteration = dispatch.iteration;
)";

void addDispatch(InterfaceDraft& draft) {
    draft.add(dispatch);
    draft.addLine(draft.isOverLights() ? "uint iterationLight = lightViews[dispatch.iteration].light;"
                                       : "const uint iterationLight = 0u;");
}

}  // namespace

NodeInterface nodeInterface(const graph::Plan& plan, const graph::PlannedPass& pass,
                            const graph::ParameterValues& values, const Filterable& filterable) {
    InterfaceDraft draft(plan, pass);
    addDispatch(draft);
    addParameters(draft, values);
    for (graph::Index port = 0; port < pass.outputs.count; ++port) addOutput(draft, port);
    for (graph::Index port = 0; port < pass.inputs.count; ++port) addInput(draft, port, filterable);
    addEntryPoint(draft);
    return draft.finish();
}

std::uint32_t tileListLayers(const graph::Plan& plan, const graph::PlannedPass& pass) {
    const std::uint32_t tiles = ((pass.extent.width + graph::tileSide - 1) / graph::tileSide) *
                                ((pass.extent.height + graph::tileSide - 1) / graph::tileSide);
    return plan.resources[pass.tileList].extent.width / (4 + tiles);
}

std::uint32_t tileLayer(const graph::Plan& plan, const graph::PlannedPass& pass, std::uint32_t iteration) {
    const graph::InputRead& domain = plan.inputs[pass.inputs.first + plan.typeOf(pass).domainInput];
    if (!domain.perIteration || domain.resource == graph::noIndex) return 0;
    return iteration * plan.resources[domain.resource].layersPerIteration;
}

}  // namespace nephrite::runtime
