// The schema of pass manifests, from the key tables of their reader (keys.h) and what must hold between keys.
#include <fmt/format.h>

#include "graph/format.h"
#include "graph/keys.h"
#include "graph/manifest_ports.h"
#include "graph/parameter_checks.h"
#include "graph/schema.h"
#include "graph/schema_parts.h"
#include "graph/value_readers.h"
#include "text/json_schema.h"

namespace nephrite::graph {
namespace {

/// What each kind of pass needs and cannot have.
constexpr std::string_view kinds = R"([
    {"properties": {"kind": {"enum": ["native"]}, "outputs": {"$ref": "#/definitions/colorOutputs"}},
     "not": {"anyOf": [{"required": ["shader"]}, {"required": ["raster"]}, {"required": ["domain"]}]}},
    {"properties": {"kind": {"enum": ["pixel"]},
                    "outputs": {"allOf": [{"minProperties": 1}, {"$ref": "#/definitions/colorOutputs"}]}},
     "required": ["shader", "outputs"], "not": {"required": ["raster"]}},
    {"properties": {"kind": {"enum": ["compute"]}, "outputs": {"$ref": "#/definitions/colorOutputs"}},
     "required": ["shader"], "not": {"anyOf": [{"required": ["raster"]}, {"required": ["domain"]}]},
     "anyOf": [{"required": ["outputs"], "properties": {"outputs": {"minProperties": 1}}},
               {"required": ["sideEffect"], "properties": {"sideEffect": {"enum": [true]}}}]},
    {"properties": {"kind": {"enum": ["raster"]}, "forEach": {"not": {"enum": ["mips"]}},
                    "outputs": {"allOf": [{"minProperties": 1}, {"$ref": "#/definitions/drawnOutputs"}]}},
     "required": ["shader", "outputs"], "not": {"required": ["domain"]}}])";

/// Outputs of passes that do not draw: none is a depth buffer.
constexpr std::string_view colorOutputs = R"({"additionalProperties": {
    "not": {"required": ["format"], "properties": {"format": {"enum": ["d32f"]}}}}})";

/// Outputs of passes that draw: images of one level and one layer.
constexpr std::string_view drawnOutputs = R"({"additionalProperties": {
    "not": {"required": ["buffer"]},
    "properties": {"mips": {"anyOf": [{"enum": [1, true]}, {"type": "string"}]},
                   "layers": {"anyOf": [{"enum": [1, true]}, {"type": "string"}]}}}})";

/// What describes an image means nothing on a buffer, and what is modified keeps its size.
constexpr std::string_view inputDependencies = R"({"buffer": {"not": {"required": ["format"]}}})";
constexpr std::string_view outputDependencies = R"({
    "count": ["buffer"],
    "buffer": {"not": {"anyOf": [{"required": ["format"]}, {"required": ["size"]},
                                 {"required": ["mips"]}, {"required": ["layers"]}]},
               "anyOf": [{"required": ["count"]}, {"required": ["modifies"]}]},
    "modifies": {"not": {"anyOf": [{"required": ["size"]}, {"required": ["mips"]},
                                   {"required": ["layers"]}, {"required": ["count"]}]}}})";

/// float[N] has 1 to 1024 elements.
constexpr std::string_view arrayType = R"(float\[([1-9][0-9]{0,2}|10[01][0-9]|102[0-4])\])";

/// The `types`, a default that fits them, and `rest`.
Json::Value typedParameter(Json::Value types, Json::Value defaultValue, std::string_view rest = "{}") {
    Json::Value schema = json::schemaFragment(rest);
    schema["properties"]["type"] = std::move(types);
    schema["properties"]["default"] = std::move(defaultValue);
    return schema;
}

Json::Value oneType(ParameterType type) {
    Json::Value schema(Json::objectValue);
    schema["enum"].append(std::string(name(type)));
    return schema;
}

Json::Value numberOf(ParameterType type) {
    const auto [least, most] = limits(type);
    return type == ParameterType::Float ? json::numberSchema(least, most)
                                        : json::wholeNumberSchema(least, most);
}

