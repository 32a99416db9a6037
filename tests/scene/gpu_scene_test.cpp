// The scene as shaders see it, against the same quantities computed on the CPU.
#include "scene/gpu_scene.h"

#include <gtest/gtest.h>
#include <stdlib.h>

#include <array>
#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>

#include "gpu/barriers.h"
#include "gpu/buffer.h"
#include "gpu/commands.h"
#include "gpu/pipeline.h"
#include "gpu/shader_compiler.h"
#include "gpu/transfer.h"
#include "image/exr.h"
#include "scene/environment.h"
#include "scene/scene_state.h"
#include "scene/scene_support.h"
#include "scene/shader_interface.h"

namespace nephrite::scene {
namespace {

/// A device under synchronization validation, and a folder for scene files.
class GpuSceneTest : public test::InFolder {
  protected:
    GpuSceneTest() { ::setenv("MESA_SHADER_CACHE_DIR", in("shader-cache").c_str(), 1); }

    void SetUp() override {
        if (gpu::availableDevices().empty()) GTEST_SKIP() << "no Vulkan device";
        gpu::DeviceOptions options;
        options.validation = gpu::Validation::Sync;
        device_ = std::make_unique<gpu::Device>(options);
    }
    void TearDown() override {
        if (!device_) return;
        for (const std::string& text : device_->validationTexts()) ADD_FAILURE() << text;
    }

    const gpu::Device& device() const { return *device_; }

    Scene load(const std::string& text) const {
        return Scene::load(put("scene.json", text), {test::presetFolder, 0});
    }

    std::vector<std::uint32_t> compile(gpu::ShaderStage stage, const std::string& text) const {
        gpu::ShaderSource source;
        source.name = "test shader";
        source.stage = stage;
        source.chunks = {{"scene interface", "#version 460\n" + shaderInterface()}, {"test shader", text}};
        return gpu::ShaderCompiler().compile(source).spirv;
    }

    /// Runs `body` for i = 0 .. count - 1; it writes vec4 result[i].
    std::vector<glm::vec4> run(const GpuScene& scene, const std::string& body, std::uint32_t count) const {
        const auto spirv = compile(gpu::ShaderStage::Compute,
                                   "layout(local_size_x = 1) in;\n"
                                   "layout(set = 1, binding = 0, std430) buffer Result { vec4 result[]; };\n"
                                   "void main() { uint i = gl_GlobalInvocationID.x;\n" +
                                       body + "}\n");
        const gpu::DescriptorSetLayout resultLayout(device(), {{0, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER}});
        const std::array layouts{scene.descriptorSetLayout(), resultLayout.handle()};
        const gpu::PipelineLayout layout(device(), layouts, 0);
        const gpu::Pipeline pipeline(device(), gpu::ComputePipelineDescription{spirv, layout.handle()});
        const gpu::Buffer result(device(), {count * sizeof(glm::vec4), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT,
                                            gpu::Residence::Readback, "result"});
        gpu::DescriptorAllocator allocator(device());
        const std::array sets{scene.descriptorSet(), allocator.allocate(resultLayout)};
        gpu::DescriptorWriter().storageBuffer(0, result).update(device(), sets[1]);
        gpu::runCommands(device(), [&](VkCommandBuffer commands) {
            vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, pipeline.handle());
            vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_COMPUTE, layout.handle(), 0, 2,
                                    sets.data(), 0, nullptr);
            vkCmdDispatch(commands, count, 1, 1);
            gpu::BarrierBatch()
                .buffer(result,
                        {VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT},
                        {VK_PIPELINE_STAGE_2_HOST_BIT, VK_ACCESS_2_HOST_READ_BIT})
                .record(commands);
        });
        std::vector<glm::vec4> values(count);
        std::memcpy(values.data(), result.mapped().data(), count * sizeof(glm::vec4));
        return values;
    }

  private:
    std::unique_ptr<gpu::Device> device_;
};

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

/// World positions (w = 1 where something is) seen by one pass over the scene.
class PositionPass {
  public:
    static constexpr std::uint32_t side = 64;

    PositionPass(const gpu::Device& device, const GpuScene& scene, const std::vector<std::uint32_t>& vertex,
                 const std::vector<std::uint32_t>& fragment)
        : device_(device),
          scene_(scene),
          layouts_{scene.descriptorSetLayout()},
          layout_(device, layouts_, 16) {
        gpu::GraphicsPipelineDescription description;
        description.vertexSpirv = vertex;
        description.fragmentSpirv = fragment;
        description.layout = layout_.handle();
        const auto bindings = GpuScene::vertexBindings();
        const auto attributes = GpuScene::vertexAttributes();
        description.vertexBindings.assign(bindings.begin(), bindings.end());
        description.vertexAttributes.assign(attributes.begin(), attributes.end());
        description.colorFormats = {VK_FORMAT_R32G32B32A32_SFLOAT};
        description.depthFormat = VK_FORMAT_D32_SFLOAT;
        description.cullMode = VK_CULL_MODE_BACK_BIT;
        pipeline_ = gpu::Pipeline(device, description);
        constexpr VkImageUsageFlags color =
            VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
        color_ = gpu::Image(device, {VK_FORMAT_R32G32B32A32_SFLOAT, side, side, 1, 1, color, "color"});
        depth_ = gpu::Image(device, {VK_FORMAT_D32_SFLOAT, side, side, 1, 1,
                                     VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT, "depth"});
    }

