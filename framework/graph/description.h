// What a graph file says, in the file's own words: names are not looked up yet. link() turns it into a
// LinkedGraph.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "graph/pass_type.h"

namespace nephrite::graph {

/// "node.port" as written.
struct PortReference {
    std::string node;
    std::string port;
    SourceLocation where;
    SourceLocation whereKey{};  ///< of the input's or output's name that it is given to, in a graph file
};
/// Splits "node.port"; adds a fault and returns nothing if it has another form.
std::optional<PortReference> readPortReference(const std::string& text, const SourceLocation& where,
                                               Diagnostics& diagnostics);

/// A graph parameter: a bool, a number, or an array of numbers.
struct GraphParameter {
    std::string name;
    ParameterValue value;
    bool isBool = false;
    std::optional<std::array<double, 2>> range{};  ///< inclusive, each component
    std::string doc;
    SourceLocation where;
};

/// One member of a node's "set": a value, or `$NAME` for a graph parameter.
struct ParameterSetting {
    std::string parameter;
    std::variant<json::Value, std::string> value;  ///< the JSON value, or the graph parameter's name
    SourceLocation where;
};

/// One member of a node's "format".
struct FormatOverride {
    std::string port;
    Format format = Format::rgba16f;
    SourceLocation where;
};

enum class ViewKind : std::uint8_t { Camera, Light };

struct NodeDescription {
    std::string name;
    std::string passType;
    ViewKind view = ViewKind::Camera;
    bool forEachLight = false;
    std::optional<SizeRule> size;  ///< applies to every output of the node
    std::vector<std::pair<std::string, PortReference>> inputs;
    std::vector<ParameterSetting> settings;
    std::vector<FormatOverride> formats;
    std::optional<Expression> when;
    SourceLocation where;
    SourceLocation wherePass;  ///< of the "pass" value
};

struct GraphDescription {
    std::string name;
    std::string file;
    std::vector<GraphParameter> parameters;
    std::vector<NodeDescription> nodes;  ///< in the file's order
    std::vector<std::pair<std::string, PortReference>> outputs;
};

/// Reads a graph file. Throws InputError.
GraphDescription readGraph(const std::filesystem::path& file);
GraphDescription readGraph(const json::Value& value);

}  // namespace nephrite::graph
