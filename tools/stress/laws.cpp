// See laws.h.
#include "stress/laws.h"

#include <fmt/format.h>

#include <cmath>

namespace nephrite::stress {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Without screen-space.json: its 8 to 64 samples a pixel change sides and number with the medium, in steps
/// of some tenths of a percent.
std::vector<GraphChoice> smoothGraphs() {
    return {graphNamed("consistent"), graphNamed("light-pyramid")};
}

/// Scenes whose pictures must have the same means as that of their limit.
struct Limit {
    std::string name;
    std::vector<SceneValues> scenes;
    SceneValues limit;
    double tolerance;  ///< relative
};

void checkSame(const Limit& law, const Place& place, Outcome& outcome) {
    const auto graphs = smoothGraphs();
    const auto expected = pictureMeans(law.limit, graphs, place);
    for (const SceneValues& scene : law.scenes) {
        const auto means = pictureMeans(scene, graphs, place);
        for (std::size_t graph = 0; graph < graphs.size(); ++graph) {
            for (std::size_t c = 0; c < 3; ++c) {
                const double difference = std::abs(means[graph][c] - expected[graph][c]);
                outcome.check(
                    difference <= law.tolerance * expected[graph][c],
                    fmt::format("{}: mean {:.6g} of channel {}, expected {:.6g} within {:.2g} of it",
                                graphs[graph].file.stem().string(), means[graph][c], c, expected[graph][c],
                                law.tolerance));
            }
        }
    }
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

/// The more is absorbed, the darker the picture.
void checkFallsWithAbsorption(const MaterialValues& material, const Place& place, Outcome& outcome) {
    const auto graphs = smoothGraphs();
    std::vector<Triple> last;
    for (const double absorption : {0.0, 0.01, 0.1, 1.0, 10.0}) {
        SceneValues scene = sphereOf(material);
        for (LayerValues& layer : scene.materials[0].layers)
            layer.absorption = {absorption, absorption, absorption};
        const auto means = pictureMeans(scene, graphs, place);
        for (std::size_t graph = 0; graph < graphs.size() && !last.empty(); ++graph)
            for (std::size_t c = 0; c < 3; ++c)
                outcome.check(means[graph][c] < last[graph][c],
                              fmt::format("{}: mean {:.6g} of channel {} at absorption {}, {:.6g} at less",
                                          graphs[graph].file.stem().string(), means[graph][c], c, absorption,
                                          last[graph][c]));
        last = means;
    }
}

}  // namespace

std::vector<Case> lawCases(const Place& place) {
    std::vector<Case> cases;
    for (const auto& laws : {scaleLaws(), limitLaws()})
        for (const Limit& law : laws)
            cases.push_back({"law/" + law.name, [law, place](Outcome& o) { checkSame(law, place, o); }});
    for (const NamedMaterial& named : someMaterials())
        cases.push_back({"law/falls-with-absorption+" + named.name,
                         [named, place](Outcome& o) { checkFallsWithAbsorption(named.material, place, o); }});
    return cases;
}

}  // namespace nephrite::stress
