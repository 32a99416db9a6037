// The parameters of a graph and of its nodes as plain data, for a user interface to make a control of each.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "graph/linked_graph.h"

namespace nephrite::graph {

/// One parameter. A graph parameter has the type of the nodes' parameters that are bound to it, and float (of
/// an array float[N]) where there are none.
struct Control {
    std::string target;  ///< "NODE.PARAM" or "PARAM": what a setting names
    std::string name;
    std::string doc;
    ParameterType type = ParameterType::Float;
    std::uint32_t count = 1;                     ///< components
    std::optional<std::array<double, 2>> range;  ///< of a graph parameter: what it and all bound to it allow
    ParameterValue defaultValue;  ///< of the manifest; of a graph parameter the value in the graph's file
    ParameterValue value;         ///< as it is now
    std::string boundTo;          ///< the graph parameter that decides it ("$NAME"); empty: it is its own
    bool specialized = false;     ///< compiled into a shader: another value means another pipeline
    bool logarithmic = false;     ///< see isLogarithmic
};

struct NodeControls {
    Index node = noIndex;  ///< into LinkedGraph::nodes
    std::string name;
    std::string passType;
    std::string doc;  ///< the pass type's
    std::vector<Control> parameters;
};

struct GraphControls {
    std::vector<Control> parameters;  ///< the graph's own
    std::vector<NodeControls> nodes;  ///< in the file's order, without those that link() adds
};

/// Every parameter with its value among `current`.
GraphControls controlsOf(const LinkedGraph& graph, const ParameterValues& current);

/// Gives the graph's parameters the values of `file`, what the graph's file declares, as their defaults. For
/// a graph that was edited since it was read.
void setDefaults(GraphControls& controls, std::span<const GraphParameter> file);

/// Whether a slider over a range should be logarithmic: the greatest magnitude in the range is at least 1,000
/// times the size that matters. That is the least value of a range above 0; else the smallest component of
/// the default that is not 0, and 1 if there is none.
bool isLogarithmic(const std::array<double, 2>& range, const ParameterValue& defaultValue);

/// A value as JSON, as short as it can be written: 0.1 of the float nearest to it.
std::string valueText(const Control& control, const ParameterValue& value);
/// `NODE.PARAM=JSON`, as Session::set and --set take it.
std::string settingText(const Control& control, const ParameterValue& value);

}  // namespace nephrite::graph
