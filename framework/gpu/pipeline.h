// Pipelines and their layouts, and the driver's pipeline cache kept on disk.
#pragma once

#include <vulkan/vulkan.h>

#include <bit>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "gpu/descriptors.h"
#include "gpu/device.h"
#include "gpu/disk_cache.h"
#include "gpu/handle.h"

namespace nephrite::gpu {

/// The driver's compiled pipelines, loaded at the start, merged with what other processes wrote meanwhile and
/// saved at the end, one file for each device and driver.
class PipelineCache {
  public:
    PipelineCache(const Device& device, DiskCache disk);
    ~PipelineCache();  ///< saves
    PipelineCache(const PipelineCache&) = delete;
    PipelineCache& operator=(const PipelineCache&) = delete;

    VkPipelineCache handle() const { return cache_.get(); }
    bool loaded() const { return !original_.empty(); }  ///< something was found on disk
    /// Writes the cache to disk if it holds something new. Never throws.
    void save() noexcept;

  private:
    const Device& device_;
    DiskCache disk_;
    std::string key_;
    std::vector<std::byte> original_;
    Handle<VkPipelineCache, vkDestroyPipelineCache> cache_;
};

/// Every stage there is here.
inline constexpr VkShaderStageFlags pushConstantStages =
    VK_SHADER_STAGE_COMPUTE_BIT | VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT;

class PipelineLayout {
  public:
    PipelineLayout() = default;
    /// Set i has sets[i]'s layout; push constants (if any) start at 0 and are visible to `pushStages`.
    PipelineLayout(const Device& device, std::span<const VkDescriptorSetLayout> sets,
                   std::uint32_t pushConstantBytes, VkShaderStageFlags pushStages = pushConstantStages);
    VkPipelineLayout handle() const { return layout_.get(); }
    /// For vkCmdPushConstants.
    VkShaderStageFlags pushStages() const { return pushStages_; }

  private:
    VkShaderStageFlags pushStages_ = 0;
    Handle<VkPipelineLayout, vkDestroyPipelineLayout> layout_;
};

/// A specialization constant's value: bool, int, uint or float, all 32 bits.
struct SpecializationValue {
    std::uint32_t id = 0;
    std::uint32_t bits = 0;

    static SpecializationValue of(std::uint32_t id, bool value) { return {id, value ? 1u : 0u}; }
    static SpecializationValue of(std::uint32_t id, std::int32_t value) {
        return {id, std::bit_cast<std::uint32_t>(value)};
    }
    static SpecializationValue of(std::uint32_t id, std::uint32_t value) { return {id, value}; }
    static SpecializationValue of(std::uint32_t id, float value) {
        return {id, std::bit_cast<std::uint32_t>(value)};
    }
};

struct ComputePipelineDescription {
    std::span<const std::uint32_t> spirv;
    VkPipelineLayout layout = VK_NULL_HANDLE;
    std::span<const SpecializationValue> specialization = {};
    std::string name = {};  ///< for errors and validation messages
};

struct GraphicsPipelineDescription {
    std::span<const std::uint32_t> vertexSpirv;
    std::span<const std::uint32_t> fragmentSpirv;
    VkPipelineLayout layout = VK_NULL_HANDLE;
    std::span<const SpecializationValue> specialization = {};  ///< of both stages
    std::vector<VkVertexInputBindingDescription> vertexBindings = {};
    std::vector<VkVertexInputAttributeDescription> vertexAttributes = {};
    std::vector<VkFormat> colorFormats = {};   ///< one for each attachment; written without blending
    std::optional<VkFormat> depthFormat = {};  ///< with one, depth is tested and written
    VkCompareOp depthCompare = VK_COMPARE_OP_LESS;
    VkCullModeFlags cullMode = VK_CULL_MODE_NONE;
    VkFrontFace frontFace = VK_FRONT_FACE_COUNTER_CLOCKWISE;
    VkPrimitiveTopology topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
    std::string name = {};
};

/// A compute or a graphics pipeline. A graphics pipeline is used inside vkCmdBeginRendering, with viewport
/// and scissor set by command.
class Pipeline {
  public:
    Pipeline() = default;
    /// Both throw RunError if the driver refuses. `cache` may be null.
    Pipeline(const Device& device, const ComputePipelineDescription& description,
             const PipelineCache* cache = nullptr);
    Pipeline(const Device& device, const GraphicsPipelineDescription& description,
             const PipelineCache* cache = nullptr);

    VkPipeline handle() const { return pipeline_.get(); }
    VkPipelineBindPoint bindPoint() const { return bindPoint_; }
    explicit operator bool() const { return static_cast<bool>(pipeline_); }

  private:
    Handle<VkPipeline, vkDestroyPipeline> pipeline_;
    VkPipelineBindPoint bindPoint_ = VK_PIPELINE_BIND_POINT_COMPUTE;
};

}  // namespace nephrite::gpu
