// The scene's JSON Schema, from the key tables and the rules that the readers use.
#include "scene/scene_schema.h"

#include "scene/scene_keys.h"
#include "scene/shape_keys.h"
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

constexpr std::string_view oneSource = R"([{"required": ["radiance"]}, {"required": ["image"]}])";

Json::Value numberSchema(const NumberRule& rule) {
    return json::numberSchema(rule.least, rule.most, rule.open);
}

Json::Value anyKind(std::span<const keys::Kind> kinds, std::string_view doc) {
    Json::Value schema(Json::objectValue);
    schema["description"] = std::string(doc);
    for (const keys::Kind& kind : kinds) schema["anyOf"].append(json::objectSchema(kind.keys, kind.doc));
    return schema;
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
    definitions["length"] = numberSchema(lengthRule);
    definitions["degrees"] = numberSchema(degreesRule);
    definitions["waves"] = numberSchema(wavesRule);
    definitions["amount"] = numberSchema(amountRule);
    definitions["period"] = numberSchema(periodRule);
    definitions["vector"] = json::arraySchema(json::definition("number"), 3);
    definitions["color"] = json::arraySchema(json::definition("notNegative"), 3);
    definitions["reflectance"] = json::arraySchema(json::definition("unitInterval"), 3);
    definitions["direction"] = json::arraySchema(numberSchema(directionRule), 3);
    definitions["lengths"] = json::arraySchema(json::definition("length"), 3);
    definitions["twoLengths"] = json::arraySchema(json::definition("length"), 2);
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
    definitions["procedural"] = anyKind(keys::procedural(), "A shape made by formula.");
    definitions["deformation"] =
        anyKind(keys::deformation(), "Twists, bends or swells the mesh periodically.");
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
