// What identifies a run of `reference`: kept in its pictures, so that parts can be put together, and in the
// file it continues from.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "image/exr.h"
#include "truth/tiles.h"

namespace nephrite::truth {

/// Digest of the bytes of all files, 16 hexadecimal digits. Throws InputError if one cannot be read.
std::string digestOf(const std::vector<std::filesystem::path>& files);

/// "I/N" with 1 <= I <= N <= 1000000; nothing for other text.
std::optional<Part> parsePart(std::string_view text);
std::string toText(const Part& part);

/// Puts pictures of parts together. They must say the same of their run and be all its parts, each once;
/// the attribute "part" is not kept. Throws InputError naming the file that does not fit.
image::ExrFile merge(const std::vector<std::filesystem::path>& files);

/// The text that a run's unfinished work begins with: the record, one attribute a line, and an empty line.
std::string toText(const image::Metadata& record);

}  // namespace nephrite::truth
