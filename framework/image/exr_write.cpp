// Writes EXR files: encoded in memory by OpenEXR, then written whole.
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfOutputFile.h>
#include <ImfStringAttribute.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <set>
#include <span>
#include <stdexcept>
#include <vector>

#include "image/exr.h"
#include "image/output_file.h"
#include "text/diagnostics.h"

namespace nephrite::image {
namespace {

/// Collects what OpenEXR writes; it goes back to fill in its table of offsets.
class MemoryOutput : public Imf::OStream {
  public:
    MemoryOutput() : OStream("memory") {}

    void write(const char source[], int count) override {
        const auto added = std::as_bytes(std::span(source, static_cast<std::size_t>(count)));
        bytes_.resize(std::max(bytes_.size(), position_ + added.size()));
        std::copy(added.begin(), added.end(), bytes_.begin() + static_cast<std::ptrdiff_t>(position_));
        position_ += added.size();
    }
    std::uint64_t tellp() override { return position_; }
    void seekp(std::uint64_t position) override { position_ = position; }

    std::span<const std::byte> bytes() const { return bytes_; }

  private:
    std::vector<std::byte> bytes_;
    std::size_t position_ = 0;
};

void requireConsistent(const Image& image) {
    const std::set<std::string> names(image.channels.begin(), image.channels.end());
    const std::size_t values = std::size_t{image.width} * image.height * image.channels.size();
    if (names.size() != image.channels.size() || names.contains("") || values == 0 ||
        image.pixels.size() != values) {
        throw std::invalid_argument("an image's size, channels and values do not agree");
    }
}

void encode(const Image& image, const Metadata& metadata, Imf::OStream& stream) {
    Imf::Header header(static_cast<int>(image.width), static_cast<int>(image.height));
    header.compression() = Imf::ZIP_COMPRESSION;
    for (const auto& [name, text] : metadata) header.insert(name, Imf::StringAttribute(text));

    const std::size_t pixelBytes = image.channels.size() * sizeof(float);
    Imf::FrameBuffer buffer;
    for (std::size_t i = 0; i < image.channels.size(); ++i) {
        header.channels().insert(image.channels[i], Imf::Channel(Imf::FLOAT));
        // A slice can be read and written through, so its pointer is not const; writing a file only reads.
        auto* const first = const_cast<char*>(reinterpret_cast<const char*>(image.pixels.data() + i));
        buffer.insert(image.channels[i], Imf::Slice(Imf::FLOAT, first, pixelBytes, pixelBytes * image.width));
    }
    Imf::OutputFile file(stream, header);
    file.setFrameBuffer(buffer);
    file.writePixels(static_cast<int>(image.height));
}

}  // namespace

void writeExr(const std::filesystem::path& path, const Image& image, const Metadata& metadata) {
    requireConsistent(image);
    MemoryOutput encoded;
    try {
        encode(image, metadata, encoded);
    } catch (const std::exception& fault) {
        throw RunError(
            toLine({{path.string()}, fmt::format("cannot be encoded as OpenEXR: {}", fault.what())}));
    }
    writeFile(path, encoded.bytes());
}

}  // namespace nephrite::image
