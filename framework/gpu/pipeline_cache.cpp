// Loading, merging and saving the driver's pipeline cache.
#include <fmt/format.h>

#include "gpu/pipeline.h"
#include "gpu/result.h"
#include "text/diagnostics.h"

namespace nephrite::gpu {
namespace {

constexpr std::string_view cacheKind = "pipelines";

/// One key for each device and driver build.
std::string keyOf(const VkPhysicalDeviceProperties& properties) {
    std::string key = fmt::format("vendor {:x} device {:x} driver {:x} cache ", properties.vendorID,
                                  properties.deviceID, properties.driverVersion);
    for (const std::uint8_t byte : properties.pipelineCacheUUID) key += fmt::format("{:02x}", byte);
    return key;
}

Handle<VkPipelineCache, vkDestroyPipelineCache> createCache(const Device& device,
                                                            std::span<const std::byte> data) {
    VkPipelineCacheCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_PIPELINE_CACHE_CREATE_INFO;
    info.initialDataSize = data.size();
    info.pInitialData = data.data();
    VkPipelineCache cache = VK_NULL_HANDLE;
    check(vkCreatePipelineCache(device.handle(), &info, nullptr, &cache), "cannot create a pipeline cache");
    return {device.handle(), cache};
}

std::vector<std::byte> dataOf(const Device& device, VkPipelineCache cache) {
    std::size_t size = 0;
    check(vkGetPipelineCacheData(device.handle(), cache, &size, nullptr), "cannot read the pipeline cache");
    std::vector<std::byte> data(size);
    check(vkGetPipelineCacheData(device.handle(), cache, &size, data.data()),
          "cannot read the pipeline cache");
    data.resize(size);
    return data;
}

}  // namespace

PipelineCache::PipelineCache(const Device& device, DiskCache disk)
    : device_(device), disk_(std::move(disk)), key_(keyOf(device.properties())) {
    if (auto found = disk_.read(cacheKind, key_)) original_ = std::move(*found);
    cache_ = createCache(device, original_);
}

PipelineCache::~PipelineCache() {
    save();
}

void PipelineCache::save() noexcept {
    try {
        if (dataOf(device_, cache_.get()) == original_) return;
        const auto current = disk_.read(cacheKind, key_);
        if (current && *current != original_) {  // another process saved meanwhile
            const auto theirs = createCache(device_, *current);
            const VkPipelineCache source = theirs.get();
            check(vkMergePipelineCaches(device_.handle(), cache_.get(), 1, &source),
                  "cannot merge pipeline caches");
        }
        std::vector<std::byte> merged = dataOf(device_, cache_.get());
        if (disk_.write(cacheKind, key_, merged)) original_ = std::move(merged);
    } catch (const std::exception&) {
        // A cache that cannot be saved costs only time in the next run.
    }
}

}  // namespace nephrite::gpu
