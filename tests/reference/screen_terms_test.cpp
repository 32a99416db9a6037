// Ambient occlusion, refraction and the composite on small pictures made by hand.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "reference/literal/ambient_occlusion.h"
#include "reference/literal/composite.h"
#include "reference/literal/fresnel.h"
#include "reference/literal/refraction.h"

namespace nephrite::reference {
namespace {

constexpr int size = 33;
const View camera{{0, 0, 10}, {0, 0, -1}, {1, 0, 0}, {0, 1, 0}, 0.5, 0.5};

/// A picture of the plane z = 0, and of a wall x = 1 in front of it where the rays meet it first.
Texels picture(bool wall) {
    std::vector<glm::dvec4> texels;
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            const glm::dvec3 ray = rayThrough(camera, {(x + 0.5) / size, (y + 0.5) / size});
            const double toPlane = 10 / -ray.z;
            const double toWall = wall && ray.x > 0 ? 1 / ray.x : toPlane;
            texels.emplace_back(camera.position + ray * std::min(toPlane, toWall), 1);
        }
    }
    return {size, size, texels};
}
const Texels upward(size, size, std::vector<glm::dvec4>(size* size, {0, 0, 1, 0}));
const OcclusionSettings settings{32, 2, 5, 1e-4, 1};

TEST(AmbientVisibility, OfAPlaneIsOne) {
    EXPECT_DOUBLE_EQ(ambientVisibility(picture(false), upward, {16, 16}, camera, settings), 1);
    EXPECT_DOUBLE_EQ(ambientVisibility(picture(false), upward, {0, 32}, camera, settings), 1);
}

TEST(AmbientVisibility, FallsBesideAWall) {
    const double beside = ambientVisibility(picture(true), upward, {18, 16}, camera, settings);
    const double away = ambientVisibility(picture(true), upward, {4, 16}, camera, settings);
    EXPECT_LT(beside, 0.95);
    EXPECT_GE(beside, 0);
    EXPECT_DOUBLE_EQ(away, 1);
}

TEST(AmbientVisibility, OneSampleIsTheEstimatorsTerm) {
    // One sample has radius sqrt(1/2) of the reach and no turn but the pixel's rotation: 0 at pixel (0, 0).
    // reach = radius / (2 t tan) * height = 2 / (2 * 10 * 0.5) * 9 = 1.8 pixels, so the sample is floor(1.27
    // + 0.5) = 1 right.
    std::vector<glm::dvec4> texels(81, glm::dvec4(0));
    texels[0] = {0, 0, 0, 1};
    texels[1] = {0.3, 0, 0.4, 1};
    const Texels position(9, 9, texels);
    const Texels normal(9, 9, std::vector<glm::dvec4>(81, {0, 0, 1, 0}));
    const double occlusion = (0.4 - 0.01 * 10) / (0.25 + 4e-4);
    const double expected = 1 - 2 * 0.25 * occlusion;
    EXPECT_NEAR(ambientVisibility(position, normal, {0, 0}, camera, {1, 2, 0, 0.01, 0.25}), expected, 1e-14);
}

TEST(AmbientVisibility, SamplesBeyondTheRadiusOrWithoutASurfaceAddNothing) {
    std::vector<glm::dvec4> texels(81, glm::dvec4(0));
    texels[0] = {0, 0, 0, 1};
    const Texels normal(9, 9, std::vector<glm::dvec4>(81, {0, 0, 1, 0}));
    EXPECT_EQ(ambientVisibility(Texels(9, 9, texels), normal, {0, 0}, camera, {1, 2, 0, 0, 1}), 1);
    texels[1] = {0, 0, 2.001, 1};
    EXPECT_EQ(ambientVisibility(Texels(9, 9, texels), normal, {0, 0}, camera, {1, 2, 0, 0, 1}), 1);
    texels[1] = {0, 0, 1.999, 1};
    EXPECT_LT(ambientVisibility(Texels(9, 9, texels), normal, {0, 0}, camera, {1, 2, 0, 0, 1}), 1);
}

