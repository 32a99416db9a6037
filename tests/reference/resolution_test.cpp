// What changes with the size of the picture and what does not.
#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <numbers>

#include "reference/dumped_frame.h"
#include "reference/literal/dipole.h"
#include "scratch_folder.h"

namespace nephrite::reference {
namespace {

/// A sphere of radius 10 mm seen from 40 mm, lit from beside the camera; apple's red coefficients in all
/// channels.
constexpr const char* scene = R"({ "millimetersPerUnit": 1,
  "camera": {"position": [0, 0, 40], "target": [0, 0, 0], "up": [0, 1, 0], "fovY": 36, "near": 1, "far": 1000},
  "lights": [{"type": "point", "position": [20, 10, 60], "intensity": [5000, 5000, 5000]}],
  "materials": {"grey": {"layers": [{"absorption": [0.003, 0.003, 0.003], "scattering": [2.29, 2.29, 2.29]}], "g": 0, "eta": 1.3}},
  "objects": [{"mesh": {"procedural": "sphere", "radius": 10}, "material": "grey"}] })";
const Medium grey{0.003, 2.29, 0, 1.3};

DumpedFrame frameOf(std::uint32_t size) {
    return DumpedFrame(
        {sharedScratchFolder().write("resolution.json", scene), {size, size}, Formats::AllFloat32, {}});
}

double meanOverCovered(const DumpedFrame& frame, const std::string& port) {
    const Texels values = frame.texels(port);
    const Texels position = frame.texels("gbuffer.position");
    double sum = 0;
    double count = 0;
    for (int y = 0; y < values.height(); ++y) {
        for (int x = 0; x < values.width(); ++x) {
            if (position.at(x, y).w == 0) continue;
            sum += values.at(x, y).x;
            count += 1;
        }
    }
    return sum / count;
}

/// Sum of R_d over the taps of a plane that faces the camera, as the middle of the sphere nearly does at 30
/// mm.
double sumOverTaps(std::uint32_t size) {
    const double pixel = 2 * std::tan(18 * std::numbers::pi / 180) * 30 / size;
    double sum = 0;
    for (const glm::ivec2 offset : nearestOffsets(12))
        sum += diffuseReflectance(grey, pixel * std::hypot(offset.x, offset.y));
    return sum;
}

TEST(Resolution, DirectIrradianceDoesNotDependOnItAndTheLiteralDipoleDoes) {
    const DumpedFrame coarse = frameOf(128);
    const DumpedFrame fine = frameOf(256);
    const double direct =
        meanOverCovered(fine, "direct.irradiance") / meanOverCovered(coarse, "direct.irradiance");
    EXPECT_NEAR(direct, 1, 0.01);

    // Twelve pixels, no area: at twice the size they lie nearer and count as much each, so it gets brighter.
    const double dipole =
        meanOverCovered(fine, "dipole.radiance") / meanOverCovered(coarse, "dipole.radiance");
    std::cout << "dipole-literal: mean at 256x256 over mean at 128x128 = " << dipole << "\n";
    EXPECT_GT(dipole, 1.05);
    for (const auto& [frame, size] : {std::pair(&coarse, 128U), std::pair(&fine, 256U)}) {
        const int middle = static_cast<int>(size / 2);
        const double measured = frame->texels("dipole.radiance").at(middle, middle).x /
                                frame->texels("direct.irradiance").at(middle, middle).x;
        EXPECT_NEAR(measured / sumOverTaps(size), 1, 0.01) << size;
    }
}

}  // namespace
}  // namespace nephrite::reference
