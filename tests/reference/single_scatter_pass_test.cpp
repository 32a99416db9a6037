// The consistent pass of single scattering against its closed form below a flat surface.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "reference/dumped_frame.h"
#include "reference/literal/fresnel.h"
#include "runtime/session.h"
#include "scratch_folder.h"

namespace nephrite::reference {
namespace {

struct Flat {
    double g;
    double eta;
};

constexpr double scattering = 1.2;
constexpr double absorption = 0.4;

/// The radiance in the middle of the picture. Light comes from 1 m away at cosine 0.8, the camera looks on
/// at cosine 0.8 from 50 mm, and their planes are at right angles.
double shown(const Flat& flat) {
    runtime::SessionOptions options;
    options.scene =
        sharedScratchFolder().write("flat.json", fmt::format(R"json({{
  "camera": {{"position": [30, 0, 40], "target": [0, 0, 0], "up": [0, 1, 0], "fovY": 4, "near": 1, "far": 1000}},
  "lights": [{{"type": "point", "position": [0, 600, 800], "intensity": [1e6, 1e6, 1e6]}}],
  "objects": [{{"mesh": {{"procedural": "slab", "size": [60, 60, 60]}}, "transform": {{"translate": [0, 0, -30]}},
    "material": {{"layers": [{{"absorption": [{1}, {1}, {1}], "scattering": [{0}, {0}, {0}]}}], "g": {2}, "eta": {3},
                  "specular": false}}}}] }})json",
                                                             scattering, absorption, flat.g, flat.eta));
    options.graph = graphFolder() / "light-pyramid.json";
    options.size = {5, 5};
    options.settings = {"single-scatter.samples=64"};
    options.dumps = {"single-scatter.radiance"};
    runtime::Session session(options);
    session.renderFrame(0);
    return static_cast<double>(session.read("single-scatter.radiance").at(2, 2, 1));
}

/// (1-F_o)/eta^2 sigma_s/sigma_t p (1-F_i) mu_i/(c_i + c_o) for an irradiance of 1 W/mm^2 across the beam
/// (Hanrahan and Krueger 1993), p Henyey and Greenstein's.
double exact(const Flat& flat) {
    constexpr double mu = 0.8;  // of the light and of the view
    const double inside = refractedCosine(mu, flat.eta);
    const double entering = 1 - fresnelReflectance(mu, flat.eta);
    const double g = flat.g;
    const double phase =
        (1 - g * g) / (4 * std::numbers::pi * std::pow(1 + g * g + 2 * g * inside * inside, 1.5));
    return entering * entering / (flat.eta * flat.eta) * scattering / (scattering + absorption) * phase * mu /
           (2 * inside);
}

TEST(SingleScatterPass, HasItsClosedFormBelowAFlatSurface) {
    for (const double eta : {1.0, 1.3, 1.5})
        for (const double g : {0.0, 0.6, -0.3})
            EXPECT_NEAR(shown({g, eta}) / exact({g, eta}), 1, 0.01) << "eta " << eta << ", g " << g;
}

}  // namespace
}  // namespace nephrite::reference