TEST(AmbientVisibility, SpiralRotationHas64Steps) {
    EXPECT_DOUBLE_EQ(spiralRotation({0, 0}), 0);
    EXPECT_DOUBLE_EQ(spiralRotation({1, 0}), 2 * std::numbers::pi * 38 / 64);  // 37 + (1 xor 0)
    EXPECT_DOUBLE_EQ(spiralRotation({3, 5}), 2 * std::numbers::pi * ((111 + 85 + 6) % 64) / 64);
}

TEST(DiffuseRadiance, OfAWhiteSurfaceUnderPiIsOne) {
    EXPECT_EQ(diffuseRadiance(glm::dvec3(1), glm::dvec3(std::numbers::pi), 1), glm::dvec3(1));
}

TEST(RefractedRadiance, AttenuatesAlongTheThickness) {
    Material material;
    material.eta = 1.3;
    material.layerCount = 2;
    const LayerStack layers{{0.5, 1e30}, {glm::dvec3(0.1), glm::dvec3(0.2)}, {glm::dvec3(1), glm::dvec3(2)}};
    const SurfacePoint point{{0, 0, 0}, {0, 0, 1}, {0, 0, 1}};
    const auto sky = [](const glm::dvec3& d) { return glm::dvec3(d.z < 0 ? 3 : 0); };
    const double transmitted = 1 - 0.3 * 0.3 / (2.3 * 2.3);
    const double depth = 1.1 * 0.5 + 2.2 * 1.5;
    const auto radiance = refractedRadiance(point, material, layers, {0, 0, -2}, sky);
    EXPECT_NEAR(radiance.x, transmitted * 3 * std::exp(-depth), 1e-14);
}

TEST(RefractedRadiance, IndexOneLooksStraightThrough) {
    Material material;
    material.eta = 1;
    material.layerCount = 1;
    const LayerStack clear{{1e30}, {glm::dvec3(0)}, {glm::dvec3(0)}};
    const glm::dvec3 toViewer(0.6, 0, 0.8);
    const auto direction = [](const glm::dvec3& d) { return d; };
    const auto radiance =
        refractedRadiance({{0, 0, 0}, {0, 0, 1}, toViewer}, material, clear, {9, 9, 9}, direction);
    EXPECT_NEAR(radiance.x, -0.6, 1e-15);
    EXPECT_NEAR(radiance.z, -0.8, 1e-15);
}

TEST(RefractedRadiance, OpaqueMaterialsAndTotalReflectionAreDark) {
    const auto sky = [](const glm::dvec3&) { return glm::dvec3(1); };
    const SurfacePoint grazing{{0, 0, 0}, {0, 0, 1}, {0.8, 0, 0.6}};
    Material material;
    material.eta = 0.7;
    EXPECT_EQ(
        refractedRadiance(grazing, material, {{1e30}, {glm::dvec3(0)}, {glm::dvec3(0)}}, {0, 0, -1}, sky),
        glm::dvec3(0));
    material.eta = 1.3;
    EXPECT_EQ(refractedRadiance(grazing, material, {}, {0, 0, -1}, sky), glm::dvec3(0));
}

TEST(Composite, IsTheWeightedSum) {
    const auto one = [](double value) { return Texels(1, 1, {glm::dvec4(value, 2 * value, 3 * value, 1)}); };
    const std::array<Texels, 5> terms{one(1), one(2), one(3), one(4), one(5)};
    const glm::dvec3 sum = composite(terms, {0.3, 0.3, 0.05, 0.05, 0.3}, 1, 1, 0, 0);
    EXPECT_NEAR(sum.x, 0.3 + 0.6 + 0.15 + 0.2 + 1.5, 1e-14);
    EXPECT_NEAR(sum.z, 3 * sum.x, 1e-14);
}

TEST(Composite, FiltersTermsOfAnotherSize) {
    // Two texels 0 and 8 across four pixels: 0, 2, 6, 8.
    const Texels small(2, 1, {glm::dvec4(0), glm::dvec4(8)});
    const std::array<Texels, 5> terms{small, {}, {}, {}, {}};
    const std::array<double, 4> expected{0, 2, 6, 8};
    for (int x = 0; x < 4; ++x)
        EXPECT_DOUBLE_EQ(composite(terms, {1, 0, 0, 0, 0}, 4, 1, x, 0).x,
                         expected[static_cast<std::size_t>(x)]);
}

}  // namespace
}  // namespace nephrite::reference
