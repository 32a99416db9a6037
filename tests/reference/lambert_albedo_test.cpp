// Lambert's law with the total albedo: on a sphere every pixel is a formula.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "reference/dumped_frame.h"
#include "reference/literal/fresnel.h"
#include "reference/sphere_dipole.h"
#include "runtime/session.h"
#include "scattering/half_space.h"
#include "scratch_folder.h"

namespace nephrite::reference {
namespace {

constexpr double eta = 1.3;
constexpr std::array<double, 3> absorption{0.003, 0.0034, 0.046};
constexpr std::array<double, 3> reducedScattering{2.29, 2.39, 1.97};

/// A pixel's place on the sphere scene of graphs/scenes/sphere.json.
struct Seen {
    glm::dvec3 normal{0};
    double toViewer = 0;  ///< cosine of the view direction; 0 where the ray misses
    double toLight = 0;   ///< cosine of the light's
    double squaredDistance = 0;
};

Seen seenAt(std::uint32_t x, std::uint32_t y, double size) {
    const double slope = std::tan(std::numbers::pi / 10);
    const glm::dvec3 ray = glm::normalize(
        glm::dvec3((2 * (x + 0.5) / size - 1) * slope, (1 - 2 * (y + 0.5) / size) * slope, -1));
    const double along = 40 * -ray.z;
    const double under = along * along - (40 * 40 - 10 * 10);
    if (under <= 0) return {};
    const glm::dvec3 point = glm::dvec3(0, 0, 40) + ray * (along - std::sqrt(under));
    const glm::dvec3 toLight = glm::dvec3(30, 30, 10) - point;
    const glm::dvec3 normal = point / 10.0;
    return {normal, -glm::dot(ray, normal), glm::dot(glm::normalize(toLight), normal),
            glm::dot(toLight, toLight)};
}

/// R F_t E F_t(mu)/(pi T), R from the exact solution of radiative transfer in a half space.
double expectedRadiance(const Seen& seen, std::size_t channel) {
    const double entering =
        5000 * seen.toLight / seen.squaredDistance * (1 - fresnelReflectance(seen.toLight, eta));
    const double reflectance =
        scattering::halfSpaceReflectance({absorption[channel], reducedScattering[channel], 0, eta});
    return diffuseRadiance(reflectance * entering, seen.toViewer, eta);
}

TEST(LambertAlbedo, IsTheReflectanceOfAHalfSpaceTimesTheLightThatEnters) {
    sharedScratchFolder();
    constexpr std::uint32_t size = 64;
    runtime::SessionOptions options;
    options.graph = graphFolder() / "lambert-albedo.json";
    options.scene = graphFolder() / "scenes" / "sphere.json";
    options.size = {size, size};
    runtime::Session session(options);
    session.renderFrame(0);
    const image::Image picture = session.read("color");
    std::size_t lit = 0;
    for (std::uint32_t y = 0; y < size; ++y) {
        for (std::uint32_t x = 0; x < size; ++x) {
            const Seen seen = seenAt(x, y, size);
            // Near the terminator the shadow map's texels show, near the outline the facets.
            if (seen.toViewer < 0.2 || std::abs(seen.toLight) < 0.2) continue;
            for (std::uint32_t c = 0; c < 3; ++c) {
                const double expected = seen.toLight > 0 ? expectedRadiance(seen, c) : 0;
                // The fit of the reflectance is good to 0.3 %.
                EXPECT_NEAR(picture.at(x, y, c), expected, 5e-3 * expected) << x << ", " << y;
            }
            lit += seen.toLight > 0 ? 1 : 0;
        }
    }
    EXPECT_GT(lit, 300U);
}

}  // namespace
}  // namespace nephrite::reference
