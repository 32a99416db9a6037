// OpenEXR files: float pictures with named channels and text attributes.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "image/image.h"

namespace nephrite::image {

/// Text attributes of the header, by name.
using Metadata = std::map<std::string, std::string>;

struct ExrFile {
    Image image;
    Metadata metadata;  ///< every attribute of type string but the format's own, `type`
};

/// Reads a flat (not deep) EXR file, tiled or in scan lines; of a file of several parts the first. Half and
/// uint channels become float. The image is the display window: pixels of it outside the data window are 0,
/// and data outside it is left out. In each layer R, G, B, A come first and in this order, then the other
/// channels by name; layers are in alphabetical order, the one without a name first. Throws InputError `FILE:
/// error: ...` for a file that is missing, damaged, not an EXR file, or whose header claims more pixels than
/// the file can hold or than 2^30 values.
ExrFile readExr(const std::filesystem::path& path);

/// Writes 32-bit float channels, losslessly compressed, and the metadata as string attributes. A whole file
/// or none (see OutputFile). Throws RunError `FILE: error: ...`; std::invalid_argument if the image
/// contradicts itself.
void writeExr(const std::filesystem::path& path, const Image& image, const Metadata& metadata = {});

}  // namespace nephrite::image
