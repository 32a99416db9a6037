// Evaluates expressions at a node: parameters, graph parameters, scene facts and which inputs are neutral.
// Names are looked up once an expression, not once a node, so a manifest's expressions cost no string work
// per pass.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "graph/linked_graph.h"

namespace nephrite::graph {

struct SceneFacts;

class ExpressionValues {
  public:
    /// The references must outlive the object; `inputIsNeutral` has an entry for each of graph.inputs.
    ExpressionValues(const LinkedGraph& graph, const ParameterValues& parameters, const SceneFacts& facts,
                     std::span<const std::uint8_t> inputIsNeutral);

    /// The value of `expression` at `node`. Throws InputError for a name that does not exist.
    double at(Index node, const Expression& expression);
    /// The same for a number of things: cut to a whole number, as integer division does. Rounding errors of
    /// the expression's own arithmetic do not lose a whole one.
    double countAt(Index node, const Expression& expression);

  private:
    struct ResolvedName {
        ExpressionName::Space space{};
        Index index = 0;  ///< of the parameter, graph parameter or input
        Index element = 0;
        double fact = 0;  ///< a scene fact's value
    };
    const std::vector<ResolvedName>& resolve(Index node, const Expression& expression);
    ResolvedName resolve(Index node, const ExpressionName& name);
    double valueOf(Index node, const ResolvedName& name) const;

    const LinkedGraph& graph_;
    const ParameterValues& parameters_;
    const SceneFacts& facts_;
    std::span<const std::uint8_t> inputIsNeutral_;
    Index graphParameterNamed(std::string_view name);
    std::unordered_map<std::string_view, Index> graphParameters_;  ///< filled when first asked
    std::unordered_map<const Expression*, std::vector<ResolvedName>> resolved_;
};

}  // namespace nephrite::graph
