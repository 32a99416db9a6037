// Making rings of history, neutral at first.
#include "runtime/resources/history.h"

#include <fmt/format.h>

#include <algorithm>

#include "gpu/barriers.h"
#include "gpu/commands.h"
#include "runtime/resources/resource_descriptions.h"
#include "runtime/resources/vulkan_names.h"

namespace nephrite::runtime {
namespace {

constexpr gpu::Access anything{VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT,
                               VK_ACCESS_2_MEMORY_READ_BIT | VK_ACCESS_2_MEMORY_WRITE_BIT};
constexpr gpu::Access clearing{VK_PIPELINE_STAGE_2_CLEAR_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT};

void clearImages(VkCommandBuffer commands, const HistoryRing& ring, const graph::Resource& resource,
                 const graph::PassType& type) {
    const VkImageLayout cleared = VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL;
    gpu::BarrierBatch before;
    gpu::BarrierBatch after;
    for (const gpu::Image& image : ring.images) {
        before.image(image, {}, clearing, VK_IMAGE_LAYOUT_UNDEFINED, cleared);
        after.image(image, clearing, anything, cleared, vulkanLayout(resource.initial));
    }
    before.record(commands);
    for (const gpu::Image& image : ring.images)
        clearImage(commands, image, type, type.outputs[resource.port], resource.format);
    after.record(commands);
}

void makeNeutral(const gpu::Device& device, const HistoryRing& ring, const graph::Resource& resource,
                 const graph::PassType& type) {
    gpu::runCommands(device, [&](VkCommandBuffer commands) {
        clearImages(commands, ring, resource, type);
        for (const gpu::Buffer& buffer : ring.buffers) clearBuffer(commands, buffer);
        gpu::fullBarrier(commands);
    });
}

constexpr gpu::Access copying{VK_PIPELINE_STAGE_2_COPY_BIT,
                              VK_ACCESS_2_TRANSFER_READ_BIT | VK_ACCESS_2_TRANSFER_WRITE_BIT};

void copyImage(VkCommandBuffer commands, const gpu::Image& from, const gpu::Image& to) {
    std::vector<VkImageCopy> regions;
    for (std::uint32_t mip = 0; mip < from.description().mips; ++mip) {
        const VkImageSubresourceLayers part{from.aspect(), mip, 0, from.description().layers};
        const VkExtent2D extent = from.extent(mip);
        regions.push_back({part, {}, part, {}, {extent.width, extent.height, 1}});
    }
    vkCmdCopyImage(commands, from.handle(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, to.handle(),
                   VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, static_cast<std::uint32_t>(regions.size()),
                   regions.data());
}

void copyBuffer(VkCommandBuffer commands, const gpu::Buffer& from, const gpu::Buffer& to) {
    const VkBufferCopy whole{0, 0, from.size()};
    vkCmdCopyBuffer(commands, from.handle(), to.handle(), 1, &whole);
}

/// The frames that both rings have; `from` stays as it is.
void copyFrames(const gpu::Device& device, const HistoryRing& from, graph::Layout fromLayout,
                const HistoryRing& to, graph::Layout toLayout) {
    const VkImageLayout source = VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL;
    const VkImageLayout target = VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL;
    gpu::BarrierBatch before;
    gpu::BarrierBatch after;
    const std::uint32_t frames = std::min(from.length(), to.length());
    for (std::uint32_t back = 0; back < frames && !from.images.empty(); ++back) {
        const gpu::Image& old = from.images[from.at(back)];
        const gpu::Image& image = to.images[to.at(back)];
        before.image(old, anything, copying, vulkanLayout(fromLayout), source);
        before.image(image, anything, copying, vulkanLayout(toLayout), target);
        after.image(old, copying, anything, source, vulkanLayout(fromLayout));
        after.image(image, copying, anything, target, vulkanLayout(toLayout));
    }
    gpu::runCommands(device, [&](VkCommandBuffer commands) {
        gpu::fullBarrier(commands);
        before.record(commands);
        for (std::uint32_t back = 0; back < frames; ++back) {
            if (from.images.empty())
                copyBuffer(commands, from.buffers[from.at(back)], to.buffers[to.at(back)]);
            else
                copyImage(commands, from.images[from.at(back)], to.images[to.at(back)]);
        }
        after.record(commands);
        gpu::fullBarrier(commands);
    });
}

std::shared_ptr<HistoryRing> makeRing(const gpu::Device& device, const graph::Plan& plan,
                                      const graph::Resource& resource, const std::string& name,
                                      std::uint32_t length) {
    auto ring = std::make_shared<HistoryRing>();
    for (std::uint32_t frame = 0; frame < length; ++frame) {
        if (resource.isBuffer)
            ring->buffers.emplace_back(device, bufferDescription(bufferBytes(plan, resource), name));
        else
            ring->images.emplace_back(device, imageDescription(resource, plan.inputReads, name));
    }
    makeNeutral(device, *ring, resource, *plan.graph->nodes[resource.node].type);
    return ring;
}

}  // namespace

FoundRing HistoryStore::ring(const gpu::Device& device, const graph::Plan& plan, graph::Index index,
                             std::uint32_t length, std::uint32_t uses) {
    graph::Resource resource = plan.resources[index];
    resource.uses = uses | graph::bit(graph::Use::Clear) | graph::bit(graph::Use::Copy);
    const std::string name = plan.graph->portName(resource.node, resource.port);
    const std::string key =
        fmt::format("{} {}x{} {} levels {} layers {} bytes {}", name, resource.extent.width,
                    resource.extent.height, resource.isBuffer ? "buffer" : graph::info(resource.format).name,
                    resource.mips, resource.layers, resource.isBuffer ? bufferBytes(plan, resource) : 0);
    const auto [first, end] = rings_.equal_range(key);
    const auto serving = std::find_if(first, end, [&](const auto& entry) {
        const Entry& known = entry.second;
        return known.ring->length() == length && known.resource.uses == resource.uses &&
               known.resource.initial == resource.initial;
    });
    if (serving != end) return {serving->second.ring, true};
    auto ring = makeRing(device, plan, resource, name, length);
    const bool inherits = first != end;
    if (inherits)
        copyFrames(device, *first->second.ring, first->second.resource.initial, *ring, resource.initial);
    rings_.emplace(key, Entry{resource, ring});
    return {ring, inherits};
}

void HistoryStore::dropUnused() {
    std::erase_if(rings_, [](const auto& entry) { return entry.second.ring.use_count() <= 1; });
}

}  // namespace nephrite::runtime