Json::Value parameterSchema() {
    constexpr std::string_view whole = R"({"properties": {"specialize": {"enum": [false]}}})";
    const Json::Value number = numberOf(ParameterType::Float);
    Json::Value arrayName(Json::objectValue);
    arrayName["pattern"] = fmt::format("^{}$", arrayType);
    Json::Value numbers = json::schemaFragment(R"({"type": "array", "minItems": 1})");
    numbers["items"] = number;

    Json::Value schema = json::objectSchema(keys::parameter(), "a value a graph may set");
    Json::Value& types = schema["anyOf"];
    types.append(typedParameter(oneType(ParameterType::Bool), json::schemaFragment(R"({"type": "boolean"})"),
                                R"({"not": {"required": ["range"]}})"));
    for (const ParameterType type : {ParameterType::Int, ParameterType::Uint, ParameterType::Float})
        types.append(typedParameter(oneType(type), numberOf(type)));
    unsigned count = 2;
    for (const ParameterType type : {ParameterType::Vec2, ParameterType::Vec3, ParameterType::Vec4})
        types.append(typedParameter(oneType(type), json::arraySchema(number, count++), whole));
    types.append(typedParameter(std::move(arrayName), std::move(numbers), whole));
    return schema;
}

Json::Value parameterTypeSchema() {
    Json::Value schema = json::schemaFragment(R"({"type": "string"})");
    schema["pattern"] = fmt::format("^(bool|int|uint|float|vec[234]|{})$", arrayType);
    return schema;
}

Json::Value portSchema(std::span<const json::Key> keys, std::string_view doc, std::string_view dependencies) {
    Json::Value schema = json::objectSchema(keys, doc);
    schema["dependencies"] = json::schemaFragment(dependencies);
    return schema;
}

Json::Value bufferElementSchema() {
    Json::Value schema(Json::objectValue);
    for (const std::string_view element : bufferElements()) schema["enum"].append(std::string(element));
    return schema;
}

/// Counts of parts: a number within bounds, true for 1, or an expression.
void defineCounts(Json::Value& definitions) {
    const Json::Value one = json::schemaFragment(R"({"enum": [true]})");
    const Json::Value boolean = json::schemaFragment(R"({"type": "boolean"})");
    definitions["mips"] = expressionSchema(json::anyOf({json::wholeNumberSchema(0, mostMips), boolean}));
    definitions["layers"] = expressionSchema(json::anyOf({json::wholeNumberSchema(1, mostLayers), one}));
    definitions["count"] = expressionSchema(json::anyOf({json::wholeNumberSchema(0, mostElements), boolean}));
}

Json::Value definitionsOfPasses() {
    Json::Value definitions = commonDefinitions();
    definitions["size"] = sizeSchema(json::schemaFragment(R"({"type": "string"})"));
    definitions["neutral"] = json::arraySchema(json::numberSchema(-largestNeutral, largestNeutral), 4);
    definitions["bufferElement"] = bufferElementSchema();
    defineCounts(definitions);
    definitions["parameterType"] = parameterTypeSchema();
    definitions["parameter"] = parameterSchema();
    definitions["input"] = portSchema(keys::input(), "an image or buffer the pass reads", inputDependencies);
    definitions["output"] =
        portSchema(keys::output(), "an image or buffer the pass writes", outputDependencies);
    definitions["raster"] = json::objectSchema(keys::raster(), "how a raster pass draws");
    for (const char* part : {"parameter", "input", "output"})
        definitions[std::string(part) + "s"] = json::namedSchema(glslNamePattern(), json::definition(part));
    definitions["colorOutputs"] = json::schemaFragment(colorOutputs);
    definitions["drawnOutputs"] = json::schemaFragment(drawnOutputs);
    return definitions;
}

}  // namespace

std::string passSchema() {
    Json::Value schema =
        json::objectSchema(keys::manifest(), "a pass type: its ports, parameters and skip conditions");
    schema["anyOf"] = json::schemaFragment(kinds);
    return json::schemaDocument(std::move(schema), "Nephrite pass manifest", definitionsOfPasses());
}

}  // namespace nephrite::graph
