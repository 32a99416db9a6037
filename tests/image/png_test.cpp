// PNG files, read back through libpng.
#include "image/png.h"

#include <gmock/gmock.h>
#include <png.h>

#include <stdexcept>

#include "scratch.h"
#include "text/diagnostics.h"

namespace nephrite::image {
namespace {

class PngTest : public Scratch {};

ByteImage gradient(std::uint32_t width, std::uint32_t height, std::uint32_t channels) {
    ByteImage image{width, height, channels, {}};
    for (std::uint32_t i = 0; i < width * height * channels; ++i) {
        image.pixels.push_back(static_cast<std::uint8_t>((i * 2654435761U) >> 24));
    }
    return image;
}

std::vector<std::uint8_t> readBack(const std::filesystem::path& path, const ByteImage& written) {
    png_image control{};
    control.version = PNG_IMAGE_VERSION;
    EXPECT_NE(png_image_begin_read_from_file(&control, path.c_str()), 0) << control.message;
    EXPECT_EQ(control.width, written.width);
    EXPECT_EQ(control.height, written.height);
    const png_uint_32 format = written.channels == 4 ? PNG_FORMAT_RGBA : PNG_FORMAT_RGB;
    EXPECT_EQ(control.format, format);
    control.format = format;
    std::vector<std::uint8_t> pixels(PNG_IMAGE_SIZE(control));
    EXPECT_NE(png_image_finish_read(&control, nullptr, pixels.data(), 0, nullptr), 0) << control.message;
    return pixels;
}

TEST_F(PngTest, RoundTrip) {
    for (const std::uint32_t channels : {3U, 4U}) {
        const ByteImage image = gradient(37, 23, channels);
        writePng(in("a.png"), image);
        EXPECT_EQ(readBack(in("a.png"), image), image.pixels);
    }
    EXPECT_THAT(listing(), testing::ElementsAre("a.png"));
}

TEST_F(PngTest, HeaderSaysEightBitSrgb) {
    writePng(in("a.png"), gradient(2, 3, 3));
    const std::string bytes = contents(in("a.png"));
    // Signature; IHDR of 13 bytes: width, height, 8 bits, colour type 2 (RGB), no interlacing.
    const std::string expected("\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\0\2\0\0\0\3\x8\2\0\0\0", 29);
    EXPECT_EQ(bytes.substr(0, expected.size()), expected);
    EXPECT_NE(bytes.find("sRGB"), std::string::npos);
}

TEST_F(PngTest, NoiseLargerThanItsPixelsFits) {
    const ByteImage image = gradient(1, 5000, 4);
    writePng(in("a.png"), image);
    EXPECT_EQ(readBack(in("a.png"), image), image.pixels);
}

TEST_F(PngTest, UnwritableTargetIsARunError) {
    const auto target = put("file", "kept") / "x.png";
    const std::string message = messageOf<RunError>([&] { writePng(target, gradient(4, 4, 3)); });
    EXPECT_EQ(message, target.string() + ": error: cannot be written: Not a directory");
}

TEST_F(PngTest, ImagesThatContradictThemselvesAreRefused) {
    EXPECT_THROW(writePng(in("a.png"), {2, 2, 3, std::vector<std::uint8_t>(11)}), std::invalid_argument);
    EXPECT_THROW(writePng(in("a.png"), {2, 2, 2, std::vector<std::uint8_t>(8)}), std::invalid_argument);
    EXPECT_THROW(writePng(in("a.png"), {0, 2, 3, {}}), std::invalid_argument);
    EXPECT_THAT(listing(), testing::IsEmpty());
}

}  // namespace
}  // namespace nephrite::image
