// A plan as a Graphviz drawing: nodes coloured by what became of them, edges labelled with what flows along
// them.
#include <fmt/format.h>

#include <iterator>

#include "graph/plan_words.h"
#include "graph/plan_writer.h"

namespace nephrite::graph {
namespace {

using Output = std::back_insert_iterator<std::string>;

/// Text inside DOT's double quotes.
std::string escaped(std::string_view text) {
    std::string result;
    for (const char c : text) {
        if (c == '"' || c == '\\') result += '\\';
        result += c;
    }
    return result;
}

std::string_view fillColor(NodeState state) {
    switch (state) {
        case NodeState::Run:
            return "#cfe8d5";
        case NodeState::Skipped:
            return "#f6e3b4";
        case NodeState::Culled:
            return "#e2e2e2";
    }
    return "white";
}

void writeNode(const Plan& plan, Index node, Index pass, Output out) {
    const NodeState state = plan.nodes[node].state;
    const PassType& type = *plan.graph->nodes[node].type;
    const std::string position = pass == noIndex ? std::string(name(state)) : fmt::format("pass {}", pass);
    fmt::format_to(out, "  n{} [label=\"{}\\n{}\\n{}\", tooltip=\"{}\", fillcolor=\"{}\"{}];\n", node,
                   escaped(plan.graph->nodeName(node)), escaped(type.name), position,
                   escaped(whyOf(plan, node)), fillColor(state),
                   state == NodeState::Run ? "" : ", style=\"filled,rounded,dashed\"");
}

/// "position rgba32f 512 x 512"; the size only where the image exists.
std::string edgeLabel(const Plan& plan, const LinkedInput& source, Index resource) {
    const std::string port =
        escaped(plan.graph->nodes[source.sourceNode].type->outputs[source.sourcePort].name);
    if (resource != noIndex) {
        const Resource& read = plan.resources[resource];
        return fmt::format("{}\\n{} {}", port, formatName(plan, read), sizeInWords(read));
    }
    return fmt::format("{}\\n{}", port, declaredFormat(*plan.graph, source.sourceNode, source.sourcePort));
}

void writeEdges(const Plan& plan, Index node, Index pass, Output out) {
    const auto sources = slice(plan.graph->inputs, plan.graph->nodes[node].inputs);
    for (Index i = 0; i < sources.size(); ++i) {
        if (sources[i].sourceNode == noIndex) continue;
        const Index resource =
            pass == noIndex ? noIndex : plan.inputs[plan.passes[pass].inputs.first + i].resource;
        fmt::format_to(out, "  n{} -> n{} [label=\"{}\"{}];\n", sources[i].sourceNode, node,
                       edgeLabel(plan, sources[i], resource),
                       resource == noIndex ? ", style=dashed, color=\"#999999\", fontcolor=\"#777777\"" : "");
    }
}

void writeRequested(const Plan& plan, Index index, Output out) {
    const RequestedOutput& output = plan.requested[index];
    if (output.resource == noIndex) return;
    const Resource& resource = plan.resources[output.resource];
    const LinkedInput source{resource.node, resource.port};
    fmt::format_to(out, "  o{} [label=\"{}\", shape=ellipse, fillcolor=\"#cfdff5\"];\n", index,
                   escaped(output.name));
    fmt::format_to(out, "  n{} -> o{} [label=\"{}\"];\n", resource.node, index,
                   edgeLabel(plan, source, output.resource));
}

}  // namespace

std::string planAsDot(const Plan& plan) {
    std::string text = fmt::format("digraph \"{}\" {{\n", escaped(plan.graph->description.name));
    text += "  node [shape=box, style=\"filled,rounded\", fontname=\"sans-serif\", fontsize=11];\n";
    text += "  edge [fontname=\"sans-serif\", fontsize=9];\n";
    const Output out = std::back_inserter(text);
    const std::vector<Index> passes = passOfNode(plan);
    for (Index node = 0; node < plan.nodes.size(); ++node) writeNode(plan, node, passes[node], out);
    for (Index node = 0; node < plan.nodes.size(); ++node) writeEdges(plan, node, passes[node], out);
    for (Index i = 0; i < plan.requested.size(); ++i) writeRequested(plan, i, out);
    return text + "}\n";
}

}  // namespace nephrite::graph
