// The scene as shaders see it, against the same quantities computed on the CPU.
#include "scene/gpu_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "image/exr.h"
#include "scene/environment.h"
#include "scene/gpu_scene_support.h"
#include "scene/scene_state.h"
#include "scene/view.h"

namespace nephrite::scene {
namespace {

using GpuSceneTest = test::OnDevice;

/// GLSL for direction i of a Fibonacci spiral of 64, and the same here.
constexpr const char* spiral =
    "float sy = 1.0 - 2.0 * (float(i) + 0.5) / 64.0; float sa = float(i) * 2.39996323;\n"
    "vec3 direction = vec3(sqrt(1.0 - sy * sy) * cos(sa), sy, sqrt(1.0 - sy * sy) * sin(sa));\n";
glm::dvec3 spiralDirection(int i) {
    const double y = 1 - 2 * (i + 0.5) / 64, azimuth = i * 2.39996323;
    return {std::sqrt(1 - y * y) * std::cos(azimuth), y, std::sqrt(1 - y * y) * std::sin(azimuth)};
}

TEST_F(GpuSceneTest, ShadersSeeFrameLightsAndMaterials) {
    const Scene scene = load("{" + test::anyCamera + R"(,
        "lights": [{"type": "point", "position": [30, 1, 2], "intensity": [1, 2, 3]},
                   {"type": "point", "position": [1, 0, 0], "intensity": [4, 5, 6]}],
        "objects": [{"mesh": {"procedural": "cube", "size": 8}, "material": {"diffuse": [0.5, 0.25, 0.125], "roughness": 0.75}},
                    {"mesh": {"procedural": "cube", "size": 2}, "material": {"preset": "skin2", "g": 0.5, "eta": 1.4}}]})");
    GpuScene gpuScene(device(), scene);
    gpuScene.update(2.5, 64, 32);
    const auto values = run(gpuScene, R"(
        if (i == 0u) result[i] = vec4(lightCount, lightViewCount, materialCount, time);
        if (i == 1u) result[i] = vec4(lights[1].position, lights[1].firstView);
        if (i == 2u) result[i] = vec4(lights[1].intensity, lights[1].viewCount);
        if (i == 3u) result[i] = vec4(materials[0].diffuse, materials[0].roughness);
        if (i == 4u) result[i] = vec4(materials[1].g, materials[1].eta, materials[1].layerCount, materials[1].specular);
        if (i == 5u) result[i] = vec4(camera.position, camera.near);
        if (i == 6u) result[i] = vec4(camera.tanHalfFovX / camera.tanHalfFovY, camera.far, lightViews[3].light, materials[0].layerCount);
    )",
                            7);
    EXPECT_EQ(values[0], glm::vec4(2, 7, 2, 2.5));
    EXPECT_EQ(values[1], glm::vec4(1, 0, 0, 1));
    EXPECT_EQ(values[2], glm::vec4(4, 5, 6, 6));
    EXPECT_EQ(values[3], glm::vec4(0.5, 0.25, 0.125, 0.75));
    EXPECT_EQ(values[4], glm::vec4(0.5, 1.4F, 1, 1));
    EXPECT_EQ(values[5], glm::vec4(0, 0, 40, 1));
    EXPECT_EQ(values[6], glm::vec4(2, 100, 1, 0));
    EXPECT_EQ(gpuScene.lightOfView(0), 0U);
    EXPECT_EQ(gpuScene.lightOfView(6), 1U);
    EXPECT_EQ(gpuScene.lightViewCount(), 7U);
    EXPECT_EQ(gpuScene.triangleCount(), 24U);
    EXPECT_GT(gpuScene.bytes(), 2 * 24 * 32U);
}

