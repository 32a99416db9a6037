// What tests of the references share: scenes from text, and estimates with their errors.
#pragma once

#include <gtest/gtest.h>
#include <stdlib.h>

#include <filesystem>
#include <fstream>
#include <glm/glm.hpp>
#include <stdexcept>
#include <string>

#include "scattering/statistics.h"
#include "truth/walk.h"
#include "truth/world.h"

namespace nephrite::truth::test {

/// The scene a text says.
inline scene::Scene sceneOf(const std::string& text) {
    std::string folder = (std::filesystem::temp_directory_path() / "nephrite-truth-XXXXXX").string();
    if (::mkdtemp(folder.data()) == nullptr) throw std::runtime_error("no folder for the test");
    const std::filesystem::path file = std::filesystem::path(folder) / "scene.json";
    std::ofstream(file) << text;
    auto scene =
        scene::Scene::load(file, {std::filesystem::path(NEPHRITE_SOURCE_DIR) / "graphs" / "materials", 0});
    std::filesystem::remove_all(folder);
    return scene;
}

inline const std::string anyCamera = R"json("camera": {"position": [0, 0, 40], "fovY": 36})json";

/// The contract's sphere of radius 10 mm with its light, made of `material`.
inline std::string sphereScene(const std::string& material) {
    return "{" + anyCamera +
           R"json(, "lights": [{"type": "point", "position": [30, 30, 10], "intensity": [5000, 5000, 5000]}],
                  "objects": [{"mesh": {"procedural": "sphere", "radius": 10}, "material": )json" +
           material + "}]}";
}

/// A block so large that from the middle of its upper face, y = 0, it looks endless; lit from very far away
/// along the direction whose angle to +y has this cosine, with an irradiance of 1 W/mm^2 across the beam.
inline std::string slabScene(const std::string& material, double lightCosine) {
    const double distance = 1e5;
    const double sine = std::sqrt(1 - lightCosine * lightCosine);
    return "{" + anyCamera + R"json(, "lights": [{"type": "point", "position": [)json" +
           std::to_string(distance * sine) + ", " + std::to_string(distance * lightCosine) +
           R"json(, 0], "intensity": [1e10, 1e10, 1e10]}],
                  "objects": [{"mesh": {"procedural": "slab", "size": [600, 300, 600]}, "material": )json" +
           material + R"json(, "transform": {"translate": [0, -150, 0]}}]})json";
}

inline std::string text(const glm::dvec3& vector) {
    return "[" + std::to_string(vector.x) + "," + std::to_string(vector.y) + "," + std::to_string(vector.z) +
           "]";
}

/// A grey layer's text.
inline std::string layer(double absorption, double scattering, const std::string& thickness = "null") {
    const std::string a = std::to_string(absorption), s = std::to_string(scattering);
    return R"({"absorption": [)" + a + "," + a + "," + a + R"(], "scattering": [)" + s + "," + s + "," + s +
           R"(], "thickness": )" + thickness + "}";
}

inline std::string material(const std::string& layers, double eta, double g = 0) {
    return R"({"layers": [)" + layers + R"(], "eta": )" + std::to_string(eta) + R"(, "g": )" +
           std::to_string(g) + "}";
}

/// Mean and error of what `draw(random)` gives in `count` independent streams.
template<class Draw>
scattering::RunningStatistics estimate(std::uint64_t seed, std::uint64_t count, Draw&& draw) {
    scattering::RunningStatistics statistics;
    for (std::uint64_t i = 0; i < count; ++i) {
        scattering::Random random(seed, 0, i);
        statistics.add(draw(random));
    }
    return statistics;
}

/// The surface that a ray towards -direction from far away in `direction` sees at `target`, and that ray's
/// direction.
struct Sight {
    SurfacePoint seen;
    glm::dvec3 view;
};

inline Sight look(const World& world, const glm::dvec3& target, const glm::dvec3& direction) {
    const glm::dvec3 unit = glm::normalize(direction);
    const auto seen = world.geometry().trace({target + 20.0 * unit, -unit});
    if (!seen) throw std::runtime_error("there is nothing to be seen");
    return {*seen, -unit};
}

}  // namespace nephrite::truth::test
