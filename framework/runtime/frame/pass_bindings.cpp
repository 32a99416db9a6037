// Filling descriptor sets.
#include "runtime/frame/pass_bindings.h"

#include <algorithm>

#include "runtime/resources/vulkan_names.h"

namespace nephrite::runtime {
namespace {

std::uint16_t levelOf(const PortDescriptor& descriptor, std::uint32_t iteration) {
    const auto above = static_cast<std::uint16_t>(iteration == 0 ? 0 : iteration - 1);
    switch (descriptor.level) {
        case PortDescriptor::Level::Fixed:
            break;
        case PortDescriptor::Level::Iteration:
            return static_cast<std::uint16_t>(iteration);
        case PortDescriptor::Level::Above:
            return std::min(descriptor.mip, above);
    }
    return descriptor.mip;
}

}  // namespace

PassBindings::PassBindings(const BindingContext& context, std::size_t pass, NodeInterface interface,
                           std::shared_ptr<const Program> program)
    : pass_(pass), interface_(std::move(interface)), program_(std::move(program)) {
    for (const PortDescriptor& descriptor : interface_.descriptors)
        if (descriptor.resource != graph::noIndex && context.resources.isHistory(descriptor.resource))
            history_.push_back(descriptor);
    if (!history_.empty() || !interface_.parameterWords.empty()) slots_ = context.slots;
    const graph::PlannedPass& planned = context.plan.passes[pass];
    if (planned.forEach == graph::ForEach::Mips) iterations_ = planned.iterations;
    for (std::uint32_t slot = 0; slot < slots_; ++slot) {
        for (std::uint32_t iteration = 0; iteration < iterations_; ++iteration) {
            sets_.push_back(context.descriptors.allocate(program_->setLayout));
            for (const PortDescriptor& descriptor : interface_.descriptors)
                write(context, descriptor, slot, iteration);
            writer_.update(context.programs.device, sets_.back());
        }
    }
}

void PassBindings::prepare(const BindingContext& context, std::uint32_t slot) {
    if (history_.empty()) return;
    for (std::uint32_t iteration = 0; iteration < iterations_; ++iteration) {
        for (const PortDescriptor& descriptor : history_) write(context, descriptor, slot, iteration);
        writer_.update(context.programs.device, set(slot, iteration));
    }
}

void PassBindings::write(const BindingContext& context, const PortDescriptor& descriptor, std::uint32_t slot,
                         std::uint32_t iteration) {
    const FrameResources& resources = context.resources;
    const graph::Index resource = descriptor.resource;
    switch (descriptor.kind) {
        case PortDescriptor::Kind::ParameterBlock:
            writer_.uniformBuffer(descriptor.binding, context.parameters.buffer(slot),
                                  context.parameters.offset(pass_),
                                  interface_.parameterWords.size() * sizeof(std::uint32_t));
            return;
        case PortDescriptor::Kind::StorageBuffer:
            writer_.storageBuffer(descriptor.binding, resources.buffer(resource));
            return;
        case PortDescriptor::Kind::StorageImage:
            writer_.storageImage(descriptor.binding,
                                 resources.view(resource, levelOf(descriptor, iteration), descriptor.layer));
            return;
        case PortDescriptor::Kind::SampledImage: {
            const graph::Format format = context.plan.resources[resource].format;
            const graph::Layout layout =
                graph::layoutOf(graph::Use::ComputeRead, context.plan.inputReads, format);
            const VkSampler sampler = context.programs.filterable(format) ? context.programs.linearSampler
                                                                          : context.programs.nearestSampler;
            writer_.sampledImage(descriptor.binding,
                                 resources.view(resource, descriptor.mip, descriptor.layer), sampler,
                                 vulkanLayout(layout));
            return;
        }
    }
}

}  // namespace nephrite::runtime
