// Plans of small graphs written as JSON, and ways to ask about them by name.
#pragma once

#include <array>
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
/// The constant that the named input of a pass reads where there is no resource.
std::array<double, 4> neutralOf(const Plan& plan, std::string_view node, std::string_view input);
/// The batch before a pass, or before one level of a pass over mips, as the plan's words:
/// "a.color undefined -> general for compute write, ...".
std::vector<std::string> barriersBefore(const Plan& plan, std::string_view node, Index iteration = 0);
std::vector<std::string> barriersAtEnd(const Plan& plan);
/// Every barrier of one resource, in the order of their batches.
std::vector<std::string> barriersOf(const Plan& plan, std::string_view resource);

}  // namespace nephrite::graph::tests
