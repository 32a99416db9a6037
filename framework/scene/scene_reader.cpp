// Reads a scene file: camera, lights and environment here, materials and objects with their own readers.
#include <fmt/format.h>

#include <array>
#include <glm/geometric.hpp>
#include <map>

#include "scene/material_reader.h"
#include "scene/object_reader.h"
#include "scene/scene_description.h"
#include "scene/scene_keys.h"
#include "scene/value_rules.h"

namespace nephrite::scene {
namespace {

using json::ObjectReader;
using json::Value;

constexpr std::array<std::string_view, 1> lightTypes{"point"};

/// Reads the members of one scene in turn.
class SceneReader {
  public:
    SceneReader(const Value& value, const SceneOptions& options, Diagnostics& diagnostics)
        : root_(value, "a scene", keys::scene(), diagnostics),
          presets_(options.materialFolder),
          folder_(std::filesystem::path(value.where().file).parent_path()),
          models_(options.modelFolder),
          diagnostics_(diagnostics) {
        scene_.file = value.where().file;
    }

    SceneDescription read() {
        if (!root_.value().isObject()) return scene_;
        readNumber(root_, "millimetersPerUnit", unitRule, scene_.millimetersPerUnit);
        if (const auto camera = root_.optional("camera")) readCamera(*camera);
        readLights();
        if (const auto environment = root_.optional("environment")) readEnvironment(*environment);
        readMaterials();
        readObjects();
        root_.finish();
        warn();
        return std::move(scene_);
    }

  private:
    // ---- camera

    void readCamera(const Value& value) {
        const std::size_t faultsBefore = diagnostics_.errors().size();
        ObjectReader object(value, "a camera", keys::camera(), diagnostics_);
        CameraDescription& camera = scene_.camera;
        camera.where = value.where();
        if (const auto position = object.optional("position")) readPosition(*position, camera.position);
        if (const auto target = object.optional("target")) readPosition(*target, camera.target);
        readVector(object, "up", anyNumber, camera.up);
        readNumber(object, "fovY", fieldOfView, camera.fovY);
        readDepthRange(object, camera);
        object.finish();
        if (diagnostics_.errors().size() != faultsBefore) return;  // what follows from them is no news
        checkDepthRange(object, camera);
        checkOrientation(camera);
    }

    void readPosition(const Value& value, glm::dvec3& position) {
        readVector(value, anyNumber, position, diagnostics_);
        position *= scene_.millimetersPerUnit;
    }

    void readDepthRange(ObjectReader& object, CameraDescription& camera) {
        const double distance = glm::distance(camera.position, camera.target);
        double near = distance / 100 / scene_.millimetersPerUnit, far = near * 10000;
        readNumber(object, "near", positive, near);
        readNumber(object, "far", positive, far);
        camera.near = near * scene_.millimetersPerUnit;
        camera.far = far * scene_.millimetersPerUnit;
    }

    void checkDepthRange(const ObjectReader& object, const CameraDescription& camera) {
        if (camera.near < camera.far) return checkDepthPrecision(object, camera);
        const auto near = object.value().find("near"), far = object.value().find("far");
        if (!near && !far) return;  // both are 0 then: position and target are the same
        diagnostics_.error(
            (near ? near : far)->where(),
            fmt::format("the camera's near must be less than its far, found near {} and far {}",
                        camera.near / scene_.millimetersPerUnit, camera.far / scene_.millimetersPerUnit));
    }

    /// A 32-bit depth of 1 - near/distance cannot tell surfaces from empty space when near/far nears 2^-24.
    void checkDepthPrecision(const ObjectReader& object, const CameraDescription& camera) {
        constexpr double leastRatio = 1e-6;
        if (camera.near >= leastRatio * camera.far) return;
        const auto near = object.value().find("near"), far = object.value().find("far");
        const Value& place = near ? *near : far ? *far : object.value();
        diagnostics_.error(
            place.where(),
            fmt::format("the camera's near must be at least 1e-6 of its far, found near {} and far {}",
                        camera.near / scene_.millimetersPerUnit, camera.far / scene_.millimetersPerUnit));
    }

    void checkOrientation(const CameraDescription& camera) {
        const glm::dvec3 forward = camera.target - camera.position;
        const double distance = glm::length(forward), up = glm::length(camera.up);
        if (!(distance > 0))
            diagnostics_.error(camera.where, "the camera's position and target are the same place");
        else if (!(up > 0))
            diagnostics_.error(camera.where, "the camera's up is zero");
        else if (glm::length(glm::cross(forward / distance, camera.up / up)) < 1e-6)
            diagnostics_.error(camera.where, "the camera's up is parallel to its view direction");
    }

    // ---- light

    void readLights() {
        const auto lights = root_.optional("lights");
        if (!lights || !isArray(*lights, "lights")) return;
        for (std::size_t i = 0; i < lights->size(); ++i) readLight(lights->at(i));
    }

    void readLight(const Value& value) {
        ObjectReader object(value, "a light", keys::light(), diagnostics_);
        LightDescription light;
        light.where = value.where();
        if (const auto type = object.optional("type"))
            readWord(*type, "a light's type", lightTypes, diagnostics_);
        if (const auto position = object.optional("position")) readPosition(*position, light.position);
        if (const auto intensity = object.optional("intensity"))
            readVector(*intensity, notNegative, light.intensity, diagnostics_);
        object.finish();
        scene_.lights.push_back(light);
    }

