// Pipeline statistics queries and their results.
#include "gpu/pipeline_statistics.h"

#include <array>

namespace nephrite::gpu {
namespace {

constexpr VkQueryPipelineStatisticFlags drawStatistics =
    VK_QUERY_PIPELINE_STATISTIC_VERTEX_SHADER_INVOCATIONS_BIT |
    VK_QUERY_PIPELINE_STATISTIC_CLIPPING_INVOCATIONS_BIT |
    VK_QUERY_PIPELINE_STATISTIC_FRAGMENT_SHADER_INVOCATIONS_BIT;
constexpr VkQueryPipelineStatisticFlags dispatchStatistics =
    VK_QUERY_PIPELINE_STATISTIC_COMPUTE_SHADER_INVOCATIONS_BIT;

Handle<VkQueryPool, vkDestroyQueryPool> makePool(const Device& device, std::uint32_t count,
                                                 VkQueryPipelineStatisticFlags statistics) {
    VkQueryPoolCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO;
    info.queryType = VK_QUERY_TYPE_PIPELINE_STATISTICS;
    info.queryCount = count;
    info.pipelineStatistics = statistics;
    VkQueryPool pool = VK_NULL_HANDLE;
    device.check(vkCreateQueryPool(device.handle(), &info, nullptr, &pool),
                 "cannot create pipeline statistics queries");
    return {device.handle(), pool};
}

/// The counts of one query, in the order of their bits.
template<std::size_t Count>
std::array<std::uint64_t, Count> readQuery(const Device& device, VkQueryPool pool, std::uint32_t index) {
    std::array<std::uint64_t, Count> values{};
    device.check(vkGetQueryPoolResults(device.handle(), pool, index, 1, sizeof(values), values.data(),
                                       sizeof(values), VK_QUERY_RESULT_64_BIT),
                 "cannot read pipeline statistics");
    return values;
}

}  // namespace

PipelineStatistics::PipelineStatistics(const Device& device, std::uint32_t count)
    : device_(&device), count_(count) {
    if (!device.features().pipelineStatistics || count == 0) return;
    draws_ = makePool(device, count, drawStatistics);
    dispatches_ = makePool(device, count, dispatchStatistics);
}

void PipelineStatistics::reset(VkCommandBuffer commands) const {
    if (!draws_) return;
    vkCmdResetQueryPool(commands, draws_.get(), 0, count_);
    vkCmdResetQueryPool(commands, dispatches_.get(), 0, count_);
}

void PipelineStatistics::begin(VkCommandBuffer commands, std::uint32_t index,
                               VkPipelineBindPoint bindPoint) const {
    if (pool(bindPoint)) vkCmdBeginQuery(commands, pool(bindPoint).get(), index, 0);
}

void PipelineStatistics::end(VkCommandBuffer commands, std::uint32_t index,
                             VkPipelineBindPoint bindPoint) const {
    if (pool(bindPoint)) vkCmdEndQuery(commands, pool(bindPoint).get(), index);
}

std::optional<PipelineCounts> PipelineStatistics::counts(std::uint32_t index,
                                                         VkPipelineBindPoint bindPoint) const {
    if (!pool(bindPoint)) return std::nullopt;
    PipelineCounts counts;
    if (bindPoint == VK_PIPELINE_BIND_POINT_COMPUTE) {
        counts.computeInvocations = readQuery<1>(*device_, dispatches_.get(), index)[0];
        return counts;
    }
    const auto values = readQuery<3>(*device_, draws_.get(), index);
    counts.vertexInvocations = values[0];
    counts.clippingInvocations = values[1];
    counts.fragmentInvocations = values[2];
    return counts;
}

}  // namespace nephrite::gpu
