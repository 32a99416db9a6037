// A node's parameters and the names in its expressions looked up.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>

#include "graph/linked_graph.h"

namespace nephrite::graph {

/// Why a parameter cannot take its value from a graph parameter, or nothing.
std::optional<std::string> whyNotLinked(const GraphParameter& parameter,
                                        const ParameterDeclaration& declaration);

class ParameterLinker {
  public:
    /// `graph` must outlive this; the parameters of its nodes are appended to graph.parameters.
    ParameterLinker(LinkedGraph& graph, Diagnostics& diagnostics);

    /// Links the settings of a node whose type is known.
    void linkParameters(Index node);
    /// Checks the names in a node's "when" and "size".
    void checkExpressions(Index node);

  private:
    void applySetting(const ParameterSetting& setting, Index node);
    void useGraphParameter(const std::string& name, const ParameterDeclaration& declaration,
                           LinkedParameter& linked);
    const GraphParameter* findGraphParameter(std::string_view name, const SourceLocation& where);

    LinkedGraph& graph_;
    Diagnostics& diagnostics_;
    std::unordered_map<std::string_view, Index> graphParameters_;
};

}  // namespace nephrite::graph
