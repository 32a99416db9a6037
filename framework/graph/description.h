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

/// A port as a graph names it: `node.port`, or `import(name)`, inside any number of `previous(...)`,
/// `previous(..., n)`, `mip(..., level)` and `layer(..., index)`.
struct PortReference {
    std::string node;  ///< for an import the whole `import(name)`
    std::string port;  ///< for an import "image"
    SourceLocation where;
    SourceLocation whereKey{};     ///< of the input's or output's name that it is given to, in a graph file
    std::uint32_t framesBack = 0;  ///< sum of the previous(...) around it
    std::optional<std::uint32_t> mip{};    ///< one level alone
    std::optional<std::uint32_t> layer{};  ///< one array layer alone
};
/// Reads the forms above; adds a fault and returns nothing if it has another form.
std::optional<PortReference> readPortReference(const std::string& text, const SourceLocation& where,
                                               Diagnostics& diagnostics);
/// The shortest form that reads as the reference: `previous(mip(blur.color, 2))`.
std::string toText(const PortReference& reference);

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

/// An image that comes from outside the graph: a file, or one its user hands to the compiler.
struct GraphImport {
    std::string name;
    std::filesystem::path image;  ///< OpenEXR, beside the graph's file; empty: handed over at compile time
    Format format = Format::rgba32f;
    std::string doc;
    SourceLocation where;
};

struct NodeDescription {
    std::string name;
    std::string passType;
    ViewKind view = ViewKind::Camera;
    std::optional<ForEach> forEach;  ///< empty: the pass type's
    std::optional<SizeRule> size;    ///< applies to every output of the node
    std::vector<std::pair<std::string, PortReference>> inputs;
    std::vector<ParameterSetting> settings;
    std::vector<FormatOverride> formats;
    std::optional<Expression> when;
    SourceLocation where;
    SourceLocation wherePass;       ///< of the "pass" value
    SourceLocation whereView{};     ///< of the "view" value
    SourceLocation whereForEach{};  ///< of the "forEach" value
};

struct GraphDescription {
    std::string name;
    std::string file;
    std::vector<GraphParameter> parameters;
    std::vector<GraphImport> imports;
    std::vector<NodeDescription> nodes;  ///< in the file's order
    std::vector<std::pair<std::string, PortReference>> outputs;
};

/// Reads a graph file. Throws InputError.
GraphDescription readGraph(const std::filesystem::path& file);
GraphDescription readGraph(const json::Value& value);

}  // namespace nephrite::graph
