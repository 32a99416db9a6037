// Reads EXR channels for layer textures and environments.
#include "scene/texture_channels.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string_view>

#include "image/exr.h"

namespace nephrite::scene {
namespace {

std::optional<std::uint32_t> indexOf(const image::Image& image, std::string_view channel) {
    const auto found = std::find(image.channels.begin(), image.channels.end(), channel);
    if (found == image.channels.end()) return std::nullopt;
    return static_cast<std::uint32_t>(found - image.channels.begin());
}

/// The image channels to copy; empty, with a fault, if one is missing.
std::vector<std::uint32_t> chooseChannels(const image::Image& image, const TextureReference& reference,
                                          std::uint32_t wanted, Diagnostics& diagnostics) {
    const auto missing = [&](std::string_view what) {
        diagnostics.error(reference.where,
                          fmt::format("{} has no {}, its channels are {}", reference.file.string(), what,
                                      fmt::join(image.channels, ", ")));
        return std::vector<std::uint32_t>{};
    };
    if (!reference.channel.empty()) {
        const auto index = indexOf(image, reference.channel);
        return index ? std::vector{*index} : missing(fmt::format("channel \"{}\"", reference.channel));
    }
    if (wanted == 1 || image.channels.size() == 1) return {0};
    std::vector<std::uint32_t> indices;
    for (const std::string_view name : {"R", "G", "B"}) {
        const auto index = indexOf(image, name);
        if (!index) return missing("channels R, G and B");
        indices.push_back(*index);
    }
    return indices;
}

std::optional<image::Image> readImage(const TextureReference& reference, Diagnostics& diagnostics) {
    try {
        return image::readExr(reference.file).image;
    } catch (const InputError& error) {
        for (const Diagnostic& fault : error.faults()) diagnostics.error(fault.where, fault.message);
        diagnostics.error(reference.where, fmt::format("cannot use the image {}", reference.file.string()));
        return std::nullopt;
    }
}

}  // namespace

std::optional<Texels> readTexels(const TextureReference& reference, std::uint32_t wanted,
                                 Diagnostics& diagnostics) {
    const auto image = readImage(reference, diagnostics);
    if (!image) return std::nullopt;
    const std::vector<std::uint32_t> channels = chooseChannels(*image, reference, wanted, diagnostics);
    if (channels.empty()) return std::nullopt;
    Texels texels{image->width, image->height, static_cast<std::uint32_t>(channels.size()), {}};
    texels.values.reserve(std::size_t{image->width} * image->height * channels.size());
    for (std::uint32_t y = 0; y < image->height; ++y)
        for (std::uint32_t x = 0; x < image->width; ++x)
            for (const std::uint32_t channel : channels) {
                const float value = static_cast<float>(reference.scale * image->at(x, y, channel));
                if (!std::isfinite(value) || value < 0) {
                    diagnostics.error(
                        reference.where,
                        fmt::format("{}: pixel ({}, {}) of channel \"{}\" times {} is {}, expected a finite "
                                    "number that is not negative",
                                    reference.file.string(), x, y, image->channels[channel], reference.scale,
                                    value));
                    return std::nullopt;
                }
                texels.values.push_back(value);
            }
    return texels;
}

}  // namespace nephrite::scene
