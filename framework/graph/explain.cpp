// The reasons of a plan in words. Everything is read off the plan; nothing is decided here.
#include "graph/explain.h"

#include <fmt/format.h>

#include <algorithm>

#include "graph/plan_words.h"
#include "graph/value_readers.h"

namespace nephrite::graph {
namespace {

class Explanation {
  public:
    explicit Explanation(const Plan& plan) : plan_(plan), passes_(passOfNode(plan)) {}

    std::string ofNode(Index node) {
        const std::string& nodeName = plan_.graph->nodeName(node);
        line(fmt::format("{}: {}: {}", nodeName, name(plan_.nodes[node].state), whyOf(plan_, node)));
        if (passes_[node] == noIndex) return text_;
        const PlannedPass& pass = plan_.passes[passes_[node]];
        line("  " + whyItStandsThere(pass));
        if (pass.tileList != noIndex)
            line(fmt::format(
                "  computes only the tiles listed in {}: outside its domain its outputs are neutral",
                nameOf(pass.tileList)));
        explainBarriersBefore(pass);
        for (const Index output : slice(plan_.outputs, pass.outputs)) explainMemory(output);
        return text_;
    }

    std::string ofResource(Index resource) {
        const Resource& r = plan_.resources[resource];
        line(fmt::format("{}: {}, {}, {}", nameOf(resource), formatName(plan_, r), sizeInWords(r),
                         bytesInWords(r.bytes)));
        if (r.first != noIndex)
            line(fmt::format("  used from {} to {}{}", passInWords(r.first), passInWords(r.last),
                             r.requested ? ", then copied out" : ""));
        explainMemory(resource);
        for (const Barrier& barrier : plan_.schedule.barriers) {
            if (barrier.resource == resource) explainBarrier(barrier);
        }
        return text_;
    }

    std::string ofMissing(Index node, const std::string& port) {
        line(fmt::format("{}: has no memory: \"{}\" {}: {}", port, plan_.graph->nodeName(node),
                         name(plan_.nodes[node].state), whyOf(plan_, node)));
        return text_;
    }

  private:
    void line(const std::string& words) { text_ += words + "\n"; }
    std::string nameOf(Index resource) const { return plan_.nameOf(plan_.resources[resource]); }
    std::string passInWords(Index pass) const { return graph::passInWords(plan_, pass); }

    std::string whyItStandsThere(const PlannedPass& pass) const {
        const auto index = static_cast<Index>(&pass - plan_.passes.data());
        const std::string place = fmt::format("pass {} of {}: ", index, plan_.passes.size());
        const std::string_view rule =
            plan_.policy == Policy::Barriers
                ? "as early as its sources allow, among passes of the same depth as declared"
                : "where the search for a small heap put it";
        if (plan_.nodes[pass.node].state != NodeState::Run)
            return place + "it is only cleared, which nothing waits for, so it comes last";
        if (pass.placedAfter == noIndex) return fmt::format("{}{}; it waits for no other pass", place, rule);
        return fmt::format(
            "{}{}; it cannot come before {}, {}", place, rule, passInWords(pass.placedAfter),
            readsFrom(pass, pass.placedAfter) ? "which it reads" : "which reads what it overwrites");
    }

    bool readsFrom(const PlannedPass& pass, Index source) const {
        const auto outputs = slice(plan_.outputs, plan_.passes[source].outputs);
        const auto wrote = [&](Index resource) {
            return resource != noIndex &&
                   std::find(outputs.begin(), outputs.end(), resource) != outputs.end();
        };
        const auto inputs = slice(plan_.inputs, pass.inputs);
        return wrote(pass.tileList) || std::any_of(inputs.begin(), inputs.end(), [&](const InputRead& read) {
                   return wrote(read.resource);
               });
    }

    /// The barriers that protect what the pass uses; they may stand in an earlier batch.
    void explainBarriersBefore(const PlannedPass& pass) {
        const auto index = static_cast<Index>(&pass - plan_.passes.data());
        for (const Barrier& barrier : plan_.schedule.barriers) {
            if (barrier.passAfter == index) explainBarrier(barrier);
        }
    }

    void explainBarrier(const Barrier& barrier) {
        const std::string part = partInWords(plan_, barrier);
        line(fmt::format("  barrier on {}{}: {}; {}", nameOf(barrier.resource),
                         part.empty() ? "" : fmt::format(" ({})", part), transitionInWords(plan_, barrier),
                         protectionInWords(plan_, barrier)));
    }

    void explainMemory(Index resource) {
        const Resource& r = plan_.resources[resource];
        line(fmt::format("  {} {}{}", nameOf(resource), placeInWords(r), whyKept(resource)));
        if (r.kind != ResourceKind::Transient) return;
        bool shares = false;
        for (Index other = 0; other < plan_.resources.size(); ++other) {
            const Resource& o = plan_.resources[other];
            const bool overlaps = o.offset != Resource::noOffset && r.offset < o.offset + o.bytes &&
                                  o.offset < r.offset + r.bytes;
            if (other == resource || !overlaps) continue;
            shares = true;
            line(fmt::format("    shares bytes with {}, which is used from {} to {}", nameOf(other),
                             passInWords(o.first), passInWords(o.last)));
        }
        if (!shares)
            line("    shares no bytes: nothing else that fits there is needed only before or after it");
    }

    std::string whyKept(Index resource) const {
        const Resource& r = plan_.resources[resource];
        if (r.kind == ResourceKind::History) return ": the next frames read it";
        if (r.kind != ResourceKind::Kept) return "";
        return r.requested ? ": an unchanged frame shows it again"
                           : ": it changes less often than a pass that reads it";
    }

    const Plan& plan_;
    std::vector<Index> passes_;
    std::string text_;
};

Index findNode(const LinkedGraph& graph, const std::string& name) {
    const NodeDescription* node = findNamed(graph.description.nodes, name);
    return node == nullptr ? noIndex : static_cast<Index>(node - graph.description.nodes.data());
}

}  // namespace

std::string explain(const Plan& plan, const std::string& what) {
    Explanation explanation(plan);
    const Index node = findNode(*plan.graph, what);
    if (node != noIndex) return explanation.ofNode(node);
    for (Index i = 0; i < plan.resources.size(); ++i) {
        if (plan.nameOf(plan.resources[i]) == what) return explanation.ofResource(i);
    }
    Diagnostics faults;
    const auto reference = readPortReference(what, {"--why"}, faults);
    if (!reference) {
        const auto& nodes = plan.graph->description.nodes;
        throw InputError({"--why"}, fmt::format("expected NODE or NODE.PORT, found {}{}", inQuotes(what),
                                                suggestionAmong(what, nodes)));
    }
    return explanation.ofMissing(plan.graph->find(*reference).node, what);
}

}  // namespace nephrite::graph
