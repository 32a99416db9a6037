// The passes of the default graph against the same formulas in double precision, leaf by leaf: with the tree
// and the grid switched off as far as that goes, and with them on.
#include "reference/geometric_sources.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <iostream>

#include "reference/dumped_frame.h"
#include "runtime/session.h"
#include "scattering/half_space.h"
#include "scratch_folder.h"

namespace nephrite::reference {
namespace {

constexpr std::uint32_t base = 512;
const glm::dvec3 light{30, 30, 10};
const glm::dvec3 camera{0, 0, 40};
constexpr double intensity = 5000;

/// Media by channel: apple's red and blue, and one of skin that absorbs more.
struct Material {
    double eta;
    std::array<Medium, 3> channels;
    std::array<double, 3> reflectance;  ///< total, of a half space under perpendicular light
};

Material materialOf(double eta) {
    Material material{eta, {{{0.003, 2.29, 0, eta}, {0.046, 1.97, 0, eta}, {0.17, 0.88, 0, eta}}}, {}};
    for (std::size_t c = 0; c < 3; ++c) {
        const Medium& medium = material.channels[c];
        material.reflectance[c] =
            scattering::halfSpaceReflectance({medium.absorption, medium.scattering, 0, eta});
    }
    return material;
}

runtime::Session sessionOf(const Material& material, const std::vector<std::string>& settings) {
    const auto& c = material.channels;
    runtime::SessionOptions options;
    options.scene = sharedScratchFolder().write(
        "geometric-sources.json",
        fmt::format(R"json({{ "millimetersPerUnit": 1,
  "camera": {{"position": [0, 0, 40], "target": [0, 0, 0], "up": [0, 1, 0], "fovY": 36, "near": 1, "far": 1000}},
  "lights": [{{"type": "point", "position": [30, 30, 10], "intensity": [5000, 5000, 5000]}}],
  "materials": {{"medium": {{"layers": [{{"absorption": [{}, {}, {}], "scattering": [{}, {}, {}]}}], "g": 0, "eta": {}}}}},
  "objects": [{{"mesh": {{"procedural": "sphere", "radius": 10}}, "material": "medium"}}] }})json",
                    c[0].absorption, c[1].absorption, c[2].absorption, c[0].scattering, c[1].scattering,
                    c[2].scattering, material.eta));
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

/// By channel, over sampled pixels: the greatest difference relative to the brightest of them, and the
/// greatest relative to a pixel itself, of those above a thousandth of the brightest.
struct Differences {
    std::array<double, 3> ofBrightest{};
    std::array<double, 3> ofPixel{};
};

/// Pixels near the terminator, where the shadow map's filter counts, are left out.
Differences differences(const Material& material, const std::vector<std::string>& settings) {
    runtime::Session session = sessionOf(material, settings);
    const DumpedFluxTree tree(session.read("flux-tree.places"), session.read("flux-tree.entries"), base);
    const std::vector<FluxNode> leaves = tree.level(0);
    const image::Image position = session.read("gbuffer.position");
    const image::Image normal = session.read("gbuffer.normal");
    const image::Image radiance = session.read("multiple.radiance");
    std::array<std::vector<std::array<double, 2>>, 3> pixels;  // exact and shown, by channel
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
            for (std::uint32_t c = 0; c < 3; ++c)
                pixels[c].push_back(
                    {geometricRadiance(point, leaves, material.channels[c], material.reflectance[c]),
                     static_cast<double>(radiance.at(x, y, c))});
        }
    }
    Differences result;
    for (std::size_t c = 0; c < 3; ++c) {
        const double brightest = (*std::max_element(pixels[c].begin(), pixels[c].end()))[0];
        for (const auto& [exact, shown] : pixels[c]) {
            const double difference = std::abs(shown - exact);
            result.ofBrightest[c] = std::max(result.ofBrightest[c], difference / brightest);
            if (exact > 1e-3 * brightest) result.ofPixel[c] = std::max(result.ofPixel[c], difference / exact);
        }
    }
    return result;
}

void print(const std::string& what, double eta, const Differences& off) {
    std::cout << fmt::format("{}, eta {}: off by {:.4f} of the brightest, {:.4f} of each pixel\n", what, eta,
                             fmt::join(off.ofBrightest, ", "), fmt::join(off.ofPixel, ", "));
}

TEST(GeometricSources, SmallPatchesWithoutAGridGiveWhatTheFormulasDo) {
    for (const double eta : {1.0, 1.3}) {
        const Differences off =
            differences(materialOf(eta), {"openingAngle=0.1", "interpolated.interpolationTolerance=0"});
        print("small patches", eta, off);
        for (std::size_t c = 0; c < 3; ++c) {
            EXPECT_LT(off.ofBrightest[c], 0.01);
            EXPECT_LT(off.ofPixel[c], eta == 1 ? 0.05 : 0.012);
        }
    }
}

TEST(GeometricSources, TreeAndGridChangeLittle) {
    const Differences off = differences(materialOf(1.3), {});
    print("tree and grid", 1.3, off);
    for (const double part : off.ofBrightest) EXPECT_LT(part, 0.05);
}

}  // namespace
}  // namespace nephrite::reference