TEST_F(GpuSceneTest, LightTexelIsWhereTheViewProjectionPutsThePoint) {
    const Scene scene = load("{" + test::anyCamera + R"(,
        "lights": [{"type": "point", "position": [30, 20, 10], "intensity": [1, 1, 1]},
                   {"type": "point", "position": [1, 2, 3], "intensity": [1, 1, 1]}],
        "objects": [{"mesh": {"procedural": "sphere", "radius": 10}, "material": "apple"}]})");
    GpuScene gpuScene(device(), scene);
    gpuScene.update(0, 64, 64);
    for (const std::uint32_t light : {0U, 1U}) {
        const auto texels = run(gpuScene,
                                std::string(spiral) + "LightTexel t = lightTexelOf(" + std::to_string(light) +
                                    "u, direction * 8.0); result[i] = vec4(t.inside, t.view, t.uv);",
                                64);
        const auto views = lightViews(scene.description().lights[light].position, light,
                                      scene.boundingSphere(0), scene.lightViewCounts()[light]);
        for (int i = 0; i < 64; ++i) {
            const glm::vec4 texel = texels[static_cast<std::size_t>(i)];
            EXPECT_EQ(texel.x, 1) << i;
            const std::size_t view = static_cast<std::size_t>(texel.y) - (light == 1 ? 1 : 0);
            ASSERT_LT(view, views.size());
            const glm::vec4 clip =
                views[view].viewProjection * glm::vec4(glm::vec3(spiralDirection(i) * 8.0), 1);
            EXPECT_GT(clip.w, 0);
            EXPECT_NEAR(texel.z, 0.5 + 0.5 * clip.x / clip.w, 1e-5) << i;
            EXPECT_NEAR(texel.w, 0.5 + 0.5 * clip.y / clip.w, 1e-5) << i;
        }
    }
    const auto outside = run(gpuScene,
                             "result[i] = vec4(lightTexelOf(0u, i == 0u ? vec3(60.0, 40.0, 20.0) : "
                             "vec3(30.0, -300.0, 0.0)).inside);",
                             2);
    EXPECT_EQ(outside[0].x, 0) << "behind the light";
    EXPECT_EQ(outside[1].x, 0) << "beside the view";
}

TEST_F(GpuSceneTest, ViewRayIsTheCpusRay) {
    const Scene scene = load(R"({"camera": {"position": [3, 14, 40], "fovY": 50}})");
    GpuScene gpuScene(device(), scene);
    gpuScene.update(0, 200, 100);
    const auto rays =
        run(gpuScene,
            "result[i] = vec4(viewRay(camera, vec2(float(i) / 15.0, 1.0 - float(i * i) / 225.0)), 0);", 16);
    const View view = cameraView(scene.description().camera, 200, 100);
    for (std::size_t i = 0; i < 16; ++i) {
        const float t = static_cast<float>(i) / 15;
        EXPECT_LT(glm::distance(glm::vec3(rays[i]), viewRay(view, t, 1 - t * t)), 1e-6F) << i;
    }
}

TEST_F(GpuSceneTest, LayersAreLookedUpBilinearlyAndRepeat) {
    image::writeExr(in("t.exr"), {4, 2, {"R"}, {1, 2, 3, 4, 5, 6, 7, 8}});
    image::writeExr(in("c.exr"), {2, 1, {"R", "G", "B"}, {0, 1, 2, 4, 3, 2}});
    const Scene scene = load("{" + test::anyCamera + R"(, "objects": [
        {"mesh": {"procedural": "cube"}, "material": {"diffuse": [0, 0, 0]}},
        {"mesh": {"procedural": "cube"}, "material": {"g": 0.75, "layers": [
            {"thickness": {"texture": "t.exr", "scale": 0.5}, "absorption": {"texture": "c.exr"}, "scattering": [1, 2, 4], "reduced": true},
            {"absorption": [3, 2, 1], "scattering": {"texture": "c.exr", "channel": "G"}}]}}]})");
    EXPECT_EQ(scene.facts().layerTextures, 3U);
    GpuScene gpuScene(device(), scene);
    gpuScene.update(0, 64, 64);
    const auto values = run(gpuScene, R"(
        vec2 uv[4] = vec2[](vec2(0.125, 0.25), vec2(0.25, 0.5), vec2(-0.875, 3.25), vec2(0.0, 0.25));
        if (i < 4u) result[i] = vec4(layerAt(1u, 0u, uv[i]).absorption, layerAt(1u, 0u, uv[i]).thickness);
        if (i == 4u) result[i] = vec4(layerAt(1u, 0u, vec2(0.3)).scattering, layerAt(1u, 1u, vec2(0.3)).thickness);
        if (i == 5u) result[i] = vec4(layerAt(1u, 1u, vec2(0.25, 0.9)).scattering, layerAt(1u, 1u, vec2(0.3)).absorption.x);
        if (i == 6u) result[i] = vec4(layerAt(1u, 2u, vec2(0.3)).absorption, layerAt(1u, 2u, vec2(0.3)).thickness);
        if (i == 7u) result[i] = vec4(layerAt(0u, 0u, vec2(0.3)).scattering, layerAt(0u, 0u, vec2(0.3)).thickness);
    )",
                            8);
    EXPECT_EQ(values[0].w, 0.5F) << "the centre of the first texel";
    EXPECT_EQ(values[1].w, 0.5F * (1 + 2 + 5 + 6) / 4) << "between four texels";
    EXPECT_EQ(values[2].w, 0.5F) << "one to the left and three down";
    EXPECT_EQ(values[3].w, 0.5F * (1 + 4) / 2) << "across the left edge";
    // At u = 1/8 the two texels of c.exr, centred at 1/4 and 3/4, mix 3 : 1 across the edge.
    EXPECT_EQ(glm::vec3(values[0]), glm::vec3(1, 1.5, 2));
    EXPECT_EQ(values[4], glm::vec4(4, 8, 16, 1e30F));
    EXPECT_EQ(values[5], glm::vec4(1, 1, 1, 3));
    EXPECT_EQ(values[6], glm::vec4(0));
    EXPECT_EQ(values[7], glm::vec4(0));
}

