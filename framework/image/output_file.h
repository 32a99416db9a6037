// A file that appears under its name only when it is complete.
//
// The bytes go to a temporary file in the target's folder, which is renamed over the target at the end.
// Whatever fails before that leaves the target as it was and removes the temporary file.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string_view>

namespace nephrite::image {

/// One file being written. Symbolic links are followed; a target that is a device or a pipe is written in
/// place, since there is nothing to rename over. Every failure is a RunError `TARGET: error: ...`.
class OutputFile {
  public:
    /// Creates the temporary file. Throws RunError.
    explicit OutputFile(std::filesystem::path target);
    /// Removes the temporary file unless `commit` has put it in place.
    ~OutputFile();
    OutputFile(OutputFile&& other) noexcept;
    OutputFile& operator=(OutputFile&&) = delete;

    /// Appends bytes. Throws RunError.
    void write(std::span<const std::byte> bytes);
    void write(std::string_view text);

    /// Closes the file and gives it its name. Throws RunError. Nothing may be written after it.
    void commit();

    const std::filesystem::path& target() const { return target_; }

  private:
    [[noreturn]] void fail(int errorNumber) const;

    std::filesystem::path target_;     ///< as the caller named it, for messages
    std::filesystem::path resolved_;   ///< with symbolic links followed
    std::filesystem::path temporary_;  ///< empty when the target is written in place, or once it is committed
    int descriptor_ = -1;
};

/// Writes a whole file at once, or leaves what was there. Throws RunError `TARGET: error: ...`.
void writeFile(const std::filesystem::path& target, std::span<const std::byte> bytes);
void writeFile(const std::filesystem::path& target, std::string_view text);

}  // namespace nephrite::image
