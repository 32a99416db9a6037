// What identifies a run of `reference`: kept in its pictures, so that parts can be put together, and in the
// file it continues from.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "image/exr.h"
#include "truth/tiles.h"

namespace nephrite::truth {

/// Digest of the bytes of all files, 16 hexadecimal digits. Throws InputError if one cannot be read.
std::string digestOf(const std::vector<std::filesystem::path>& files);

/// "I/N" with 1 <= I <= N <= 1000000; nothing for other text.
std::optional<Part> parsePart(std::string_view text);
std::string toText(const Part& part);

/// Whether a picture is what a run of this record writes as its `content`, "radiance" or "standard error".
/// Attributes called one of `ignored` may differ.
bool isOf(const image::Metadata& record, std::string_view content, const image::ExrFile& picture,
          std::span<const std::string_view> ignored = {});

/// Puts pictures of parts together. They must say the same of their run and be all its parts, each once;
/// the attribute "part" is not kept. Throws InputError naming the file that does not fit.
image::ExrFile merge(const std::vector<std::filesystem::path>& files);

/// The text that a run's unfinished work begins with: the record, one attribute a line, and an empty line.
std::string toText(const image::Metadata& record);

}  // namespace nephrite::truth
