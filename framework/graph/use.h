// What a pass does with a resource: its stage and access, and the image layout that goes with it.
#pragma once

#include <cstdint>
#include <string_view>

#include "graph/format.h"

namespace nephrite::graph {

/// Why a pass touches a resource. Each use has one pipeline stage, access and layout.
enum class Use : std::uint8_t {
    None,         ///< before its first use in a frame: contents undefined
    ComputeRead,  ///< read by a pixel or compute pass
    ComputeWrite,
    RasterRead,       ///< read by a raster pass's shader
    ColorAttachment,  ///< written by a raster pass
    DepthAttachment,
    Clear,             ///< cleared to its neutral value
    Copy,              ///< copied out (a requested output or dump)
    Indirect,          ///< arguments of an indirect dispatch
    ComputeModify,     ///< read and written by a pixel or compute pass
    ComputeLevelRead,  ///< a lower level of its own output, read by an iteration over mips as a storage image
};

enum class Layout : std::uint8_t {
    Undefined,
    General,
    ShaderRead,
    ColorAttachment,
    DepthAttachment,
    TransferSource,
    TransferDestination
};

/// How shaders read images on the device at hand; decides the layout of reads (runtime/ asks gpu/).
enum class InputReads : std::uint8_t { StorageImage, SampledImage };

/// The layout an image is in while it is used so.
constexpr Layout layoutOf(Use use, InputReads reads, Format format) {
    switch (use) {
        case Use::None:
            return Layout::Undefined;
        case Use::ComputeRead:
        case Use::RasterRead:
            // A depth image cannot be a storage image.
            return reads == InputReads::StorageImage && format != Format::d32f ? Layout::General
                                                                               : Layout::ShaderRead;
        case Use::ComputeWrite:
        case Use::ComputeModify:
        case Use::ComputeLevelRead:
            return Layout::General;
        case Use::Indirect:
            return Layout::Undefined;
        case Use::ColorAttachment:
            return Layout::ColorAttachment;
        case Use::DepthAttachment:
            return Layout::DepthAttachment;
        case Use::Clear:
            return Layout::TransferDestination;
        case Use::Copy:
            return Layout::TransferSource;
    }
    return Layout::Undefined;
}

constexpr bool writes(Use use) {
    return use == Use::ComputeWrite || use == Use::ColorAttachment || use == Use::DepthAttachment ||
           use == Use::Clear || use == Use::ComputeModify;
}
constexpr std::uint32_t bit(Use use) {
    return 1U << static_cast<std::uint32_t>(use);
}

std::string_view name(Use use);        ///< "compute read"
std::string_view name(Layout layout);  ///< "shader read"

}  // namespace nephrite::graph
