// JSON Schemas built from the key tables the readers use (keys.h).
#include "graph/schema.h"

#include <json/reader.h>
#include <json/writer.h>

#include <memory>
#include <stdexcept>

#include "graph/format.h"
#include "graph/keys.h"

namespace nephrite::graph {
namespace {

/// A fragment of a schema written in this program.
Json::Value fragment(std::string_view text) {
    const std::unique_ptr<Json::CharReader> reader(Json::CharReaderBuilder().newCharReader());
    Json::Value value;
    std::string faults;
    if (!reader->parse(text.data(), text.data() + text.size(), &value, &faults))
        throw std::logic_error(faults);
    return value;
}

Json::Value objectSchema(std::span<const json::Key> keys, std::string_view doc) {
    Json::Value schema(Json::objectValue);
    schema["type"] = "object";
    schema["description"] = std::string(doc);
    schema["additionalProperties"] = false;
    for (const json::Key& key : keys) {
        Json::Value property = fragment(key.schema);
        if (property.isMember("$ref")) {
            // Draft 4 ignores what stands beside a $ref.
            Json::Value reference = std::move(property);
            property = Json::Value(Json::objectValue);
            property["allOf"].append(std::move(reference));
        }
        property["description"] = std::string(key.doc);
        schema["properties"][std::string(key.name)] = std::move(property);
        if (key.required) schema["required"].append(std::string(key.name));
    }
    return schema;
}

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
    definitions["expression"] = fragment(R"({"type": ["number", "boolean", "string"]})");
    definitions["size"] = fragment(R"({"anyOf": [
        {"type": "array", "minItems": 2, "maxItems": 2, "items": {"$ref": "#/definitions/expression"}},
        {"type": "object", "additionalProperties": false, "required": ["scale"],
         "properties": {"scale": {"$ref": "#/definitions/expression"}}},
        {"type": "object", "additionalProperties": false, "required": ["like"],
         "properties": {"like": {"type": "string"}}}]})");
    definitions["range"] =
        fragment(R"({"type": "array", "minItems": 2, "maxItems": 2, "items": {"type": "number"}})");
    definitions["format"] = formatSchema();
    return definitions;
}

std::string documentText(Json::Value schema, std::string_view title, Json::Value definitions) {
    schema["$schema"] = "http://json-schema.org/draft-04/schema#";
    schema["title"] = std::string(title);
    schema["definitions"] = std::move(definitions);
    Json::StreamWriterBuilder builder;
    builder["indentation"] = "  ";
    return Json::writeString(builder, schema) + "\n";
}

}  // namespace

std::string graphSchema() {
    Json::Value definitions = commonDefinitions();
    definitions["port"] =
        fragment(R"({"type": "string", "pattern": "^[A-Za-z_][A-Za-z0-9_-]*\\.[A-Za-z_][A-Za-z0-9_]*$"})");
    definitions["parameter"] = objectSchema(keys::graphParameter(), "a value nodes and expressions may use");
    definitions["node"] = objectSchema(keys::node(), "one pass of the graph");
    return documentText(objectSchema(keys::graph(), "passes, how they are connected, and what comes out"),
                        "Nephrite render graph", std::move(definitions));
}

std::string passSchema() {
    Json::Value definitions = commonDefinitions();
    definitions["neutral"] =
        fragment(R"({"type": "array", "minItems": 4, "maxItems": 4, "items": {"type": "number"}})");
    definitions["bufferElement"] = bufferElementSchema();
    definitions["input"] = objectSchema(keys::input(), "an image or buffer the pass reads");
    definitions["output"] = objectSchema(keys::output(), "an image or buffer the pass writes");
    definitions["parameter"] = objectSchema(keys::parameter(), "a value a graph may set");
    definitions["raster"] = objectSchema(keys::raster(), "how a raster pass draws");
    return documentText(
        objectSchema(keys::manifest(), "a pass type: its ports, parameters and skip conditions"),
        "Nephrite pass manifest", std::move(definitions));
}

}  // namespace nephrite::graph
