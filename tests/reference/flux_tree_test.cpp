// The flux that enters a sphere through the texels of a light's view, and the tree that gathers it up:
// against the exact flux, leaf by leaf against its density, and level by level.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <numbers>

#include "reference/dumped_flux_tree.h"
#include "reference/dumped_frame.h"
#include "reference/literal/fresnel.h"
#include "runtime/session.h"
#include "scratch_folder.h"
#include "special_functions.h"
#include "statistics.h"

namespace nephrite::reference {
namespace {

constexpr double radius = 10;
constexpr double eta = 1.3;
const glm::dvec3 light{30, 30, 10};
constexpr std::uint32_t base = 128;

constexpr const char* scene = R"({ "millimetersPerUnit": 1,
  "camera": {"position": [0, 0, 40], "target": [0, 0, 0], "up": [0, 1, 0], "fovY": 36, "near": 1, "far": 1000},
  "lights": [{"type": "point", "position": [30, 30, 10], "intensity": [5000, 5000, 5000]}],
  "materials": {"apple": {"layers": [{"absorption": [0.003, 0.0034, 0.046], "scattering": [2.29, 2.39, 1.97]}], "g": 0, "eta": 1.3}},
  "objects": [{"mesh": {"procedural": "sphere", "radius": 10}, "material": "apple"}] })";

DumpedFluxTree renderedTree() {
    runtime::SessionOptions options;
    options.scene = sharedScratchFolder().write("flux-tree.json", scene);
    options.graph = graphFolder() / "consistent.json";
    options.size = {16, 16};
    options.settings = {"lightSize=512", "treeSize=" + std::to_string(base)};
    options.dumps = {"flux-tree.places", "flux-tree.entries"};
    runtime::Session session(options);
    session.renderFrame(0);
    return {session.read("flux-tree.places"), session.read("flux-tree.entries"), base};
}

const DumpedFluxTree& tree() {
    static const DumpedFluxTree made = renderedTree();
    return made;
}

/// Flux per radiant intensity through the part of the sphere whose normal makes a cosine of at least `low`
/// with the direction of the light: int F_t dOmega. With D the light's distance and t the cosine,
/// dOmega = 2 pi R^2 mu dt / d^2, d^2 = D^2 + R^2 - 2 D R t, mu = (D t - R)/d.
double exactFlux(double low, double high) {
    const double distance = glm::length(light);
    return statistics::integrate(low, high, [&](double t) {
        const double squared = distance * distance + radius * radius - 2 * distance * radius * t;
        const double cosine = (distance * t - radius) / std::sqrt(squared);
        return 2 * std::numbers::pi * radius * radius * cosine / squared *
               (1 - fresnelReflectance(cosine, eta));
    });
}

double total(const std::vector<FluxNode>& nodes) {
    double sum = 0;
    for (const FluxNode& node : nodes) sum += node.flux;
    return sum;
}

TEST(FluxTree, HoldsTheFluxThatEntersASphereAtEveryLevel) {
    const double exact = exactFlux(radius / glm::length(light), 1);
    for (std::uint32_t number = 0; number <= 7; ++number) {
        const double sum = total(tree().level(number));
        // The outline of the view's texels is not quite the sphere's; merging loses nothing but roundings.
        EXPECT_NEAR(sum / exact, 1, 2e-3) << "level " << number;
        EXPECT_NEAR(sum / total(tree().level(0)), 1, 1e-5) << "level " << number;
    }
}

/// Chi-squared test of the leaves' flux over bands of the sphere against a density: each lit leaf counts as a
/// sample.
template<class Density>
double bandTest(Density&& flux) {
    constexpr int bands = 16;
    const double low = radius / glm::length(light);
    std::vector<double> shares(bands, 0);
    std::vector<double> exact(bands);
    double samples = 0;
    double sum = 0;
    for (const FluxNode& node : tree().level(0)) {
        if (node.variance < 0) continue;
        const double cosine = glm::dot(glm::normalize(node.centre), glm::normalize(light));
        const int band = static_cast<int>((cosine - low) / (1 - low) * bands);
        shares[static_cast<std::size_t>(std::clamp(band, 0, bands - 1))] += node.flux;
        samples += 1;
        sum += node.flux;
    }
    double exactSum = 0;
    for (int band = 0; band < bands; ++band) {
        exact[static_cast<std::size_t>(band)] =
            flux(low + (1 - low) * band / bands, low + (1 - low) * (band + 1) / bands);
        exactSum += exact[static_cast<std::size_t>(band)];
    }
    std::vector<std::uint64_t> counts;
    for (std::size_t band = 0; band < shares.size(); ++band) {
        counts.push_back(static_cast<std::uint64_t>(std::lround(samples * shares[band] / sum)));
        exact[band] /= exactSum;
    }
    return statistics::chiSquaredTest(counts, exact);
}

TEST(FluxTree, LeavesFollowTheDensityOfTheFlux) {
    statistics::Family family;
    family.add("flux over bands of the sphere", bandTest(exactFlux));
    EXPECT_TRUE(family.holds());

    statistics::Family wrong;
    wrong.add("as if every band of the sphere took in the same",
              bandTest([](double low, double high) { return high - low; }));
    EXPECT_FALSE(wrong.holds());
}

TEST(FluxTree, NodesHaveTheMeanAndTheVarianceOfTheirLeaves) {
    const std::vector<FluxNode> leaves = tree().level(0);
    for (const std::uint32_t number : {1U, 3U, 4U, 7U}) {
        const std::vector<FluxNode> nodes = tree().level(number);
        const std::size_t parts = leaves.size() / nodes.size();
        for (std::size_t i = 0; i < nodes.size(); i += std::max<std::size_t>(1, nodes.size() / 64)) {
            FluxNode exact{glm::dvec3(0), 0, glm::dvec3(0), 0};
            for (std::size_t k = i * parts; k < (i + 1) * parts; ++k) {
                exact.flux += leaves[k].flux;
                exact.centre += leaves[k].flux * leaves[k].centre;
                exact.normal += leaves[k].flux * leaves[k].normal;
            }
            if (exact.flux == 0) {
                EXPECT_LT(nodes[i].variance, 0) << "a dark node of level " << number;
                continue;
            }
            exact.centre /= exact.flux;
            exact.normal /= exact.flux;
            for (std::size_t k = i * parts; k < (i + 1) * parts; ++k) {
                const glm::dvec3 off = leaves[k].centre - exact.centre;
                exact.variance +=
                    leaves[k].flux / exact.flux * (glm::dot(off, off) + std::max(leaves[k].variance, 0.0));
            }
            EXPECT_NEAR(glm::distance(nodes[i].centre, exact.centre), 0, 1e-4) << number;
            EXPECT_NEAR(glm::distance(nodes[i].normal, exact.normal), 0, 1e-4) << number;
            EXPECT_NEAR(nodes[i].variance, exact.variance, 1e-4 * exact.variance + 1e-6) << number;
        }
    }
}

}  // namespace
}  // namespace nephrite::reference
