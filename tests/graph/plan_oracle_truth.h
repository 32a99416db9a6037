// What a graph asks for, derived from its description alone: which nodes must run and where each input really
// comes from.
#pragma once

#include <optional>
#include <vector>

#include "graph/compile.h"

namespace nephrite::graph::tests {

/// A version of a port's contents: what `node` left in it.
struct Version {
    Index node = noIndex;  ///< noIndex: unconnected
    Index port = noIndex;
    std::uint16_t framesBack = 0;
    std::uint16_t mip = every;
    std::uint16_t layer = every;

    bool isSame(const Version& other) const {
        return node == other.node && port == other.port && framesBack == other.framesBack;
    }
};

class GraphTruth {
  public:
    /// Of the plan it only takes the sizes of passes and of what they read.
    GraphTruth(const CompileRequest& request, const Plan& plan);

    /// Switched off by its "when", or by its skipWhen where skipping is allowed.
    bool isOff(Index node) const { return off_[node] != 0; }
    /// An output of it is wanted although it is off: it is cleared.
    bool isCleared(Index node) const { return cleared_[node] != 0; }
    bool runs(Index node) const { return runs_[node] != 0; }
    /// It runs, but without a light there is nothing to run it over.
    bool lacksLight(Index node) const;
    /// A node that runs and reads would read it, if it needed that input.
    bool isRefused(Index node) const { return (refused_[node] & 1) != 0; }
    /// The same where the one that is read is off and would only pass this node's result on.
    bool isRefusedBehindOther(Index node) const { return (refused_[node] & 2) != 0; }

    /// It computes only the tiles of its domain: skipping is allowed, the domain is there and has the pass's
    /// texels.
    bool isTiled(Index node) const;

    /// A node that runs needs it.
    bool isWanted(Index node) const { return wanted_[node] != 0; }

    const LinkedGraph& graph() const { return graph_; }
    Version sourceOf(Index node, Index input) const;
    /// Whether the node reads that input when it runs.
    bool needs(Index node, Index input) const;
    /// The port that a version's resource belongs to: that of its first writer.
    Version rootOf(Version version) const;
    const std::vector<Version>& requested() const { return requested_; }
    /// The version that an output modifies when its node runs, or one without a node.
    Version modifiedBy(Index node, Index port) const;

  private:
    Version resolve(Version version) const;
    double valueOf(Index node, const ExpressionName& name) const;
    bool holds(const Expression& expression, Index node) const;
    bool isNeutral(Index node, std::string_view input) const;
    void decideOff();
    void request(Version version);
    void demandFromRoots();
    void demand(Index node);
    void demandSources(Index node);

    const CompileRequest& request_;
    const Plan& plan_;
    const LinkedGraph& graph_;
    const ParameterValues& values_;
    std::vector<const PlannedPass*> passes_;  ///< by node
    std::vector<std::uint8_t> off_, cleared_, runs_, refused_, wanted_;
    std::vector<Version> requested_;
    std::vector<Index> waiting_;  ///< nodes that run and whose sources are not yet demanded
};

/// The faults of a plan against the truth: nodes that run for nothing or are missing, inputs that read
/// something else, passes in an order that their data forbids.
void checkAgainstTruth(const GraphTruth& truth, const Plan& plan, std::vector<std::string>& findings);

}  // namespace nephrite::graph::tests
