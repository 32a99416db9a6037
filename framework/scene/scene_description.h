// What a scene file says, checked and in millimetres: camera, lights, environment, materials, objects,
// animation.
//
// Plain data. The reader has already multiplied every length by millimetersPerUnit, made paths relative to
// the naming file absolute, filled in defaults and looked up material names.
#pragma once

#include <glm/vec3.hpp>

#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "scene/mesh/deformation.h"
#include "scene/mesh/prepare.h"
#include "text/diagnostics.h"
#include "text/json.h"

namespace nephrite::scene {

/// A perspective camera. Right-handed world, +y up unless `up` says otherwise.
struct CameraDescription {
    glm::dvec3 position{0, 0, 0};  ///< mm
    glm::dvec3 target{0, 0, 0};    ///< mm
    glm::dvec3 up{0, 1, 0};        ///< any length, not parallel to the view direction
    double fovY = 45;              ///< whole vertical angle, degrees
    double near = 1;               ///< mm; absent: a hundredth of the distance to the target
    double far = 1000;             ///< mm; absent: a hundred times that distance
    SourceLocation where;

    /// The same view, wherever it stands written.
    friend bool operator==(const CameraDescription& a, const CameraDescription& b) {
        return a.position == b.position && a.target == b.target && a.up == b.up && a.fovY == b.fovY &&
               a.near == b.near && a.far == b.far;
    }
};

/// A point light.
struct LightDescription {
    glm::dvec3 position{0, 0, 0};   ///< mm
    glm::dvec3 intensity{0, 0, 0};  ///< W/sr, not scaled by millimetersPerUnit
    SourceLocation where;
};

/// Light from infinitely far away: a constant, or a lat-long image (see environment.h for its orientation).
struct EnvironmentDescription {
    glm::dvec3 radiance{0, 0, 0};  ///< W/mm^2/sr; used when there is no image
    std::filesystem::path image;   ///< empty: constant
    double scale = 1;              ///< multiplies the image
    SourceLocation where;
};

/// An EXR image a layer's quantity is looked up in.
struct TextureReference {
    std::filesystem::path file;
    std::string channel;  ///< empty: R, G, B of a colour, the first channel of a thickness
    double scale = 1;     ///< multiplies the texels
    SourceLocation where;
};

/// One layer of a material, from the surface inward. A textured quantity's constant is not used.
struct LayerDescription {
    double thickness = std::numeric_limits<double>::infinity();  ///< mm
    glm::dvec3 absorption{0, 0, 0};                              ///< 1/mm
    glm::dvec3 scattering{0, 0, 0};                              ///< 1/mm; reduced if `reduced`
    std::optional<TextureReference> thicknessTexture;
    std::optional<TextureReference> absorptionTexture;
    std::optional<TextureReference> scatteringTexture;
    bool reduced = false;  ///< scattering is (1 - g) sigma_s
    SourceLocation where;
};

/// A surface and what lies under it. Without layers it is opaque.
struct MaterialDescription {
    std::string name;
    glm::dvec3 diffuse{0.8, 0.8, 0.8};  ///< reflectance, 0..1
    double roughness = 0.5;             ///< 0..1
    double g = 0;                       ///< mean cosine of the phase function
    double eta = 1.3;                   ///< refractive index relative to outside
    bool specular = false;              ///< has a dielectric surface highlight
    std::vector<LayerDescription> layers;
    std::filesystem::path presetFile;  ///< empty: no preset
    SourceLocation where;
};

/// Where an object's triangles come from: a file, or a procedural shape.
struct MeshDescription {
    std::filesystem::path file;             ///< empty: procedural
    std::optional<json::Value> procedural;  ///< as written; see mesh/procedural.h
    std::optional<TextureMapping>
        mapping;  ///< absent: the mesh's texture coordinates, or "box" if it has none
    SourceLocation where;
};

/// world = move(translate + path) * spin * rotate * scale * mesh, where mesh coordinates are first multiplied
/// by millimetersPerUnit or, with a fit, centred and scaled to it.
struct TransformDescription {
    glm::dvec3 translate{0, 0, 0};  ///< mm
    glm::dvec3 rotate{0, 0, 0};     ///< degrees about x, then y, then z (fixed axes)
    glm::dvec3 scale{1, 1, 1};      ///< > 0
    std::optional<double>
        fit;  ///< mm: centre the bounding box at the origin and give its longest side this length
};

enum class AnimationType : std::uint8_t { Clip, Rotate, Path, Deformation };

/// One motion of an object. Which members count depends on the type.
struct AnimationDescription {
    AnimationType type = AnimationType::Rotate;
    std::string clip;                ///< Clip: the glTF animation's name, empty for the first
    glm::dvec3 axis{0, 1, 0};        ///< Rotate: unit world direction, through the object's place
    double degreesPerSecond = 90;    ///< Rotate
    std::vector<glm::dvec3> points;  ///< Path: mm, added to the object's place; a closed loop
    double secondsPerLoop = 4;       ///< Path
    bool smooth = true;              ///< Path: Catmull-Rom, else straight lines
    Deformation deformation;         ///< Deformation: twist, bend or pulse
    SourceLocation where;
};

struct ObjectDescription {
    MeshDescription mesh;
    std::uint32_t material = 0;  ///< index into SceneDescription::materials
    TransformDescription transform;
    std::vector<AnimationDescription> animations;  ///< at most one clip and one deformation
    SourceLocation where;
};

struct SceneDescription {
    std::string file;
    double millimetersPerUnit = 1;
    CameraDescription camera;
    std::vector<LightDescription> lights;
    EnvironmentDescription environment;
    std::vector<MaterialDescription> materials;  ///< only those an object uses, each once
    std::vector<ObjectDescription> objects;
};

/// How a scene is read.
struct SceneOptions {
    std::filesystem::path materialFolder;  ///< of the presets, NAME.json each
    double time = 0;                       ///< seconds; the time Scene::facts() speaks of
    std::filesystem::path modelFolder{};   ///< of meshes that are not part of the project; empty: not at hand
};

/// Reads a scene file. Adds every fault and warning (no light, no object) to `diagnostics`; a description
/// with faults is not to be used. Throws InputError only where there is nothing to read: no such file,
/// malformed JSON.
SceneDescription readScene(const std::filesystem::path& file, const SceneOptions& options,
                           Diagnostics& diagnostics);
/// The same from text already parsed; relative paths are then relative to the folder of the document's file
/// name.
SceneDescription readScene(const json::Value& value, const SceneOptions& options, Diagnostics& diagnostics);

}  // namespace nephrite::scene
