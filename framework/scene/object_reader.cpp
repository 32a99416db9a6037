// Objects, their transforms and animations.
#include "scene/object_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "scene/deformation_reader.h"
#include "scene/material_reader.h"
#include "scene/scene_keys.h"
#include "scene/shape_keys.h"
#include "scene/value_rules.h"

namespace nephrite::scene {
namespace {

using json::ObjectReader;
using json::Value;

std::vector<std::string_view> animationTypes() {
    std::vector<std::string_view> types{"clip", "rotate", "path"};
    for (const keys::Kind& kind : keys::deformation()) types.push_back(kind.name);
    return types;
}

void readModel(const Value& value, const std::filesystem::path& models, MeshDescription& mesh,
               Diagnostics& diagnostics) {
    ObjectReader object(value, "a model", keys::model(), diagnostics);
    const auto model = object.optional("model");
    object.finish();
    const auto file = model->string(diagnostics, "a mesh file's name");
    if (!file) return;
    if (models.empty())
        return diagnostics.error(
            model->where(),
            fmt::format("the model {} is not part of Nephrite: set NEPHRITE_MODELS to the folder that has it",
                        inQuotes(*file)));
    mesh.file = resolvePath(*file, models);
}

void readMesh(const Value& value, const MeshFolders& folders, MeshDescription& mesh,
              Diagnostics& diagnostics) {
    mesh.where = value.where();
    if (value.isObject() && value.find("model"))
        readModel(value, folders.models, mesh, diagnostics);
    else if (value.isObject())
        mesh.procedural = value;
    else if (const auto file = value.string(diagnostics, "a mesh file's name or {\"procedural\": ...}"))
        mesh.file = resolvePath(*file, folders.scene);
}

void readMapping(ObjectReader& object, MeshDescription& mesh) {
    const auto value = object.optional("uv");
    if (!value) return;
    const auto word = readWord(*value, "a texture mapping", textureMappingNames, object.diagnostics());
    if (word) mesh.mapping = textureMapping(textureMappingNames[*word]);
}

void readScale(ObjectReader& object, glm::dvec3& scale) {
    const auto value = object.optional("scale");
    if (!value) return;
    if (value->isArray()) return readVector(*value, scaleRule, scale, object.diagnostics());
    double uniform = 1;
    readNumber(*value, scaleRule, uniform, object.diagnostics());
    scale = glm::dvec3(uniform);
}

TransformDescription readTransform(const Value& value, double millimetersPerUnit, Diagnostics& diagnostics) {
    ObjectReader object(value, "a transform", keys::transform(), diagnostics);
    TransformDescription transform;
    readVector(object, "translate", anyNumber, transform.translate);
    transform.translate *= millimetersPerUnit;
    readVector(object, "rotate", anyNumber, transform.rotate);
    readScale(object, transform.scale);
    if (const auto fit = object.optional("fit")) {
        double length = 1;
        readNumber(*fit, positive, length, diagnostics);
        transform.fit = length;
    }
    object.finish();
    return transform;
}

/// Reads animations and keeps count of those a mesh can have only one of.
class AnimationReader {
  public:
    AnimationReader(double millimetersPerUnit, Diagnostics& diagnostics)
        : millimetersPerUnit_(millimetersPerUnit), diagnostics_(diagnostics) {}

    std::vector<AnimationDescription> readAll(const Value& value) {
        std::vector<AnimationDescription> animations;
        const std::size_t count = value.isArray() ? value.size() : 1;
        for (std::size_t i = 0; i < count; ++i)
            if (auto animation = read(value.isArray() ? value.at(i) : value))
                animations.push_back(std::move(*animation));
        checkSingle(animations, AnimationType::Clip, "clip");
        checkSingle(animations, AnimationType::Deformation, "deformation (twist, bend or pulse)");
        return animations;
    }

