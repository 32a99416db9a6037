// Pipelines: specialization, reflection, drawing, descriptor pools, the pipeline cache, timestamps.
#include "gpu/pipeline.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cstring>
#include <limits>

#include "gpu/reflection.h"
#include "gpu/support.h"
#include "gpu/timestamps.h"
#include "gpu/transfer.h"
#include "text/diagnostics.h"

namespace nephrite::gpu {
namespace {

using test::Kernel;
using test::OnDevice;
using test::TemporaryFolder;
using testing::ElementsAre;

constexpr const char* specialized = R"(#version 460
layout(constant_id = 3) const bool flag = false;
layout(constant_id = 7) const uint taps = 12;
layout(constant_id = 8) const int offset = -2;
layout(constant_id = 9) const float scale = 0.5;
layout(local_size_x = 4) in;
struct Parameters { bool flag; uint taps; int offset; float scale; };
Parameters params = Parameters(flag, taps, offset, scale);
layout(set = 0, binding = 0) buffer Result { float result[]; };
void main() {
    float sum = 0;
    for (uint tap = 0; tap < params.taps; ++tap) sum += params.scale;
    result[gl_GlobalInvocationID.x] = (params.flag ? 1000.0 : 0.0) + sum + params.offset;
})";

/// What the kernel wrote to its only buffer.
std::array<float, 4> resultOf(const Device& device, const Kernel& kernel) {
    const Buffer result(device, {4 * sizeof(float), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT});
    DescriptorWriter().storageBuffer(0, result).update(device, kernel.set);
    runCommands(device, [&](VkCommandBuffer commands) { kernel.dispatch(commands, 1); });
    std::array<float, 4> values{};
    std::memcpy(values.data(), download(device, result).data(), sizeof(values));
    return values;
}

TEST_F(OnDevice, SpecializationConstantsChangeTheResult) {
    EXPECT_THAT(resultOf(device(), Kernel(device(), specialized)), testing::Each(12 * 0.5F - 2));
    const std::vector values{SpecializationValue::of(3, true), SpecializationValue::of(7, std::uint32_t{20}),
                             SpecializationValue::of(8, std::int32_t{-5}), SpecializationValue::of(9, 0.25F)};
    EXPECT_THAT(resultOf(device(), Kernel(device(), specialized, values)),
                testing::Each(1000 + 20 * 0.25F - 5));
}

TEST(Reflection, FindsSpecializationConstantsByIdAndName) {
    const ShaderReflection reflection = reflect(test::compileText(ShaderStage::Compute, specialized));
    EXPECT_THAT(reflection.specializationConstants,
                ElementsAre(SpecializationConstant{3, "flag"}, SpecializationConstant{7, "taps"},
                            SpecializationConstant{8, "offset"}, SpecializationConstant{9, "scale"}));
    EXPECT_EQ(reflection.workgroupSize, (std::array<std::uint32_t, 3>{4, 1, 1}));
}

TEST(Reflection, ListsOnlyWhatIsUsed) {
    const ShaderReflection reflection = reflect(test::compileText(ShaderStage::Compute, R"(#version 460
layout(local_size_x = 8, local_size_y = 4, local_size_z = 2) in;
layout(set = 0, binding = 0) uniform Frame { mat4 camera; float time; } frame;
layout(set = 0, binding = 1) readonly buffer Lights { vec4 lights[]; };
layout(set = 0, binding = 6) uniform sampler2D environment;
layout(set = 1, binding = 0, rgba16f) uniform readonly image2D color;
layout(set = 1, binding = 1, r32f) uniform writeonly image2DArray depth;
layout(set = 1, binding = 2) uniform sampler2D pictures[3];
layout(push_constant) uniform Push { uint iteration; uint reserved0; uint reserved1; uint reserved2; };
float unusedFunction() { return texture(environment, vec2(0)).x; }
void main() {
    imageStore(depth, ivec3(0, 0, iteration), lights[0] + textureLod(pictures[1], vec2(frame.time), 0));
})"));
    EXPECT_THAT(reflection.bindings,
                ElementsAre(ShaderBinding{0, 0, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, 1, "Frame"},
                            ShaderBinding{0, 1, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 1, "Lights"},
                            ShaderBinding{1, 1, VK_DESCRIPTOR_TYPE_STORAGE_IMAGE, 1, "depth"},
                            ShaderBinding{1, 2, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, 3, "pictures"}));
    EXPECT_TRUE(reflection.uses(0, 1));
    EXPECT_FALSE(reflection.uses(0, 6));
    EXPECT_EQ(reflection.pushConstantBytes, 16U);
    EXPECT_EQ(reflection.workgroupSize, (std::array<std::uint32_t, 3>{8, 4, 2}));
}

TEST(Reflection, RefusesWhatIsNotSpirv) {
    const std::vector<std::uint32_t> noise{1, 2, 3, 4, 5, 6};
    EXPECT_THROW(reflect(noise), RunError);
}

constexpr const char* triangleVertex = R"(#version 460
layout(location = 0) in vec3 position;
layout(location = 0) out vec2 place;
void main() { gl_Position = vec4(position, 1); place = position.xy; })";
constexpr const char* triangleFragment = R"(#version 460
layout(location = 0) in vec2 place;
layout(location = 0) out vec4 first;
layout(location = 1) out vec4 second;
layout(constant_id = 0) const float level = 0;
void main() { first = vec4(gl_FragCoord.xy, level, 1); second = vec4(place, 0, 1); })";

