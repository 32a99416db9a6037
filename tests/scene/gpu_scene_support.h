// A device for tests of the scene on it, and a way to run GLSL that sees the scene.
#pragma once

#include <gtest/gtest.h>
#include <stdlib.h>

#include <array>
#include <cstring>
#include <glm/vec4.hpp>
#include <memory>
#include <string>
#include <vector>

#include "gpu/barriers.h"
#include "gpu/buffer.h"
#include "gpu/commands.h"
#include "gpu/descriptors.h"
#include "gpu/pipeline.h"
#include "gpu/shader_compiler.h"
#include "scene/gpu_scene.h"
#include "scene/scene_support.h"
#include "scene/shader_interface.h"

namespace nephrite::scene::test {

/// A device under synchronization validation, and a folder for scene files.
class OnDevice : public InFolder {
  protected:
    OnDevice() { ::setenv("MESA_SHADER_CACHE_DIR", in("shader-cache").c_str(), 1); }

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
        return Scene::load(put("scene.json", text), {presetFolder, 0});
    }

    std::vector<std::uint32_t> compile(gpu::ShaderStage stage, const std::string& text) const {
        gpu::ShaderSource source;
        source.name = "test shader";
        source.stage = stage;
        source.chunks = {{"scene interface", "#version 460\n" + shaderInterface()}, {"test shader", text}};
        return gpu::ShaderCompiler().compile(source).spirv;
    }

    /// Runs `body` for i = 0 .. count - 1; it writes vec4 result[i].
    std::vector<glm::vec4> run(const GpuScene& scene, const std::string& body, std::uint32_t count,
                               std::uint32_t slot = 0) const {
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
        const std::array sets{scene.descriptorSet(slot), allocator.allocate(resultLayout)};
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

}  // namespace nephrite::scene::test