    std::vector<float> draw(std::uint32_t iteration) {
        constexpr gpu::Access colorWrite{VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT,
                                         VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT};
        constexpr gpu::Access depthWrite{
            VK_PIPELINE_STAGE_2_EARLY_FRAGMENT_TESTS_BIT | VK_PIPELINE_STAGE_2_LATE_FRAGMENT_TESTS_BIT,
            VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_READ_BIT | VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT};
        gpu::runCommands(device_, [&](VkCommandBuffer commands) {
            gpu::BarrierBatch()
                .image(color_, {}, colorWrite, VK_IMAGE_LAYOUT_UNDEFINED,
                       VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL)
                .image(depth_, {}, depthWrite, VK_IMAGE_LAYOUT_UNDEFINED,
                       VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL)
                .record(commands);
            render(commands, iteration);
            gpu::BarrierBatch()
                .image(color_, colorWrite, {VK_PIPELINE_STAGE_2_COPY_BIT, VK_ACCESS_2_TRANSFER_READ_BIT},
                       VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL)
                .record(commands);
        });
        return gpu::readImage(device_, color_);
    }

  private:
    void render(VkCommandBuffer commands, std::uint32_t iteration) const {
        VkRenderingAttachmentInfo color{};
        color.sType = VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO;
        color.imageView = color_.view();
        color.imageLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
        color.loadOp = VK_ATTACHMENT_LOAD_OP_CLEAR;
        color.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
        VkRenderingAttachmentInfo depth = color;
        depth.imageView = depth_.view();
        depth.imageLayout = VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL;
        depth.clearValue.depthStencil = {1, 0};
        VkRenderingInfo info{};
        info.sType = VK_STRUCTURE_TYPE_RENDERING_INFO;
        info.renderArea.extent = {side, side};
        info.layerCount = 1;
        info.colorAttachmentCount = 1;
        info.pColorAttachments = &color;
        info.pDepthAttachment = &depth;
        vkCmdBeginRendering(commands, &info);
        vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline_.handle());
        const VkDescriptorSet set = scene_.descriptorSet();
        vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, layout_.handle(), 0, 1, &set, 0,
                                nullptr);
        const std::array<std::uint32_t, 4> push{iteration, 0, 0, 0};
        vkCmdPushConstants(commands, layout_.handle(), gpu::pushConstantStages, 0, sizeof(push), push.data());
        const VkViewport viewport{0, 0, side, side, 0, 1};
        const VkRect2D scissor{{0, 0}, {side, side}};
        vkCmdSetViewport(commands, 0, 1, &viewport);
        vkCmdSetScissor(commands, 0, 1, &scissor);
        scene_.draw(commands);
        vkCmdEndRendering(commands);
    }

    const gpu::Device& device_;
    const GpuScene& scene_;
    std::array<VkDescriptorSetLayout, 1> layouts_;
    gpu::PipelineLayout layout_;
    gpu::Pipeline pipeline_;
    gpu::Image color_;
    gpu::Image depth_;
};

constexpr const char* positionFragment = R"(
layout(location = 0) in vec3 position;
layout(location = 3) in flat uint material;
layout(location = 0) out vec4 color;
void main() { color = vec4(position, 1.0 + float(material)); })";

