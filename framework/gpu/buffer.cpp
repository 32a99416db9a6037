// Making buffers and moving bytes into and out of them.
#include "gpu/buffer.h"

#include <fmt/format.h>

#include <algorithm>

#include "gpu/barriers.h"
#include "gpu/commands.h"
#include "gpu/result.h"
#include "text/diagnostics.h"

namespace nephrite::gpu {
namespace {

std::string describe(const BufferDescription& description) {
    return description.name.empty() ? fmt::format("a buffer of {} bytes", description.size)
                                    : fmt::format("the buffer {}", description.name);
}

/// Throws RunError if the description is empty or beyond what the device allows.
void requireUsable(const Device& device, const BufferDescription& description) {
    if (description.size == 0)
        throw RunError(fmt::format("{} needs at least one byte", describe(description)));
    const auto refuseAbove = [&](VkBufferUsageFlags usage, std::uint32_t limit, std::string_view kind) {
        if ((description.usage & usage) == 0 || description.size <= limit) return;
        throw RunError(fmt::format("{} has {} bytes, more than the {} this device allows a {} buffer",
                                   describe(description), description.size, limit, kind));
    };
    refuseAbove(VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, device.limits().maxStorageBufferRange, "storage");
    refuseAbove(VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT, device.limits().maxUniformBufferRange, "uniform");
}

VkBufferCreateInfo createInfo(const BufferDescription& description) {
    VkBufferCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO;
    info.size = description.size;
    info.usage = description.usage;
    if (description.residence == Residence::Device)
        info.usage |= VK_BUFFER_USAGE_TRANSFER_DST_BIT | VK_BUFFER_USAGE_TRANSFER_SRC_BIT;
    info.sharingMode = VK_SHARING_MODE_EXCLUSIVE;
    return info;
}

void recordCopy(VkCommandBuffer commands, const Buffer& from, const Buffer& to, VkDeviceSize bytes,
                VkDeviceSize toOffset) {
    VkBufferCopy region{};
    region.dstOffset = toOffset;
    region.size = bytes;
    vkCmdCopyBuffer(commands, from.handle(), to.handle(), 1, &region);
}

}  // namespace

MemoryNeeds memoryNeeds(const Device& device, const BufferDescription& description) {
    requireUsable(device, description);
    const VkBufferCreateInfo info = createInfo(description);
    VkDeviceBufferMemoryRequirements request{};
    request.sType = VK_STRUCTURE_TYPE_DEVICE_BUFFER_MEMORY_REQUIREMENTS;
    request.pCreateInfo = &info;
    NeedsQuery query;
    vkGetDeviceBufferMemoryRequirements(device.handle(), &request, query.chain());
    return query.answer(device);
}

Buffer::Buffer(const Device& device, const BufferDescription& description) : size_(description.size) {
    create(device, description);
    VkMemoryRequirements requirements{};
    vkGetBufferMemoryRequirements(device.handle(), handle(), &requirements);
    VkMemoryDedicatedAllocateInfo dedicated{};
    dedicated.sType = VK_STRUCTURE_TYPE_MEMORY_DEDICATED_ALLOCATE_INFO;
    dedicated.buffer = handle();
    memory_ = Memory(device, requirements, description.residence, &dedicated, describe(description));
    check(vkBindBufferMemory(device.handle(), handle(), memory_.handle(), 0),
          "cannot bind a buffer's memory");
}

Buffer::Buffer(const Device& device, const BufferDescription& description, const Memory& memory,
               VkDeviceSize offset)
    : size_(description.size) {
    create(device, description);
    check(vkBindBufferMemory(device.handle(), handle(), memory.handle(), offset),
          fmt::format("cannot bind {} to shared memory", describe(description)));
}

void Buffer::create(const Device& device, const BufferDescription& description) {
    requireUsable(device, description);
    const VkBufferCreateInfo info = createInfo(description);
    VkBuffer buffer = VK_NULL_HANDLE;
    check(vkCreateBuffer(device.handle(), &info, nullptr, &buffer),
          fmt::format("cannot create {}", describe(description)));
    buffer_ = {device.handle(), buffer};
    device.setName(VK_OBJECT_TYPE_BUFFER, buffer, description.name);
}

void upload(const Device& device, const Buffer& buffer, std::span<const std::byte> bytes,
            VkDeviceSize offset) {
    if (offset + bytes.size() > buffer.size()) {
        throw RunError(fmt::format("{} bytes at {} do not fit into a buffer of {}", bytes.size(), offset,
                                   buffer.size()));
    }
    if (bytes.empty()) return;
    if (!buffer.mapped().empty()) {
        std::copy(bytes.begin(), bytes.end(), buffer.mapped().begin() + static_cast<std::ptrdiff_t>(offset));
        return;
    }
    const Buffer staging(device,
                         {bytes.size(), VK_BUFFER_USAGE_TRANSFER_SRC_BIT, Residence::Upload, "staging"});
    std::copy(bytes.begin(), bytes.end(), staging.mapped().begin());
    runCommands(device, [&](VkCommandBuffer commands) {
        recordCopy(commands, staging, buffer, bytes.size(), offset);
        BarrierBatch()
            .memory({VK_PIPELINE_STAGE_2_COPY_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT},
                    {VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT,
                     VK_ACCESS_2_MEMORY_READ_BIT | VK_ACCESS_2_MEMORY_WRITE_BIT})
            .record(commands);
    });
}

std::vector<std::byte> download(const Device& device, const Buffer& buffer) {
    if (!buffer.mapped().empty()) return {buffer.mapped().begin(), buffer.mapped().end()};
    const Buffer staging(device,
                         {buffer.size(), VK_BUFFER_USAGE_TRANSFER_DST_BIT, Residence::Readback, "readback"});
    runCommands(device, [&](VkCommandBuffer commands) {
        BarrierBatch()
            .memory({VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, VK_ACCESS_2_MEMORY_WRITE_BIT},
                    {VK_PIPELINE_STAGE_2_COPY_BIT, VK_ACCESS_2_TRANSFER_READ_BIT})
            .record(commands);
        recordCopy(commands, buffer, staging, buffer.size(), 0);
        BarrierBatch()
            .memory({VK_PIPELINE_STAGE_2_COPY_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT},
                    {VK_PIPELINE_STAGE_2_HOST_BIT, VK_ACCESS_2_HOST_READ_BIT})
            .record(commands);
    });
    return {staging.mapped().begin(), staging.mapped().end()};
}

}  // namespace nephrite::gpu
