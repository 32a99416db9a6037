// A plan's passes, reads and order held against what the graph asks for.
#include <fmt/format.h>

#include <algorithm>

#include "graph/plan_oracle_truth.h"

namespace nephrite::graph::tests {
namespace {

bool overlap(std::uint16_t a, std::uint16_t b) {
    return a == every || b == every || a == b;
}

class DecisionCheck {
  public:
    DecisionCheck(const GraphTruth& truth, const Plan& plan, std::vector<std::string>& findings)
        : truth_(truth), plan_(plan), findings_(findings), passOf_(plan.nodes.size(), noIndex) {}

    void check() {
        if (!indexPasses()) return;
        for (Index node = 0; node < plan_.nodes.size(); ++node) checkNode(node);
        for (const PlannedPass& pass : plan_.passes) {
            checkReads(pass);
            checkModifiers(pass);
        }
        checkRequested();
    }

  private:
    const LinkedNode& linked(Index node) const { return truth_.graph().nodes[node]; }
    void report(Index node, const std::string& what) {
        findings_.push_back(truth_.graph().nodeName(node) + ": " + what);
    }

    bool indexPasses() {
        if (plan_.nodes.size() != truth_.graph().nodes.size()) {
            findings_.push_back("not one decision for each node");
            return false;
        }
        for (Index i = 0; i < plan_.passes.size(); ++i) {
            Index& pass = passOf_[plan_.passes[i].node];
            if (pass != noIndex) report(plan_.passes[i].node, "has two passes");
            pass = i;
        }
        return true;
    }

    void checkNode(Index node) {
        const bool hasPass = passOf_[node] != noIndex;
        const bool isImport = linked(node).role == NodeRole::Import;
        const NodeState state = plan_.nodes[node].state;
        if (truth_.runs(node)) {
            if (state != NodeState::Run) report(node, fmt::format("is needed, but {}", name(state)));
            if (hasPass == isImport)
                report(node, isImport ? "an import has a pass" : "is needed, but has no pass");
            if (!hasPass) return;
            if ((plan_.passes[passOf_[node]].iterations == 0) != truth_.lacksLight(node))
                report(node, "runs without iterations, or with some although there is no light");
            return;
        }
        if (hasPass != truth_.isCleared(node))
            report(node,
                   hasPass ? "is dead, but has a pass" : "its cleared output is wanted, but it has no pass");
        if (hasPass && plan_.passes[passOf_[node]].iterations != 0) report(node, "runs although it is off");
        // Either is true of a node that is off and that nobody wants.
        const bool isSkipped = truth_.isRefused(node) || truth_.isWanted(node) || truth_.isCleared(node);
        if (!isSkipped && (truth_.isOff(node) || truth_.isRefusedBehindOther(node))) return;
        if (state != (isSkipped ? NodeState::Skipped : NodeState::Culled))
            report(node, fmt::format("is {}", name(state)));
    }

    /// A running pass reads exactly the inputs that are needed and whose source runs.
    void checkReads(const PlannedPass& pass) {
        const LinkedNode& node = linked(pass.node);
        for (Index i = 0; i < node.inputs.count; ++i) {
            const InputRead& read = plan_.inputs[pass.inputs.first + i];
            const Version source = truth_.sourceOf(pass.node, i);
            const bool mayRead = pass.iterations > 0 && source.node != noIndex &&
                                 !truth_.isOff(source.node) && truth_.needs(pass.node, i);
            if (!mayRead) {
                if (read.resource != noIndex) report(pass.node, fmt::format("reads its input {}", i));
                continue;
            }
            if (read.resource == noIndex) {
                report(pass.node, fmt::format("does not read its input {}", i));
                continue;
            }
            checkResource(pass.node, read.resource, source, read.mip, read.layer);
            const bool isSourceEarlier = linked(source.node).role == NodeRole::Import ||
                                         source.framesBack > 0 || passOf_[source.node] < passOf_[pass.node];
            if (!isSourceEarlier) report(pass.node, fmt::format("runs before the source of its input {}", i));
        }
        const Index tiles = node.tileList;
        if ((pass.tileList != noIndex) != (pass.iterations > 0 && truth_.isTiled(pass.node)))
            report(pass.node, "computes only some tiles and should not, or the other way round");
        if (pass.tileList == noIndex) return;
        if (tiles == noIndex || passOf_[tiles] >= passOf_[pass.node])
            report(pass.node, "its tiles are not listed");
        if (tiles != noIndex && plan_.resources[pass.tileList].node != tiles)
            report(pass.node, "computes another image's tiles");
    }

    void checkResource(Index node, Index index, Version source, std::uint16_t mip, std::uint16_t layer) {
        const Resource& resource = plan_.resources[index];
        const Version root = truth_.rootOf(source);
        const bool isSame = resource.node == root.node && resource.port == root.port &&
                            resource.framesBack == source.framesBack;
        if (!isSame) report(node, fmt::format("reads {}", plan_.nameOf(resource)));
        if (mip != source.mip || layer != source.layer) report(node, "reads another level or layer");
        if (source.framesBack > 0 && resource.kind != ResourceKind::History)
            report(node, "reads earlier frames' contents of what keeps none");
    }

    /// Whoever reads what a pass overwrites has read it before.
    void checkModifiers(const PlannedPass& pass) {
        if (pass.iterations == 0) return;
        for (Index port = 0; port < pass.outputs.count; ++port) {
            const Version version = truth_.modifiedBy(pass.node, port);
            if (version.node == noIndex) continue;
            for (const PlannedPass& reader : plan_.passes) {
                if (reader.node == pass.node || reader.iterations == 0) continue;
                if (reads(reader, version) && passOf_[reader.node] > passOf_[pass.node])
                    report(reader.node, fmt::format("reads after {} has modified it", plan_.nameOf(pass)));
            }
        }
    }

    bool reads(const PlannedPass& reader, const Version& version) const {
        for (Index i = 0; i < linked(reader.node).inputs.count; ++i) {
            const Version source = truth_.sourceOf(reader.node, i);
            const bool isRead = source.node != noIndex && source.isSame(version) &&
                                overlap(source.mip, version.mip) && overlap(source.layer, version.layer);
            if (isRead && truth_.needs(reader.node, i)) return true;
        }
        return false;
    }

    void checkRequested() {
        const auto& wanted = truth_.requested();
        if (plan_.requested.size() != wanted.size())
            findings_.push_back("not as many outputs as are requested");
        for (std::size_t i = 0; i < std::min(wanted.size(), plan_.requested.size()); ++i) {
            const RequestedOutput& output = plan_.requested[i];
            if (output.resource == noIndex) {
                report(wanted[i].node, "is requested, but not there");
                continue;
            }
            checkResource(wanted[i].node, output.resource, wanted[i], output.mip, output.layer);
            if (!plan_.resources[output.resource].requested)
                report(wanted[i].node, "is not marked as requested");
        }
    }

    const GraphTruth& truth_;
    const Plan& plan_;
    std::vector<std::string>& findings_;
    std::vector<Index> passOf_;
};

}  // namespace

void checkAgainstTruth(const GraphTruth& truth, const Plan& plan, std::vector<std::string>& findings) {
    DecisionCheck(truth, plan, findings).check();
}

}  // namespace nephrite::graph::tests
