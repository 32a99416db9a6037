// A look at an EXR header before OpenEXR gets the file, so that a damaged one cannot ask for absurd memory.
#pragma once

#include <cstddef>
#include <span>

namespace nephrite::image {

/// Throws std::runtime_error, saying what is wrong, unless `file` (a whole EXR file) has headers that fit in
/// it and claims sizes that so many bytes can hold when decompressed. Layout: "OpenEXR File Layout", Academy
/// Software Foundation, version 2 files.
void checkExrHeader(std::span<const std::byte> file);

}  // namespace nephrite::image
