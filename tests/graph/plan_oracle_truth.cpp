// See plan_oracle_truth.h.
#include "graph/plan_oracle_truth.h"

#include <algorithm>

namespace nephrite::graph::tests {

GraphTruth::GraphTruth(const CompileRequest& request, const Plan& plan)
    : request_(request),
      plan_(plan),
      graph_(*request.graph),
      values_(request.parameters ? *request.parameters : graph_.values),
      passes_(graph_.nodes.size(), nullptr),
      off_(graph_.nodes.size(), 0),
      cleared_(off_),
      runs_(off_),
      refused_(off_),
      wanted_(off_) {
    for (const PlannedPass& pass : plan.passes) passes_[pass.node] = &pass;
    decideOff();
    demandFromRoots();
    for (Index node = 0; node < graph_.nodes.size(); ++node) {
        if (!runs(node) || lacksLight(node)) continue;
        for (Index i = 0; i < graph_.nodes[node].inputs.count; ++i) {
            const Version source = sourceOf(node, i);
            if (source.node == noIndex) continue;
            if (needs(node, i)) {
                wanted_[source.node] = 1;
            } else {
                const bool isDirect =
                    graph_.inputs[graph_.nodes[node].inputs.first + i].sourceNode == source.node;
                refused_[source.node] |= isDirect ? 1 : 2;
            }
        }
    }
}

bool GraphTruth::lacksLight(Index node) const {
    const bool needsLight = graph_.nodes[node].forEach == ForEach::Lights ||
                            graph_.description.nodes[node].view == ViewKind::Light;
    return needsLight && request_.facts.lightViews == 0;
}

bool GraphTruth::isTiled(Index node) const {
    const LinkedNode& linked = graph_.nodes[node];
    if (!request_.skip || linked.tileList == noIndex || linked.formats.count == 0) return false;
    if (passes_[node] == nullptr || lacksLight(node)) return false;
    const Index input = linked.type->domainInput;
    const Version domain = sourceOf(node, input);
    if (domain.node == noIndex || isOff(domain.node) || !needs(node, input)) return false;
    return plan_.inputs[passes_[node]->inputs.first + input].extent == passes_[node]->extent;
}

/// A node that is off passes on what it would have modified.
Version GraphTruth::resolve(Version version) const {
    while (version.node != noIndex && isOff(version.node)) {
        const Index modified = graph_.modifies[graph_.nodes[version.node].formats.first + version.port];
        if (modified == noIndex) break;
        const LinkedInput& input = graph_.inputs[modified];
        if (input.sourceNode == noIndex) break;
        version.node = input.sourceNode;
        version.port = input.sourcePort;
        version.framesBack = static_cast<std::uint16_t>(version.framesBack + input.framesBack);
    }
    return version;
}

Version GraphTruth::sourceOf(Index node, Index input) const {
    const LinkedInput& linked = graph_.inputs[graph_.nodes[node].inputs.first + input];
    if (linked.sourceNode == noIndex) return {};
    return resolve({linked.sourceNode, linked.sourcePort, linked.framesBack, linked.mip, linked.layer});
}

Version GraphTruth::modifiedBy(Index node, Index port) const {
    const Index modified = graph_.modifies[graph_.nodes[node].formats.first + port];
    if (modified == noIndex || lacksLight(node)) return {};
    const Version source = sourceOf(node, modified - graph_.nodes[node].inputs.first);
    return source.node != noIndex && !isOff(source.node) ? source : Version{};
}

Version GraphTruth::rootOf(Version version) const {
    while (true) {
        const Version before = modifiedBy(version.node, version.port);
        if (before.node == noIndex) return version;
        version.node = before.node;
        version.port = before.port;
    }
}

double GraphTruth::valueOf(Index node, const ExpressionName& name) const {
    switch (name.space) {
        case ExpressionName::Space::Parameter: {
            const auto& declared = graph_.nodes[node].type->parameters;
            const auto found = std::find_if(declared.begin(), declared.end(), [&](const auto& parameter) {
                return parameter.name == name.name;
            });
            const auto index = static_cast<Index>(found - declared.begin());
            return graph_.valueOf(node, index, values_).components[name.element.value_or(0)];
        }
        case ExpressionName::Space::GraphParameter: {
            const auto& declared = graph_.description.parameters;
            const auto found = std::find_if(declared.begin(), declared.end(), [&](const auto& parameter) {
                return parameter.name == name.name;
            });
            return values_.graph[static_cast<std::size_t>(found - declared.begin())]
                .components[name.element.value_or(0)];
        }
        case ExpressionName::Space::SceneFact:
            return request_.facts.find(name.name).value();
        case ExpressionName::Space::InputNeutral:
            return isNeutral(node, name.name) ? 1 : 0;
    }
    return 0;
}

bool GraphTruth::holds(const Expression& expression, Index node) const {
    return expression.evaluate([&](const ExpressionName& name) { return valueOf(node, name); }) != 0;
}

/// An input is a constant if nothing is connected or its source is off. What earlier frames left is none.
bool GraphTruth::isNeutral(Index node, std::string_view input) const {
    const auto& inputs = graph_.nodes[node].type->inputs;
    for (Index i = 0; i < inputs.size(); ++i) {
        if (inputs[i].name != input) continue;
        const Version source = sourceOf(node, i);
        return source.node == noIndex || (source.framesBack == 0 && isOff(source.node));
    }
    return true;
}

void GraphTruth::decideOff() {
    for (const Index node : graph_.declarationOrder) {
        const auto& when = graph_.description.nodes[node].when;
        const auto& skipWhen = graph_.nodes[node].type->skipWhen;
        const bool isOff =
            (when && !holds(*when, node)) || (request_.skip && skipWhen && holds(*skipWhen, node));
        off_[node] = isOff ? 1 : 0;
    }
}

bool GraphTruth::needs(Index node, Index input) const {
    const auto& neededWhen = graph_.nodes[node].type->inputs[input].neededWhen;
    return !request_.skip || !neededWhen || holds(*neededWhen, node);
}

void GraphTruth::request(Version version) {
    const Version source = resolve(version);
    if (isOff(source.node)) {
        requested_.push_back(version);
        cleared_[version.node] = 1;
    } else {
        requested_.push_back(source);
        demand(source.node);
    }
}

void GraphTruth::demandFromRoots() {
    for (const LinkedOutput& output : graph_.outputs)
        request({output.node, output.port, output.framesBack, output.mip, output.layer});
    for (const PortReference& dump : request_.dumps) {
        const LinkedOutput output = graph_.find(dump);
        request({output.node, output.port, output.framesBack, output.mip, output.layer});
    }
    for (Index node = 0; node < graph_.nodes.size(); ++node) {
        if (graph_.nodes[node].type->sideEffect && !isOff(node)) demand(node);
    }
    while (!waiting_.empty()) {
        const Index node = waiting_.back();
        waiting_.pop_back();
        demandSources(node);
    }
}

void GraphTruth::demand(Index node) {
    if (runs(node)) return;
    runs_[node] = 1;
    waiting_.push_back(node);
}

void GraphTruth::demandSources(Index node) {
    if (lacksLight(node)) return;
    const LinkedNode& linked = graph_.nodes[node];
    for (Index i = 0; i < linked.inputs.count; ++i) {
        const Version source = sourceOf(node, i);
        if (source.node != noIndex && !isOff(source.node) && needs(node, i)) demand(source.node);
    }
    if (isTiled(node)) demand(linked.tileList);
}

}  // namespace nephrite::graph::tests