/// Checks each covered pixel against the nearest of the spheres its ray meets; `materials` are the spheres'
/// indices.
void expectSpheres(const std::vector<float>& pixels, const View& view,
                   const std::vector<EnclosingSphere>& spheres) {
    constexpr std::uint32_t side = PositionPass::side;
    int covered = 0;
    for (std::uint32_t y = 0; y < side; ++y)
        for (std::uint32_t x = 0; x < side; ++x) {
            const float* pixel = &pixels[(std::size_t{y} * side + x) * 4];
            const glm::dvec3 ray =
                viewRay(view, (static_cast<float>(x) + 0.5F) / side, (static_cast<float>(y) + 0.5F) / side);
            double nearest = 1e30;
            std::size_t hit = 0;
            bool grazing = false;
            for (std::size_t i = 0; i < spheres.size(); ++i) {
                const glm::dvec3 toCenter = spheres[i].center - glm::dvec3(view.position);
                const double along = glm::dot(toCenter, ray);
                const double miss = std::sqrt(std::max(0.0, glm::dot(toCenter, toCenter) - along * along));
                grazing = grazing || std::abs(miss - spheres[i].radius) < 0.02 * spheres[i].radius;
                if (along < 0 || miss > spheres[i].radius) continue;
                const double distance =
                    along - std::sqrt(spheres[i].radius * spheres[i].radius - miss * miss);
                if (distance < nearest) nearest = distance, hit = i;
            }
            if (grazing) continue;
            ASSERT_EQ(pixel[3] > 0, nearest < 1e30) << x << ", " << y;
            if (pixel[3] == 0) continue;
            ++covered;
            EXPECT_EQ(pixel[3], static_cast<float>(hit + 1)) << x << ", " << y;
            const glm::dvec3 expected = glm::dvec3(view.position) + nearest * ray;
            EXPECT_LT(glm::distance(glm::dvec3(pixel[0], pixel[1], pixel[2]), expected),
                      0.01 * spheres[hit].radius)
                << x << ", " << y;
        }
    EXPECT_GT(covered, 100);
}

TEST_F(GpuSceneTest, DrawingPutsEverySurfaceWhereItsPixelsRayMeetsIt) {
    const Scene scene = load(R"({"camera": {"position": [0, 5, 40], "fovY": 36, "near": 1, "far": 100},
        "lights": [{"type": "point", "position": [25, 20, 15], "intensity": [1, 1, 1]},
                   {"type": "point", "position": [0, 0, 1], "intensity": [1, 1, 1]}],
        "objects": [
            {"mesh": {"procedural": "sphere", "radius": 2}, "material": "apple", "transform": {"translate": [-5, 2, 0], "scale": 2}},
            {"mesh": {"procedural": "sphere", "radius": 2}, "material": "marble", "transform": {"translate": [3, -1, -4]},
             "animation": {"type": "path", "points": [[0, 0, 0], [2, 3, 0]], "smooth": false, "secondsPerLoop": 2}}]})");
    GpuScene gpuScene(device(), scene);
    gpuScene.update(1, PositionPass::side, PositionPass::side);  // half-way: at the path's second point
    const std::vector<EnclosingSphere> spheres{{{-5, 2, 0}, 4}, {{5, 2, -4}, 2}};
    const auto fragment = compile(gpu::ShaderStage::Fragment, positionFragment);
    PositionPass fromCamera(device(), gpuScene,
                            compile(gpu::ShaderStage::Vertex, vertexStage(RasterView::Camera)), fragment);
    expectSpheres(fromCamera.draw(0), cameraView(scene.description().camera, 64, 64), spheres);
    PositionPass fromLight(device(), gpuScene,
                           compile(gpu::ShaderStage::Vertex, vertexStage(RasterView::Light)), fragment);
    const EnclosingSphere bounds = scene.boundingSphere(1);
    expectSpheres(fromLight.draw(0), lightViews({25, 20, 15}, 0, bounds, 1)[0], spheres);
    const std::vector<View> faces = lightViews({0, 0, 1}, 1, bounds, 6);
    ASSERT_EQ(gpuScene.lightViewCount(), 7U);
    expectSpheres(fromLight.draw(1), faces[0], spheres);  // +x
    expectSpheres(fromLight.draw(2), faces[1], spheres);  // -x
}

TEST_F(GpuSceneTest, DeformedVerticesFollowTheTime) {
    const Scene scene = load("{" + test::anyCamera + R"(, "objects": [
        {"mesh": {"procedural": "cube", "size": 4}, "material": "apple",
         "animation": {"type": "pulse", "amount": 0.5, "waves": 0, "period": 4}}]})");
    // At a quarter of the period after the start the sine is -1 or 1; the width across the axis changes by a
    // half.
    const Moment rest = scene.state().at(0);
    const Moment peak = scene.state().at(3);
    EXPECT_NEAR(rest.bounds.radius, std::sqrt(12.0), 1e-4);
    EXPECT_NEAR(peak.bounds.radius, std::sqrt(4 + 2 * 9.0), 1e-4);
    GpuScene gpuScene(device(), scene);
    gpuScene.update(3, PositionPass::side, PositionPass::side);
    PositionPass pass(device(), gpuScene, compile(gpu::ShaderStage::Vertex, vertexStage(RasterView::Camera)),
                      compile(gpu::ShaderStage::Fragment, positionFragment));
    float widest = 0;
    const std::vector<float> pixels = pass.draw(0);
    for (std::size_t i = 0; i < pixels.size(); i += 4)
        if (pixels[i + 3] > 0) widest = std::max(widest, std::abs(pixels[i]));
    EXPECT_GT(widest, 2.5F);
    EXPECT_LT(widest, 3.01F);
}

}  // namespace
}  // namespace nephrite::scene
