// Drawing the scene: every pixel shows the surface its ray meets, from the camera and from lights, at a time.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "gpu/image.h"
#include "gpu/transfer.h"
#include "scene/gpu_scene_support.h"
#include "scene/scene_state.h"
#include "scene/view.h"

namespace nephrite::scene {
namespace {

using GpuSceneDrawing = test::OnDevice;

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

TEST_F(GpuSceneDrawing, DrawingPutsEverySurfaceWhereItsPixelsRayMeetsIt) {
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

TEST_F(GpuSceneDrawing, DeformedVerticesFollowTheTime) {
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