/// Draws triangles into two colour images and a depth image.
class Drawing {
  public:
    static constexpr std::uint32_t width = 16, height = 8;

    Drawing(const Device& device, VkCompareOp compare, VkCullModeFlags cull)
        : device_(device),
          first_(device, {VK_FORMAT_R32G32B32A32_SFLOAT, width, height, 1, 1, colorUsage, "first"}),
          second_(device, {VK_FORMAT_R16G16B16A16_SFLOAT, width, height, 1, 1, colorUsage, "second"}),
          depth_(device,
                 {VK_FORMAT_D32_SFLOAT, width, height, 1, 1,
                  VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT, "depth"}),
          layout_(device, {}, 0) {
        const auto vertex = test::compileText(ShaderStage::Vertex, triangleVertex);
        const auto fragment = test::compileText(ShaderStage::Fragment, triangleFragment);
        const std::vector values{SpecializationValue::of(0, 3.0F)};
        GraphicsPipelineDescription description;
        description.vertexSpirv = vertex;
        description.fragmentSpirv = fragment;
        description.layout = layout_.handle();
        description.specialization = values;
        description.vertexBindings = {{0, 3 * sizeof(float), VK_VERTEX_INPUT_RATE_VERTEX}};
        description.vertexAttributes = {{0, 0, VK_FORMAT_R32G32B32_SFLOAT, 0}};
        description.colorFormats = {first_.format(), second_.format()};
        description.depthFormat = depth_.format();
        description.depthCompare = compare;
        description.cullMode = cull;
        description.name = "triangles";
        pipeline_ = Pipeline(device, description);
    }

    void draw(std::span<const float> positions, float clearDepth) {
        const Buffer vertices = bufferOf(device_, positions, VK_BUFFER_USAGE_VERTEX_BUFFER_BIT, "vertices");
        runCommands(device_, [&](VkCommandBuffer commands) {
            prepare(commands);
            begin(commands, clearDepth);
            vkCmdBindPipeline(commands, pipeline_.bindPoint(), pipeline_.handle());
            const VkBuffer buffer = vertices.handle();
            const VkDeviceSize offset = 0;
            vkCmdBindVertexBuffers(commands, 0, 1, &buffer, &offset);
            vkCmdDraw(commands, static_cast<std::uint32_t>(positions.size() / 3), 1, 0, 0);
            vkCmdEndRendering(commands);
            finish(commands);
        });
    }

    std::vector<float> first() const { return readImage(device_, first_); }
    std::vector<float> second() const { return readImage(device_, second_); }
    std::vector<float> depth() const { return readImage(device_, depth_); }

  private:
    static constexpr VkImageUsageFlags colorUsage =
        VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
    static constexpr Access colorWrite{VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT,
                                       VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT};
    static constexpr Access depthWrite{
        VK_PIPELINE_STAGE_2_EARLY_FRAGMENT_TESTS_BIT | VK_PIPELINE_STAGE_2_LATE_FRAGMENT_TESTS_BIT,
        VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_READ_BIT | VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT};