    void readEnvironment(const Value& value) {
        ObjectReader object(value, "an environment", keys::environment(), diagnostics_);
        EnvironmentDescription& environment = scene_.environment;
        environment.where = value.where();
        const auto radiance = object.optional("radiance"), image = object.optional("image");
        if (radiance) readVector(*radiance, notNegative, environment.radiance, diagnostics_);
        if (image)
            if (const auto file = image->string(diagnostics_, "the name of an EXR file"))
                environment.image = resolvePath(*file, folder_);
        readNumber(object, "scale", notNegative, environment.scale);
        object.finish();
        if (radiance && image)
            diagnostics_.error(image->whereKey(),
                               "an environment has either \"radiance\" or \"image\", found both");
        else if (value.isObject() && !radiance && !image)
            diagnostics_.error(value.where(), "an environment needs \"radiance\" or \"image\"");
    }

    // ---- materials

    void readMaterials() {
        const auto materials = root_.optional("materials");
        if (!materials) return;
        if (!materials->isObject())
            return diagnostics_.error(
                materials->where(),
                fmt::format("expected an object of materials, found {}", materials->describe()));
        for (const auto& [name, value] : materials->members()) {
            if (value.isString()) {
                if (auto preset = presetOf(value, {})) named_.emplace(name, std::move(*preset));
            } else {
                named_.emplace(name, readMaterial(value, name, folder_, presets_, diagnostics_));
            }
        }
    }

    /// The preset a string names. `others` are names that would have been right, too.
    std::optional<MaterialDescription> presetOf(const Value& value,
                                                const std::vector<std::string_view>& others) {
        const auto name = value.string(diagnostics_, "a material's name");
        if (!name) return std::nullopt;
        if (presets_.has(*name)) return readPreset(*name, presets_, diagnostics_);
        std::vector<std::string_view> known = others;
        known.insert(known.end(), presets_.names().begin(), presets_.names().end());
        diagnostics_.error(value.where(), fmt::format("no material or preset is called \"{}\"{}", *name,
                                                      suggestion(*name, known)));
        return std::nullopt;
    }

    /// Index of the material of an object, which is added to the scene when it is first used.
    std::optional<std::uint32_t> use(const Value& value) {
        if (value.isObject()) return append(readMaterial(value, "", folder_, presets_, diagnostics_));
        const auto name = value.string(diagnostics_, "a material's name or an object");
        if (!name) return std::nullopt;
        if (const auto known = used_.find(*name); known != used_.end()) return known->second;
        const auto found = named_.find(*name);
        std::optional<MaterialDescription> material;
        if (found != named_.end()) {
            material = found->second;
        } else {
            std::vector<std::string_view> names;
            for (const auto& entry : named_) names.push_back(entry.first);
            material = presetOf(value, names);
        }
        if (!material) return std::nullopt;
        return used_.emplace(*name, append(std::move(*material))).first->second;
    }

    std::uint32_t append(MaterialDescription material) {
        scene_.materials.push_back(std::move(material));
        return static_cast<std::uint32_t>(scene_.materials.size() - 1);
    }

    // ---- objects

    void readObjects() {
        const auto objects = root_.optional("objects");
        if (!objects || !isArray(*objects, "objects")) return;
        const MaterialLookup lookup = [this](const Value& value) { return use(value); };
        for (std::size_t i = 0; i < objects->size(); ++i)
            scene_.objects.push_back(readObject(objects->at(i), {folder_, models_}, scene_.millimetersPerUnit,
                                                lookup, diagnostics_));
    }

    bool isArray(const Value& value, std::string_view what) {
        if (value.isArray()) return true;
        diagnostics_.error(value.where(),
                           fmt::format("expected an array of {}, found {}", what, value.describe()));
        return false;
    }

    void warn() {
        const bool noRadiance =
            scene_.environment.image.empty() && scene_.environment.radiance == glm::dvec3(0);
        const SourceLocation where = root_.value().where();
        if (scene_.lights.empty())
            diagnostics_.warning(
                where, noRadiance ? "the scene has no light and a dark environment, the picture will be black"
                                  : "the scene has no light, only its environment will be seen");
        if (scene_.objects.empty())
            diagnostics_.warning(where, "the scene has no object, the picture will be black");
    }

    ObjectReader root_;
    PresetFolder presets_;
    std::filesystem::path folder_;
    std::filesystem::path models_;
    Diagnostics& diagnostics_;
    SceneDescription scene_;
    std::map<std::string, MaterialDescription> named_;
    std::map<std::string, std::uint32_t> used_;
};

}  // namespace

SceneDescription readScene(const Value& value, const SceneOptions& options, Diagnostics& diagnostics) {
    return SceneReader(value, options, diagnostics).read();
}

SceneDescription readScene(const std::filesystem::path& file, const SceneOptions& options,
                           Diagnostics& diagnostics) {
    return readScene(json::parseFile(file), options, diagnostics);
}

}  // namespace nephrite::scene
