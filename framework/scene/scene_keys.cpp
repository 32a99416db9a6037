// The key tables: name, JSON Schema, meaning. "$ref" names a definition of scene_schema.cpp.
#include "scene/scene_keys.h"

namespace nephrite::scene::keys {
namespace {

using json::Key;

constexpr std::string_view point = R"({"$ref": "#/definitions/vector"})";
constexpr std::string_view color = R"({"$ref": "#/definitions/color"})";
constexpr std::string_view number = R"({"$ref": "#/definitions/number"})";
constexpr std::string_view positive = R"({"$ref": "#/definitions/positive"})";
constexpr std::string_view notNegative = R"({"$ref": "#/definitions/notNegative"})";

constexpr Key sceneKeys[] = {
    {"millimetersPerUnit", R"({"$ref": "#/definitions/unit"})",
     "Multiplies every position, radius, near, far and mesh coordinate; default 1."},
    {"camera", R"({"$ref": "#/definitions/camera"})", "Where the picture is taken from.", true},
    {"lights", R"({"type": "array", "items": {"$ref": "#/definitions/light"}})",
     "Point lights; default none."},
    {"environment", R"({"$ref": "#/definitions/environment"})",
     "Light from infinitely far away; default dark."},
    {"materials", R"({"type": "object", "additionalProperties": {"$ref": "#/definitions/materialOrPreset"}})",
     "Materials by name."},
    {"objects", R"({"type": "array", "items": {"$ref": "#/definitions/object"}})",
     "What is seen; default nothing."},
};

constexpr Key cameraKeys[] = {
    {"position", point, "Place, in units of the scene.", true},
    {"target", point, "The place in the middle of the picture; default the origin."},
    {"up", point, "The direction that is up in the picture; default +y."},
    {"fovY", R"({"$ref": "#/definitions/fieldOfView"})",
     "Whole vertical field of view in degrees; default 45."},
    {"near", positive, "Distance of the near plane; default a hundredth of the distance to the target."},
    {"far", positive, "Distance of the far plane; default a hundred times the distance to the target."},
};

constexpr Key lightKeys[] = {
    {"type", R"({"enum": ["point"]})", "The kind of light.", true},
    {"position", point, "Place, in units of the scene.", true},
    {"intensity", color, "Radiant intensity R, G, B in W/sr (not scaled by millimetersPerUnit).", true},
};

constexpr Key environmentKeys[] = {
    {"radiance", color, "Constant radiance R, G, B in W/mm^2/sr."},
    {"image", R"({"type": "string"})",
     "A lat-long EXR image: top row +y, middle -z, right half +x. Instead of radiance."},
    {"scale", notNegative, "Multiplies the image; default 1."},
};

// "preset" comes first, so that the table without it is the rest.
constexpr Key materialKeys[] = {
    {"preset", R"({"type": "string"})", "A preset whose values hold unless they are given here."},
    {"doc", R"({"type": "string"})", "What the material is and where its numbers come from."},
    {"diffuse", R"({"$ref": "#/definitions/reflectance"})",
     "Diffuse reflectance R, G, B, 0..1; default 0.8."},
    {"roughness", R"({"$ref": "#/definitions/unitInterval"})",
     "Roughness of the surface; default 0.5 (a preset: 0.3)."},
    {"g", R"({"$ref": "#/definitions/anisotropy"})", "Mean cosine of the phase function; default 0."},
    {"eta", positive, "Refractive index relative to outside; default 1.3."},
    {"specular", R"({"type": "boolean"})",
     "Whether the surface has a highlight; default false (a preset: true)."},
    {"layers", R"({"type": "array", "items": {"$ref": "#/definitions/layer"}})",
     "Layers from the surface inward; without them the material is opaque."},
};

constexpr Key layerKeys[] = {
    {"thickness", R"({"$ref": "#/definitions/thickness"})", "Thickness in mm; absent or null: infinite."},
    {"absorption", R"({"$ref": "#/definitions/coefficient"})", "Absorption coefficients R, G, B in 1/mm.",
     true},
    {"scattering", R"({"$ref": "#/definitions/coefficient"})", "Scattering coefficients R, G, B in 1/mm.",
     true},
    {"reduced", R"({"type": "boolean"})",
     "Whether scattering is reduced, (1 - g) times the coefficient; default false."},
};

constexpr Key textureKeys[] = {
    {"texture", R"({"type": "string"})", "An EXR image; it repeats.", true},
    {"channel", R"({"type": "string"})",
     "A channel's name; default R, G, B for coefficients, the first channel for thickness."},
    {"scale", notNegative, "Multiplies the texels; default 1."},
};

constexpr Key objectKeys[] = {
    {"mesh", R"({"$ref": "#/definitions/mesh"})",
     "A PLY, OBJ, glTF or GLB file, a model of the folder $NEPHRITE_MODELS, or a procedural shape.", true},
    {"material", R"({"$ref": "#/definitions/materialOrPreset"})",
     "A material's name, a preset's name, or a material.", true},
    {"uv", R"({"enum": ["file", "box", "spherical"]})",
     "Texture coordinates; default the file's, or box where it has none."},
    {"transform", R"({"$ref": "#/definitions/transform"})", "Where the object is."},
    {"animation", R"({"$ref": "#/definitions/animations"})",
     "How it moves: one animation or an array of them."},
};

constexpr Key modelKeys[] = {
    {"model", R"({"type": "string"})", "A mesh file in the folder that NEPHRITE_MODELS names.", true},
};

constexpr Key transformKeys[] = {
    {"translate", point, "Applied last, in units of the scene; default 0."},
    {"rotate", point, "Degrees about x, then y, then z (fixed axes); default 0."},
    {"scale", R"({"$ref": "#/definitions/scale"})", "A factor, or one for each axis; default 1."},
    {"fit", positive, "mm: first centre the bounding box at the origin and make its longest side this long."},
};

constexpr Key clipKeys[] = {
    {"type", R"({"enum": ["clip"]})", "Plays an animation of the glTF file.", true},
    {"name", R"({"type": "string"})", "Its name; default the file's first."},
};

constexpr Key rotationKeys[] = {
    {"type", R"({"enum": ["rotate"]})", "Turns the object about an axis through its place.", true},
    {"axis", point, "World direction; default +y."},
    {"degreesPerSecond", number, "Speed, counter-clockwise seen against the axis; default 90."},
};

constexpr Key pathKeys[] = {
    {"type", R"({"enum": ["path"]})", "Moves the object along a closed path.", true},
    {"points", R"({"type": "array", "minItems": 2, "items": {"$ref": "#/definitions/vector"}})",
     "Places passed, added to the transform's; in units of the scene.", true},
    {"secondsPerLoop", positive, "Time of a loop, the same for each segment; default 4."},
    {"smooth", R"({"type": "boolean"})", "Catmull-Rom curves (default) or straight lines."},
};

}  // namespace

std::span<const Key> scene() {
    return sceneKeys;
}
std::span<const Key> camera() {
    return cameraKeys;
}
std::span<const Key> light() {
    return lightKeys;
}
std::span<const Key> environment() {
    return environmentKeys;
}
std::span<const Key> material() {
    return materialKeys;
}
std::span<const Key> preset() {
    return std::span<const Key>(materialKeys).subspan(1);
}
std::span<const Key> layer() {
    return layerKeys;
}
std::span<const Key> texture() {
    return textureKeys;
}
std::span<const Key> object() {
    return objectKeys;
}
std::span<const Key> model() {
    return modelKeys;
}
std::span<const Key> transform() {
    return transformKeys;
}
std::span<const Key> clip() {
    return clipKeys;
}
std::span<const Key> rotation() {
    return rotationKeys;
}
std::span<const Key> path() {
    return pathKeys;
}

}  // namespace nephrite::scene::keys
