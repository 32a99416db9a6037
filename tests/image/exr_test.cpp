// EXR files written and read: every bit of the pixels, the channels, the metadata, and what OpenEXR itself
// sees.
#include "image/exr.h"

#include <ImathBox.h>
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfMultiPartOutputFile.h>
#include <ImfOutputFile.h>
#include <ImfOutputPart.h>
#include <ImfPartType.h>
#include <ImfStringAttribute.h>
#include <ImfTiledOutputFile.h>
#include <gmock/gmock.h>
#include <half.h>

#include <bit>
#include <limits>
#include <stdexcept>

#include "scratch.h"
#include "text/diagnostics.h"

namespace nephrite::image {
namespace {

using testing::ElementsAre;

class ExrTest : public Scratch {};

/// Floats of every kind: a walk through bit patterns, NaNs with payloads, infinities and denormals among
/// them.
Image everyKindOfFloat(std::uint32_t width, std::uint32_t height, std::vector<std::string> channels) {
    Image image{width, height, std::move(channels), {}};
    image.pixels.resize(std::size_t{width} * height * image.channels.size());
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        image.pixels[i] = std::bit_cast<float>(static_cast<std::uint32_t>(i) * 2654435761U);
    }
    image.pixels[0] = std::numeric_limits<float>::infinity();
    image.pixels[1] = std::bit_cast<float>(0x7fc12345U);
    image.pixels[2] = -0.0F;
    return image;
}

std::vector<std::uint32_t> bits(const Image& image) {
    std::vector<std::uint32_t> result;
    for (const float value : image.pixels) result.push_back(std::bit_cast<std::uint32_t>(value));
    return result;
}

TEST_F(ExrTest, RoundTripIsBitExact) {
    const Image image = everyKindOfFloat(61, 47, {"R", "G", "B", "A", "depth.Z"});
    const Metadata metadata{{"scene", "a.json"}, {"weights", "[0.3, 0.3]\n\"q\""}, {"empty", ""}};
    writeExr(in("a.exr"), image, metadata);
    const ExrFile file = readExr(in("a.exr"));
    EXPECT_EQ(file.image.width, 61U);
    EXPECT_EQ(file.image.height, 47U);
    EXPECT_EQ(file.image.channels, image.channels);
    EXPECT_EQ(bits(file.image), bits(image));
    EXPECT_EQ(file.metadata, metadata);
    EXPECT_THAT(listing(), ElementsAre("a.exr"));
}

TEST_F(ExrTest, ChannelsComeBackLayerByLayer) {
    const Image image{
        1, 1, {"layer1.R", "A", "layer1.G", "Z", "B", "R", "layer1.A", "G"}, {1, 2, 3, 4, 5, 6, 7, 8}};
    writeExr(in("a.exr"), image);
    const Image read = readExr(in("a.exr")).image;
    EXPECT_THAT(read.channels, ElementsAre("R", "G", "B", "A", "Z", "layer1.R", "layer1.G", "layer1.A"));
    EXPECT_THAT(read.pixels, ElementsAre(6, 8, 5, 2, 4, 1, 3, 7));
}

TEST_F(ExrTest, SameImageSameBytes) {
    const Image image = everyKindOfFloat(33, 20, {"R", "G", "B"});
    writeExr(in("a.exr"), image, {{"scene", "s"}});
    writeExr(in("b.exr"), image, {{"scene", "s"}});
    EXPECT_EQ(contents(in("a.exr")), contents(in("b.exr")));
}

TEST_F(ExrTest, OpenExrSeesFloatsTopDownAndTheAttributes) {
    writeExr(in("a.exr"), {2, 2, {"R"}, {1, 2, 3, 4}}, {{"commit", "unknown"}});
    Imf::InputFile file(in("a.exr").c_str());
    EXPECT_EQ(file.header().channels().findChannel("R")->type, Imf::FLOAT);
    EXPECT_EQ(file.header().typedAttribute<Imf::StringAttribute>("commit").value(), "unknown");
    float pixels[4] = {};
    Imf::FrameBuffer buffer;
    buffer.insert("R",
                  Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(pixels), sizeof(float), 2 * sizeof(float)));
    file.setFrameBuffer(buffer);
    file.readPixels(0, 1);
    EXPECT_THAT(pixels, ElementsAre(1, 2, 3, 4));  // y = 0 is the top row
}

TEST_F(ExrTest, ReadsHalfAndUintChannels) {
    Imf::Header header(3, 1);
    header.channels().insert("H", Imf::Channel(Imf::HALF));
    header.channels().insert("U", Imf::Channel(Imf::UINT));
    half halves[3] = {half(0.5F), half(-2.0F), half(65504.0F)};
    unsigned uints[3] = {0, 7, 16777216};
    Imf::FrameBuffer buffer;
    buffer.insert("H", Imf::Slice(Imf::HALF, reinterpret_cast<char*>(halves), sizeof(half), 0));
    buffer.insert("U", Imf::Slice(Imf::UINT, reinterpret_cast<char*>(uints), sizeof(unsigned), 0));
    {
        Imf::OutputFile file(in("a.exr").c_str(), header);
        file.setFrameBuffer(buffer);
        file.writePixels(1);
    }
    const Image image = readExr(in("a.exr")).image;
    EXPECT_THAT(image.channels, ElementsAre("H", "U"));
    EXPECT_THAT(image.pixels, ElementsAre(0.5F, 0, -2.0F, 7, 65504.0F, 16777216));
}

