// PNG through libpng's simplified interface, which needs no setjmp: a failure is a return value.
#include "image/png.h"

#include <fmt/format.h>
#include <png.h>

#include <cstddef>
#include <stdexcept>

#include "image/output_file.h"
#include "text/diagnostics.h"

namespace nephrite::image {
namespace {

void requireConsistent(const ByteImage& image) {
    const bool hasChannels = image.channels == 3 || image.channels == 4;
    const std::size_t values = std::size_t{image.width} * image.height * image.channels;
    if (!hasChannels || values == 0 || image.pixels.size() != values) {
        throw std::invalid_argument("a picture's size, channels and values do not agree");
    }
}

/// libpng's description of a picture, freed whatever happens.
class PngControl {
  public:
    explicit PngControl(const ByteImage& image) {
        control_.version = PNG_IMAGE_VERSION;
        control_.width = image.width;
        control_.height = image.height;
        control_.format = image.channels == 4 ? PNG_FORMAT_RGBA : PNG_FORMAT_RGB;
    }
    ~PngControl() { png_image_free(&control_); }
    PngControl(const PngControl&) = delete;
    PngControl& operator=(const PngControl&) = delete;

    png_image* get() { return &control_; }
    const char* message() const { return control_.message; }

  private:
    png_image control_{};
};

}  // namespace

std::vector<std::byte> encodePng(const ByteImage& image) {
    requireConsistent(image);
    PngControl control(image);
    // A bound for data that deflate cannot compress, so that one pass is enough.
    png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(*control.get());
    std::vector<std::byte> bytes(size);
    const int convertTo8Bit = 0;
    if (png_image_write_to_memory(control.get(), bytes.data(), &size, convertTo8Bit, image.pixels.data(), 0,
                                  nullptr) == 0) {
        throw RunError(fmt::format("a picture cannot be encoded as PNG: {}", control.message()));
    }
    bytes.resize(size);
    return bytes;
}

void writePng(const std::filesystem::path& path, const ByteImage& image) {
    writeFile(path, encodePng(image));
}

}  // namespace nephrite::image
