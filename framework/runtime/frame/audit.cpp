// Comparing images by their bytes.
#include "runtime/frame/audit.h"

#include <fmt/format.h>

#include <algorithm>

#include "gpu/texels.h"
#include "gpu/transfer.h"
#include "runtime/resources/readback.h"
#include "text/diagnostics.h"

namespace nephrite::runtime {
namespace {

std::string valuesAt(VkFormat format, std::span<const std::byte> texel) {
    const std::vector<float> values = gpu::decodeTexels(format, texel);
    return fmt::format("({:.9g}, {:.9g}, {:.9g}, {:.9g})", values[0], values[1], values[2], values[3]);
}

/// One level of one layer of a requested output.
struct Part {
    const graph::RequestedOutput& output;
    std::uint32_t mip = 0;
    std::uint32_t layer = 0;
};

std::vector<std::byte> bytesOf(const gpu::Device& device, const Executor& executor, const Part& part) {
    const graph::Resource& resource = executor.plan().resources[part.output.resource];
    return gpu::readImageBytes(device, executor.resources().image(part.output.resource), part.mip, part.layer,
                               layoutAfterFrame(resource));
}

void comparePart(const gpu::Device& device, const Executor& skipping, const Executor& plain, const Part& part,
                 const Part& plainPart) {
    const std::vector<std::byte> found = bytesOf(device, skipping, part);
    const std::vector<std::byte> expected = bytesOf(device, plain, plainPart);
    const auto [at, other] = std::mismatch(found.begin(), found.end(), expected.begin(), expected.end());
    if (at == found.end() && other == expected.end()) return;
    const gpu::Image& image = skipping.resources().image(part.output.resource);
    const std::size_t stride = gpu::texelBytes(image.format());
    const std::size_t texel = static_cast<std::size_t>(at - found.begin()) / stride;
    const std::size_t width = image.extent(part.mip).width;
    const auto valueIn = [&](const std::vector<std::byte>& bytes) {
        return valuesAt(image.format(), std::span(bytes).subspan(texel * stride, stride));
    };
    throw RunError(fmt::format(
        "{}: error: skipping changes the picture at ({}, {}) of level {}, layer {}: {} with it, {} without",
        part.output.name, texel % width, texel / width, part.mip, part.layer, valueIn(found),
        valueIn(expected)));
}

const graph::RequestedOutput& outputNamed(const graph::Plan& plan, const std::string& name) {
    return *std::find_if(plan.requested.begin(), plan.requested.end(),
                         [&](const graph::RequestedOutput& output) { return output.name == name; });
}

}  // namespace

void compareFrames(const gpu::Device& device, const Executor& skipping, const Executor& plain) {
    for (const graph::RequestedOutput& output : skipping.plan().requested) {
        if (output.resource == graph::noIndex || skipping.plan().resources[output.resource].isBuffer)
            continue;
        const graph::RequestedOutput& plainOutput = outputNamed(plain.plan(), output.name);
        const graph::Subresources range = partOf(skipping.plan(), output);
        for (std::uint32_t mip = range.baseMip; mip < range.baseMip + range.mips; ++mip)
            for (std::uint32_t layer = range.baseLayer; layer < range.baseLayer + range.layers; ++layer)
                comparePart(device, skipping, plain, {output, mip, layer}, {plainOutput, mip, layer});
    }
}

}  // namespace nephrite::runtime
