// The scene's JSON Schema, from the key tables the readers use.
#include "scene/scene_schema.h"

#include "scene/scene_keys.h"
#include "text/json_schema.h"

namespace nephrite::scene {
namespace {

constexpr std::string_view valueDefinitions = R"({
    "vector": {"type": "array", "minItems": 3, "maxItems": 3, "items": {"type": "number"}},
    "color": {"type": "array", "minItems": 3, "maxItems": 3, "items": {"type": "number", "minimum": 0}},
    "reflectance": {"type": "array", "minItems": 3, "maxItems": 3, "items": {"type": "number", "minimum": 0, "maximum": 1}},
    "scale": {"anyOf": [
        {"type": "number", "minimum": 0, "exclusiveMinimum": true},
        {"type": "array", "minItems": 3, "maxItems": 3, "items": {"type": "number", "minimum": 0, "exclusiveMinimum": true}}]},
    "coefficient": {"anyOf": [{"$ref": "#/definitions/color"}, {"$ref": "#/definitions/texture"}]},
    "thickness": {"anyOf": [{"type": "null"}, {"type": "number", "minimum": 0}, {"$ref": "#/definitions/texture"}]},
    "materialOrPreset": {"anyOf": [{"type": "string"}, {"$ref": "#/definitions/material"}]},
    "mesh": {"anyOf": [{"type": "string"}, {"$ref": "#/definitions/model"}, {"$ref": "#/definitions/procedural"}]},
    "procedural": {
        "type": "object", "required": ["procedural"], "additionalProperties": false,
        "properties": {
            "procedural": {"enum": ["sphere", "slab", "teapot", "cube", "plane", "torus"]},
            "radius": {"type": "number", "minimum": 0, "exclusiveMinimum": true,
                       "description": "sphere, torus: radius; default 1."},
            "tube": {"type": "number", "minimum": 0, "exclusiveMinimum": true,
                     "description": "torus: radius of its tube; default 0.25."},
            "size": {"description": "slab: [x, y, z]; plane: [x, z]; cube: a number.",
                     "anyOf": [{"type": "number", "minimum": 0, "exclusiveMinimum": true},
                               {"type": "array", "minItems": 2, "maxItems": 3, "items": {"type": "number"}}]}}},
    "animations": {"anyOf": [{"$ref": "#/definitions/animation"},
                             {"type": "array", "items": {"$ref": "#/definitions/animation"}}]},
    "animation": {"anyOf": [{"$ref": "#/definitions/clip"}, {"$ref": "#/definitions/rotation"},
                            {"$ref": "#/definitions/path"}, {"$ref": "#/definitions/deformation"}]},
    "deformation": {
        "type": "object", "required": ["type"], "additionalProperties": false,
        "description": "Twists, bends or swells the mesh periodically.",
        "properties": {
            "type": {"enum": ["twist", "bend", "pulse"]},
            "axis": {"$ref": "#/definitions/vector"},
            "towards": {"$ref": "#/definitions/vector"},
            "degrees": {"type": "number"},
            "amount": {"type": "number"},
            "waves": {"type": "number"},
            "period": {"type": "number", "minimum": 0, "exclusiveMinimum": true}}}
})";

}  // namespace

std::string sceneSchema() {
    Json::Value schema = json::objectSchema(
        keys::scene(), "A Nephrite scene: right-handed, +y up, lengths in units of millimetersPerUnit mm.");
    Json::Value definitions = json::schemaFragment(valueDefinitions);
    definitions["camera"] = json::objectSchema(keys::camera(), "A perspective camera.");
    definitions["light"] = json::objectSchema(keys::light(), "A point light.");
    definitions["environment"] = json::objectSchema(keys::environment(), "Light from infinitely far away.");
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
    return json::schemaDocument(std::move(schema), "Nephrite scene", std::move(definitions));
}

}  // namespace nephrite::scene
