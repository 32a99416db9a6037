// What a SPIR-V module uses: bindings, push constants, specialization constants.
#pragma once

#include <vulkan/vulkan.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace nephrite::gpu {

/// A descriptor the entry point statically uses.
struct ShaderBinding {
    std::uint32_t set = 0;
    std::uint32_t binding = 0;
    VkDescriptorType type = VK_DESCRIPTOR_TYPE_STORAGE_IMAGE;
    std::uint32_t count = 1;  ///< elements of an array of descriptors
    std::string name;
    friend bool operator==(const ShaderBinding&, const ShaderBinding&) = default;
};

struct SpecializationConstant {
    std::uint32_t id = 0;
    std::string name;
    friend bool operator==(const SpecializationConstant&, const SpecializationConstant&) = default;
};

struct ShaderReflection {
    std::vector<ShaderBinding> bindings;                          ///< by set, then binding
    std::vector<SpecializationConstant> specializationConstants;  ///< by id
    std::uint32_t pushConstantBytes = 0;
    std::array<std::uint32_t, 3> workgroupSize{0, 0, 0};  ///< of a compute shader, defaults of its constants

    bool uses(std::uint32_t set, std::uint32_t binding) const;
};

/// Bytes of a uniform or storage block.
struct ByteRange {
    std::size_t offset = 0;
    std::size_t bytes = 0;
};
/// The members of a uniform block that the entry point may read, whole members of the block, in no certain
/// order; empty if it has no such block. Throws RunError if the module cannot be read.
std::vector<ByteRange> usedMembers(std::span<const std::uint32_t> spirv, std::uint32_t set,
                                   std::uint32_t binding);

/// Throws RunError if the module cannot be read.
ShaderReflection reflect(std::span<const std::uint32_t> spirv);

}  // namespace nephrite::gpu
