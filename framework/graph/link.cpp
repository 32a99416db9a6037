// Every name of a description looked up, every fault collected.
#include <fmt/format.h>

#include <unordered_map>

#include "graph/link_parameters.h"
#include "graph/linked_graph.h"
#include "graph/node_order.h"
#include "graph/value_readers.h"

namespace nephrite::graph {
namespace {

/// Searching the nearest of n names for each of n faults would take n * n steps: the first faults get
/// suggestions.
constexpr std::size_t faultsWithSuggestion = 100;

class Linker {
  public:
    Linker(GraphDescription description, const PassLibrary& passTypes)
        : graph_(std::make_shared<LinkedGraph>()), passTypes_(passTypes) {
        graph_->description = std::move(description);
    }

    std::shared_ptr<const LinkedGraph> link() {
        nameNodes();
        ParameterLinker parameters(*graph_, diagnostics_);
        for (Index node = 0; node < graph_->nodes.size(); ++node) {
            linkInputs(node);
            linkSize(node);
            if (graph_->nodes[node].type == nullptr) continue;
            linkFormats(node);
            parameters.linkParameters(node);
            parameters.checkExpressions(node);
        }
        linkOutputs();
        order();
        diagnostics_.throwIfErrors();
        return graph_;
    }

  private:
    void nameNodes() {
        const auto& descriptions = graph_->description.nodes;
        graph_->nodes.resize(descriptions.size());
        for (Index node = 0; node < descriptions.size(); ++node) {
            nodeNamed_.emplace(descriptions[node].name, node);
            graph_->nodes[node].type = findType(descriptions[node]);
        }
    }

    const PassType* findType(const NodeDescription& node) {
        const auto [entry, isNew] = types_.emplace(node.passType, nullptr);
        if (isNew) {
            try {
                entry->second = passTypes_.find(node.passType);
                if (entry->second == nullptr) unknownTypes_.emplace(node.passType, true);
            } catch (const InputError& error) {
                for (const Diagnostic& fault : error.faults()) diagnostics_.error(fault.where, fault.message);
            }
        }
        if (entry->second == nullptr && unknownTypes_.count(node.passType) > 0) {
            diagnostics_.error(node.wherePass, fmt::format("unknown pass {}{}", inQuotes(node.passType),
                                                           suggestionForPass(node.passType)));
        }
        return entry->second;
    }

    std::string suggestionForPass(std::string_view name) const {
        if (diagnostics_.errors().size() >= faultsWithSuggestion) return {};
        const std::vector<std::string> known = passTypes_.names();
        return suggestion(name, std::span<const std::string>(known));
    }

    /// The node and output of a reference; the node alone if only the output is unknown; each with a fault.
    LinkedInput resolve(const PortReference& reference) {
        const auto& descriptions = graph_->description.nodes;
        const auto found = nodeNamed_.find(reference.node);
        if (found == nodeNamed_.end()) {
            const bool suggest = diagnostics_.errors().size() < faultsWithSuggestion;
            diagnostics_.error(reference.where,
                               fmt::format("unknown node {}{}", inQuotes(reference.node),
                                           suggest ? suggestionAmong(reference.node, descriptions) : ""));
            return {};
        }
        const Index node = found->second;
        const PassType* type = graph_->nodes[node].type;
        if (type == nullptr) return {node, noIndex};
        const OutputPort* port = findNamed(type->outputs, reference.port);
        if (port == nullptr) {
            diagnostics_.error(
                reference.where,
                fmt::format("{} (pass {}) has no output {}{}", inQuotes(reference.node), inQuotes(type->name),
                            inQuotes(reference.port), suggestionAmong(reference.port, type->outputs)));
            return {node, noIndex};
        }
        return {node, static_cast<Index>(port - type->outputs.data())};
    }

    void linkInputs(Index node) {
        const NodeDescription& description = graph_->description.nodes[node];
        LinkedNode& linked = graph_->nodes[node];
        linked.inputs.first = static_cast<Index>(graph_->inputs.size());
        linked.inputs.count = linked.type == nullptr ? 0 : static_cast<Index>(linked.type->inputs.size());
        graph_->inputs.resize(graph_->inputs.size() + linked.inputs.count);
        std::vector<bool> connected(linked.inputs.count, false);
        for (const auto& [name, reference] : description.inputs) {
            const LinkedInput source = resolve(reference);
            if (source.sourceNode != noIndex) dependencies_.push_back({source.sourceNode, node});
            if (linked.type == nullptr) continue;
            const InputPort* port = findNamed(linked.type->inputs, name);
            if (port == nullptr) {
                diagnostics_.error(reference.whereKey,
                                   fmt::format("the pass {} has no input {}{}", inQuotes(linked.type->name),
                                               inQuotes(name), suggestionAmong(name, linked.type->inputs)));
                continue;
            }
            const auto index = static_cast<std::size_t>(port - linked.type->inputs.data());
            connected[index] = true;
            graph_->inputs[linked.inputs.first + index] = source;
            if (source.sourcePort != noIndex) checkConnection(*port, source, reference);
        }
        if (linked.type != nullptr) checkRequiredInputs(description, *linked.type, connected);
    }

