// Reads EXR files with OpenEXR, from memory, one row at a time.
#include <ImathBox.h>
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputPart.h>
#include <ImfMultiPartInputFile.h>
#include <ImfStringAttribute.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <tuple>
#include <vector>

#include "image/exr.h"
#include "image/exr_header.h"
#include "text/diagnostics.h"

namespace nephrite::image {
namespace {

/// A whole file in memory as OpenEXR wants it.
class MemoryInput : public Imf::IStream {
  public:
    explicit MemoryInput(std::span<const std::byte> bytes) : IStream("the file"), bytes_(bytes) {}

    bool read(char target[], int count) override {
        const auto size = static_cast<std::size_t>(count);
        if (size > bytes_.size() - position_) throw std::runtime_error("the file ends before its pixels");
        std::memcpy(target, bytes_.data() + position_, size);
        position_ += size;
        return position_ < bytes_.size();
    }
    std::uint64_t tellg() override { return position_; }
    void seekg(std::uint64_t position) override {
        position_ = std::min<std::uint64_t>(position, bytes_.size());
    }

  private:
    std::span<const std::byte> bytes_;
    std::size_t position_ = 0;
};

std::vector<std::byte> readBytes(const std::filesystem::path& path) {
    std::error_code error;
    const std::uintmax_t size =
        std::filesystem::file_size(path, error);  // fails for anything but a regular file
    if (error) throw std::runtime_error("cannot be read: " + error.message());
    constexpr std::uintmax_t most = std::uintmax_t{1} << 33;
    if (size > most) throw std::runtime_error("cannot be read: it is larger than 8 GiB");
    std::vector<std::byte> bytes(size);
    std::ifstream stream(path, std::ios::binary);
    stream.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size));
    if (!stream) throw std::runtime_error("cannot be read");
    return bytes;
}

/// Orders channels by layer, then R, G, B, A before the others, then by name.
std::tuple<std::string_view, std::size_t, std::string_view> channelOrder(std::string_view name) {
    constexpr std::array<std::string_view, 4> first{"R", "G", "B", "A"};
    const std::size_t dot = name.rfind('.');
    const std::string_view layer = dot == std::string_view::npos ? std::string_view{} : name.substr(0, dot);
    const std::string_view last = dot == std::string_view::npos ? name : name.substr(dot + 1);
    const auto rank = std::find(first.begin(), first.end(), last) - first.begin();
    return {layer, static_cast<std::size_t>(rank), last};
}

std::vector<std::string> channelNames(const Imf::Header& header) {
    std::vector<std::string> names;
    for (auto channel = header.channels().begin(); channel != header.channels().end(); ++channel) {
        names.emplace_back(channel.name());
    }
    std::sort(names.begin(), names.end(),
              [](const std::string& a, const std::string& b) { return channelOrder(a) < channelOrder(b); });
    return names;
}

Metadata textAttributes(const Imf::Header& header) {
    constexpr std::string_view pixelLayout = "type";  // the format's own, always there
    Metadata metadata;
    for (auto attribute = header.begin(); attribute != header.end(); ++attribute) {
        const auto* text = dynamic_cast<const Imf::StringAttribute*>(&attribute.attribute());
        if (text != nullptr && attribute.name() != pixelLayout) {
            metadata[attribute.name()] = text->value();
        }
    }
    return metadata;
}

std::uint32_t extent(int first, int last) {
    return static_cast<std::uint32_t>(std::int64_t{last} - first + 1);
}

/// Reads the rows that are in both windows and copies what the display window shows of each.
void readPixels(Imf::InputPart& part, Image& image) {
    const Imath::Box2i data = part.header().dataWindow();
    const Imath::Box2i display = part.header().displayWindow();
    const std::size_t channels = image.channels.size();
    const std::size_t pixelBytes = channels * sizeof(float);

    // Every row lands in the same place: the stride from row to row is 0.
    std::vector<float> row(extent(data.min.x, data.max.x) * channels);
    char* const origin = reinterpret_cast<char*>(row.data()) -
                         std::int64_t{data.min.x} * static_cast<std::int64_t>(pixelBytes);
    Imf::FrameBuffer buffer;
    for (std::size_t i = 0; i < channels; ++i) {
        buffer.insert(image.channels[i], Imf::Slice(Imf::FLOAT, origin + i * sizeof(float), pixelBytes, 0));
    }
    part.setFrameBuffer(buffer);

    const int left = std::max(data.min.x, display.min.x);
    const int right = std::min(data.max.x, display.max.x);
    if (right < left) return;
    for (int y = std::max(data.min.y, display.min.y); y <= std::min(data.max.y, display.max.y); ++y) {
        part.readPixels(y, y);
        const std::size_t source = (static_cast<std::size_t>(left - data.min.x)) * channels;
        const std::size_t target = (static_cast<std::size_t>(y - display.min.y) * image.width +
                                    static_cast<std::size_t>(left - display.min.x)) *
                                   channels;
        std::copy_n(row.begin() + static_cast<std::ptrdiff_t>(source), extent(left, right) * channels,
                    image.pixels.begin() + static_cast<std::ptrdiff_t>(target));
    }
}

ExrFile decode(std::span<const std::byte> bytes) {
    checkExrHeader(bytes);
    MemoryInput stream(bytes);
    Imf::MultiPartInputFile file(stream);
    Imf::InputPart part(file, 0);

    const Imath::Box2i display = part.header().displayWindow();
    ExrFile result;
    result.image.width = extent(display.min.x, display.max.x);
    result.image.height = extent(display.min.y, display.max.y);
    result.image.channels = channelNames(part.header());
    result.image.pixels.resize(std::size_t{result.image.width} * result.image.height *
                               result.image.channels.size());
    result.metadata = textAttributes(part.header());
    readPixels(part, result.image);
    return result;
}

/// OpenEXR's messages may hold line breaks; a fault is one line.
std::string oneLine(std::string text) {
    std::replace(text.begin(), text.end(), '\n', ' ');
    return text;
}

}  // namespace

ExrFile readExr(const std::filesystem::path& path) {
    std::vector<std::byte> bytes;
    try {
        bytes = readBytes(path);
    } catch (const std::exception& fault) {
        throw InputError({path.string()}, fault.what());
    }
    try {
        return decode(bytes);
    } catch (const std::exception& fault) {
        throw InputError({path.string()}, "not a readable OpenEXR file: " + oneLine(fault.what()));
    }
}

}  // namespace nephrite::image
