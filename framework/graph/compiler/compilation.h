// What the compiler's phases hand to each other: flat arrays indexed by node, by linked input or by output
// port.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "graph/compile.h"
#include "graph/compiler/expression_values.h"

namespace nephrite::graph {

/// Whether a node's own conditions let it run.
enum class Switch : std::uint8_t { On, OffByWhen, OffBySkipWhen };

/// One use of a resource by a pass; pass == Plan::passes.size() is what follows the last pass.
struct PassUse {
    Index resource = noIndex;
    Index pass = noIndex;
    Use use = Use::None;
};

/// Where an expression of a port is written, or the port if the manifest leaves the expression out.
const SourceLocation& whereOf(const Expression& expression, const OutputPort& port);

struct Compilation {
    explicit Compilation(const CompileRequest& compileRequest);

    const CompileRequest& request;
    const LinkedGraph& graph;
    Plan plan;
    Diagnostics faults;

    std::vector<LinkedOutput> requested;  ///< graph outputs, then dumps

    std::vector<Switch> switches;           ///< by node
    std::vector<std::uint32_t> iterations;  ///< by node; 0 where it only clears or does nothing

    std::vector<std::uint8_t>
        inputIsNeutral;  ///< by linked input: unconnected, or its source is switched off
    std::vector<std::uint8_t>
        inputIsRead;  ///< by linked input: its node reads the source's image if it is needed

    std::vector<Extent> extents;   ///< by output port
    std::vector<Index> resources;  ///< by output port: index into Plan::resources or noIndex

    std::vector<PassUse> uses;          ///< sorted by resource, then pass
    std::vector<Range> usesOfResource;  ///< in `uses`

    ExpressionValues values;

    Index portIndex(Index node, Index port) const { return graph.nodes[node].formats.first + port; }
    const NodeDescription& description(Index node) const { return graph.description.nodes[node]; }
    const PassType& typeOf(Index node) const { return *graph.nodes[node].type; }
    /// The value of a condition; NaN is a fault.
    bool holds(Index node, const Expression& condition);
};

}  // namespace nephrite::graph
