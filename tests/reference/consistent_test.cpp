// The consistent passes on a sphere: against the exact integral, over sizes of the picture, scales of the
// scene, and media at the edge of what there is.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <iostream>
#include <numbers>

#include "reference/dumped_frame.h"
#include "reference/integrate.h"
#include "reference/literal/fresnel.h"
#include "reference/sphere_dipole.h"
#include "runtime/session.h"
#include "scratch_folder.h"

namespace nephrite::reference {
namespace {

constexpr std::array<const char*, 3> estimators{"consistent.json", "light-pyramid.json", "screen-space.json"};

struct SphereScene {
    std::array<double, 3> absorption{0.003, 0.0034, 0.046};
    std::array<double, 3> scattering{2.29, 2.39, 1.97};
    double g = 0;
    double eta = 1.3;
    double scale = 1;  ///< of all lengths; coefficients shrink and the intensity grows, so the picture stays
    std::array<double, 3> light{30, 30, 10};
    double intensity = 5000;  ///< 0: there is no light
    double environment = 0;   ///< radiance from everywhere
};

std::filesystem::path write(const SphereScene& s) {
    const auto triple = [](const std::array<double, 3>& v, double factor) {
        return fmt::format("[{}, {}, {}]", v[0] * factor, v[1] * factor, v[2] * factor);
    };
    const double k = s.scale;
    const double intensity = s.intensity * k * k;
    const std::string lights =
        intensity > 0
            ? fmt::format(R"json({{"type": "point", "position": {}, "intensity": [{}, {}, {}]}})json",
                          triple(s.light, k), intensity, intensity, intensity)
            : "";
    return sharedScratchFolder().write(
        "consistent-sphere.json",
        fmt::format(
            R"json({{ "millimetersPerUnit": 1,
 "camera": {{"position": [0, 0, {}], "target": [0, 0, 0], "up": [0, 1, 0], "fovY": 36, "near": {}, "far": {}}},
 "lights": [{}],
 "environment": {{"radiance": [{}, {}, {}]}},
 "materials": {{"medium": {{"layers": [{{"absorption": {}, "scattering": {}}}], "g": {}, "eta": {}, "specular": false}}}},
 "objects": [{{"mesh": {{"procedural": "sphere", "radius": {}}}, "material": "medium"}}] }})json",
            40 * k, k, 1000 * k, lights, s.environment, s.environment, s.environment,
            triple(s.absorption, 1 / k), triple(s.scattering, 1 / k), s.g, s.eta, 10 * k));
}

image::Image rendered(const std::string& graph, const SphereScene& scene, std::uint32_t size,
                      const std::string& output = "color") {
    runtime::SessionOptions options;
    options.scene = write(scene);
    options.graph = graphFolder() / graph;
    options.size = {size, size};
    options.settings = {"lightSize=128"};
    if (graph != "screen-space.json") options.settings.emplace_back("treeSize=128");
    if (output != "color") options.dumps = {output};
    runtime::Session session(options);
    session.renderFrame(0);
    return session.read(output);
}

std::array<double, 3> meanOf(const image::Image& picture) {
    std::array<double, 3> sum{};
    for (std::uint32_t y = 0; y < picture.height; ++y)
        for (std::uint32_t x = 0; x < picture.width; ++x)
            for (std::uint32_t c = 0; c < 3; ++c) sum[c] += static_cast<double>(picture.at(x, y, c));
    for (double& value : sum) value /= static_cast<double>(picture.width) * picture.height;
    return sum;
}

/// RMSE over the mean of the exact radiance, over pixels well inside the sphere's outline.
double errorAgainstDipole(const image::Image& picture, const SphereScene& scene, std::size_t channel) {
    const Medium medium{scene.absorption[channel], scene.scattering[channel], scene.g, scene.eta};
    const double slope = std::tan(std::numbers::pi / 10);
    double squares = 0;
    double sum = 0;
    double count = 0;
    for (std::uint32_t y = 1; y < picture.height; y += 3) {
        for (std::uint32_t x = 1; x < picture.width; x += 3) {
            const glm::dvec3 ray =
                glm::normalize(glm::dvec3((2 * (x + 0.5) / picture.width - 1) * slope,
                                          (1 - 2 * (y + 0.5) / picture.height) * slope, -1));
            const double along = 40 * -ray.z;
            const double under = along * along - (40 * 40 - 10 * 10);
            if (under < 4) continue;
            const glm::dvec3 point = glm::dvec3(0, 0, 40) + ray * (along - std::sqrt(under));
            const double cosine = -glm::dot(ray, point) / 10;
            const double exact = diffuseRadiance(dipoleExitance({}, medium, point), cosine, scene.eta);
            const double difference =
                static_cast<double>(picture.at(x, y, static_cast<std::uint32_t>(channel))) - exact;
            squares += difference * difference;
            sum += exact;
            count += 1;
        }
    }
    return std::sqrt(squares / count) / (sum / count);
}

TEST(ConsistentSphere, LightPyramidComesWithinTwoPercentOfTheExactDipole) {
    for (const double eta : {1.0, 1.3}) {
        SphereScene scene;
        scene.eta = eta;
        const image::Image picture = rendered("light-pyramid.json", scene, 64, "multiple.radiance");
        for (const std::size_t channel : {0U, 2U}) {
            const double error = errorAgainstDipole(picture, scene, channel);
            std::cout << fmt::format("light-gather, eta {}, channel {}: relRMSE {:.4f}\n", eta, channel,
                                     error);
            EXPECT_LT(error, 0.02);
        }
    }
}

