// Which formats a device filters.
#include "runtime/program/program_context.h"

#include <map>

#include "gpu/device.h"
#include "runtime/resources/vulkan_names.h"

namespace nephrite::runtime {

Filterable filterableOn(const gpu::Device& device) {
    std::map<graph::Format, bool> answers;
    for (const graph::FormatInfo& format : graph::allFormats())
        answers[format.format] = (device.formatFeatures(vulkanFormat(format.format)) &
                                  VK_FORMAT_FEATURE_2_SAMPLED_IMAGE_FILTER_LINEAR_BIT) != 0;
    return [answers](graph::Format format) { return answers.at(format); };
}

}  // namespace nephrite::runtime
