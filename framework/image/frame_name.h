// The name of an output that may stand for one file a frame: `out/frame-%04d.exr`.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace nephrite::image {

/// A file name with at most one frame number in it, written `%d` or `%0Nd` with N from 1 to 9. Any other
/// percent sign is itself. The name is never handed to printf.
class FrameName {
  public:
    /// Throws InputError `NAME: error: ...` if the name holds two frame numbers.
    explicit FrameName(std::string pattern);

    bool isNumbered() const { return isNumbered_; }
    /// The frame's file; the plain name for every frame if there is no number in it.
    std::filesystem::path of(std::uint32_t frame) const;

  private:
    std::string before_;
    std::string after_;
    int digits_ = 0;
    bool isNumbered_ = false;
};

}  // namespace nephrite::image
