// Making rings of history, neutral at first.
#include "runtime/history.h"

#include <fmt/format.h>

#include "gpu/barriers.h"
#include "gpu/commands.h"
#include "runtime/resource_descriptions.h"
#include "runtime/vulkan_names.h"

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

}  // namespace

std::shared_ptr<HistoryRing> HistoryStore::ring(const gpu::Device& device, const graph::Plan& plan,
                                                graph::Index index, std::uint32_t length,
                                                std::uint32_t uses) {
    graph::Resource resource = plan.resources[index];
    resource.uses = uses | graph::bit(graph::Use::Clear);
    const std::string name = plan.graph->portName(resource.node, resource.port);
    const std::string key = fmt::format(
        "{} {}x{} {} {} levels {} layers {} bytes uses {:x} layout {} length {}", name, resource.extent.width,
        resource.extent.height, resource.isBuffer ? "buffer" : graph::info(resource.format).name,
        resource.mips, resource.layers, resource.isBuffer ? bufferBytes(plan, resource) : 0, resource.uses,
        static_cast<int>(resource.initial), length);
    std::shared_ptr<HistoryRing>& kept = rings_[key];
    if (kept) return kept;
    auto ring = std::make_shared<HistoryRing>();
    for (std::uint32_t frame = 0; frame < length; ++frame) {
        if (resource.isBuffer)
            ring->buffers.emplace_back(device, bufferDescription(bufferBytes(plan, resource), name));
        else
            ring->images.emplace_back(device, imageDescription(resource, plan.inputReads, name));
    }
    makeNeutral(device, *ring, resource, *plan.graph->nodes[resource.node].type);
    return kept = std::move(ring);
}

void HistoryStore::dropUnused() {
    std::erase_if(rings_, [](const auto& entry) { return entry.second.use_count() <= 1; });
}

}  // namespace nephrite::runtime
