// Recording and submitting the frames of a plan.
#include "runtime/executor.h"

#include <algorithm>
#include <array>
#include <chrono>

#include "gpu/barriers.h"
#include "runtime/vulkan_names.h"

namespace nephrite::runtime {
namespace {

using Clock = std::chrono::steady_clock;

double millisecondsSince(Clock::time_point start) {
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

std::uint32_t groups(std::uint32_t count, std::uint32_t size) {
    return (count + size - 1) / size;
}

/// As many groups in rows of what every device allows in one direction; the generated main() counts them
/// through.
void dispatchLinear(VkCommandBuffer commands, std::uint32_t count) {
    constexpr std::uint32_t longestRow = 65535;
    vkCmdDispatch(commands, std::min(count, longestRow), groups(count, longestRow), 1);
}

VkClearColorValue clearColor(const std::array<double, 4>& neutral, bool isUnsignedInteger) {
    VkClearColorValue value{};
    for (std::size_t i = 0; i < 4; ++i) {
        if (isUnsignedInteger)
            value.uint32[i] = static_cast<std::uint32_t>(std::max(neutral[i], 0.0));
        else
            value.float32[i] = static_cast<float>(neutral[i]);
    }
    return value;
}

/// What empty space is in the depth image: beyond everything, seen from where the kept surface is.
float clearDepth(const graph::PassType& type) {
    return type.raster.keep == graph::RasterState::Keep::Farthest ? 0.0F : 1.0F;
}

/// True if something after the pass itself looks at the resource.
bool isReadLater(const graph::Resource& resource) {
    const std::uint32_t written = 1U << static_cast<std::uint32_t>(graph::Use::ColorAttachment) |
                                  1U << static_cast<std::uint32_t>(graph::Use::DepthAttachment);
    return (resource.uses & ~written) != 0;
}

VkRenderingAttachmentInfo emptyAttachment() {
    VkRenderingAttachmentInfo attachment{};
    attachment.sType = VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO;
    return attachment;
}

}  // namespace

Executor::Executor(const ProgramContext& context, const graph::Plan& plan, scene::GpuScene& scene,
                   bool profile)
    : device_(context.device),
      plan_(plan),
      scene_(scene),
      profile_(profile),
      resources_(context.device, plan),
      commands_(context.device),
      timestamps_(context.device, static_cast<std::uint32_t>(plan.passes.size() + 1)),
      recordMs_(plan.passes.size()) {
    for (const graph::PlannedPass& pass : plan.passes)
        programs_.push_back(
            pass.iterations == 0 ? nullptr : std::make_unique<PassProgram>(context, plan, pass, resources_));
}

FrameTimes Executor::renderFrame(double time) {
    FrameTimes times;
    const Clock::time_point start = Clock::now();
    scene_.update(time, plan_.view.width, plan_.view.height);
    record();
    times.recordMs = millisecondsSince(start);
    commands_.submit();
    commands_.wait();
    times.wallMs = millisecondsSince(start);

    const std::vector<double> stamps =
        timestamps_.milliseconds(static_cast<std::uint32_t>(plan_.passes.size() + 1));
    times.waitMs = times.wallMs - times.recordMs - stamps.back();
    for (std::size_t i = 0; i < plan_.passes.size(); ++i)
        times.passes.push_back({stamps[i + 1] - stamps[i], recordMs_[i]});
    return times;
}

void Executor::record() {
    commands_.begin();
    timestamps_.reset(commands_.handle());
    writeTimestamp(0);
    for (std::size_t i = 0; i < plan_.passes.size(); ++i) {
        const Clock::time_point start = Clock::now();
        recordBarriers(plan_.passes[i].barriers);
        recordPass(i);
        writeTimestamp(i + 1);
        recordMs_[i] = millisecondsSince(start);
    }
    recordBarriers(plan_.finalBarriers);
    commands_.end();
}

void Executor::writeTimestamp(std::size_t index) {
    timestamps_.write(commands_.handle(), static_cast<std::uint32_t>(index));
    // Without a barrier behind the timestamp a software driver books a draw's cost on a later pass.
    if (profile_) gpu::fullBarrier(commands_.handle());
}

void Executor::recordBarriers(graph::Range range) {
    gpu::BarrierBatch batch;
    for (const graph::Barrier& barrier : graph::slice(plan_.barriers, range)) {
        gpu::Access before = writesOf(barrier.usesBefore);
        if (!barrier.writeBefore) before.access = VK_ACCESS_2_NONE;
        const gpu::Access after = accessOf(barrier.usesAfter);
        if (plan_.resources[barrier.resource].isBuffer) {
            batch.buffer(resources_.buffer(barrier.resource), before, after);
            continue;
        }
        const gpu::Image& image = resources_.image(barrier.resource);
        const VkImageSubresourceRange subresources{image.aspect(), barrier.baseMip, barrier.mips,
                                                   barrier.baseLayer, barrier.layers};
        batch.image(image, subresources, before, after, vulkanLayout(barrier.oldLayout),
                    vulkanLayout(barrier.newLayout));
    }
    batch.record(commands_.handle());
}

void Executor::recordPass(std::size_t index) {
    const graph::PlannedPass& pass = plan_.passes[index];
    if (pass.iterations == 0) return recordClears(pass);
    const PassProgram& program = *programs_[index];
    if (plan_.typeOf(pass).kind == graph::PassKind::Raster) return recordRaster(pass, program);
    recordCompute(pass, program);
}

void Executor::recordClears(const graph::PlannedPass& pass) {
    for (const graph::Index index : graph::slice(plan_.outputs, pass.outputs)) {
        const graph::Resource& resource = plan_.resources[index];
        if (resource.isBuffer) {
            vkCmdFillBuffer(commands_.handle(), resources_.buffer(index).handle(), 0, VK_WHOLE_SIZE, 0);
            continue;
        }
        const gpu::Image& image = resources_.image(index);
        const VkImageSubresourceRange range = image.wholeRange();
        const VkImageLayout layout = VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL;
        if (graph::info(resource.format).isDepth) {
            const VkClearDepthStencilValue value{clearDepth(plan_.typeOf(pass)), 0};
            vkCmdClearDepthStencilImage(commands_.handle(), image.handle(), layout, &value, 1, &range);
            continue;
        }
        const auto& neutral = plan_.typeOf(pass).outputs[resource.port].neutral;
        const VkClearColorValue value = clearColor(neutral, graph::info(resource.format).isUnsignedInteger);
        vkCmdClearColorImage(commands_.handle(), image.handle(), layout, &value, 1, &range);
    }
}

void Executor::bind(const PassProgram& program) {
    const VkPipelineBindPoint point = program.pipeline().bindPoint();
    vkCmdBindPipeline(commands_.handle(), point, program.pipeline().handle());
    const std::array sets{scene_.descriptorSet(), program.descriptorSet()};
    vkCmdBindDescriptorSets(commands_.handle(), point, program.layout(), 0,
                            static_cast<std::uint32_t>(sets.size()), sets.data(), 0, nullptr);
}

void Executor::push(const graph::PlannedPass& pass, const PassProgram& program, std::uint32_t iteration) {
    const std::array<std::uint32_t, 4> values{iteration, pass.extent.width, pass.extent.height, 0};
    vkCmdPushConstants(commands_.handle(), program.layout(), gpu::pushConstantStages, 0, sizeof(values),
                       values.data());
}

void Executor::recordCompute(const graph::PlannedPass& pass, const PassProgram& program) {
    bind(program);
    const bool linear = plan_.resources[plan_.outputs[pass.outputs.first]].isBuffer;
    for (std::uint32_t iteration = 0; iteration < pass.iterations; ++iteration) {
        push(pass, program, iteration);
        if (linear)
            dispatchLinear(commands_.handle(), groups(pass.extent.width, 64));
        else
            vkCmdDispatch(commands_.handle(), groups(pass.extent.width, 8), groups(pass.extent.height, 8), 1);
    }
}

void Executor::recordRaster(const graph::PlannedPass& pass, const PassProgram& program) {
    bind(program);
    const VkViewport viewport{
        0, 0, static_cast<float>(pass.extent.width), static_cast<float>(pass.extent.height), 0, 1};
    const VkRect2D scissor{{0, 0}, {pass.extent.width, pass.extent.height}};
    vkCmdSetViewport(commands_.handle(), 0, 1, &viewport);
    vkCmdSetScissor(commands_.handle(), 0, 1, &scissor);
    for (std::uint32_t iteration = 0; iteration < pass.iterations; ++iteration)
        recordRasterIteration(pass, program, iteration);
}

void Executor::recordRasterIteration(const graph::PlannedPass& pass, const PassProgram& program,
                                     std::uint32_t iteration) {
    std::vector<VkRenderingAttachmentInfo> colors;
    VkRenderingAttachmentInfo depth = emptyAttachment();
    for (const graph::Index index : graph::slice(plan_.outputs, pass.outputs)) {
        const graph::Resource& resource = plan_.resources[index];
        if (resource.isBuffer) continue;
        const graph::FormatInfo& format = graph::info(resource.format);
        VkRenderingAttachmentInfo attachment = emptyAttachment();
        attachment.imageView =
            resources_.image(index).view(0, 1, iteration * resource.layersPerIteration, 1, false);
        attachment.loadOp = VK_ATTACHMENT_LOAD_OP_CLEAR;
        attachment.storeOp =
            isReadLater(resource) ? VK_ATTACHMENT_STORE_OP_STORE : VK_ATTACHMENT_STORE_OP_DONT_CARE;
        if (format.isDepth) {
            attachment.imageLayout = VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL;
            attachment.clearValue.depthStencil.depth = clearDepth(plan_.typeOf(pass));
            depth = attachment;
        } else {
            attachment.imageLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
            attachment.clearValue.color =
                clearColor(plan_.typeOf(pass).outputs[resource.port].neutral, format.isUnsignedInteger);
            colors.push_back(attachment);
        }
    }
    VkRenderingInfo rendering{};
    rendering.sType = VK_STRUCTURE_TYPE_RENDERING_INFO;
    rendering.renderArea = {{0, 0}, {pass.extent.width, pass.extent.height}};
    rendering.layerCount = 1;
    rendering.colorAttachmentCount = static_cast<std::uint32_t>(colors.size());
    rendering.pColorAttachments = colors.data();
    rendering.pDepthAttachment = depth.imageView != VK_NULL_HANDLE ? &depth : nullptr;
    vkCmdBeginRendering(commands_.handle(), &rendering);
    push(pass, program, iteration);
    scene_.draw(commands_.handle());
    vkCmdEndRendering(commands_.handle());
}

}  // namespace nephrite::runtime
