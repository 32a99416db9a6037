// What the tests of this room share: a device that must stay free of validation messages, folders,
// environment.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "gpu/barriers.h"
#include "gpu/commands.h"
#include "gpu/descriptors.h"
#include "gpu/device.h"
#include "gpu/image.h"
#include "gpu/pipeline.h"
#include "gpu/shader_compiler.h"

namespace nephrite::gpu::test {

/// A new empty folder, removed with everything in it.
class TemporaryFolder {
  public:
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }
    /// Writes a text file below the folder, making the folders on the way.
    std::filesystem::path write(const std::string& name, const std::string& text) const;
    std::vector<std::filesystem::path> files() const;

  private:
    std::filesystem::path path_;
};

/// An environment variable set (or, with nothing, unset) for a while.
class Environment {
  public:
    Environment(std::string name, std::optional<std::string> value);
    ~Environment();
    Environment(const Environment&) = delete;
    Environment& operator=(const Environment&) = delete;

  private:
    std::string name_;
    std::optional<std::string> before_;
};

/// Tests on a device under synchronization validation. Skipped only on a machine without any Vulkan device;
/// fails if the validation layer said anything.
class OnDevice : public testing::Test {
  protected:
    void SetUp() override;
    void TearDown() override;

    Device& device() { return *device_; }

  private:
    TemporaryFolder driverCache_;
    Environment driverCacheVariable_{"MESA_SHADER_CACHE_DIR", driverCache_.path().string()};
    std::unique_ptr<Device> device_;
};

/// A shader of one piece.
std::vector<std::uint32_t> compileText(ShaderStage stage, const std::string& text);

/// A compute pipeline with the bindings its shader uses in set 0, and one set of them.
struct Kernel {
    DescriptorSetLayout setLayout;
    PipelineLayout layout;
    Pipeline pipeline;
    std::unique_ptr<DescriptorAllocator> allocator;
    VkDescriptorSet set = VK_NULL_HANDLE;

    Kernel(const Device& device, const std::string& text,
           std::span<const SpecializationValue> specialization = {});
    void dispatch(VkCommandBuffer commands, std::uint32_t x, std::uint32_t y = 1, std::uint32_t z = 1) const;
};

inline constexpr Access computeWrite{VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT,
                                     VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT};
inline constexpr Access copyRead{VK_PIPELINE_STAGE_2_COPY_BIT, VK_ACCESS_2_TRANSFER_READ_BIT};
inline constexpr Access nothing{};

}  // namespace nephrite::gpu::test
