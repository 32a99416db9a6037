// JSON Schemas built from the key tables the readers use (keys.h).
#include "graph/schema.h"

#include "graph/format.h"
#include "graph/keys.h"
#include "text/json_schema.h"

namespace nephrite::graph {
namespace {

Json::Value formatSchema() {
    Json::Value schema(Json::objectValue);
    for (const FormatInfo& format : allFormats()) schema["enum"].append(std::string(format.name));
    for (const char* alias : {"r8unorm", "rg8unorm", "rgba8unorm"}) schema["enum"].append(alias);
    return schema;
}

Json::Value bufferElementSchema() {
    Json::Value schema(Json::objectValue);
    for (const std::string_view element : bufferElements()) schema["enum"].append(std::string(element));
    return schema;
}

Json::Value commonDefinitions() {
    Json::Value definitions(Json::objectValue);
    definitions["expression"] = json::schemaFragment(R"({"type": ["number", "boolean", "string"]})");
    definitions["size"] = json::schemaFragment(R"({"anyOf": [
        {"type": "array", "minItems": 2, "maxItems": 2, "items": {"$ref": "#/definitions/expression"}},
        {"type": "object", "additionalProperties": false, "required": ["scale"],
         "properties": {"scale": {"$ref": "#/definitions/expression"}}},
        {"type": "object", "additionalProperties": false, "required": ["like"],
         "properties": {"like": {"type": "string"}}}]})");
    definitions["range"] = json::schemaFragment(
        R"({"type": "array", "minItems": 2, "maxItems": 2, "items": {"type": "number"}})");
    definitions["format"] = formatSchema();
    return definitions;
}

}  // namespace

std::string graphSchema() {
    Json::Value definitions = commonDefinitions();
    // What stands inside the parentheses is for the reader: a pattern cannot count them.
    definitions["port"] = json::schemaFragment(
        R"({"type": "string", "pattern": "^([A-Za-z_][A-Za-z0-9_-]*\\.[A-Za-z_][A-Za-z0-9_]*|(previous|mip|layer|import)\\(.*\\))$"})");
    definitions["parameter"] =
        json::objectSchema(keys::graphParameter(), "a value nodes and expressions may use");
    definitions["import"] = json::objectSchema(keys::graphImport(), "an image from outside the graph");
    definitions["node"] = json::objectSchema(keys::node(), "one pass of the graph");
    return json::schemaDocument(
        json::objectSchema(keys::graph(), "passes, how they are connected, and what comes out"),
        "Nephrite render graph", std::move(definitions));
}

std::string passSchema() {
    Json::Value definitions = commonDefinitions();
    definitions["neutral"] = json::schemaFragment(
        R"({"type": "array", "minItems": 4, "maxItems": 4, "items": {"type": "number"}})");
    definitions["bufferElement"] = bufferElementSchema();
    definitions["input"] = json::objectSchema(keys::input(), "an image or buffer the pass reads");
    definitions["output"] = json::objectSchema(keys::output(), "an image or buffer the pass writes");
    definitions["parameter"] = json::objectSchema(keys::parameter(), "a value a graph may set");
    definitions["raster"] = json::objectSchema(keys::raster(), "how a raster pass draws");
    return json::schemaDocument(
        json::objectSchema(keys::manifest(), "a pass type: its ports, parameters and skip conditions"),
        "Nephrite pass manifest", std::move(definitions));
}

}  // namespace nephrite::graph