    void prepare(VkCommandBuffer commands) const {
        BarrierBatch()
            .image(first_, test::nothing, colorWrite, VK_IMAGE_LAYOUT_UNDEFINED,
                   VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL)
            .image(second_, test::nothing, colorWrite, VK_IMAGE_LAYOUT_UNDEFINED,
                   VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL)
            .image(depth_, test::nothing, depthWrite, VK_IMAGE_LAYOUT_UNDEFINED,
                   VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL)
            .record(commands);
    }

    void finish(VkCommandBuffer commands) const {
        BarrierBatch()
            .image(first_, colorWrite, test::copyRead, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL,
                   VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL)
            .image(second_, colorWrite, test::copyRead, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL,
                   VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL)
            .image(depth_, depthWrite, test::copyRead, VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL,
                   VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL)
            .record(commands);
    }

    static VkRenderingAttachmentInfo attachment(const Image& image, VkImageLayout layout,
                                                VkClearValue clear) {
        VkRenderingAttachmentInfo info{};
        info.sType = VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO;
        info.imageView = image.view();
        info.imageLayout = layout;
        info.loadOp = VK_ATTACHMENT_LOAD_OP_CLEAR;
        info.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
        info.clearValue = clear;
        return info;
    }

    void begin(VkCommandBuffer commands, float clearDepth) const {
        VkClearValue clear{};
        clear.depthStencil = {clearDepth, 0};
        const std::array colors{attachment(first_, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL, {}),
                                attachment(second_, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL, {})};
        const auto depth = attachment(depth_, VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL, clear);
        VkRenderingInfo info{};
        info.sType = VK_STRUCTURE_TYPE_RENDERING_INFO;
        info.renderArea = {{0, 0}, {width, height}};
        info.layerCount = 1;
        info.colorAttachmentCount = static_cast<std::uint32_t>(colors.size());
        info.pColorAttachments = colors.data();
        info.pDepthAttachment = &depth;
        vkCmdBeginRendering(commands, &info);
        const VkViewport viewport{0, 0, width, height, 0, 1};
        vkCmdSetViewport(commands, 0, 1, &viewport);
        vkCmdSetScissor(commands, 0, 1, &info.renderArea);
    }

    const Device& device_;
    Image first_, second_, depth_;
    PipelineLayout layout_;
    Pipeline pipeline_;
};

/// A rectangle from x = `left` (-1..1) to the right edge, at a depth, counter-clockwise as Vulkan counts (y
/// down).
std::vector<float> rectangle(float left, float depth) {
    return {left, -1, depth, left, 1, depth, 1, -1, depth, 1, -1, depth, left, 1, depth, 1, 1, depth};
}

TEST_F(OnDevice, DrawsColoursAndDepth) {
    Drawing drawing(device(), VK_COMPARE_OP_LESS, VK_CULL_MODE_NONE);
    drawing.draw(rectangle(0, 0.25F), 1);  // the right half
    const auto first = drawing.first(), second = drawing.second(), depth = drawing.depth();
    for (std::uint32_t y = 0; y < Drawing::height; ++y) {
        for (std::uint32_t x = 0; x < Drawing::width; ++x) {
            const std::size_t at = (y * Drawing::width + x) * 4;
            const bool covered = x >= Drawing::width / 2;
            const std::vector<float> found(first.begin() + static_cast<std::ptrdiff_t>(at),
                                           first.begin() + static_cast<std::ptrdiff_t>(at) + 4);
            const float centerX = static_cast<float>(x) + 0.5F, centerY = static_cast<float>(y) + 0.5F;
            EXPECT_EQ(found,
                      covered ? (std::vector<float>{centerX, centerY, 3, 1}) : std::vector<float>(4, 0.0F));
            EXPECT_EQ(depth[at], covered ? 0.25F : 1.0F);
            if (!covered) continue;
            EXPECT_NEAR(second[at], 2 * centerX / Drawing::width - 1, 1e-3F);
            EXPECT_NEAR(second[at + 1], 2 * centerY / Drawing::height - 1, 1e-3F);
        }
    }
}

TEST_F(OnDevice, KeepsTheNearestOrTheFarthest) {
    std::vector<float> both = rectangle(-1, 0.75F);
    for (const float value : rectangle(-1, 0.25F)) both.push_back(value);
    Drawing nearest(device(), VK_COMPARE_OP_LESS, VK_CULL_MODE_NONE);
    nearest.draw(both, 1);
    EXPECT_EQ(nearest.depth()[0], 0.25F);
    Drawing farthest(device(), VK_COMPARE_OP_GREATER, VK_CULL_MODE_NONE);
    farthest.draw(both, 0);
    EXPECT_EQ(farthest.depth()[0], 0.75F);
}

