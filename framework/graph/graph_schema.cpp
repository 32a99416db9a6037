// The schema of graph files, from the key tables of their reader (keys.h).
#include "graph/keys.h"
#include "graph/schema.h"
#include "graph/schema_parts.h"
#include "graph/value_readers.h"
#include "text/json_schema.h"

namespace nephrite::graph {
namespace {

/// What stands inside the parentheses is for the reader: a pattern cannot count them.
constexpr std::string_view port =
    R"({"type": "string",
        "pattern": "^([A-Za-z_][A-Za-z0-9_-]*\\.[A-Za-z_][A-Za-z0-9_]*|(previous|mip|layer|import)\\(.*\\))$"})";

/// A size is like that of a whole port of this frame.
constexpr std::string_view wholePort =
    R"({"type": "string",
        "pattern": "^([A-Za-z_][A-Za-z0-9_-]*\\.[A-Za-z_][A-Za-z0-9_]*|import\\(.*\\))$"})";

/// A graph has nodes, or images from outside that it hands on.
constexpr std::string_view notEmpty = R"([
    {"properties": {"nodes": {"minProperties": 1}}},
    {"required": ["imports"], "properties": {"imports": {"minProperties": 1}}}])";

Json::Value definitionsOfGraphs() {
    Json::Value definitions = commonDefinitions();
    definitions["importFormat"] = formatSchema(false);
    definitions["size"] = sizeSchema(json::schemaFragment(wholePort));
    definitions["port"] = json::schemaFragment(port);
    definitions["setting"] = json::anyOf(
        {json::definition("value"), json::schemaFragment(R"({"type": "string", "pattern": "^\\$"})")});
    definitions["parameter"] =
        json::objectSchema(keys::graphParameter(), "a value nodes and expressions may use");
    definitions["import"] = json::objectSchema(keys::graphImport(), "an image from outside the graph");
    definitions["node"] = json::objectSchema(keys::node(), "one pass of the graph");
    definitions["parameters"] = json::namedSchema(identifierPattern(), json::definition("parameter"));
    definitions["imports"] = json::namedSchema(identifierPattern(true), json::definition("import"));
    definitions["nodes"] = json::namedSchema(identifierPattern(true), json::definition("node"));
    return definitions;
}

}  // namespace

std::string graphSchema() {
    Json::Value schema =
        json::objectSchema(keys::graph(), "passes, how they are connected, and what comes out");
    schema["anyOf"] = json::schemaFragment(notEmpty);
    return json::schemaDocument(std::move(schema), "Nephrite render graph", definitionsOfGraphs());
}

}  // namespace nephrite::graph
