// The scene's JSON Schema, from the key tables and the rules that the readers use.
#include "scene/scene_schema.h"

#include "scene/mesh/deformation.h"
#include "scene/mesh/procedural.h"
#include "scene/scene_keys.h"
#include "scene/value_rules.h"
#include "text/json_schema.h"

namespace nephrite::scene {
namespace {

constexpr std::string_view choices = R"({
    "scale": {"anyOf": [{"$ref": "#/definitions/scaleFactor"},
                        {"type": "array", "minItems": 3, "maxItems": 3, "items": {"$ref": "#/definitions/scaleFactor"}}]},
    "coefficient": {"anyOf": [{"$ref": "#/definitions/color"}, {"$ref": "#/definitions/texture"}]},
    "thickness": {"anyOf": [{"type": "null"}, {"$ref": "#/definitions/notNegative"}, {"$ref": "#/definitions/texture"}]},
    "materialOrPreset": {"anyOf": [{"type": "string"}, {"$ref": "#/definitions/material"}]},
    "mesh": {"anyOf": [{"type": "string"}, {"$ref": "#/definitions/model"}, {"$ref": "#/definitions/procedural"}]},
    "animations": {"anyOf": [{"$ref": "#/definitions/animation"},
                             {"type": "array", "items": {"$ref": "#/definitions/animation"}}]},
    "animation": {"anyOf": [{"$ref": "#/definitions/clip"}, {"$ref": "#/definitions/rotation"},
                            {"$ref": "#/definitions/path"}, {"$ref": "#/definitions/deformation"}]}
})";

/// Shapes made by formula, and the lengths each has (procedural_reader.cpp).
constexpr std::string_view procedural = R"({
    "description": "A shape made by formula.",
    "anyOf": [
        {"type": "object", "required": ["procedural"], "additionalProperties": false, "properties": {
            "procedural": {"enum": ["sphere"]},
            "radius": {"allOf": [{"$ref": "#/definitions/length"}], "description": "Radius; default 1."}}},
        {"type": "object", "required": ["procedural", "size"], "additionalProperties": false, "properties": {
            "procedural": {"enum": ["slab"]},
            "size": {"type": "array", "minItems": 3, "maxItems": 3, "items": {"$ref": "#/definitions/length"},
                     "description": "Sides along x, y and z."}}},
        {"type": "object", "required": ["procedural"], "additionalProperties": false, "properties": {
            "procedural": {"enum": ["teapot"]}}},
        {"type": "object", "required": ["procedural"], "additionalProperties": false, "properties": {
            "procedural": {"enum": ["cube"]},
            "size": {"allOf": [{"$ref": "#/definitions/length"}], "description": "Every side; default 1."}}},
        {"type": "object", "required": ["procedural"], "additionalProperties": false, "properties": {
            "procedural": {"enum": ["plane"]},
            "size": {"type": "array", "minItems": 2, "maxItems": 2, "items": {"$ref": "#/definitions/length"},
                     "description": "Sides along x and z; default 1."}}},
        {"type": "object", "required": ["procedural"], "additionalProperties": false, "properties": {
            "procedural": {"enum": ["torus"]},
            "radius": {"allOf": [{"$ref": "#/definitions/length"}], "description": "Radius of the ring; default 1."},
            "tube": {"allOf": [{"$ref": "#/definitions/length"}], "description": "Radius of its tube; default 0.25."}}}]
})";

/// Twists, bends and pulses, and what each can be told (deformation.cpp).
constexpr std::string_view deformation = R"({
    "description": "Twists, bends or swells the mesh periodically.",
    "anyOf": [
        {"type": "object", "required": ["type"], "additionalProperties": false, "properties": {
            "type": {"enum": ["twist"]},
            "axis": {"$ref": "#/definitions/direction"}, "degrees": {"$ref": "#/definitions/degrees"},
            "period": {"$ref": "#/definitions/period"}}},
        {"type": "object", "required": ["type"], "additionalProperties": false, "properties": {
            "type": {"enum": ["bend"]},
            "axis": {"$ref": "#/definitions/direction"}, "degrees": {"$ref": "#/definitions/degrees"},
            "towards": {"$ref": "#/definitions/direction"}, "period": {"$ref": "#/definitions/period"}}},
        {"type": "object", "required": ["type"], "additionalProperties": false, "properties": {
            "type": {"enum": ["pulse"]},
            "axis": {"$ref": "#/definitions/direction"}, "amount": {"$ref": "#/definitions/amount"},
            "waves": {"$ref": "#/definitions/waves"}, "period": {"$ref": "#/definitions/period"}}}]
})";

