// Passes and barriers as commands.
#include "runtime/frame/frame_recorder.h"

#include <algorithm>
#include <array>

#include "runtime/resources/resource_descriptions.h"
#include "runtime/resources/vulkan_names.h"

namespace nephrite::runtime {
namespace {

using graph::Index;
using graph::PlannedPass;
using graph::Resource;

constexpr gpu::Access everything{VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT,
                                 VK_ACCESS_2_MEMORY_READ_BIT | VK_ACCESS_2_MEMORY_WRITE_BIT};

std::uint32_t groups(std::uint32_t count, std::uint32_t size) {
    return (count + size - 1) / size;
}

/// As many groups in rows of what every device allows in one direction; the generated main() counts them
/// through.
void dispatchLinear(VkCommandBuffer commands, std::uint32_t count) {
    constexpr std::uint32_t longestRow = 65535;
    vkCmdDispatch(commands, std::min(count, longestRow), groups(count, longestRow), 1);
}

graph::Extent levelOf(graph::Extent extent, std::uint32_t level) {
    return {std::max(extent.width >> level, 1U), std::max(extent.height >> level, 1U)};
}

/// True if something after the pass looks at the resource, in this frame or a later one.
bool isReadLater(const Resource& resource, Index pass) {
    return resource.kind != graph::ResourceKind::Transient || resource.requested || resource.last > pass;
}

/// The input that an output of a pass modifies, or nullptr.
const graph::InputRead* modifiedBy(const graph::Plan& plan, const PlannedPass& pass, Index port) {
    const Index input = plan.typeOf(pass).outputs[port].modifiedInput;
    if (input == graph::noIndex) return nullptr;
    const graph::InputRead& read = plan.inputs[pass.inputs.first + input];
    return read.modified ? &read : nullptr;
}

}  // namespace

FrameRecorder::FrameRecorder(const graph::Plan& plan, const FrameResources& resources,
                             const scene::GpuScene& scene,
                             const std::vector<std::unique_ptr<PassBindings>>& bindings)
    : plan_(plan), resources_(resources), scene_(scene), bindings_(bindings) {}

void FrameRecorder::begin(VkCommandBuffer commands, std::uint32_t slot,
                          const graph::BarrierSchedule& schedule, const gpu::PipelineStatistics& statistics) {
    commands_ = commands;
    slot_ = slot;
    schedule_ = &schedule;
    statistics_ = &statistics;
    batch_.memory(everything, everything).record(commands);
}

void FrameRecorder::pass(Index index) {
    const PlannedPass& pass = plan_.passes[index];
    Index batch = pass.firstBatch;
    if (pass.clearsFirst || pass.iterations == 0) {
        barriers(batch);
        clears(pass);
        if (pass.iterations == 0) return;
        ++batch;
    }
    const PassBindings& bindings = *bindings_[index];
    bind(bindings);
    const VkPipelineBindPoint bindPoint = bindings.program().pipeline.bindPoint();
    statistics_->begin(commands_, index, bindPoint);
    if (plan_.typeOf(pass).kind == graph::PassKind::Raster) {
        barriers(batch);
        raster(index, bindings);
    } else {
        compute(pass, bindings, batch);
    }
    statistics_->end(commands_, index, bindPoint);
}

void FrameRecorder::end() {
    barriers(static_cast<Index>(schedule_->batches.size() - 1));
}

void FrameRecorder::barriers(Index batch) {
    for (const graph::Barrier& barrier : graph::slice(schedule_->barriers, schedule_->batches[batch]))
        addBarrier(barrier);
    batch_.record(commands_);
}

void FrameRecorder::addBarrier(const graph::Barrier& barrier) {
    gpu::Access before = writesOf(barrier.usesBefore);
    const gpu::Access after = accessOf(barrier.usesAfter);
    // What other resources left in the same memory must be out of the way: no barrier of this one covers
    // that.
    if (barrier.aliases) batch_.memory(before, after);
    // Behind readers, an execution dependency is enough by the specification: the barrier before them made
    // the write available. Validation follows that chain by accesses, also where a shader reads nothing of
    // what its pass declares.
    if (!barrier.writeBefore) before = accessOf(barrier.usesBefore);
    if (plan_.resources[barrier.resource].isBuffer) {
        batch_.buffer(resources_.buffer(barrier.resource), before, after);
        return;
    }
    const gpu::Image& image = resources_.image(barrier.resource);
    const VkImageSubresourceRange range{image.aspect(), barrier.range.baseMip, barrier.range.mips,
                                        barrier.range.baseLayer, barrier.range.layers};
    batch_.image(image, range, before, after, vulkanLayout(barrier.oldLayout),
                 vulkanLayout(barrier.newLayout));
}

void FrameRecorder::clears(const PlannedPass& pass) {
    const graph::PassType& type = plan_.typeOf(pass);
    for (Index port = 0; port < pass.outputs.count; ++port) {
        if (!graph::isCleared(plan_, pass, port)) continue;
        const Index index = plan_.outputs[pass.outputs.first + port];
        const Resource& resource = plan_.resources[index];
        if (resource.isBuffer)
            clearBuffer(commands_, resources_.buffer(index));
        else
            clearImage(commands_, resources_.image(index), type, type.outputs[port], resource.format);
    }
}

void FrameRecorder::bind(const PassBindings& bindings) {
    const gpu::Pipeline& pipeline = bindings.program().pipeline;
    vkCmdBindPipeline(commands_, pipeline.bindPoint(), pipeline.handle());
    bindSets(bindings, 0);
}

void FrameRecorder::bindSets(const PassBindings& bindings, std::uint32_t iteration) {
    const Program& program = bindings.program();
    const std::array sets{scene_.descriptorSet(slot_), bindings.set(slot_, iteration)};
    vkCmdBindDescriptorSets(commands_, program.pipeline.bindPoint(), program.layout.handle(), 0,
                            static_cast<std::uint32_t>(sets.size()), sets.data(), 0, nullptr);
}

void FrameRecorder::push(const PassBindings& bindings, std::uint32_t iteration, graph::Extent extent,
                         std::uint32_t layer) {
    const std::array<std::uint32_t, 4> values{iteration, extent.width, extent.height, layer};
    const gpu::PipelineLayout& layout = bindings.program().layout;
    vkCmdPushConstants(commands_, layout.handle(), layout.pushStages(), 0, sizeof(values), values.data());
}

void FrameRecorder::compute(const PlannedPass& pass, const PassBindings& bindings, Index batch) {
    const bool overMips = pass.forEach == graph::ForEach::Mips;
    for (std::uint32_t iteration = 0; iteration < pass.iterations; ++iteration) {
        if (iteration == 0 || overMips) barriers(batch + iteration);
        if (iteration > 0 && bindings.differsByIteration()) bindSets(bindings, iteration);
        dispatch(pass, bindings, iteration);
    }
}

void FrameRecorder::dispatch(const PlannedPass& pass, const PassBindings& bindings, std::uint32_t iteration) {
    if (pass.tileList != graph::noIndex) {
        const std::uint32_t layer = tileLayer(plan_, pass, iteration);
        push(bindings, iteration, pass.extent, layer);
        vkCmdDispatchIndirect(commands_, resources_.buffer(pass.tileList).handle(), VkDeviceSize{16} * layer);
        return;
    }
    const bool overMips = pass.forEach == graph::ForEach::Mips;
    const graph::Extent extent = overMips ? levelOf(pass.extent, iteration) : pass.extent;
    push(bindings, iteration, extent);
    const bool linear = pass.outputs.count > 0 && plan_.resources[plan_.outputs[pass.outputs.first]].isBuffer;
    if (linear)
        dispatchLinear(commands_, groups(extent.width, 64));
    else
        vkCmdDispatch(commands_, groups(extent.width, 8), groups(extent.height, 8), 1);
}

void FrameRecorder::raster(Index index, const PassBindings& bindings) {
    const PlannedPass& pass = plan_.passes[index];
    const VkViewport viewport{
        0, 0, static_cast<float>(pass.extent.width), static_cast<float>(pass.extent.height), 0, 1};
    const VkRect2D scissor{{0, 0}, {pass.extent.width, pass.extent.height}};
    vkCmdSetViewport(commands_, 0, 1, &viewport);
    vkCmdSetScissor(commands_, 0, 1, &scissor);
    for (std::uint32_t iteration = 0; iteration < pass.iterations; ++iteration)
        drawIteration(index, bindings, iteration);
}

/// Fills colors_ and depth_: what is modified is loaded, the rest starts neutral.
void FrameRecorder::attachments(Index index, std::uint32_t iteration) {
    const PlannedPass& pass = plan_.passes[index];
    const graph::PassType& type = plan_.typeOf(pass);
    colors_.clear();
    depth_ = {};
    for (Index port = 0; port < pass.outputs.count; ++port) {
        const Index output = plan_.outputs[pass.outputs.first + port];
        const Resource& resource = plan_.resources[output];
        if (resource.isBuffer) continue;
        const graph::InputRead* modified = modifiedBy(plan_, pass, port);
        const bool part = modified != nullptr && modified->layer != graph::every;
        const std::uint32_t layer = part ? modified->layer : iteration * resource.layersPerIteration;
        const std::uint32_t mip = modified != nullptr && modified->mip != graph::every ? modified->mip : 0;
        VkRenderingAttachmentInfo attachment{};
        attachment.sType = VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO;
        attachment.imageView = resources_.image(output).view(mip, 1, layer, 1, false);
        attachment.loadOp = modified != nullptr ? VK_ATTACHMENT_LOAD_OP_LOAD : VK_ATTACHMENT_LOAD_OP_CLEAR;
        attachment.storeOp =
            isReadLater(resource, index) ? VK_ATTACHMENT_STORE_OP_STORE : VK_ATTACHMENT_STORE_OP_DONT_CARE;
        if (graph::info(resource.format).isDepth) {
            attachment.imageLayout = VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL;
            attachment.clearValue.depthStencil.depth = neutralDepth(type);
            depth_ = attachment;
        } else {
            attachment.imageLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
            attachment.clearValue.color = neutralColor(type.outputs[port], resource.format);
            colors_.push_back(attachment);
        }
    }
}

void FrameRecorder::drawIteration(Index index, const PassBindings& bindings, std::uint32_t iteration) {
    const PlannedPass& pass = plan_.passes[index];
    attachments(index, iteration);
    VkRenderingInfo rendering{};
    rendering.sType = VK_STRUCTURE_TYPE_RENDERING_INFO;
    rendering.renderArea = {{0, 0}, {pass.extent.width, pass.extent.height}};
    rendering.layerCount = 1;
    rendering.colorAttachmentCount = static_cast<std::uint32_t>(colors_.size());
    rendering.pColorAttachments = colors_.data();
    rendering.pDepthAttachment = depth_.imageView != VK_NULL_HANDLE ? &depth_ : nullptr;
    vkCmdBeginRendering(commands_, &rendering);
    push(bindings, iteration, pass.extent);
    scene_.draw(commands_, slot_);
    vkCmdEndRendering(commands_);
}

}  // namespace nephrite::runtime
