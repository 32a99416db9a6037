// See controls.h.
#include "graph/controls.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "graph/value_readers.h"
#include "text/json_edit.h"

namespace nephrite::graph {
namespace {

using PossibleRange = std::optional<std::array<double, 2>>;

PossibleRange both(const PossibleRange& a, const PossibleRange& b) {
    if (!a || !b) return a ? a : b;
    return std::array<double, 2>{std::max((*a)[0], (*b)[0]), std::min((*a)[1], (*b)[1])};
}

bool isIntegral(ParameterType type) {
    return type == ParameterType::Int || type == ParameterType::Uint;
}

void decideScale(Control& control) {
    control.logarithmic = control.range && isLogarithmic(*control.range, control.defaultValue);
}

Control ownControl(const LinkedGraph& graph, Index parameter, const ParameterValues& current) {
    const GraphParameter& declared = graph.description.parameters[parameter];
    Control control;
    control.target = control.name = declared.name;
    control.doc = declared.doc;
    control.count = static_cast<std::uint32_t>(declared.value.components.size());
    control.type = declared.isBool     ? ParameterType::Bool
                   : control.count > 1 ? ParameterType::FloatArray
                                       : ParameterType::Float;
    control.range = declared.range;
    control.defaultValue = declared.value;
    control.value = current.graph[parameter];
    return control;
}

/// A graph parameter is what all that take their value from it can be.
void restrict(Control& control, const ParameterDeclaration& user) {
    // An integer may be bound to beside a float, and then only integers do.
    if (!isIntegral(control.type)) control.type = user.type;
    if (user.type == ParameterType::Uint) control.type = user.type;
    control.range = both(control.range, user.range);
    control.specialized |= user.specialize;
}

NodeControls nodeControls(const LinkedGraph& graph, Index node, const ParameterValues& current) {
    const LinkedNode& linked = graph.nodes[node];
    NodeControls result{node, graph.nodeName(node), linked.type->name, linked.type->doc, {}};
    for (Index i = 0; i < linked.parameters.count; ++i) {
        const ParameterDeclaration& declared = linked.type->parameters[i];
        Control control;
        control.target = fmt::format("{}.{}", result.name, declared.name);
        control.name = declared.name;
        control.doc = declared.doc;
        control.type = declared.type;
        control.count = declared.count;
        control.range = declared.range;
        control.defaultValue = declared.defaultValue;
        control.value = graph.valueOf(node, i, current);
        control.specialized = declared.specialize;
        const Index bound = graph.parameters[linked.parameters.first + i].graphParameter;
        if (bound != noIndex) control.boundTo = graph.description.parameters[bound].name;
        decideScale(control);
        result.parameters.push_back(std::move(control));
    }
    return result;
}

/// Shaders see floats: what is exactly a float is written as the shortest number that gives it.
std::string numberText(double value) {
    const auto nearest = static_cast<float>(value);
    const bool isFloat = static_cast<double>(nearest) == value && value != std::floor(value);
    return isFloat ? json::shortestNumber(nearest) : json::shortestNumber(value);
}

}  // namespace

GraphControls controlsOf(const LinkedGraph& graph, const ParameterValues& current) {
    GraphControls controls;
    for (Index i = 0; i < graph.description.parameters.size(); ++i)
        controls.parameters.push_back(ownControl(graph, i, current));
    for (Index node = 0; node < graph.nodes.size(); ++node) {
        const LinkedNode& linked = graph.nodes[node];
        if (linked.role != NodeRole::Pass) continue;
        controls.nodes.push_back(nodeControls(graph, node, current));
        for (Index i = 0; i < linked.parameters.count; ++i) {
            const Index bound = graph.parameters[linked.parameters.first + i].graphParameter;
            if (bound != noIndex) restrict(controls.parameters[bound], linked.type->parameters[i]);
        }
    }
    for (Control& control : controls.parameters) decideScale(control);
    return controls;
}

void setDefaults(GraphControls& controls, std::span<const GraphParameter> file) {
    for (Control& control : controls.parameters) {
        const GraphParameter* declared = findNamed(file, control.name);
        if (declared == nullptr) continue;
        control.defaultValue = declared->value;
        decideScale(control);
    }
}

bool isLogarithmic(const std::array<double, 2>& range, const ParameterValue& defaultValue) {
    constexpr double widest = 1000;
    const double greatest = std::max(std::abs(range[0]), std::abs(range[1]));
    if (range[0] > 0) return greatest >= widest * range[0];
    double smallest = 0;
    for (const double component : defaultValue.components) {
        const double size = std::abs(component);
        if (size > 0 && (smallest == 0 || size < smallest)) smallest = size;
    }
    return greatest >= widest * (smallest > 0 ? smallest : 1);
}

std::string valueText(const Control& control, const ParameterValue& value) {
    if (control.type == ParameterType::Bool) return value.components[0] != 0 ? "true" : "false";
    std::vector<std::string> numbers;
    for (const double component : value.components) numbers.push_back(numberText(component));
    const bool isArray = control.count > 1 || control.type == ParameterType::FloatArray;
    return isArray ? fmt::format("[{}]", fmt::join(numbers, ", ")) : numbers[0];
}

std::string settingText(const Control& control, const ParameterValue& value) {
    return fmt::format("{}={}", control.target, valueText(control, value));
}

}  // namespace nephrite::graph