constexpr std::string_view oneSource = R"([{"required": ["radiance"]}, {"required": ["image"]}])";

Json::Value numberSchema(const NumberRule& rule) {
    return json::numberSchema(rule.least, rule.most, rule.open);
}

void defineNumbers(Json::Value& definitions) {
    definitions["number"] = numberSchema(anyNumber);
    definitions["positive"] = numberSchema(positive);
    definitions["notNegative"] = numberSchema(notNegative);
    definitions["unitInterval"] = numberSchema(unitInterval);
    definitions["anisotropy"] = numberSchema(anisotropy);
    definitions["fieldOfView"] = numberSchema(fieldOfView);
    definitions["unit"] = numberSchema(unitRule);
    definitions["scaleFactor"] = numberSchema(scaleRule);
    definitions["length"] = json::numberSchema(shortestLength, longestLength);
    definitions["degrees"] = json::numberSchema(-mostDegrees, mostDegrees);
    definitions["waves"] = json::numberSchema(-mostWaves, mostWaves);
    definitions["amount"] = json::numberSchema(-1, 1, true);
    definitions["period"] = json::numberSchema(shortestPeriod, longestPeriod, true);
    definitions["vector"] = json::arraySchema(json::definition("number"), 3);
    definitions["color"] = json::arraySchema(json::definition("notNegative"), 3);
    definitions["reflectance"] = json::arraySchema(json::definition("unitInterval"), 3);
    definitions["direction"] =
        json::arraySchema(json::numberSchema(-longestDirection, longestDirection, true), 3);
}

void defineObjects(Json::Value& definitions) {
    definitions["camera"] = json::objectSchema(keys::camera(), "A perspective camera.");
    definitions["light"] = json::objectSchema(keys::light(), "A point light.");
    definitions["environment"] = json::objectSchema(keys::environment(), "Light from infinitely far away.");
    definitions["environment"]["oneOf"] = json::schemaFragment(oneSource);
    definitions["material"] = json::objectSchema(keys::material(), "A surface and the layers under it.");
    definitions["layer"] = json::objectSchema(keys::layer(), "A homogeneous or textured layer.");
    definitions["texture"] =
        json::objectSchema(keys::texture(), "An image looked up at the texture coordinates.");
    definitions["object"] = json::objectSchema(keys::object(), "A mesh with a material at a place.");
    definitions["model"] = json::objectSchema(keys::model(), "A mesh that is not part of the project.");
    definitions["transform"] =
        json::objectSchema(keys::transform(), "fit, scale, rotate and translate, in this order.");
    definitions["clip"] = json::objectSchema(keys::clip(), "An animation of a glTF file.");
    definitions["rotation"] = json::objectSchema(keys::rotation(), "A steady turn.");
    definitions["path"] = json::objectSchema(keys::path(), "A closed path.");
    definitions["procedural"] = json::schemaFragment(procedural);
    definitions["deformation"] = json::schemaFragment(deformation);
}

}  // namespace

std::string sceneSchema() {
    Json::Value schema = json::objectSchema(
        keys::scene(), "A Nephrite scene: right-handed, +y up, lengths in units of millimetersPerUnit mm.");
    Json::Value definitions = json::schemaFragment(choices);
    defineNumbers(definitions);
    defineObjects(definitions);
    return json::schemaDocument(std::move(schema), "Nephrite scene", std::move(definitions));
}

}  // namespace nephrite::scene
