// See compatible_types.h. What can be said in plain words is looked at first; link() has the last word.
#include "graph/compatible_types.h"

#include <fmt/format.h>

#include <algorithm>

#include "graph/link_parameters.h"
#include "graph/link_phases.h"
#include "graph/value_readers.h"

namespace nephrite::graph {
namespace {

/// An output of the node that somebody reads.
struct Reader {
    std::string port;                  ///< the output's name
    std::string who;                   ///< "composite.diffuse", `the graph's output "color"`
    const InputPort* input = nullptr;  ///< nullptr: any image or buffer will do
};

/// Who reads the outputs of a node, each reader once for each port.
std::vector<Reader> readersOf(const LinkedGraph& graph, Index node) {
    const auto& outputs = graph.nodes[node].type->outputs;
    std::vector<Reader> readers;
    for (Index other = 0; other < graph.nodes.size(); ++other) {
        const LinkedNode& reader = graph.nodes[other];
        if (reader.role != NodeRole::Pass) continue;
        for (Index i = 0; i < reader.inputs.count; ++i) {
            const LinkedInput& input = graph.inputs[reader.inputs.first + i];
            if (input.sourceNode != node) continue;
            const InputPort& port = reader.type->inputs[i];
            readers.push_back({outputs[input.sourcePort].name,
                               fmt::format("{}.{}", graph.nodeName(other), port.name), &port});
        }
        if (reader.sizeLikeNode == node) {
            readers.push_back({outputs[reader.sizeLikePort].name,
                               fmt::format("the size of {}", inQuotes(graph.nodeName(other))), nullptr});
        }
    }
    for (const LinkedOutput& output : graph.outputs) {
        if (output.node != node) continue;
        readers.push_back({outputs[output.port].name,
                           fmt::format("the graph's output {}", inQuotes(output.name)), nullptr});
    }
    return readers;
}

std::string_view often(ForEach forEach) {
    if (forEach == ForEach::Lights) return "once for each light view";
    return forEach == ForEach::Mips ? "once for each level" : "once";
}

class Comparison {
  public:
    Comparison(const LinkedGraph& graph, Index node, const PassLibrary& passTypes)
        : graph_(graph), node_(node), passTypes_(passTypes), readers_(readersOf(graph, node)) {}

    TypeChoice with(const std::string& name) {
        TypeChoice choice{name, {}, {}};
        try {
            const PassType& type = *passTypes_.find(name);
            choice.doc = type.doc;
            reasons_.clear();
            compare(type);
            choice.reasons = reasons_;
        } catch (const InputError& error) {
            choice.reasons = {fmt::format("its manifest is wrong: {}", toLine(error.faults().front()))};
        }
        return choice;
    }

  private:
    void compare(const PassType& type) {
        if (type.kind == PassKind::Native) reasons_.push_back("it is written in C++, which does not run yet");
        compareIteration(type);
        compareInputs(type);
        compareOutputs(type);
        if (reasons_.empty()) tryToLink(type);
    }

    void compareIteration(const PassType& type) {
        const ForEach now = graph_.nodes[node_].forEach;
        const ForEach then = graph_.description.nodes[node_].forEach.value_or(type.forEach);
        if (now != then) reasons_.push_back(fmt::format("it runs {}, the node {}", often(then), often(now)));
    }

    void compareInputs(const PassType& type) {
        const LinkedNode& linked = graph_.nodes[node_];
        std::vector<bool> isConnected(type.inputs.size(), false);
        for (Index i = 0; i < linked.inputs.count; ++i) {
            const LinkedInput& source = graph_.inputs[linked.inputs.first + i];
            if (source.sourceNode == noIndex) continue;
            const InputPort* input = findNamed(type.inputs, linked.type->inputs[i].name);
            if (input == nullptr) {
                reasons_.push_back(fmt::format("it has no input {}", inQuotes(linked.type->inputs[i].name)));
                continue;
            }
            isConnected[static_cast<std::size_t>(input - type.inputs.data())] = true;
            compareSource(*input, source);
        }
        for (std::size_t i = 0; i < type.inputs.size(); ++i) {
            if (isConnected[i] || type.inputs[i].optional) continue;
            reasons_.push_back(
                fmt::format("its input {} would not be connected", inQuotes(type.inputs[i].name)));
        }
    }

