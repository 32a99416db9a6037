// See schema_parts.h.
#include "graph/schema_parts.h"

#include "graph/format.h"
#include "graph/value_readers.h"
#include "text/json_schema.h"

namespace nephrite::graph {
namespace {

/// An object with one key, which it must have.
Json::Value singleKeySchema(const char* key, Json::Value value) {
    Json::Value schema = json::schemaFragment(R"({"type": "object", "additionalProperties": false})");
    schema["required"].append(key);
    schema["properties"][key] = std::move(value);
    return schema;
}

}  // namespace

Json::Value formatSchema(bool withDepth) {
    Json::Value schema(Json::objectValue);
    for (const std::string_view name : formatNames())
        if (withDepth || !info(*formatNamed(name)).isDepth) schema["enum"].append(std::string(name));
    return schema;
}

Json::Value expressionSchema(const Json::Value& literal) {
    return json::anyOf({literal, json::schemaFragment(R"({"type": "string", "minLength": 1})")});
}

Json::Value sizeSchema(Json::Value like) {
    Json::Value scale = json::numberSchema(0, largestScale);
    scale["exclusiveMinimum"] = true;
    const Json::Value one = json::schemaFragment(R"({"enum": [true]})");
    return json::anyOf({json::arraySchema(json::definition("side"), 2),
                        singleKeySchema("scale", expressionSchema(json::anyOf({std::move(scale), one}))),
                        singleKeySchema("like", std::move(like))});
}

Json::Value commonDefinitions() {
    const Json::Value boolean = json::schemaFragment(R"({"type": "boolean"})");
    Json::Value definitions(Json::objectValue);
    definitions["expression"] =
        json::schemaFragment(R"({"type": ["number", "boolean", "string"], "minLength": 1})");
    definitions["side"] = expressionSchema(json::anyOf({json::wholeNumberSchema(0, largestSide), boolean}));
    definitions["range"] = json::arraySchema(json::schemaFragment(R"({"type": "number"})"), 2);
    definitions["format"] = formatSchema(true);
    definitions["value"] = json::schemaFragment(R"({"anyOf": [
        {"type": ["boolean", "number"]}, {"type": "array", "minItems": 1, "items": {"type": "number"}}]})");
    return definitions;
}

}  // namespace nephrite::graph
