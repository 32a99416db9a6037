// The scene's JSON Schema, from the key tables the readers use.
#include "scene/scene_schema.h"

#include <json/reader.h>
#include <json/writer.h>

#include <memory>
#include <stdexcept>

#include "scene/scene_keys.h"

namespace nephrite::scene {
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
            Json::Value wrapped(Json::objectValue);
            wrapped["allOf"].append(property);
            property = wrapped;
        }
        property["description"] = std::string(key.doc);
        schema["properties"][std::string(key.name)] = property;
        if (key.required) schema["required"].append(std::string(key.name));
    }
    return schema;
}

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
    "mesh": {"anyOf": [{"type": "string"}, {"$ref": "#/definitions/procedural"}]},
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
    Json::Value schema = objectSchema(
        keys::scene(), "A Nephrite scene: right-handed, +y up, lengths in units of millimetersPerUnit mm.");
    schema["$schema"] = "http://json-schema.org/draft-04/schema#";
    schema["title"] = "Nephrite scene";
    Json::Value& definitions = schema["definitions"] = fragment(valueDefinitions);
    definitions["camera"] = objectSchema(keys::camera(), "A perspective camera.");
    definitions["light"] = objectSchema(keys::light(), "A point light.");
    definitions["environment"] = objectSchema(keys::environment(), "Light from infinitely far away.");
    definitions["material"] = objectSchema(keys::material(), "A surface and the layers under it.");
    definitions["layer"] = objectSchema(keys::layer(), "A homogeneous or textured layer.");
    definitions["texture"] = objectSchema(keys::texture(), "An image looked up at the texture coordinates.");
    definitions["object"] = objectSchema(keys::object(), "A mesh with a material at a place.");
    definitions["transform"] =
        objectSchema(keys::transform(), "fit, scale, rotate and translate, in this order.");
    definitions["clip"] = objectSchema(keys::clip(), "An animation of a glTF file.");
    definitions["rotation"] = objectSchema(keys::rotation(), "A steady turn.");
    definitions["path"] = objectSchema(keys::path(), "A closed path.");
    return Json::writeString(Json::StreamWriterBuilder(), schema) + "\n";
}

}  // namespace nephrite::scene