    void compareSource(const InputPort& input, const LinkedInput& source) {
        const LinkedNode& from = graph_.nodes[source.sourceNode];
        const std::string expected = sortOf(input);
        const std::string found = sortOf(from.type->outputs[source.sourcePort],
                                         graph_.formats[from.formats.first + source.sourcePort]);
        if (expected == found) return;
        reasons_.push_back(fmt::format("its input {} expects {}, but {} is {}", inQuotes(input.name),
                                       expected, graph_.portName(source.sourceNode, source.sourcePort),
                                       found));
    }

    void compareOutputs(const PassType& type) {
        for (const Reader& reader : readers_) {
            const OutputPort* output = findNamed(type.outputs, reader.port);
            if (output == nullptr) {
                reasons_.push_back(fmt::format("it has no output {}, which is read by {}",
                                               inQuotes(reader.port), reader.who));
                continue;
            }
            if (reader.input == nullptr) continue;
            const std::string expected = sortOf(*reader.input);
            const std::string found = sortOf(*output, output->format);
            if (expected == found) continue;
            reasons_.push_back(fmt::format("its output {} is {}, but {} expects {}", inQuotes(reader.port),
                                           found, reader.who, expected));
        }
    }

    void tryToLink(const PassType& type) {
        GraphDescription description = asWritten(graph_);
        description.nodes[node_] =
            withPassType(graph_.description, std::move(description.nodes[node_]), type);
        try {
            link(std::move(description), passTypes_);
        } catch (const InputError& error) {
            for (const Diagnostic& fault : error.faults()) reasons_.push_back(fault.message);
        }
    }

    const LinkedGraph& graph_;
    Index node_;
    const PassLibrary& passTypes_;
    std::vector<Reader> readers_;
    std::vector<std::string> reasons_;
};

bool suits(const GraphDescription& graph, const ParameterSetting& setting, const PassType& type) {
    const ParameterDeclaration* declaration = findNamed(type.parameters, setting.parameter);
    if (declaration == nullptr) return false;
    if (const auto* value = std::get_if<json::Value>(&setting.value)) {
        Diagnostics ignored;
        return readParameterValue(*value, *declaration, ignored).has_value();
    }
    const GraphParameter* parameter = findNamed(graph.parameters, std::get<std::string>(setting.value));
    return parameter != nullptr && !whyNotLinked(*parameter, *declaration);
}

}  // namespace

std::vector<TypeChoice> choicesFor(const LinkedGraph& graph, Index node, const PassLibrary& passTypes) {
    Comparison comparison(graph, node, passTypes);
    std::vector<TypeChoice> choices;
    for (const std::string& name : passTypes.names()) choices.push_back(comparison.with(name));
    return choices;
}

NodeDescription withPassType(const GraphDescription& graph, NodeDescription node, const PassType& type) {
    node.passType = type.name;
    const auto isUnfit = [&](const ParameterSetting& setting) { return !suits(graph, setting, type); };
    node.settings.erase(std::remove_if(node.settings.begin(), node.settings.end(), isUnfit),
                        node.settings.end());
    const auto isRefused = [&](const FormatOverride& change) {
        const OutputPort* port = findNamed(type.outputs, change.port);
        return port == nullptr || whyNotChanged(*port, change.format).has_value();
    };
    node.formats.erase(std::remove_if(node.formats.begin(), node.formats.end(), isRefused),
                       node.formats.end());
    return node;
}

GraphDescription asWritten(const LinkedGraph& graph) {
    GraphDescription description = graph.description;
    const auto isOwn = [](const LinkedNode& node) { return node.role == NodeRole::Pass; };
    description.nodes.resize(
        static_cast<std::size_t>(std::count_if(graph.nodes.begin(), graph.nodes.end(), isOwn)));
    return description;
}

}  // namespace nephrite::graph
