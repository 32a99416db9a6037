// Reads the attributes that decide how much memory a reader of the file will ask for.
#include "image/exr_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <stdexcept>
#include <string_view>

namespace nephrite::image {
namespace {

[[noreturn]] void refuse(std::string_view why) {
    throw std::runtime_error(std::string(why));
}

/// Takes little-endian values and zero-terminated names off the front of some bytes.
class Cursor {
  public:
    explicit Cursor(std::span<const std::byte> bytes) : rest_(bytes) {}

    std::span<const std::byte> take(std::size_t count) {
        if (count > rest_.size()) refuse("the file ends within its header");
        const std::span<const std::byte> taken = rest_.first(count);
        rest_ = rest_.subspan(count);
        return taken;
    }

    std::uint8_t byte() { return std::to_integer<std::uint8_t>(take(1)[0]); }

    std::uint32_t word() {
        const std::span<const std::byte> bytes = take(4);
        std::uint32_t value = 0;
        for (std::size_t i = 0; i < 4; ++i) value |= std::to_integer<std::uint32_t>(bytes[i]) << (8 * i);
        return value;
    }

    std::int32_t integer() { return static_cast<std::int32_t>(word()); }

    std::string_view name() {
        const auto end = std::find(rest_.begin(), rest_.end(), std::byte{0});
        if (end == rest_.end()) refuse("the file ends within its header");
        const auto length = static_cast<std::size_t>(end - rest_.begin());
        const std::string_view text(reinterpret_cast<const char*>(rest_.data()), length);
        rest_ = rest_.subspan(length + 1);
        return text;
    }

    bool atEnd() const { return rest_.empty(); }

