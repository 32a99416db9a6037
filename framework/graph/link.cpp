// Every name of a description looked up, every fault collected.
#include <fmt/format.h>

#include <unordered_map>

#include "graph/link_parameters.h"
#include "graph/link_phases.h"
#include "graph/manifest_roles.h"
#include "graph/value_readers.h"

namespace nephrite::graph {
namespace {

/// Searching the nearest of n names for each of n faults would take n * n steps: the first faults get
/// suggestions.
constexpr std::size_t faultsWithSuggestion = 100;

std::shared_ptr<LinkedGraph> graphOf(GraphDescription description) {
    auto graph = std::make_shared<LinkedGraph>();
    graph->description = std::move(description);
    return graph;
}

class Linker {
  public:
    Linker(GraphDescription description, const PassLibrary& passTypes)
        : graph_(graphOf(std::move(description))),
          passTypes_(passTypes),
          parameters_(*graph_, diagnostics_) {}

    std::shared_ptr<const LinkedGraph> link() {
        nameNodes();
        for (Index node = 0; node < graph_->nodes.size(); ++node) {
            if (graph_->nodes[node].role == NodeRole::Pass && graph_->nodes[node].type != nullptr)
                linkOwn(node);
        }
        for (Index node = 0; node < graph_->nodes.size(); ++node) {
            if (graph_->nodes[node].role != NodeRole::Pass) continue;
            linkInputs(node);
            linkSize(node);
        }
        linkOutputs();
        addTileLists(*graph_);
        LinkWork work{*graph_, diagnostics_, std::move(references_)};
        work.references.resize(graph_->inputs.size(), nullptr);
        checkModifiers(work);
        indexGraph(*graph_);
        orderDeclarations(work);
        diagnostics_.throwIfErrors();
        inheritFormats(*graph_);
        return graph_;
    }

  private:
    void nameNodes() {
        const auto nodeCount = static_cast<Index>(graph_->description.nodes.size());
        graph_->nodes.resize(nodeCount);
        addImports(*graph_);
        const auto& descriptions = graph_->description.nodes;
        for (Index node = 0; node < descriptions.size(); ++node) {
            const auto [other, isNew] = nodeNamed_.emplace(descriptions[node].name, node);
            if (!isNew) {
                diagnostics_.error(descriptions[node].where,
                                   fmt::format("two nodes are called {}", inQuotes(descriptions[node].name)));
            }
            if (node < nodeCount) graph_->nodes[node].type = findType(descriptions[node]);
        }
    }

    /// What concerns the node and its type alone.
    void linkOwn(Index node) {
        linkFormats(*graph_, node, diagnostics_);
        parameters_.linkParameters(node);
        parameters_.checkExpressions(node);
        linkIteration(node);
    }

    void linkIteration(Index node) {
        const NodeDescription& description = graph_->description.nodes[node];
        LinkedNode& linked = graph_->nodes[node];
        linked.forEach = description.forEach.value_or(linked.type->forEach);
        if (description.view == ViewKind::Light && linked.forEach != ForEach::Lights) {
            diagnostics_.error(description.whereView,
                               "a node with the view \"light\" needs \"forEach\": \"lights\"");
        }
        if (description.forEach != ForEach::Mips) return;
        if (const auto fault = whyNotForEachMip(*linked.type)) {
            diagnostics_.error(description.whereForEach,
                               fmt::format("the pass {} cannot run for each mip: {}",
                                           inQuotes(linked.type->name), fault->message));
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
        const auto found = nodeNamed_.find(reference.node);
        if (found == nodeNamed_.end()) {
            diagnostics_.error(reference.where, whyUnknown(reference));
            return {};
        }
        LinkedInput source;
        source.sourceNode = found->second;
        const PassType* type = graph_->nodes[source.sourceNode].type;
        source.framesBack = static_cast<std::uint16_t>(reference.framesBack);
        if (type == nullptr) return source;
        const OutputPort* port = findNamed(type->outputs, reference.port);
        if (port == nullptr) {
            diagnostics_.error(
                reference.where,
                fmt::format("{} (pass {}) has no output {}{}", inQuotes(reference.node), inQuotes(type->name),
                            inQuotes(reference.port), suggestionAmong(reference.port, type->outputs)));
            return source;
        }
        source.sourcePort = static_cast<Index>(port - type->outputs.data());
        if (auto fault = faultOfView(*graph_, reference, source))
            diagnostics_.error(reference.where, std::move(*fault));
        return source;
    }

    std::string whyUnknown(const PortReference& reference) const {
        const bool suggest = diagnostics_.errors().size() < faultsWithSuggestion;
        return unknownNode(graph_->description, reference, suggest);
    }

    void linkInputs(Index node) {
        const NodeDescription& description = graph_->description.nodes[node];
        LinkedNode& linked = graph_->nodes[node];
        linked.inputs.first = static_cast<Index>(graph_->inputs.size());
        linked.inputs.count = linked.type == nullptr ? 0 : static_cast<Index>(linked.type->inputs.size());
        graph_->inputs.resize(graph_->inputs.size() + linked.inputs.count);
        references_.resize(graph_->inputs.size(), nullptr);
        std::vector<bool> connected(linked.inputs.count, false);
        for (const auto& [name, reference] : description.inputs) {
            const LinkedInput source = resolve(reference);
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
            references_[linked.inputs.first + index] = &reference;
            if (source.sourcePort != noIndex) checkConnection(*port, source, reference);
        }
        if (linked.type != nullptr) checkRequiredInputs(description, *linked.type, connected);
    }

    void checkConnection(const InputPort& input, const LinkedInput& source, const PortReference& reference) {
        const LinkedNode& from = graph_->nodes[source.sourceNode];
        const OutputPort& output = from.type->outputs[source.sourcePort];
        const Format format = graph_->formats[from.formats.first + source.sourcePort];
        const std::string expected = sortOf(input);
        const std::string found = sortOf(output, format);
        if (expected == found) return;
        diagnostics_.error(reference.where,
                           fmt::format("{} expects {}, but {} is {}", inQuotes(input.name), expected,
                                       graph_->portName(source.sourceNode, source.sourcePort), found));
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
        graph_->nodes[node].sizeLikeNode = source.sourceNode;
        graph_->nodes[node].sizeLikePort = source.sourcePort;
        if (source.sourcePort == noIndex) return;
        if (!graph_->nodes[source.sourceNode].type->outputs[source.sourcePort].bufferElement.empty()) {
            diagnostics_.error(size->where,
                               fmt::format("{} is a buffer and has no size in pixels", inQuotes(size->like)));
        }
    }

    void linkOutputs() {
        for (const auto& [name, reference] : graph_->description.outputs) {
            const LinkedInput source = resolve(reference);
            graph_->outputs.push_back({name, source.sourceNode, source.sourcePort, reference.where,
                                       source.framesBack, source.mip, source.layer});
        }
    }

    std::shared_ptr<LinkedGraph> graph_;
    const PassLibrary& passTypes_;
    Diagnostics diagnostics_;
    std::unordered_map<std::string_view, Index> nodeNamed_;
    std::unordered_map<std::string_view, const PassType*> types_;
    std::unordered_map<std::string_view, bool> unknownTypes_;
    ParameterLinker parameters_;
    std::vector<const PortReference*> references_;  ///< by linked input
};

}  // namespace

std::shared_ptr<const LinkedGraph> link(GraphDescription description, const PassLibrary& passTypes) {
    return Linker(std::move(description), passTypes).link();
}

}  // namespace nephrite::graph