/// Bilinear look-up in a lat-long image by the definition.
glm::dvec3 latLongSample(const Environment& environment, const glm::dvec3& direction) {
    const glm::dvec2 place = latLongOf(direction);
    const double x = place.x * environment.width - 0.5, y = place.y * environment.height - 0.5;
    glm::dvec3 sum{0};
    for (const int dy : {0, 1})
        for (const int dx : {0, 1}) {
            const int column = static_cast<int>(std::floor(x)) + dx,
                      row = static_cast<int>(std::floor(y)) + dy;
            const double weight = (1 - std::abs(x - column)) * (1 - std::abs(y - row));
            const auto wrapped = static_cast<std::size_t>((column + static_cast<int>(environment.width)) %
                                                          static_cast<int>(environment.width));
            const auto clamped =
                static_cast<std::size_t>(std::clamp(row, 0, static_cast<int>(environment.height) - 1));
            sum += weight * glm::dvec3(environment.texels[clamped * environment.width + wrapped]);
        }
    return sum;
}

TEST_F(GpuSceneTest, EnvironmentIsTheCpusEnvironment) {
    constexpr std::uint32_t width = 16, height = 8;
    image::Image sky{width, height, {"R", "G", "B"}, {}};
    for (std::uint32_t i = 0; i < width * height * 3; ++i)
        sky.pixels.push_back(static_cast<float>((i * 7919U) % 101U));
    image::writeExr(in("sky.exr"), sky);
    const Scene scene = load("{" + test::anyCamera + R"(, "environment": {"image": "sky.exr", "scale": 2}})");
    GpuScene gpuScene(device(), scene);
    gpuScene.update(0, 64, 64);
    const Environment& environment = scene.state().environment;
    const auto radiance =
        run(gpuScene, std::string(spiral) + "result[i] = vec4(environmentRadiance(direction), 0);", 64);
    const auto falling =
        run(gpuScene, std::string(spiral) + "result[i] = vec4(environmentIrradiance(direction), 0);", 64);
    for (int i = 0; i < 64; ++i) {
        const auto index = static_cast<std::size_t>(i);
        EXPECT_LT(glm::distance(glm::dvec3(radiance[index]), latLongSample(environment, spiralDirection(i))),
                  0.02)
            << i;
        EXPECT_LT(glm::distance(glm::dvec3(falling[index]),
                                irradiance(environment.coefficients, spiralDirection(i))),
                  1e-3)
            << i;
    }
}

TEST_F(GpuSceneTest, EveryStageCompilesAlone) {
    for (const RasterView view : {RasterView::Camera, RasterView::Light})
        EXPECT_FALSE(compile(gpu::ShaderStage::Vertex, vertexStage(view)).empty());
    EXPECT_FALSE(compile(gpu::ShaderStage::Fragment,
                         "layout(location = 0) out vec4 color; void main() { color = vec4(time); }")
                     .empty());
}

}  // namespace
}  // namespace nephrite::scene
