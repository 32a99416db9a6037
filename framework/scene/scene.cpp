// Loading a scene, its facts, and where everything is at a time.
#include "scene/scene.h"

#include <algorithm>

#include "scene/mesh_loading.h"
#include "scene/object_motion.h"
#include "scene/scene_state.h"
#include "scene/view.h"

namespace nephrite::scene {
namespace {

/// Moments looked at to learn where an animated scene's objects ever are.
constexpr int motionSamples = 16;

/// Around all objects at all times (sampled), or at the one time of a scene that does not move.
EnclosingSphere sphereOfMotion(const Scene::State& state, double seconds) {
    double period = 0;
    for (const ObjectDescription& object : state.description.objects)
        for (const AnimationDescription& animation : object.animations)
            period = std::max(period, periodOf(animation));
    std::vector<EnclosingSphere> spheres{state.at(seconds).bounds};
    if (period > 0)
        for (int i = 1; i < motionSamples; ++i)
            spheres.push_back(state.at(seconds + period * i / motionSamples).bounds);
    return enclosingSphere(spheres);
}

std::vector<std::uint32_t> countLightViews(const Scene::State& state, double seconds) {
    std::vector<std::uint32_t> counts;
    const EnclosingSphere sphere = sphereOfMotion(state, seconds);
    for (const LightDescription& light : state.description.lights)
        counts.push_back(lightViewCount(light.position, sphere));
    return counts;
}

}  // namespace

bool Scene::State::animated() const {
    return std::any_of(description.objects.begin(), description.objects.end(),
                       [](const ObjectDescription& object) { return !object.animations.empty(); });
}

Moment Scene::State::at(double seconds) const {
    Moment moment;
    std::vector<EnclosingSphere> meshSpheres;
    for (const SceneMesh& part : meshes) {
        auto& pose = moment.poses.emplace_back();
        if (part.mesh.animated()) pose = part.mesh.at(seconds);
        meshSpheres.push_back(pose ? enclosingSphere(pose->positions) : part.restSphere);
    }
    std::vector<EnclosingSphere> objectSpheres;
    for (std::size_t i = 0; i < description.objects.size(); ++i) {
        const std::uint32_t mesh = meshOfObject[i];
        moment.matrices.push_back(worldMatrix(description.objects[i], meshes[mesh].mesh.restBox(),
                                              description.millimetersPerUnit, seconds));
        objectSpheres.push_back(transformed(meshSpheres[mesh], moment.matrices.back()));
    }
    moment.bounds = enclosingSphere(objectSpheres);
    return moment;
}

Scene Scene::load(const std::filesystem::path& file, const SceneOptions& options) {
    Diagnostics diagnostics;
    auto state = std::make_unique<State>();
    state->files.push_back(file);
    state->description = readScene(file, options, diagnostics);
    for (const MaterialDescription& material : state->description.materials)
        if (!material.presetFile.empty()) state->files.push_back(material.presetFile);
    state->materials = packMaterials(state->description.materials, diagnostics);
    state->environment = loadEnvironment(state->description.environment, diagnostics);
    loadMeshes(*state, diagnostics);
    diagnostics.throwIfErrors();
    state->files.insert(state->files.end(), state->materials.files.begin(), state->materials.files.end());
    if (!state->description.environment.image.empty())
        state->files.push_back(state->description.environment.image);
    for (std::filesystem::path& path : state->files)
        path = std::filesystem::absolute(path).lexically_normal();
    state->lightViewCounts = countLightViews(*state, options.time);
    state->warnings = diagnostics.warnings();
    return Scene(std::move(state));
}

Scene::Scene(std::unique_ptr<State> state) : state_(std::move(state)) {}
Scene::~Scene() = default;
Scene::Scene(Scene&&) noexcept = default;
Scene& Scene::operator=(Scene&&) noexcept = default;

Facts Scene::facts() const {
    Facts facts;
    for (const GpuMaterial& material : state_->materials.materials) {
        ++(material.layerCount > 0 ? facts.translucentMaterials : facts.opaqueMaterials);
        facts.maxLayers = std::max(facts.maxLayers, material.layerCount);
    }
    facts.pointLights = static_cast<std::uint32_t>(state_->description.lights.size());
    facts.environment = state_->environment.hasRadiance() ? 1 : 0;
    facts.layerTextures = state_->materials.textures;
    facts.animated = state_->animated() ? 1 : 0;
    facts.objects = static_cast<std::uint32_t>(state_->description.objects.size());
    for (const std::uint32_t count : state_->lightViewCounts) facts.lightViews += count;
    return facts;
}

const SceneDescription& Scene::description() const {
    return state_->description;
}
const std::vector<Diagnostic>& Scene::warnings() const {
    return state_->warnings;
}
const std::vector<std::filesystem::path>& Scene::files() const {
    return state_->files;
}
EnclosingSphere Scene::boundingSphere(double time) const {
    return state_->at(time).bounds;
}
std::span<const std::uint32_t> Scene::lightViewCounts() const {
    return state_->lightViewCounts;
}

}  // namespace nephrite::scene
