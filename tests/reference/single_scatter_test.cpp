// Single scattering against sums that can be done by hand.
#include "reference/literal/single_scatter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "reference/literal/fresnel.h"

namespace nephrite::reference {
namespace {

constexpr int lightSize = 64;

/// The plane z = 0, seen and lit from straight above by a light so far away that its rays are parallel.
PointLight distantLight(const LayerStack& layers) {
    PointLight light;
    light.position = {0, 0, 1e7};
    LightView view;
    view.view = {light.position, {0, 0, -1}, {1, 0, 0}, {0, 1, 0}, 1e-6, 1e-6};
    std::vector<glm::dvec4> position;
    for (int y = 0; y < lightSize; ++y) {
        for (int x = 0; x < lightSize; ++x) {
            const glm::dvec3 ray = rayThrough(view.view, {(x + 0.5) / lightSize, (y + 0.5) / lightSize});
            position.emplace_back(light.position + ray * (1e7 / -ray.z), 1);
        }
    }
    const auto filled = [](glm::dvec4 value) {
        return Texels(lightSize, lightSize, std::vector<glm::dvec4>(lightSize * lightSize, value));
    };
    view.position = Texels(lightSize, lightSize, position);
    view.normal = filled({0, 0, 1, 0});
    view.surface = filled({0, 0, 1, 0});
    view.irradiance = filled({1, 2, 4, 0});
    glm::dvec4 thickness(0);
    for (std::size_t layer = 0; layer < layers.count(); ++layer) {
        thickness[static_cast<int>(layer)] = layers.thickness[layer];
        view.scattering.push_back(filled(glm::dvec4(layers.scattering[layer], 0)));
    }
    view.thickness = {filled(thickness)};
    light.views = {view};
    return light;
}

Material mediumOf(const LayerStack& layers, double g) {
    Material material;
    material.g = g;
    material.eta = 1.3;
    material.layerCount = layers.count();
    return material;
}

glm::dvec3 seenFromAbove(const LayerStack& layers, double g, const SingleScatterSettings& settings) {
    const PointLight light = distantLight(layers);
    const Material material = mediumOf(layers, g);
    // A texel's centre, so that the lit point lies straight above every point of the ray.
    const glm::dvec4& centre = light.views[0].position.at(32, 32);
    const SurfacePoint point{glm::dvec3(centre), {0, 0, 1}, {0, 0, 1}};
    return singleScatter(point, material, layers, {&light, 1}, {&material, 1}, settings);
}

TEST(SingleScatter, StraightDownIsAGeometricSum) {
    // tau(s) = (sigma_s + sigma_a) s; the midpoint sum of exp(-sigma_t s) is a geometric series.
    const LayerStack layers{{1e30}, {glm::dvec3(0.2, 0.3, 0.4)}, {glm::dvec3(1, 2, 3)}};
    const int steps = 16;
    const double depth = 2;
    const glm::dvec3 radiance = seenFromAbove(layers, 0.5, {depth, steps});
    const double phase = (1 - 0.25) / (4 * std::numbers::pi * 0.25);  // omega . -T = -1: (1 - g)^2 below
    const glm::dvec3 irradiance(1, 2, 4);
    for (int channel = 0; channel < 3; ++channel) {
        const double extinction = layers.scattering[0][channel] + layers.absorption[0][channel];
        const double ratio = std::exp(-extinction * depth / steps);
        const double sum = std::sqrt(ratio) * (1 - std::pow(ratio, steps)) / (1 - ratio);
        const double expected = layers.scattering[0][channel] * phase * irradiance[channel] * sum;
        EXPECT_NEAR(radiance[channel], expected, 1e-6 * expected) << channel;
    }
}

TEST(SingleScatter, EqualLayersAreOneLayer) {
    const glm::dvec3 absorption(0.2, 0.3, 0.4);
    const glm::dvec3 scattering(1, 2, 3);
    const LayerStack one{{1e30}, {absorption}, {scattering}};
    const LayerStack three{
        {0.3, 0.4, 1e30}, {absorption, absorption, absorption}, {scattering, scattering, scattering}};
    const glm::dvec3 expected = seenFromAbove(one, 0, {2, 10});
    EXPECT_LT(glm::length(seenFromAbove(three, 0, {2, 10}) - expected), 1e-12 * glm::length(expected));
}

TEST(SingleScatter, OnlyTheScatteringLayersSend) {
    // The upper layer neither scatters nor absorbs: what the ray meets starts 1 mm down, 5 of 10 steps of 0.2
    // mm.
    const LayerStack layers{{1, 1e30}, {glm::dvec3(0), glm::dvec3(0)}, {glm::dvec3(0), glm::dvec3(2)}};
    double sum = 0;
    for (int step = 5; step < 10; ++step) sum += std::exp(-2 * ((step + 0.5) * 0.2 - 1));
    const double expected = 2 * sum / (4 * std::numbers::pi);
    EXPECT_NEAR(seenFromAbove(layers, 0, {2, 10}).x, expected, 1e-6 * expected);
}

TEST(SingleScatter, BrightnessGrowsWithTheStepCount) {
    // As printed, Eq. 6 has no ds.
    const LayerStack layers{{1e30}, {glm::dvec3(0.1)}, {glm::dvec3(1)}};
    const double coarse = seenFromAbove(layers, 0, {2, 32}).x;
    EXPECT_NEAR(seenFromAbove(layers, 0, {2, 64}).x / coarse, 2, 1e-2);
}

TEST(SingleScatter, ObliqueRaysReachTheSameDepth) {
    // Seen at an angle the ray is longer by 1 / cosine, and so is the absorbed way out.
    const LayerStack layers{{1e30}, {glm::dvec3(0.5)}, {glm::dvec3(1)}};
    const PointLight light = distantLight(layers);
    const Material material = mediumOf(layers, 0);
    const glm::dvec3 toViewer(0.6, 0, 0.8);
    const double cosine = refractedCosine(0.8, 1.3);
    double expected = 0;
    // The lit point is the centre of the texel over M: find it as the light sees it.
    for (int step = 0; step < 4; ++step) {
        const double s = (step + 0.5) * 1.0 / cosine / 4;
        const double across = s * std::sqrt(1 - cosine * cosine);
        const glm::dvec3 inside(-across, 0, -s * cosine);
        const glm::dvec2 uv = *project(light.views[0].view, inside);
        const glm::dvec3 lit(light.views[0].position.at(static_cast<int>(uv.x * lightSize),
                                                        static_cast<int>(uv.y * lightSize)));
        expected += std::exp(-(glm::length(lit - inside) + 0.5 * s)) / (4 * std::numbers::pi);
    }
    const glm::dvec3 radiance = singleScatter({{0, 0, 0}, {0, 0, 1}, toViewer}, material, layers, {&light, 1},
                                              {&material, 1}, {1, 4});
    EXPECT_NEAR(radiance.x, expected, 1e-6 * expected);
}

TEST(SingleScatter, TotalReflectionAndOpaqueMaterialsAreDark) {
    const LayerStack layers{{1e30}, {glm::dvec3(0.5)}, {glm::dvec3(1)}};
    const PointLight light = distantLight(layers);
    Material material = mediumOf(layers, 0);
    material.eta = 0.7;
    const SurfacePoint grazing{{0, 0, 0}, {0, 0, 1}, {0.8, 0, 0.6}};
    EXPECT_EQ(singleScatter(grazing, material, layers, {&light, 1}, {&material, 1}, {1, 4}), glm::dvec3(0));
    EXPECT_EQ(singleScatter(grazing, Material{}, {}, {&light, 1}, {&material, 1}, {1, 4}), glm::dvec3(0));
}

}  // namespace
}  // namespace nephrite::reference