  private:
    std::span<const std::byte> rest_;
};

// Numbers of the compression methods in the file.
constexpr std::uint8_t zip = 3;
constexpr std::uint8_t piz = 4;
constexpr std::uint8_t pxr24 = 5;
constexpr std::uint8_t b44 = 6;
constexpr std::uint8_t b44a = 7;
constexpr std::uint8_t dwaa = 8;
constexpr std::uint8_t dwab = 9;

struct Window {
    std::int64_t width = 0;
    std::int64_t height = 0;
};

/// What one part of the file says of itself.
struct Part {
    Window data;
    Window display;
    std::int64_t channels = 0;
    Window tile;                     ///< 0 by 0: scan lines
    std::uint8_t compression = zip;  ///< what OpenEXR takes if the header does not say
};

Window readWindow(Cursor value) {
    const std::int64_t left = value.integer();
    const std::int64_t top = value.integer();
    const std::int64_t right = value.integer();
    const std::int64_t bottom = value.integer();
    if (right < left || bottom < top) refuse("its window is empty");
    return {right - left + 1, bottom - top + 1};
}

std::int64_t countChannels(Cursor value) {
    constexpr std::size_t bytesAfterType = 4;
    std::int64_t count = 0;
    while (!value.name().empty()) {
        value.integer();  // its type
        value.take(bytesAfterType);
        if (value.integer() != 1 || value.integer() != 1)
            refuse("it has subsampled channels, which are not read");
        ++count;
    }
    if (!value.atEnd()) refuse("a value in its header has the wrong size");
    return count;
}

Window readTile(Cursor value) {
    const std::int64_t width = value.word();
    const std::int64_t height = value.word();
    if (width == 0 || height == 0) refuse("its tiles are empty");
    return {width, height};
}

struct FixedSize {
    std::string_view type;
    std::size_t bytes;
};

constexpr std::array<FixedSize, 24> fixedSizes{{
    {"box2f", 16},
    {"box2i", 16},
    {"chromaticities", 32},
    {"compression", 1},
    {"deepImageState", 1},
    {"double", 8},
    {"envmap", 1},
    {"float", 4},
    {"int", 4},
    {"keycode", 28},
    {"lineOrder", 1},
    {"m33d", 72},
    {"m33f", 36},
    {"m44d", 128},
    {"m44f", 64},
    {"rational", 8},
    {"tiledesc", 9},
    {"timecode", 8},
    {"v2d", 16},
    {"v2f", 8},
    {"v2i", 8},
    {"v3d", 24},
    {"v3f", 12},
    {"v3i", 12},
}};

std::int64_t previewBytes(Cursor value) {
    const std::int64_t width = value.word();
    const std::int64_t height = value.word();
    constexpr std::int64_t most = std::int64_t{1} << 28;
    return width > most || height > most ? most : 8 + 4 * width * height;
}

/// OpenEXR reads a value of a known type without looking at the size the file gives; a wrong one would make
/// it see another header than the one checked here.
void checkValue(std::string_view type, std::span<const std::byte> value) {
    const auto known = std::find_if(fixedSizes.begin(), fixedSizes.end(),
                                    [&](const FixedSize& size) { return size.type == type; });
    const auto size = static_cast<std::int64_t>(value.size());
    constexpr std::int64_t deflateRatio = 1032;
    const bool isRight = known != fixedSizes.end() ? value.size() == known->bytes
                         : type == "preview"       ? previewBytes(Cursor(value)) == size
                         : type == "idmanifest"    ? Cursor(value).word() <= deflateRatio * size
                                                   : true;
    if (!isRight) refuse("a value in its header has the wrong size");
}

/// Reads one header, up to and including its end; false if there is none, only the end.
bool readPart(Cursor& header, Part& part) {
    bool any = false;
    for (std::string_view name = header.name(); !name.empty(); name = header.name()) {
        any = true;
        const std::string_view type = header.name();
        const std::span<const std::byte> bytes = header.take(header.word());
        const Cursor value(bytes);
        checkValue(type, bytes);
        if (type == "chlist") part.channels = std::max(part.channels, countChannels(value));
        if (name == "dataWindow") part.data = readWindow(value);
        if (name == "displayWindow") part.display = readWindow(value);
        if (name == "tiles") part.tile = readTile(value);
        if (name == "compression") part.compression = Cursor(value).byte();
    }
    return any;
}

std::int64_t scanLinesPerChunk(std::uint8_t compression) {
    switch (compression) {
        case zip:
        case pxr24:
            return 16;
        case piz:
        case b44:
        case b44a:
        case dwaa:
            return 32;
        case dwab:
            return 256;
        default:
            return 1;
    }
}

/// How many values a file may claim: a flat picture compresses well, but not without end. Deflate reaches
/// 1032:1; DWA first reduces a flat block of 64 values to one. `always` many are allowed to any file.
std::int64_t mostValues(std::size_t fileBytes, std::uint8_t compression, std::int64_t always) {
    constexpr std::int64_t never = std::int64_t{1} << 30;
    const bool isDwa = compression == dwaa || compression == dwab;
    const std::int64_t ratio = isDwa ? 64 * 1032 : 1032;
    const auto bytes = static_cast<std::int64_t>(std::min<std::size_t>(fileBytes, std::size_t{never}));
    return std::clamp(bytes * ratio / 2, always, never);
}

/// Whether width * height * depth is at most `most`, for factors that may overflow when multiplied.
bool fits(std::int64_t width, std::int64_t height, std::int64_t depth, std::int64_t most) {
    return width <= most && height <= most / width && depth <= most / width / height;
}

std::int64_t dividedUp(std::int64_t value, std::int64_t by) {
    return (value + by - 1) / by;
}

void checkPart(const Part& part, std::size_t fileBytes) {
    if (part.data.width == 0 || part.display.width == 0) refuse("it has no data window or no display window");
    if (part.channels == 0) refuse("it has no channels");
    const std::int64_t most = mostValues(fileBytes, part.compression, std::int64_t{1} << 26);
    const std::int64_t mostInChunk = mostValues(fileBytes, part.compression, std::int64_t{1} << 24);
    const bool isTiled = part.tile.width > 0;
    const Window chunk = isTiled ? part.tile : Window{part.data.width, scanLinesPerChunk(part.compression)};
    if (!fits(part.data.width, part.data.height, part.channels, most) ||
        !fits(part.display.width, part.display.height, part.channels, most) ||
        !fits(chunk.width, chunk.height, part.channels, mostInChunk)) {
        refuse(fmt::format("its header claims {} x {} pixels of {} channels, more than its {} bytes can hold",
                           std::max(part.data.width, part.display.width),
                           std::max(part.data.height, part.display.height), part.channels, fileBytes));
    }
    constexpr std::int64_t bytesPerChunk = 8;  // its entry in the table of offsets
    const std::int64_t chunks =
        dividedUp(part.data.width, chunk.width) * dividedUp(part.data.height, chunk.height);
    if (chunks > static_cast<std::int64_t>(fileBytes) / bytesPerChunk)
        refuse("the file ends before its pixels");
}

}  // namespace

void checkExrHeader(std::span<const std::byte> file) {
    constexpr std::uint32_t magic = 20000630;
    constexpr std::uint32_t deepFlag = 0x800;
    constexpr std::uint32_t multiPartFlag = 0x1000;
    Cursor header(file);
    if (file.size() < 8 || header.word() != magic) refuse("it does not start like one");
    const std::uint32_t version = header.word();
    if ((version & deepFlag) != 0) refuse("it holds deep pixels, which are not read");

    Part part;
    if (!readPart(header, part)) refuse("its header is empty");
    checkPart(part, file.size());
    if ((version & multiPartFlag) == 0) return;
    for (Part next; readPart(header, next); next = {}) checkPart(next, file.size());
}

}  // namespace nephrite::image
