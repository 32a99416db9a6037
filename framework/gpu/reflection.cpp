// Reading SPIR-V with SPIRV-Cross.
#include "gpu/reflection.h"

#include <fmt/format.h>
#include <spirv_cross/spirv_cross_c.h>

#include <algorithm>
#include <memory>
#include <tuple>
#include <utility>

#include "text/diagnostics.h"

namespace nephrite::gpu {
namespace {

struct ContextDeleter {
    void operator()(spvc_context context) const { spvc_context_destroy(context); }
};

/// A parsed module; everything SPIRV-Cross returns lives as long as it.
class Module {
  public:
    explicit Module(std::span<const std::uint32_t> spirv) {
        spvc_context context = nullptr;
        if (spvc_context_create(&context) != SPVC_SUCCESS) throw RunError("cannot start SPIRV-Cross");
        context_.reset(context);
        spvc_parsed_ir parsed = nullptr;
        check(spvc_context_parse_spirv(context, spirv.data(), spirv.size(), &parsed));
        check(spvc_context_create_compiler(context, SPVC_BACKEND_NONE, parsed,
                                           SPVC_CAPTURE_MODE_TAKE_OWNERSHIP, &compiler_));
    }

    void check(spvc_result result) const {
        if (result == SPVC_SUCCESS) return;
        throw RunError(fmt::format("cannot read a SPIR-V module: {}",
                                   spvc_context_get_last_error_string(context_.get())));
    }

    spvc_compiler compiler() const { return compiler_; }

    /// Resources the entry point uses.
    spvc_resources usedResources() const {
        spvc_set used = nullptr;
        check(spvc_compiler_get_active_interface_variables(compiler_, &used));
        spvc_resources resources = nullptr;
        check(spvc_compiler_create_shader_resources_for_active_variables(compiler_, &resources, used));
        return resources;
    }

    std::span<const spvc_reflected_resource> list(spvc_resources resources, spvc_resource_type type) const {
        const spvc_reflected_resource* first = nullptr;
        std::size_t count = 0;
        check(spvc_resources_get_resource_list_for_type(resources, type, &first, &count));
        return {first, count};
    }

  private:
    std::unique_ptr<spvc_context_s, ContextDeleter> context_;
    spvc_compiler compiler_ = nullptr;
};

constexpr std::array<std::pair<spvc_resource_type, VkDescriptorType>, 6> descriptorKinds{{
    {SPVC_RESOURCE_TYPE_UNIFORM_BUFFER, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER},
    {SPVC_RESOURCE_TYPE_STORAGE_BUFFER, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER},
    {SPVC_RESOURCE_TYPE_STORAGE_IMAGE, VK_DESCRIPTOR_TYPE_STORAGE_IMAGE},
    {SPVC_RESOURCE_TYPE_SAMPLED_IMAGE, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER},
    {SPVC_RESOURCE_TYPE_SEPARATE_IMAGE, VK_DESCRIPTOR_TYPE_SAMPLED_IMAGE},
    {SPVC_RESOURCE_TYPE_SEPARATE_SAMPLERS, VK_DESCRIPTOR_TYPE_SAMPLER},
}};

ShaderBinding bindingOf(const Module& module, const spvc_reflected_resource& resource,
                        VkDescriptorType type) {
    spvc_compiler compiler = module.compiler();
    ShaderBinding binding;
    binding.set = spvc_compiler_get_decoration(compiler, resource.id, SpvDecorationDescriptorSet);
    binding.binding = spvc_compiler_get_decoration(compiler, resource.id, SpvDecorationBinding);
    binding.type = type;
    binding.name = resource.name;
    const spvc_type declared = spvc_compiler_get_type_handle(compiler, resource.type_id);
    for (unsigned dimension = 0; dimension < spvc_type_get_num_array_dimensions(declared); ++dimension)
        binding.count *= spvc_type_get_array_dimension(declared, dimension);
    return binding;
}

std::vector<ShaderBinding> bindingsOf(const Module& module, spvc_resources resources) {
    std::vector<ShaderBinding> bindings;
    for (const auto& [kind, type] : descriptorKinds)
        for (const spvc_reflected_resource& resource : module.list(resources, kind))
            bindings.push_back(bindingOf(module, resource, type));
    std::sort(bindings.begin(), bindings.end(), [](const ShaderBinding& a, const ShaderBinding& b) {
        return std::tie(a.set, a.binding) < std::tie(b.set, b.binding);
    });
    return bindings;
}

std::vector<SpecializationConstant> specializationConstantsOf(const Module& module) {
    const spvc_specialization_constant* first = nullptr;
    std::size_t count = 0;
    module.check(spvc_compiler_get_specialization_constants(module.compiler(), &first, &count));
    std::vector<SpecializationConstant> constants;
    for (const spvc_specialization_constant& constant : std::span(first, count))
        constants.push_back({constant.constant_id, spvc_compiler_get_name(module.compiler(), constant.id)});
    std::sort(constants.begin(), constants.end(), [](const auto& a, const auto& b) { return a.id < b.id; });
    return constants;
}

std::uint32_t pushConstantBytesOf(const Module& module, spvc_resources resources) {
    std::size_t largest = 0;
    for (const spvc_reflected_resource& block : module.list(resources, SPVC_RESOURCE_TYPE_PUSH_CONSTANT)) {
        std::size_t bytes = 0;
        const spvc_type type = spvc_compiler_get_type_handle(module.compiler(), block.base_type_id);
        module.check(spvc_compiler_get_declared_struct_size(module.compiler(), type, &bytes));
        largest = std::max(largest, bytes);
    }
    return static_cast<std::uint32_t>(largest);
}

}  // namespace

bool ShaderReflection::uses(std::uint32_t set, std::uint32_t binding) const {
    return std::any_of(bindings.begin(), bindings.end(),
                       [&](const ShaderBinding& used) { return used.set == set && used.binding == binding; });
}

std::vector<ByteRange> usedMembers(std::span<const std::uint32_t> spirv, std::uint32_t set,
                                   std::uint32_t binding) {
    const Module module(spirv);
    std::vector<ByteRange> members;
    for (const spvc_reflected_resource& block :
         module.list(module.usedResources(), SPVC_RESOURCE_TYPE_UNIFORM_BUFFER)) {
        const ShaderBinding found = bindingOf(module, block, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER);
        if (found.set != set || found.binding != binding) continue;
        const spvc_buffer_range* first = nullptr;
        std::size_t count = 0;
        module.check(spvc_compiler_get_active_buffer_ranges(module.compiler(), block.id, &first, &count));
        for (const spvc_buffer_range& range : std::span(first, count))
            members.push_back({range.offset, range.range});
    }
    return members;
}

ShaderReflection reflect(std::span<const std::uint32_t> spirv) {
    const Module module(spirv);
    const spvc_resources resources = module.usedResources();
    ShaderReflection reflection;
    reflection.bindings = bindingsOf(module, resources);
    reflection.specializationConstants = specializationConstantsOf(module);
    reflection.pushConstantBytes = pushConstantBytesOf(module, resources);
    for (unsigned axis = 0; axis < 3; ++axis)
        reflection.workgroupSize[axis] = spvc_compiler_get_execution_mode_argument_by_index(
            module.compiler(), SpvExecutionModeLocalSize, axis);
    return reflection;
}

}  // namespace nephrite::gpu