TEST_F(ExrTest, ReadsEveryCompressionTheSame) {
    std::vector<float> values(40 * 70);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<float>(i % 97);
    for (const auto compression :
         {Imf::NO_COMPRESSION, Imf::RLE_COMPRESSION, Imf::ZIPS_COMPRESSION, Imf::ZIP_COMPRESSION,
          Imf::PIZ_COMPRESSION, Imf::B44_COMPRESSION, Imf::B44A_COMPRESSION}) {
        Imf::Header header(40, 70);
        header.compression() = compression;
        header.channels().insert("Y", Imf::Channel(Imf::FLOAT));
        Imf::FrameBuffer buffer;
        buffer.insert("Y", Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(values.data()), sizeof(float),
                                      40 * sizeof(float)));
        {
            Imf::OutputFile file(in("a.exr").c_str(), header);
            file.setFrameBuffer(buffer);
            file.writePixels(70);
        }
        EXPECT_EQ(readExr(in("a.exr")).image.pixels, values) << "compression " << compression;
    }
}

TEST_F(ExrTest, ReadsTiles) {
    std::vector<float> values(50 * 30);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<float>(i);
    Imf::Header header(50, 30);
    header.channels().insert("Y", Imf::Channel(Imf::FLOAT));
    header.setTileDescription(Imf::TileDescription(16, 8, Imf::ONE_LEVEL));
    Imf::FrameBuffer buffer;
    buffer.insert("Y", Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(values.data()), sizeof(float),
                                  50 * sizeof(float)));
    {
        Imf::TiledOutputFile file(in("a.exr").c_str(), header);
        file.setFrameBuffer(buffer);
        file.writeTiles(0, file.numXTiles() - 1, 0, file.numYTiles() - 1);
    }
    EXPECT_EQ(readExr(in("a.exr")).image.pixels, values);
}

TEST_F(ExrTest, ReadsTheFirstOfSeveralParts) {
    std::vector<Imf::Header> headers(2, Imf::Header(2, 1));
    std::vector<float> values{1, 2, 3, 4};
    for (std::size_t i = 0; i < headers.size(); ++i) {
        headers[i].setName(i == 0 ? "first" : "second");
        headers[i].setType(Imf::SCANLINEIMAGE);
        headers[i].channels().insert("Y", Imf::Channel(Imf::FLOAT));
    }
    {
        Imf::MultiPartOutputFile file(in("a.exr").c_str(), headers.data(), 2);
        for (int i = 0; i < 2; ++i) {
            Imf::FrameBuffer buffer;
            buffer.insert("Y",
                          Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(&values[2 * i]), sizeof(float), 0));
            Imf::OutputPart part(file, i);
            part.setFrameBuffer(buffer);
            part.writePixels(1);
        }
    }
    EXPECT_THAT(readExr(in("a.exr")).image.pixels, ElementsAre(1, 2));
}

/// A file whose data window holds 10 y + x at each pixel.
void writeWindow(const std::filesystem::path& path, const Imath::Box2i& display, const Imath::Box2i& data) {
    Imf::Header header(display, data);
    header.channels().insert("Y", Imf::Channel(Imf::FLOAT));
    std::vector<float> values;
    for (int y = data.min.y; y <= data.max.y; ++y) {
        for (int x = data.min.x; x <= data.max.x; ++x) values.push_back(static_cast<float>(10 * y + x));
    }
    Imf::FrameBuffer buffer;
    buffer.insert("Y", Imf::Slice::Make(Imf::FLOAT, values.data(), data));
    Imf::OutputFile file(path.c_str(), header);
    file.setFrameBuffer(buffer);
    file.writePixels(data.max.y - data.min.y + 1);
}

TEST_F(ExrTest, ImageIsTheDisplayWindow) {
    // Data reaches beyond the display window on the left and the top, and leaves its right and its bottom
    // black.
    writeWindow(in("a.exr"), {{2, 3}, {4, 5}}, {{1, 1}, {3, 4}});
    const Image image = readExr(in("a.exr")).image;
    EXPECT_EQ(image.width, 3U);
    EXPECT_EQ(image.height, 3U);
    EXPECT_THAT(image.pixels, ElementsAre(32, 33, 0, 42, 43, 0, 0, 0, 0));
}

TEST_F(ExrTest, WindowsApartGiveBlack) {
    writeWindow(in("a.exr"), {{0, 0}, {1, 0}}, {{-7, -9}, {-5, -8}});
    EXPECT_THAT(readExr(in("a.exr")).image.pixels, ElementsAre(0, 0));
}

TEST_F(ExrTest, UnwritableTargetIsARunErrorAndKeepsWhatIsThere) {
    const Image image{1, 1, {"R"}, {1}};
    const auto inFile = put("file", "kept") / "x.exr";
    EXPECT_EQ(messageOf<RunError>([&] { writeExr(inFile, image); }),
              inFile.string() + ": error: cannot be written: Not a directory");
    std::filesystem::create_symlink("/dev/full", in("full.exr"));
    EXPECT_EQ(messageOf<RunError>([&] { writeExr(in("full.exr"), image); }),
              in("full.exr").string() + ": error: cannot be written: No space left on device");
    EXPECT_THAT(listing(), ElementsAre("file", "full.exr"));
}

TEST_F(ExrTest, ImagesThatContradictThemselvesAreRefused) {
    EXPECT_THROW(writeExr(in("a.exr"), {1, 1, {"R", "R"}, {1, 2}}), std::invalid_argument);
    EXPECT_THROW(writeExr(in("a.exr"), {2, 1, {"R"}, {1}}), std::invalid_argument);
    EXPECT_THROW(writeExr(in("a.exr"), {1, 1, {}, {}}), std::invalid_argument);
    EXPECT_THROW(writeExr(in("a.exr"), {1, 1, {""}, {1}}), std::invalid_argument);
    EXPECT_THAT(listing(), testing::IsEmpty());
}

}  // namespace
}  // namespace nephrite::image
