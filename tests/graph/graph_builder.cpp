// See graph_builder.h.
#include "graph/graph_builder.h"

#include <fmt/format.h>

namespace nephrite::graph::tests {

GraphBuilder::GraphBuilder() : contents_(std::make_shared<Contents>()) {
    contents_->graph.description.name = "built";
}

PassType& GraphBuilder::addType(PassType type) {
    return contents_->types.emplace_back(std::move(type));
}

Index GraphBuilder::addNode(const PassType& type, const std::vector<LinkedInput>& sources,
                            NodeDescription description) {
    LinkedGraph& graph = contents_->graph;
    const auto index = static_cast<Index>(graph.nodes.size());
    description.name = fmt::format("n{}", index);
    description.passType = type.name;
    graph.description.nodes.push_back(std::move(description));

    LinkedNode node;
    node.type = &type;
    node.forEach = graph.description.nodes.back().forEach.value_or(type.forEach);
    node.inputs = {static_cast<Index>(graph.inputs.size()), static_cast<Index>(sources.size())};
    graph.inputs.insert(graph.inputs.end(), sources.begin(), sources.end());
    node.parameters = {static_cast<Index>(graph.parameters.size()), 0};
    node.formats = {static_cast<Index>(graph.formats.size()), static_cast<Index>(type.outputs.size())};
    for (const OutputPort& output : type.outputs) graph.formats.push_back(output.format);
    graph.nodes.push_back(node);
    graph.declarationOrder.push_back(index);
    return index;
}

void GraphBuilder::addOutput(Index node, Index port) {
    contents_->graph.outputs.push_back(
        {fmt::format("output{}", contents_->graph.outputs.size()), node, port, {}, 0, every, every});
}

std::shared_ptr<const LinkedGraph> GraphBuilder::build() const {
    indexGraph(contents_->graph);
    return {contents_, &contents_->graph};
}

PassType passType(std::string name, PassKind kind, Index inputs, Index outputs) {
    PassType type;
    type.name = std::move(name);
    type.kind = kind;
    type.inputs.resize(inputs);
    for (Index i = 0; i < inputs; ++i) type.inputs[i].name = fmt::format("in{}", i);
    type.outputs.resize(outputs);
    for (Index i = 0; i < outputs; ++i) type.outputs[i].name = fmt::format("out{}", i);
    return type;
}

}  // namespace nephrite::graph::tests