    void checkConnection(const InputPort& input, const LinkedInput& source, const PortReference& reference) {
        const OutputPort& output = graph_->nodes[source.sourceNode].type->outputs[source.sourcePort];
        const auto sort = [](const std::string& element, bool isInteger) -> std::string {
            if (!element.empty()) return fmt::format("a buffer of {}", element);
            return isInteger ? "an image of unsigned integers (r32u)" : "an image of floats";
        };
        const bool expectsInteger = input.format && info(*input.format).isUnsignedInteger;
        const std::string expected = sort(input.bufferElement, expectsInteger);
        const std::string found = sort(output.bufferElement, info(output.format).isUnsignedInteger);
        if (expected == found) return;
        diagnostics_.error(reference.where,
                           fmt::format("{} expects {}, but {}.{} is {}", inQuotes(input.name), expected,
                                       reference.node, reference.port, found));
    }

    void checkRequiredInputs(const NodeDescription& node, const PassType& type,
                             const std::vector<bool>& connected) {
        for (std::size_t i = 0; i < type.inputs.size(); ++i) {
            if (connected[i] || type.inputs[i].optional) continue;
            diagnostics_.error(node.where, fmt::format("the input {} of {} (pass {}) is not connected",
                                                       inQuotes(type.inputs[i].name), inQuotes(node.name),
                                                       inQuotes(type.name)));
        }
    }

    void linkSize(Index node) {
        const auto& size = graph_->description.nodes[node].size;
        if (!size || size->kind != SizeRule::Kind::Like) return;
        const auto reference = readPortReference(size->like, size->where, diagnostics_);
        if (!reference) return;
        const LinkedInput source = resolve(*reference);
        if (source.sourceNode != noIndex) dependencies_.push_back({source.sourceNode, node});
        graph_->nodes[node].sizeLikeNode = source.sourceNode;
        graph_->nodes[node].sizeLikePort = source.sourcePort;
        if (source.sourcePort == noIndex) return;
        if (!graph_->nodes[source.sourceNode].type->outputs[source.sourcePort].bufferElement.empty()) {
            diagnostics_.error(size->where,
                               fmt::format("{} is a buffer and has no size in pixels", inQuotes(size->like)));
        }
    }

    void linkFormats(Index node) {
        const NodeDescription& description = graph_->description.nodes[node];
        LinkedNode& linked = graph_->nodes[node];
        linked.formats.first = static_cast<Index>(graph_->formats.size());
        linked.formats.count = static_cast<Index>(linked.type->outputs.size());
        for (const OutputPort& output : linked.type->outputs) graph_->formats.push_back(output.format);
        for (const FormatOverride& change : description.formats) {
            const OutputPort* port = findNamed(linked.type->outputs, change.port);
            if (port == nullptr) {
                diagnostics_.error(
                    change.where,
                    fmt::format("the pass {} has no output {}{}", inQuotes(linked.type->name),
                                inQuotes(change.port), suggestionAmong(change.port, linked.type->outputs)));
            } else if (formatFits(*port, change)) {
                graph_->formats[linked.formats.first +
                                static_cast<std::size_t>(port - linked.type->outputs.data())] = change.format;
            }
        }
    }

    /// The shader was written for floats, for unsigned integers or for depth: a format may change within
    /// these only.
    bool formatFits(const OutputPort& port, const FormatOverride& change) {
        const FormatInfo& from = info(port.format);
        const FormatInfo& to = info(change.format);
        if (!port.bufferElement.empty()) {
            diagnostics_.error(change.where,
                               fmt::format("{} is a buffer and has no pixel format", inQuotes(port.name)));
            return false;
        }
        if (from.isDepth == to.isDepth && from.isUnsignedInteger == to.isUnsignedInteger) return true;
        diagnostics_.error(change.where, fmt::format("{} has the format {}, which cannot be changed to {}",
                                                     inQuotes(port.name), from.name, to.name));
        return false;
    }

    void linkOutputs() {
        for (const auto& [name, reference] : graph_->description.outputs) {
            const LinkedInput source = resolve(reference);
            graph_->outputs.push_back({name, source.sourceNode, source.sourcePort, reference.where});
        }
    }

    void order() {
        NodeOrder order = orderNodes(static_cast<Index>(graph_->nodes.size()), dependencies_);
        for (const std::vector<Index>& cycle : order.cycles) {
            std::string path;
            for (const Index node : cycle) path += graph_->nodeName(node) + " -> ";
            path += graph_->nodeName(cycle.front());
            diagnostics_.error(whereReads(cycle.front(), cycle.back()),
                               fmt::format("{} needs its own result, the cycle is {}",
                                           inQuotes(graph_->nodeName(cycle.front())), path));
        }
        graph_->declarationOrder = std::move(order.nodes);
    }

    /// Where `reader` names `source`.
    SourceLocation whereReads(Index reader, Index source) const {
        const NodeDescription& description = graph_->description.nodes[reader];
        for (const auto& [name, reference] : description.inputs) {
            if (reference.node == graph_->nodeName(source)) return reference.where;
        }
        return description.size ? description.size->where : description.where;
    }

    std::shared_ptr<LinkedGraph> graph_;
    const PassLibrary& passTypes_;
    Diagnostics diagnostics_;
    std::unordered_map<std::string_view, Index> nodeNamed_;
    std::unordered_map<std::string_view, const PassType*> types_;
    std::unordered_map<std::string_view, bool> unknownTypes_;
    std::vector<Dependency> dependencies_;
};

}  // namespace

std::shared_ptr<const LinkedGraph> link(GraphDescription description, const PassLibrary& passTypes) {
    return Linker(std::move(description), passTypes).link();
}

}  // namespace nephrite::graph
