// See law_checks.h.
#include "stress/law_checks.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "scattering/fresnel.h"
#include "scattering/quadrature.h"

namespace nephrite::stress {
namespace {

SceneValues sphereOf(const MaterialValues& material) {
    SceneValues scene;
    scene.materials = {material};
    return scene;
}

/// One check for each graph and channel. A mean of 0 is nobody's limit: nothing was rendered.
void checkSame(const std::vector<Triple>& means, const std::vector<Triple>& expected, double tolerance,
               const std::vector<GraphChoice>& graphs, Outcome& outcome) {
    for (std::size_t graph = 0; graph < graphs.size(); ++graph) {
        for (std::size_t c = 0; c < 3; ++c) {
            const double difference = std::abs(means[graph][c] - expected[graph][c]);
            outcome.check(expected[graph][c] > 0 && difference <= tolerance * expected[graph][c],
                          fmt::format("{}: mean {:.6g} of channel {}, expected {:.6g} within {:.2g} of it",
                                      graphs[graph].file.stem().string(), means[graph][c], c,
                                      expected[graph][c], tolerance));
        }
    }
}

constexpr double lightDistance = 43.6;  ///< mm, from the sphere's centre

/// Power, W, that enters the sphere from a light of 1 W/sr.
double enteringPower(double eta) {
    const double least = std::sqrt(1 - std::pow(objectRadius / lightDistance, 2));
    return 2 * std::numbers::pi * scattering::integratePanels(least, 1, 8, [&](double cosine) {
               const double sine = std::sqrt(1 - cosine * cosine) * lightDistance / objectRadius;
               const double incidence = std::sqrt(std::max(0.0, 1 - sine * sine));
               return 1 - scattering::reflectanceFromOutside(incidence, eta);
           });
}

/// The sphere of a material, its light on the x axis, seen from far away at an angle to that of this cosine.
SceneValues seenAt(const MaterialValues& material, double cosine) {
    constexpr double distance = 400 * objectRadius;
    SceneValues scene = sphereOf(material);
    scene.lights = {{{lightDistance, 0, 0}, 1}};
    scene.camera = {distance * cosine, 0, distance * std::sqrt(1 - cosine * cosine)};
    scene.near = distance - 10 * objectRadius;
    scene.far = distance + 10 * objectRadius;
    scene.fovY = 2 * std::asin(1.02 * objectRadius / distance) * 180 / std::numbers::pi;
    return scene;
}

}  // namespace

void checkLimit(const Limit& law, const std::vector<GraphChoice>& graphs, const Place& place,
                Outcome& outcome) {
    const auto expected = pictureMeans(law.limit, graphs, place);
    for (const SceneValues& scene : law.scenes)
        checkSame(pictureMeans(scene, graphs, place), expected, law.tolerance, graphs, outcome);
}

void checkFallsWithAbsorption(const MaterialValues& material, const std::vector<GraphChoice>& graphs,
                              const Place& place, Outcome& outcome) {
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

void checkSameAtEverySize(const SceneValues& scene, const std::vector<GraphChoice>& graphs,
                          const Place& place, Outcome& outcome) {
    checkSame(pictureMeans(scene, graphs, place, 256), pictureMeans(scene, graphs, place, 1024), 0.01, graphs,
              outcome);
}

void checkKeepsPower(const MaterialValues& material, const GraphChoice& graph, const Place& place,
                     Outcome& outcome) {
    constexpr std::uint32_t size = 64;
    Triple leaving{};
    scattering::forPanelNodes(-1, 1, [&](double cosine, double weight) {
        const Triple intensity = radiantIntensity(seenAt(material, cosine), graph, place, size);
        for (std::size_t c = 0; c < 3; ++c) leaving[c] += 2 * std::numbers::pi * weight * intensity[c];
    });
    const double entering = enteringPower(material.eta);
    for (std::size_t c = 0; c < 3; ++c) {
        const double share = leaving[c] / entering;
        outcome.check(share <= 1.03 && share >= 1.0 / 3,
                      fmt::format("{}: {:.3f} of the power that enters leaves in channel {}, expected 1/3 to "
                                  "1.03",
                                  graph.file.stem().string(), share, c));
    }
}

}  // namespace nephrite::stress
