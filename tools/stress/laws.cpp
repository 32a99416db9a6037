// See laws.h.
#include "stress/laws.h"

#include <cstddef>
#include <limits>

#include "stress/axes.h"
#include "stress/law_checks.h"

namespace nephrite::stress {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Without screen-space.json: its 8 to 64 samples a pixel change sides and number with the medium, in steps
/// of some tenths of a percent.
std::vector<GraphChoice> smoothGraphs() {
    return {graphNamed("consistent"), graphNamed("light-pyramid")};
}

SceneValues sphereOf(const MaterialValues& material) {
    SceneValues scene;
    scene.materials = {material};
    return scene;
}

struct NamedMaterial {
    std::string name;
    MaterialValues material;
};

std::vector<NamedMaterial> materials() {
    return {{"apple", {}},
            {"skin", {{{{0.032, 0.17, 0.48}, {7.4, 8.8, 10.1}}}, 0.9, 1.4}},
            {"dull", {{{{1, 2, 0.5}, {1, 0.5, 2}}}, 0, 1}},
            {"white", {{{{0, 0, 1e-6}, {2, 20, 1}}}, 0, 1.5}},
            {"layered", {{{{0.1, 0.2, 0.3}, {2, 1, 3}, 0.2}, {{1, 0, 0.1}, {1, 2, 3}, 3}}, 0.3, 1.3}},
            {"low-index", {{{{0.1, 0.01, 1}, {1, 2, 3}}}, 0, 0.8}}};
}

/// Little absorption, much of it, and layers.
std::vector<NamedMaterial> someMaterials() {
    const std::vector<NamedMaterial> all = materials();
    return {all[0], all[2], all[4]};
}

std::vector<Limit> scaleLaws() {
    std::vector<Limit> laws;
    for (const NamedMaterial& named : materials()) {
        const SceneValues plain = sphereOf(named.material);
        Limit law{"scale+" + named.name, {plain, plain}, plain, 1e-3};
        law.scenes[0].scale = 1e-4;
        law.scenes[1].scale = 1e4;
        laws.push_back(std::move(law));
    }
    return laws;
}

/// One law for each of three materials: `change` brings it near the limit, `limit` is the limit.
template<class Change, class ToLimit>
void addLimits(std::vector<Limit>& laws, const std::string& name, double tolerance, Change change,
               ToLimit limit) {
    for (const NamedMaterial& named : someMaterials()) {
        MaterialValues near = named.material;
        MaterialValues at = named.material;
        change(near);
        limit(at);
        laws.push_back({name + "+" + named.name, {sphereOf(near)}, sphereOf(at), tolerance});
    }
}

std::vector<Limit> limitLaws() {
    std::vector<Limit> laws;
    const auto absorption = [](double value) {
        return [value](MaterialValues& m) {
            for (LayerValues& layer : m.layers) layer.absorption = {value, value, value};
        };
    };
    const auto eta = [](double value) { return [value](MaterialValues& m) { m.eta = value; }; };
    const auto g = [](double value) { return [value](MaterialValues& m) { m.g = value; }; };
    addLimits(laws, "eta-to-1", 0.01, eta(1.0001), eta(1));
    addLimits(laws, "eta-to-1-from-below", 0.01, eta(0.9999), eta(1));
    addLimits(laws, "g-to-0", 1e-3, g(1e-6), g(0));
    addLimits(laws, "absorption-to-0", 1e-3, absorption(1e-9), absorption(0));
    addLimits(
        laws, "equal-layers", 1e-3,
        [](MaterialValues& m) {
            m.layers.resize(1);
            m.layers[0].thickness = infinite;
            m.layers.insert(m.layers.begin(), 3, m.layers[0]);
            for (std::size_t i = 0; i < 3; ++i) m.layers[i].thickness = 0.5;
        },
        [](MaterialValues& m) {
            m.layers.resize(1);
            m.layers[0].thickness = infinite;
        });
    addLimits(
        laws, "thick-to-infinite", 1e-3, [](MaterialValues& m) { m.layers.front().thickness = 1e6; },
        [](MaterialValues& m) { m.layers.front().thickness = infinite; });
    return laws;
}

/// Media, shapes and light from the front and from behind.
std::vector<NamedScene> scenesOfSizes() {
    const std::vector<NamedMaterial> all = materials();
    std::vector<NamedScene> scenes;
    for (const std::size_t i : {0U, 1U, 4U}) scenes.push_back({all[i].name, sphereOf(all[i].material)});
    scenes.push_back({"slab", sphereOf(all[2].material)});
    scenes.back().scene.objects[0].shape = Shape::slab;
    scenes.push_back({"from-behind", sphereOf(all[0].material)});
    scenes.back().scene.materials[0].eta = 1;
    scenes.back().scene.lights[0].position = {8, 12, -40};
    return scenes;
}

/// Spheres of 2, 20 and 200 free paths' radius that absorb nothing.
std::vector<NamedMaterial> whiteMaterials() {
    const LayerValues white{{0, 0, 0}, {0.2, 2, 20}};
    return {{"index-matched", {{white}, 0, 1}}, {"refracting", {{white}, 0, 1.3}}};
}

}  // namespace

std::vector<Case> lawCases(const Place& place) {
    std::vector<Case> cases;
    for (const auto& laws : {scaleLaws(), limitLaws()})
        for (const Limit& law : laws)
            cases.push_back(
                {"law/" + law.name, [law, place](Outcome& o) { checkLimit(law, smoothGraphs(), place, o); }});
    for (const NamedMaterial& named : someMaterials())
        cases.push_back({"law/falls-with-absorption+" + named.name, [named, place](Outcome& o) {
                             checkFallsWithAbsorption(named.material, smoothGraphs(), place, o);
                         }});
    for (const NamedScene& named : scenesOfSizes())
        cases.push_back({"law/same-at-every-size+" + named.name, [named, place](Outcome& o) {
                             checkSameAtEverySize(named.scene, {graphNamed("consistent")}, place, o);
                         }});
    for (const NamedMaterial& named : whiteMaterials())
        cases.push_back({"law/keeps-power+" + named.name, [named, place](Outcome& o) {
                             checkKeepsPower(named.material, graphNamed("consistent"), place, o);
                         }});
    return cases;
}

}  // namespace nephrite::stress
