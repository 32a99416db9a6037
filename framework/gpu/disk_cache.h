// Results kept on disk between runs, by content: a file holds the whole key it answers, so it can never
// answer another.
//
// Several processes may use a folder at once: a file is written aside and renamed into place. Whatever goes
// wrong (no such folder, no space, a damaged file) only means that a result is not found or not kept.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace nephrite::gpu {

/// $NEPHRITE_CACHE_DIR, else $XDG_CACHE_HOME/nephrite, else ~/.cache/nephrite; nothing if none of them is
/// set.
std::optional<std::filesystem::path> defaultCacheFolder();

class DiskCache {
  public:
    /// Keeps nothing.
    DiskCache() = default;
    /// `folder` is made when something is first written.
    explicit DiskCache(std::filesystem::path folder) : folder_(std::move(folder)) {}
    /// In defaultCacheFolder(); keeps nothing without one.
    static DiskCache standard();

    /// The value last written under exactly this key. `kind` is a short word that starts the file's name
    /// ("spirv").
    std::optional<std::vector<std::byte>> read(std::string_view kind, std::string_view key) const;
    /// Keeps a value if possible; says whether it did.
    bool write(std::string_view kind, std::string_view key, std::span<const std::byte> value) const;

    /// Where a key's value is, or would be.
    std::filesystem::path fileOf(std::string_view kind, std::string_view key) const;

  private:
    std::filesystem::path folder_;
};

}  // namespace nephrite::gpu
