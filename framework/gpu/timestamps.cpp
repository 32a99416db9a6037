// Timestamp queries and their conversion to milliseconds.
#include "gpu/timestamps.h"

#include <limits>

#include "gpu/result.h"

namespace nephrite::gpu {

std::vector<double> ticksToMilliseconds(std::span<const std::uint64_t> ticks, std::uint32_t validBits,
                                        double periodNs) {
    const std::uint64_t mask =
        validBits >= 64 ? std::numeric_limits<std::uint64_t>::max() : (std::uint64_t{1} << validBits) - 1;
    std::vector<double> milliseconds;
    milliseconds.reserve(ticks.size());
    for (const std::uint64_t tick : ticks)
        milliseconds.push_back(static_cast<double>((tick - ticks.front()) & mask) * periodNs * 1e-6);
    return milliseconds;
}

Timestamps::Timestamps(const Device& device, std::uint32_t count) : device_(&device), count_(count) {
    if (device.timestampValidBits() == 0 || count == 0) return;
    VkQueryPoolCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO;
    info.queryType = VK_QUERY_TYPE_TIMESTAMP;
    info.queryCount = count;
    VkQueryPool pool = VK_NULL_HANDLE;
    check(vkCreateQueryPool(device.handle(), &info, nullptr, &pool), "cannot create timestamp queries");
    pool_ = {device.handle(), pool};
}

void Timestamps::reset(VkCommandBuffer commands) const {
    if (supported()) vkCmdResetQueryPool(commands, pool_.get(), 0, count_);
}

void Timestamps::write(VkCommandBuffer commands, std::uint32_t index, VkPipelineStageFlags2 stage) const {
    if (supported()) vkCmdWriteTimestamp2(commands, stage, pool_.get(), index);
}

std::vector<double> Timestamps::milliseconds(std::uint32_t count) const {
    if (!supported() || count == 0) return std::vector<double>(count, 0.0);
    std::vector<std::uint64_t> ticks(count);
    device_->check(
        vkGetQueryPoolResults(device_->handle(), pool_.get(), 0, count, ticks.size() * sizeof(std::uint64_t),
                              ticks.data(), sizeof(std::uint64_t), VK_QUERY_RESULT_64_BIT),
        "cannot read timestamps");
    return ticksToMilliseconds(ticks, device_->timestampValidBits(), device_->timestampPeriodNs());
}

}  // namespace nephrite::gpu
