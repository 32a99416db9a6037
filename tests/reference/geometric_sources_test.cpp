// The passes of the default graph against the same formulas in double precision, leaf by leaf: with the tree
// and the grid switched off as far as that goes, and with them on.
#include "reference/geometric_sources.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <iostream>

#include "reference/dumped_frame.h"
#include "runtime/session.h"
#include "scratch_folder.h"

namespace nephrite::reference {
namespace {

constexpr std::uint32_t base = 512;
const glm::dvec3 light{30, 30, 10};
const glm::dvec3 camera{0, 0, 40};
constexpr double intensity = 5000;

/// Media by channel, and the total reflectance of each: from a Monte Carlo of the half space of its own,
/// 400,000 photons, standard error below 0.0008.
struct Material {
    const char* name;
    Medium channels[3];
    double reflectance[3];
};
const Material material{"apple and skin",
                        {{0.003, 2.29, 0, 1.3}, {0.046, 1.97, 0, 1.3}, {0.17, 0.88, 0, 1.3}},
                        {0.8550, 0.5365, 0.2125}};

runtime::Session sessionOf(const std::vector<std::string>& settings) {
    const auto& c = material.channels;
    runtime::SessionOptions options;
    options.scene = sharedScratchFolder().write(
        "geometric-sources.json", fmt::format(R"json({{ "millimetersPerUnit": 1,
  "camera": {{"position": [0, 0, 40], "target": [0, 0, 0], "up": [0, 1, 0], "fovY": 36, "near": 1, "far": 1000}},
  "lights": [{{"type": "point", "position": [30, 30, 10], "intensity": [5000, 5000, 5000]}}],
  "materials": {{"medium": {{"layers": [{{"absorption": [{}, {}, {}], "scattering": [{}, {}, {}]}}], "g": 0, "eta": 1.3}}}},
  "objects": [{{"mesh": {{"procedural": "sphere", "radius": 10}}, "material": "medium"}}] }})json",
                                              c[0].absorption, c[1].absorption, c[2].absorption,
                                              c[0].scattering, c[1].scattering, c[2].scattering));
    options.graph = graphFolder() / "consistent.json";
    options.size = {48, 48};
    options.settings = settings;
    options.settings.emplace_back("lightSize=512");
    options.settings.emplace_back("treeSize=" + std::to_string(base));
    options.dumps = {"flux-tree.places", "flux-tree.entries", "gbuffer.position", "gbuffer.normal",
                     "multiple.radiance"};
    runtime::Session session(options);
    session.renderFrame(0);
    return session;
}

glm::dvec3 vectorAt(const image::Image& image, std::uint32_t x, std::uint32_t y) {
    return {static_cast<double>(image.at(x, y, 0)), static_cast<double>(image.at(x, y, 1)),
            static_cast<double>(image.at(x, y, 2))};
}

/// Greatest difference over sampled pixels, relative to the brightest of them, by channel. Pixels near the
/// terminator, where the shadow map's filter counts, are left out.
glm::dvec3 greatestDifference(runtime::Session session) {
    const DumpedFluxTree tree(session.read("flux-tree.places"), session.read("flux-tree.entries"), base);
    const std::vector<FluxNode> leaves = tree.level(0);
    const image::Image position = session.read("gbuffer.position");
    const image::Image normal = session.read("gbuffer.normal");
    const image::Image radiance = session.read("multiple.radiance");
    glm::dvec3 worst(0);
    glm::dvec3 brightest(0);
    for (std::uint32_t y = 5; y < 48; y += 7) {
        for (std::uint32_t x = 5; x < 48; x += 7) {
            if (position.at(x, y, 3) == 0) continue;
            LitPoint point;
            point.position = vectorAt(position, x, y);
            point.normal = glm::normalize(vectorAt(normal, x, y));
            point.toViewer = glm::normalize(camera - point.position);
            point.light = light;
            point.intensity = intensity;
            const double lit = glm::dot(point.normal, glm::normalize(light - point.position));
            if (std::abs(lit) < 0.15) continue;
            point.visibility = lit > 0 ? 1 : 0;
            for (int c = 0; c < 3; ++c) {
                const double exact =
                    geometricRadiance(point, leaves, material.channels[c], material.reflectance[c]);
                const double shown = static_cast<double>(radiance.at(x, y, static_cast<std::uint32_t>(c)));
                worst[c] = std::max(worst[c], std::abs(shown - exact));
                brightest[c] = std::max(brightest[c], exact);
            }
        }
    }
    return worst / brightest;
}

TEST(GeometricSources, SmallPatchesWithoutAGridGiveWhatTheFormulasDo) {
    const glm::dvec3 off =
        greatestDifference(sessionOf({"openingAngle=0.1", "interpolated.interpolationTolerance=0"}));
    std::cout << fmt::format("small patches: off by {:.4f}, {:.4f}, {:.4f} of the brightest\n", off.x, off.y,
                             off.z);
    for (int c = 0; c < 3; ++c) EXPECT_LT(off[c], 0.01);
}

TEST(GeometricSources, TreeAndGridChangeLittle) {
    const glm::dvec3 off = greatestDifference(sessionOf({}));
    std::cout << fmt::format("tree and grid: off by {:.4f}, {:.4f}, {:.4f} of the brightest\n", off.x, off.y,
                             off.z);
    for (int c = 0; c < 3; ++c) EXPECT_LT(off[c], 0.05);
}

}  // namespace
}  // namespace nephrite::reference
