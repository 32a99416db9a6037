// Meshes of a scene: from files and formulas, shared where objects do not deform them.
#include "scene/mesh_loading.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "scene/mesh/load.h"
#include "scene/procedural_reader.h"

namespace nephrite::scene {
namespace {

bool movesVertices(const ObjectDescription& object) {
    return std::any_of(
        object.animations.begin(), object.animations.end(), [](const AnimationDescription& animation) {
            return animation.type == AnimationType::Clip || animation.type == AnimationType::Deformation;
        });
}

/// Equal for objects that can share a mesh.
std::string sharingKey(const ObjectDescription& object) {
    const MeshDescription& mesh = object.mesh;
    const int mapping = mesh.mapping ? static_cast<int>(*mesh.mapping) : -1;
    const std::string source =
        mesh.procedural ? std::string(mesh.procedural->sourceText()) : mesh.file.string();
    return fmt::format("{}:{}:{}", mesh.procedural.has_value(), mapping, source);
}

std::optional<AnimatedMesh> makeProcedural(const MeshDescription& description, Diagnostics& diagnostics) {
    auto mesh = readProcedural(*description.procedural, diagnostics);
    if (!mesh) return std::nullopt;
    if (description.mapping && *description.mapping != TextureMapping::file)
        mapTexture(*mesh, *description.mapping);
    return AnimatedMesh(std::move(*mesh));
}

std::optional<AnimatedMesh> loadFile(const MeshDescription& description, Diagnostics& diagnostics) {
    try {
        return loadMesh(description.file, description.mapping, diagnostics);
    } catch (const InputError& error) {
        for (const Diagnostic& fault : error.faults()) diagnostics.error(fault.where, fault.message);
        diagnostics.error(description.where,
                          fmt::format("cannot use the mesh {}", description.file.string()));
        return std::nullopt;
    }
}

void playClip(AnimatedMesh& mesh, const AnimationDescription& animation, Diagnostics& diagnostics) {
    const std::vector<std::string> clips = mesh.clipNames();
    if (clips.empty()) return diagnostics.error(animation.where, "the mesh has no clips");
    const std::string& wanted = animation.clip.empty() ? clips.front() : animation.clip;
    if (mesh.play(wanted)) return;
    const std::vector<std::string_view> known(clips.begin(), clips.end());
    diagnostics.error(animation.where,
                      fmt::format("the mesh has no clip \"{}\"{}", wanted, suggestion(wanted, known)));
}

void applyAnimations(AnimatedMesh& mesh, const ObjectDescription& object, Diagnostics& diagnostics) {
    for (const AnimationDescription& animation : object.animations) {
        if (animation.type == AnimationType::Clip) playClip(mesh, animation, diagnostics);
        if (animation.type == AnimationType::Deformation) mesh.deform(animation.deformation);
    }
}

}  // namespace

void loadMeshes(Scene::State& state, Diagnostics& diagnostics) {
    std::map<std::string, std::uint32_t> shared;
    for (const ObjectDescription& object : state.description.objects) {
        const std::string key = sharingKey(object);
        const bool own = movesVertices(object);
        if (const auto known = shared.find(key); known != shared.end() && !own) {
            state.meshOfObject.push_back(known->second);
            continue;
        }
        if (!object.mesh.procedural && object.mesh.file.empty())
            continue;  // the reader has said what is wrong
        auto mesh = object.mesh.procedural ? makeProcedural(object.mesh, diagnostics)
                                           : loadFile(object.mesh, diagnostics);
        if (!object.mesh.procedural) state.files.push_back(object.mesh.file);
        if (!mesh) continue;
        applyAnimations(*mesh, object, diagnostics);
        const auto index = static_cast<std::uint32_t>(state.meshes.size());
        const EnclosingSphere sphere = enclosingSphere(mesh->rest().positions);
        state.meshes.push_back({std::move(*mesh), sphere});
        state.meshOfObject.push_back(index);
        if (!own) shared.emplace(key, index);
    }
}

}  // namespace nephrite::scene
