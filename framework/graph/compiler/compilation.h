// What the compiler's phases hand to each other: flat arrays indexed by node, by linked input or by output
// port.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "graph/compile.h"
#include "graph/compiler/arena.h"
#include "graph/compiler/expression_values.h"

namespace nephrite::graph {

/// Whether a node's own conditions let it run.
enum class Switch : std::uint8_t { On, OffByWhen, OffBySkipWhen };

/// Where an expression of a port is written, or the port if the manifest leaves the expression out.
const SourceLocation& whereOf(const Expression& expression, const OutputPort& port);

/// A size that no image can have.
struct RefusedExtent {
    Index node = noIndex;
    Diagnostic fault;
};

struct Compilation {
    explicit Compilation(const CompileRequest& compileRequest);

    Arena<16384> arena;  ///< of all the arrays here; phases use it for their own too

    const CompileRequest& request;
    const LinkedGraph& graph;
    const ParameterValues& parameters;
    Plan plan;
    Diagnostics faults;

    std::vector<LinkedOutput> dumps;
    std::pmr::vector<const LinkedOutput*> requested;  ///< graph outputs, then dumps

    std::pmr::vector<Switch> switches;           ///< by node
    std::pmr::vector<std::uint32_t> iterations;  ///< by node; 0 where it only clears or does nothing

    std::pmr::vector<std::uint8_t>
        inputIsNeutral;  ///< by linked input: unconnected, or its source is switched off
    std::pmr::vector<std::uint8_t>
        inputIsRead;  ///< by linked input: its node reads the source's image if it is needed
    std::pmr::vector<Index>
        forwards;  ///< by output port, if the graph has modifiers: the port whose contents it has
                   ///< (itself, unless its node is switched off), or noIndex if they are neutral
    std::pmr::vector<Index> nodeOfPort;  ///< by output port, if the graph has modifiers

    std::pmr::vector<Extent> extents;                ///< by output port
    std::pmr::vector<RefusedExtent> refusedExtents;  ///< faults, if their nodes run
    std::pmr::vector<std::uint8_t> isTiled;          ///< by node, if the graph has domains: usesTileList()
    std::pmr::vector<Index> resources;  ///< by output port: index into Plan::resources or noIndex
    std::pmr::vector<Index> older;      ///< by resource, if there is history: the same port one frame earlier

    std::pmr::vector<Index> order;   ///< the nodes that become passes
    std::pmr::vector<Index> passOf;  ///< by node: index into Plan::passes or noIndex
    std::pmr::vector<Index>
        levelStarts;  ///< by pass: the first pass of its level; empty: each is a level of its own
    std::pmr::vector<Index> placedAfter;  ///< by node: the source that kept it from standing earlier

    ExpressionValues values;

    std::pmr::memory_resource* memory() { return arena.memory(); }
    Index portIndex(Index node, Index port) const { return graph.nodes[node].formats.first + port; }
    /// The linked input that an output port modifies, or noIndex.
    Index modifiedBy(Index port) const { return graph.hasModifiers ? graph.modifies[port] : noIndex; }
    const NodeDescription& description(Index node) const { return graph.description.nodes[node]; }
    const PassType& typeOf(Index node) const { return *graph.nodes[node].type; }
    bool runs(Index node) const { return plan.nodes[node].state == NodeState::Run; }
    /// The port whose contents an input's source has: another one where the source passes its own input
    /// through; noIndex if they are neutral.
    Index contentsOf(const LinkedInput& input) const {
        const Index port = portIndex(input.sourceNode, input.sourcePort);
        return forwards.empty() ? port : forwards[port];
    }
    /// The node of that port; noIndex if the contents are neutral.
    Index sourceOf(const LinkedInput& input) const {
        if (forwards.empty()) return input.sourceNode;
        const Index port = contentsOf(input);
        return port == noIndex ? noIndex : nodeOfPort[port];
    }
    /// True if the node computes only the tiles of its domain.
    bool usesTileList(Index node) const { return !isTiled.empty() && isTiled[node] != 0; }
    /// The value of a condition; NaN is a fault.
    bool holds(Index node, const Expression& condition);
};

}  // namespace nephrite::graph