TEST(ConsistentSphere, ScreenGatherIsNoCloserThanWhatTheCameraSees) {
    const SphereScene scene;
    const double error =
        errorAgainstDipole(rendered("screen-space.json", scene, 64, "multiple.radiance"), scene, 0);
    std::cout << fmt::format("screen-gather, 64 taps at most: relRMSE {:.4f}\n", error);
    EXPECT_LT(error, 0.25);
}

TEST(ConsistentSphere, UniformLightOnAMediumThatAbsorbsNothingLeavesAsItCame) {
    SphereScene sphere;
    sphere.absorption = {0, 0, 0};
    sphere.intensity = 0;
    sphere.environment = 2;
    // What enters leaves, and in the middle it is seen perpendicularly: L F_t(1).
    const double reflected = std::pow((sphere.eta - 1) / (sphere.eta + 1), 2);
    for (const char* graph : estimators) {
        const image::Image picture = rendered(graph, sphere, 33);
        for (std::uint32_t c = 0; c < 3; ++c)
            EXPECT_NEAR(static_cast<double>(picture.at(16, 16, c)), 2 * (1 - reflected), 0.01) << graph;
    }
}

/// Power (W) that enters the sphere from a light of 1 W/sr at `distance` mm from its centre.
double enteringPower(double distance, double eta) {
    const double most = 1 - std::sqrt(1 - 100 / (distance * distance));
    return integrate(0, most, 2000, [&](double height) {
        const double offset =
            distance * std::sqrt(height * (2 - height)) / 10;  // sine of the angle of incidence
        return 2 * std::numbers::pi *
               (1 - fresnelReflectance(std::sqrt(std::max(0.0, 1 - offset * offset)), eta));
    });
}

/// Irradiance (W/mm^2) of a surface at the camera that faces the sphere, by channel.
std::array<double, 3> irradianceAtCamera(const image::Image& picture) {
    std::array<double, 3> sum{};
    const double slope = std::tan(18 * std::numbers::pi / 180);
    const double pixel = 2 * slope / picture.width;
    for (std::uint32_t y = 0; y < picture.height; ++y)
        for (std::uint32_t x = 0; x < picture.width; ++x) {
            const double right = (x + 0.5) * pixel - slope;
            const double up = (y + 0.5) * pixel - slope;
            const double squaredCosine = 1 / (1 + right * right + up * up);
            for (std::uint32_t c = 0; c < 3; ++c)
                sum[c] +=
                    static_cast<double>(picture.at(x, y, c)) * pixel * pixel * squaredCosine * squaredCosine;
        }
    return sum;
}

/// The light goes around the sphere, and what arrives at the camera adds up to all that leaves.
TEST(ConsistentSphere, NoMoreLeavesThanEntersWhereNothingIsAbsorbed) {
    constexpr double distance = 100;
    constexpr int lights = 8;
    for (const double eta : {1.0, 1.3}) {
        std::array<double, 3> leaving{};
        for (int i = 0; i < lights; ++i) {
            const double cosine = (2 * i + 1.0) / lights - 1;
            SphereScene scene;
            scene.absorption = {0, 0, 0};
            scene.scattering = {0.2, 2, 20};
            scene.eta = eta;
            scene.light = {distance * std::sqrt(1 - cosine * cosine), 0, distance * cosine};
            const auto arriving = irradianceAtCamera(rendered("consistent.json", scene, 32));
            for (std::size_t c = 0; c < 3; ++c)
                leaving[c] += 4 * std::numbers::pi * 40 * 40 * arriving[c] / lights / scene.intensity;
        }
        const double entering = enteringPower(distance, eta);
        std::cout << fmt::format("eta {}: {:.3f}, {:.3f}, {:.3f} of the power leave\n", eta,
                                 leaving[0] / entering, leaving[1] / entering, leaving[2] / entering);
        for (const double channel : leaving) {
            EXPECT_LT(channel, 1.03 * entering);
            EXPECT_GT(channel, 0.85 * entering);
        }
    }
}

TEST(ConsistentSphere, PictureDoesNotDependOnTheScaleOfTheScene) {
    for (const char* graph : estimators) {
        const auto plain = meanOf(rendered(graph, {}, 48));
        for (const double scale : {1e-4, 1e4}) {
            SphereScene scene;
            scene.scale = scale;
            const auto scaled = meanOf(rendered(graph, scene, 48));
            for (std::size_t c = 0; c < 3; ++c)
                EXPECT_NEAR(scaled[c] / plain[c], 1, 1e-3) << graph << " " << scale;
        }
    }
}

TEST(ConsistentSphere, NothingIsInfiniteAtTheEdgeOfWhatThereIs) {
    std::vector<SphereScene> scenes(10);
    scenes[0].absorption = {0, 0, 0};
    scenes[1].scattering = {0, 0, 0};
    scenes[2].absorption = scenes[2].scattering = {0, 0, 0};
    scenes[3].scattering = {1e4, 1e-6, 1};
    scenes[4].absorption = {1e4, 1e-6, 1};
    scenes[5].g = 0.999999;
    scenes[6].g = -0.999999;
    scenes[7].eta = 4;
    scenes[8].eta = 0.8;
    scenes[9].light = {0, 0, 10};
    for (std::size_t i = 0; i < scenes.size(); ++i) {
        for (const char* graph : estimators) {
            const image::Image picture = rendered(graph, scenes[i], 24);
            std::size_t wrong = 0;
            for (const float value : picture.pixels) wrong += std::isfinite(value) && value >= 0 ? 0 : 1;
            EXPECT_EQ(wrong, 0U) << graph << ", scene " << i;
        }
    }
}

}  // namespace
}  // namespace nephrite::reference
