// The shared parts of this room's tests.
#include "gpu/support.h"

#include <stdlib.h>

#include <algorithm>
#include <stdexcept>

#include "gpu/reflection.h"

namespace nephrite::gpu::test {

TemporaryFolder::TemporaryFolder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "nephrite-gpu-XXXXXX").string();
    if (::mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("cannot make a temporary folder");
    path_ = pattern;
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
}

std::filesystem::path TemporaryFolder::write(const std::string& name, const std::string& text) const {
    const std::filesystem::path file = path_ / name;
    std::filesystem::create_directories(file.parent_path());
    std::ofstream(file, std::ios::binary) << text;
    return file;
}

std::vector<std::filesystem::path> TemporaryFolder::files() const {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(path_))
        if (entry.is_regular_file()) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

Environment::Environment(std::string name, std::optional<std::string> value) : name_(std::move(name)) {
    if (const char* before = ::getenv(name_.c_str())) before_ = before;
    if (value)
        ::setenv(name_.c_str(), value->c_str(), 1);
    else
        ::unsetenv(name_.c_str());
}

Environment::~Environment() {
    if (before_)
        ::setenv(name_.c_str(), before_->c_str(), 1);
    else
        ::unsetenv(name_.c_str());
}

void OnDevice::SetUp() {
    if (availableDevices().empty()) GTEST_SKIP() << "this machine has no Vulkan device";
    device_ = std::make_unique<Device>(DeviceOptions{"", Validation::Sync});
}

void OnDevice::TearDown() {
    if (!device_) return;
    EXPECT_EQ(device_->validationMessages(), 0U);
}

std::vector<std::uint32_t> compileText(ShaderStage stage, const std::string& text) {
    return ShaderCompiler().compile({"test", stage, {{"test.glsl", text}}, {}}).spirv;
}

Kernel::Kernel(const Device& device, const std::string& text,
               std::span<const SpecializationValue> specialization) {
    const std::vector<std::uint32_t> spirv = compileText(ShaderStage::Compute, text);
    const ShaderReflection reflection = reflect(spirv);
    std::vector<LayoutBinding> bindings;
    for (const ShaderBinding& binding : reflection.bindings)
        bindings.push_back({binding.binding, binding.type, VK_SHADER_STAGE_COMPUTE_BIT, binding.count});
    setLayout = DescriptorSetLayout(device, bindings);
    const VkDescriptorSetLayout sets[] = {setLayout.handle()};
    layout = PipelineLayout(device, sets, reflection.pushConstantBytes);
    pipeline = Pipeline(device, ComputePipelineDescription{spirv, layout.handle(), specialization, "test"});
    allocator = std::make_unique<DescriptorAllocator>(device);
    set = allocator->allocate(setLayout);
}

void Kernel::dispatch(VkCommandBuffer commands, std::uint32_t x, std::uint32_t y, std::uint32_t z) const {
    vkCmdBindPipeline(commands, pipeline.bindPoint(), pipeline.handle());
    vkCmdBindDescriptorSets(commands, pipeline.bindPoint(), layout.handle(), 0, 1, &set, 0, nullptr);
    vkCmdDispatch(commands, x, y, z);
}

}  // namespace nephrite::gpu::test
