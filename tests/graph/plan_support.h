// Plans of small graphs written as JSON, and ways to ask about them by name.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "graph/compile.h"

namespace nephrite::graph::tests {

/// A request at 640 x 480 with one light view.
CompileRequest request();

/// The plan of a graph file's text, linked against the pass types of plan_support.cpp.
Plan planOf(std::string_view graph, CompileRequest request = tests::request());
/// The faults planOf() throws, as the lines a user sees.
std::vector<std::string> faultsOf(std::string_view graph, CompileRequest request = tests::request());

Index nodeNamed(const Plan& plan, std::string_view name);
NodeState stateOf(const Plan& plan, std::string_view node);
std::string whyOf(const Plan& plan, std::string_view node);
/// The names of the passes in execution order.
std::vector<std::string> passNames(const Plan& plan);
const PlannedPass& passNamed(const Plan& plan, std::string_view node);
/// What the named input of a pass reads.
const InputRead& inputOf(const Plan& plan, std::string_view node, std::string_view input);
/// The resource "node.port"; throws std::out_of_range if there is none.
const Resource& resourceNamed(const Plan& plan, std::string_view name);
/// The batch before a pass, as the plan's words: "a.color undefined -> general, for compute write, ...".
std::vector<std::string> barriersBefore(const Plan& plan, std::string_view node);
std::vector<std::string> barriersAtEnd(const Plan& plan);

}  // namespace nephrite::graph::tests