  private:
    std::optional<AnimationDescription> read(const Value& value) {
        const auto type = typeOf(value);
        if (!type) return std::nullopt;
        AnimationDescription animation;
        animation.where = value.where();
        if (isDeformation(*type)) {
            animation.type = AnimationType::Deformation;
            if (const auto deformation = readDeformation(value, diagnostics_))
                animation.deformation = *deformation;
            return animation;
        }
        if (*type == "clip") readClip(value, animation);
        if (*type == "rotate") readRotation(value, animation);
        if (*type == "path") readPath(value, animation);
        return animation;
    }

    std::optional<std::string_view> typeOf(const Value& value) {
        ObjectReader object(value, "an animation", diagnostics_);
        const auto type = object.required("type");
        if (!type) return std::nullopt;
        const std::vector<std::string_view> known = animationTypes();
        const auto word = readWord(*type, "an animation's type", known, diagnostics_);
        return word ? std::optional(known[*word]) : std::nullopt;
    }

    void readClip(const Value& value, AnimationDescription& animation) {
        ObjectReader object(value, "a clip", keys::clip(), diagnostics_);
        object.finish();
        animation.type = AnimationType::Clip;
        if (const auto name = object.optional("name"))
            if (const auto text = name->string(diagnostics_, "a clip's name")) animation.clip = *text;
    }

    void readRotation(const Value& value, AnimationDescription& animation) {
        ObjectReader object(value, "a rotation", keys::rotation(), diagnostics_);
        object.finish();
        animation.type = AnimationType::Rotate;
        readNumber(object, "degreesPerSecond", anyNumber, animation.degreesPerSecond);
        const auto axis = object.optional("axis");
        if (!axis) return;
        readVector(*axis, anyNumber, animation.axis, diagnostics_);
        const double length = glm::length(animation.axis);
        if (length > 0)
            animation.axis /= length;
        else
            diagnostics_.error(axis->where(), "expected an axis that is not zero, found [0, 0, 0]");
    }

    void readPath(const Value& value, AnimationDescription& animation) {
        ObjectReader object(value, "a path", keys::path(), diagnostics_);
        object.finish();
        animation.type = AnimationType::Path;
        readNumber(object, "secondsPerLoop", positive, animation.secondsPerLoop);
        readBool(object, "smooth", animation.smooth);
        const auto points = object.optional("points");
        if (!points) return;
        if (!points->isArray() || points->size() < 2)
            return diagnostics_.error(
                points->where(),
                fmt::format("expected an array of at least 2 points, found {}", points->describe()));
        for (std::size_t i = 0; i < points->size(); ++i) {
            animation.points.emplace_back(0);
            readVector(points->at(i), anyNumber, animation.points.back(), diagnostics_);
            animation.points.back() *= millimetersPerUnit_;
        }
    }

    void checkSingle(const std::vector<AnimationDescription>& animations, AnimationType type,
                     std::string_view what) {
        const auto isOfType = [type](const AnimationDescription& animation) {
            return animation.type == type;
        };
        const auto first = std::find_if(animations.begin(), animations.end(), isOfType);
        if (first == animations.end()) return;
        const auto second = std::find_if(first + 1, animations.end(), isOfType);
        if (second != animations.end())
            diagnostics_.error(second->where,
                               fmt::format("an object can have only one {}, the first is at line {}", what,
                                           first->where.line));
    }

    double millimetersPerUnit_;
    Diagnostics& diagnostics_;
};

}  // namespace

ObjectDescription readObject(const Value& value, const MeshFolders& folders, double millimetersPerUnit,
                             const MaterialLookup& materialOf, Diagnostics& diagnostics) {
    ObjectReader object(value, "an object", keys::object(), diagnostics);
    ObjectDescription description;
    description.where = value.where();
    if (const auto mesh = object.optional("mesh")) readMesh(*mesh, folders, description.mesh, diagnostics);
    if (const auto material = object.optional("material"))
        if (const auto index = materialOf(*material)) description.material = *index;
    readMapping(object, description.mesh);
    if (const auto transform = object.optional("transform"))
        description.transform = readTransform(*transform, millimetersPerUnit, diagnostics);
    if (const auto animation = object.optional("animation"))
        description.animations = AnimationReader(millimetersPerUnit, diagnostics).readAll(*animation);
    object.finish();
    return description;
}

}  // namespace nephrite::scene
