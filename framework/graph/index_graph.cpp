// What follows from a graph's nodes and inputs, kept beside them so that compile() need not look for it.
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "graph/modifiers.h"

namespace nephrite::graph {
namespace {

std::optional<double> constantOf(const Expression& expression) {
    const auto& program = expression.program();
    const bool isConstant = program.size() == 1 && program[0].code == Expression::Instruction::Code::Constant;
    return isConstant ? std::optional(program[0].constant) : std::nullopt;
}

/// A whole number from 1 on, or 0.
template<class Number>
Number wholeNumber(const Expression& expression) {
    const double value = constantOf(expression).value_or(0);
    const bool isWhole =
        value >= 1 && value < std::numeric_limits<Number>::max() && value == std::floor(value);
    return isWhole ? static_cast<Number>(value) : Number{0};
}

PortShape shapeOf(const LinkedNode& node, const OutputPort& output) {
    PortShape shape;
    shape.isBuffer = !output.bufferElement.empty();
    if (node.role != NodeRole::Pass || shape.isBuffer || output.modifiedInput != noIndex) return shape;
    shape.mips = wholeNumber<std::uint16_t>(output.mips);
    shape.layers = wholeNumber<std::uint16_t>(output.layers);
    if (node.hasSize || !output.size) return shape;
    shape.width = wholeNumber<std::uint32_t>(output.size->width);
    shape.height = wholeNumber<std::uint32_t>(output.size->height);
    const bool isAbsolute = output.size->kind == SizeRule::Kind::Absolute;
    const bool isScale = output.size->kind == SizeRule::Kind::ScaleOfView;
    if (isAbsolute && shape.width > 0 && shape.height > 0) shape.size = PortShape::Size::Fixed;
    if (isScale && constantOf(output.size->width) == 1.0) shape.size = PortShape::Size::Picture;
    return shape;
}

bool hasConditions(const PassType& type) {
    return type.skipWhen || std::any_of(type.inputs.begin(), type.inputs.end(),
                                        [](const InputPort& input) { return input.neededWhen.has_value(); });
}

void indexNodes(LinkedGraph& graph) {
    graph.shapes.assign(graph.formats.size(), {});
    graph.modifies.assign(graph.formats.size(), noIndex);
    graph.hasModifiers = false;
    graph.hasDomains = false;
    for (Index node = 0; node < graph.nodes.size(); ++node) {
        LinkedNode& linked = graph.nodes[node];
        const NodeDescription& description = graph.description.nodes[node];
        linked.view = description.view;
        linked.hasWhen = description.when.has_value();
        linked.hasSize = description.size.has_value();
        linked.after = {};
        graph.hasDomains |= linked.tileList != noIndex;
        if (linked.type == nullptr) continue;
        linked.forEach = description.forEach.value_or(linked.type->forEach);
        linked.hasConditions = hasConditions(*linked.type);
        linked.isRaster = linked.type->kind == PassKind::Raster;
        linked.hasSideEffect = linked.type->sideEffect;
        const auto& parameters = linked.type->parameters;
        linked.isSpecialized = std::any_of(parameters.begin(), parameters.end(),
                                           [](const auto& parameter) { return parameter.specialize; });
        for (Index port = 0; port < linked.formats.count; ++port)
            graph.shapes[linked.formats.first + port] = shapeOf(linked, linked.type->outputs[port]);
        for (Index port = 0; port < linked.formats.count; ++port) {
            const Index modified = linked.type->outputs[port].modifiedInput;
            if (modified == noIndex) continue;
            const Index input = linked.inputs.first + modified;
            if (graph.inputs[input].sourceNode == noIndex) continue;
            graph.modifies[linked.formats.first + port] = input;
            graph.hasModifiers = true;
        }
    }
}

void indexHistory(LinkedGraph& graph) {
    graph.hasHistory = false;
    for (const LinkedInput& input : graph.inputs) graph.hasHistory |= input.framesBack > 0;
    for (const LinkedOutput& output : graph.outputs) graph.hasHistory |= output.framesBack > 0;
}

/// A node that reads what another overwrites.
struct Precedence {
    Index reader = noIndex;
    Index modifier = noIndex;
};

/// Sorted by reader, each once for a modifier.
std::vector<Precedence> findPrecedences(const LinkedGraph& graph) {
    const std::vector<Modifier> modifiers = findModifiers(graph);
    std::vector<Precedence> precedences;
    std::vector<Index> lastReader(graph.nodes.size(), noIndex);  // by modifier
    for (Index node = 0; node < graph.nodes.size(); ++node) {
        const Range inputs = graph.nodes[node].inputs;
        for (const LinkedInput& input : slice(graph.inputs, inputs)) {
            if (input.sourceNode == noIndex || input.sourcePort == noIndex || input.framesBack > 0) continue;
            const Modifier* modifier = findOverwriter(graph, modifiers, input);
            if (modifier == nullptr || modifier->node == node || lastReader[modifier->node] == node) continue;
            lastReader[modifier->node] = node;
            precedences.push_back({node, modifier->node});
        }
    }
    return precedences;
}

void indexAfter(LinkedGraph& graph) {
    graph.after.clear();
    if (!graph.hasModifiers) return;
    const std::vector<Precedence> precedences = findPrecedences(graph);
    for (const Precedence& precedence : precedences) ++graph.nodes[precedence.modifier].after.count;
    Index first = 0;
    for (LinkedNode& node : graph.nodes) {
        node.after.first = first;
        first += node.after.count;
        node.after.count = 0;
    }
    graph.after.resize(first);
    for (const Precedence& precedence : precedences) {
        Range& after = graph.nodes[precedence.modifier].after;
        graph.after[after.first + after.count++] = precedence.reader;
    }
}

}  // namespace

void indexGraph(LinkedGraph& graph) {
    indexNodes(graph);
    indexHistory(graph);
    indexAfter(graph);
}

}  // namespace nephrite::graph