TEST_F(OnDevice, CullsTheAskedSide) {
    Drawing front(device(), VK_COMPARE_OP_LESS, VK_CULL_MODE_FRONT_BIT);
    front.draw(rectangle(-1, 0.25F), 1);
    Drawing back(device(), VK_COMPARE_OP_LESS, VK_CULL_MODE_BACK_BIT);
    back.draw(rectangle(-1, 0.25F), 1);
    EXPECT_EQ(front.depth()[0], 1.0F);
    EXPECT_EQ(back.depth()[0], 0.25F);
}

TEST_F(OnDevice, DescriptorPoolsGrow) {
    const DescriptorSetLayout small(device(), {{0, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER}});
    const DescriptorSetLayout large(
        device(), {{0, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, VK_SHADER_STAGE_ALL, 300}});
    DescriptorAllocator allocator(device());
    std::vector<VkDescriptorSet> sets;
    for (int i = 0; i < 200; ++i) sets.push_back(allocator.allocate(small));
    if (device().limits().maxPerStageDescriptorSamplers >= 300) sets.push_back(allocator.allocate(large));
    std::sort(sets.begin(), sets.end());
    EXPECT_EQ(std::adjacent_find(sets.begin(), sets.end()), sets.end());
}

TEST_F(OnDevice, PipelineCacheIsKeptAndDamageIgnored) {
    const TemporaryFolder folder;
    const auto spirv = test::compileText(ShaderStage::Compute, specialized);
    const DescriptorSetLayout set(device(), {{0, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER}});
    const VkDescriptorSetLayout sets[] = {set.handle()};
    const PipelineLayout layout(device(), sets, 0);
    const auto build = [&] {
        const PipelineCache cache(device(), DiskCache(folder.path()));
        const Pipeline pipeline(device(), ComputePipelineDescription{spirv, layout.handle(), {}, "cached"},
                                &cache);
        EXPECT_TRUE(pipeline);
        return cache.loaded();
    };
    EXPECT_FALSE(build());
    EXPECT_TRUE(build());
    ASSERT_EQ(folder.files().size(), 1U);
    folder.write(folder.files()[0].filename().string(), "not a pipeline cache");
    EXPECT_FALSE(build());
    EXPECT_TRUE(build());
}

TEST_F(OnDevice, TimestampsRiseAndStayWithinTheWallTime) {
    Timestamps timestamps(device(), 4);
    if (!timestamps.supported()) GTEST_SKIP() << "this device's queue has no timestamps";
    const Buffer buffer(device(), {1 << 22, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT});
    const auto start = std::chrono::steady_clock::now();
    runCommands(device(), [&](VkCommandBuffer commands) {
        timestamps.reset(commands);
        for (std::uint32_t index = 0; index < timestamps.count(); ++index) {
            timestamps.write(commands, index);
            fullBarrier(commands);
            vkCmdFillBuffer(commands, buffer.handle(), 0, VK_WHOLE_SIZE, index);
            fullBarrier(commands);
        }
    });
    const double wall =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    const std::vector<double> times = timestamps.milliseconds(4);
    EXPECT_EQ(times[0], 0.0);
    EXPECT_LT(times[0], times[1]);
    EXPECT_LT(times[1], times[2]);
    EXPECT_LT(times[2], times[3]);
    EXPECT_LT(times[3], wall);
}

TEST(Timestamps, CountersMayWrapRound) {
    const std::vector<std::uint64_t> ticks{0xFFFF'FFF0, 0xFFFF'FFFF, 0x10};
    EXPECT_THAT(ticksToMilliseconds(ticks, 32, 1e6), ElementsAre(0.0, 15.0, 32.0));
    // Bits above the valid ones mean nothing.
    const std::vector<std::uint64_t> noisy{0xAB'0000'0001, 0xCD'0000'0003};
    EXPECT_THAT(ticksToMilliseconds(noisy, 32, 2e6), ElementsAre(0.0, 4.0));
    const std::vector<std::uint64_t> whole{std::numeric_limits<std::uint64_t>::max(), 1};
    EXPECT_THAT(ticksToMilliseconds(whole, 64, 1e6), ElementsAre(0.0, 2.0));
}

}  // namespace
}  // namespace nephrite::gpu
