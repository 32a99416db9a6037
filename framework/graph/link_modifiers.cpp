// Outputs that modify inputs: what they may overwrite, and that nobody asks for what is gone by then.
#include <fmt/format.h>

#include "graph/link_phases.h"
#include "graph/modifiers.h"

namespace nephrite::graph {
namespace {

class ModifierCheck {
  public:
    explicit ModifierCheck(LinkWork& work)
        : work_(work), graph_(work.graph), modifiers_(findModifiers(work.graph)) {}

    void run() {
        bool any = false;
        for (Index node = 0; node < graph_.nodes.size(); ++node) {
            for (Index port = 0; port < graph_.nodes[node].formats.count; ++port)
                any |= checkModifier(node, port);
        }
        if (!any) return;
        for (Index node = 0; node < graph_.nodes.size(); ++node) checkReads(node);
        for (const LinkedOutput& output : graph_.outputs) {
            if (output.node == noIndex || output.port == noIndex) continue;
            if (auto fault = whyGone(graph_, modifiers_, output.view()))
                work_.diagnostics.error(output.where, std::move(*fault));
        }
    }

  private:
    /// False if the output modifies nothing.
    bool checkModifier(Index node, Index port) {
        const LinkedNode& linked = graph_.nodes[node];
        const Index modified = linked.type->outputs[port].modifiedInput;
        if (modified == noIndex) return false;
        const Modifier modifier{node, port, linked.inputs.first + modified};
        const LinkedInput& source = graph_.inputs[modifier.input];
        if (source.sourceNode == noIndex || source.sourcePort == noIndex) return false;
        const std::string name = graph_.portName(node, port);
        const std::string target = graph_.portName(source.sourceNode, source.sourcePort);
        if (source.framesBack > 0) {
            refuse(modifier.input,
                   fmt::format("{} modifies this input, but no earlier frame's {} can be", name, target));
        } else if (graph_.nodes[source.sourceNode].role == NodeRole::Import) {
            refuse(modifier.input,
                   fmt::format("{} modifies this input, but {} is not the graph's to change", name, target));
        } else {
            checkIsOnly(modifier, target);
            checkFits(modifier, target);
        }
        return true;
    }

    void checkIsOnly(const Modifier& modifier, const std::string& target) {
        const LinkedInput& source = graph_.inputs[modifier.input];
        const Modifier& first = modifiers_[graph_.nodes[source.sourceNode].formats.first + source.sourcePort];
        if (first.input == modifier.input) return;
        const std::string name = graph_.nodeName(modifier.node);
        if (first.node == modifier.node) {
            refuse(modifier.input, fmt::format("{} modifies {} twice", inQuotes(name), target));
        } else {
            refuse(modifier.input,
                   fmt::format("{} and {} both modify {}, expected one to modify the other's result",
                               inQuotes(graph_.nodeName(first.node)), inQuotes(name), target));
        }
    }

    void checkFits(const Modifier& modifier, const std::string& target) {
        const LinkedInput& source = graph_.inputs[modifier.input];
        const LinkedNode& from = graph_.nodes[source.sourceNode];
        const LinkedNode& node = graph_.nodes[modifier.node];
        const FormatInfo& found = info(graph_.formats[from.formats.first + source.sourcePort]);
        const FormatInfo& own = info(graph_.formats[node.formats.first + modifier.port]);
        const std::string name = graph_.portName(modifier.node, modifier.port);
        if (found.isDepth != own.isDepth) {
            refuse(modifier.input,
                   fmt::format("{} ({}) cannot modify {} ({})", name, own.name, target, found.name));
        }
        if (node.forEach == ForEach::Lights && from.forEach != ForEach::Lights) {
            refuse(modifier.input,
                   fmt::format("{} is written for every light at once and cannot modify {}, which is not",
                               name, target));
        } else if (node.forEach == ForEach::Lights && source.layer != every) {
            // No barrier stands between the lights: they would overwrite each other's texels.
            refuse(modifier.input,
                   fmt::format("{} is written for every light at once and cannot modify one layer of {}",
                               name, target));
        }
    }

    /// A node may not read what it modifies itself, nor may anybody read an earlier frame's contents that
    /// were overwritten in that frame.
    void checkReads(Index node) {
        const Range inputs = graph_.nodes[node].inputs;
        for (Index input = inputs.first; input < inputs.first + inputs.count; ++input) {
            const LinkedInput& source = graph_.inputs[input];
            if (source.sourceNode == noIndex || source.sourcePort == noIndex) continue;
            const Index port = graph_.nodes[source.sourceNode].formats.first + source.sourcePort;
            if (modifiers_[port].node == noIndex) continue;
            const Modifier* modifier = findOverwriter(graph_, modifiers_, source);
            if (modifier == nullptr || modifier->input == input) continue;
            if (source.framesBack > 0) {
                refuse(input, *whyGone(graph_, modifiers_, source));
            } else if (modifier->node == node && !isModified(node, input)) {
                refuse(input, fmt::format("{} reads {}, which it modifies", inQuotes(graph_.nodeName(node)),
                                          graph_.portName(source.sourceNode, source.sourcePort)));
            }
        }
    }

    bool isModified(Index node, Index input) const {
        for (const OutputPort& output : graph_.nodes[node].type->outputs) {
            if (output.modifiedInput == input - graph_.nodes[node].inputs.first) return true;
        }
        return false;
    }

    void refuse(Index input, std::string message) {
        work_.diagnostics.error(work_.references[input]->where, std::move(message));
    }

    LinkWork& work_;
    LinkedGraph& graph_;
    std::vector<Modifier> modifiers_;
};

}  // namespace

void checkModifiers(LinkWork& work) {
    ModifierCheck(work).run();
}

}  // namespace nephrite::graph
