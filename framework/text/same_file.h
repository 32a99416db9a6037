// Whether a file that is to be written is one that is read, whatever the two are called.
#pragma once

#include <filesystem>
#include <span>

namespace nephrite {

/// Whether `file` is one of `files`, also by another name or link. What is not there yet is none of them.
bool isAmong(const std::filesystem::path& file, std::span<const std::filesystem::path> files);

}  // namespace nephrite
