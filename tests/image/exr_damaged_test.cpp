// Damaged EXR files: refused with one line that names the file, without a crash and without absurd memory.
#include <ImfChannelList.h>
#include <ImfHeader.h>
#include <ImfTiledOutputFile.h>
#include <gmock/gmock.h>
#include <sys/stat.h>

#include <cstring>
#include <random>

#include "image/exr.h"
#include "scratch.h"
#include "text/diagnostics.h"

namespace nephrite::image {
namespace {

using testing::HasSubstr;

class ExrDamagedTest : public Scratch {
  protected:
    /// The bytes of a small, good file.
    std::string good() const {
        Image image{40, 40, {"R", "G", "B", "A"}, {}};
        std::mt19937 random(7);
        for (std::size_t i = 0; i < std::size_t{40} * 40 * 4; ++i)
            image.pixels.push_back(static_cast<float>(random() % 64));
        writeExr(in("good.exr"), image, {{"scene", "somewhere"}});
        return contents(in("good.exr"));
    }

    /// A fault's text; "" if the file is read.
    std::string fault(const std::string& bytes) const {
        const auto path = put("bad.exr", bytes);
        try {
            readExr(path);
        } catch (const InputError& error) {
            EXPECT_EQ(error.faults().size(), 1U);
            EXPECT_EQ(error.faults()[0].where, SourceLocation{path.string()});
            EXPECT_EQ(error.faults()[0].message.find('\n'), std::string::npos);
            return error.faults()[0].message;
        }
        return {};
    }
};

/// Overwrites the value of an attribute in a file's bytes, `offset` bytes into it.
std::string withAttribute(std::string bytes, const std::string& nameAndType, std::size_t offset,
                          std::int32_t value) {
    constexpr std::size_t sizeField = 4;
    const std::size_t start = bytes.find(nameAndType);
    EXPECT_NE(start, std::string::npos);
    std::memcpy(bytes.data() + start + nameAndType.size() + sizeField + offset, &value, sizeof(value));
    return bytes;
}

const std::string dataWindow("dataWindow\0box2i\0", 17);
const std::string displayWindow("displayWindow\0box2i\0", 20);

TEST_F(ExrDamagedTest, TruncatedAnywhere) {
    const std::string whole = good();
    ASSERT_EQ(fault(whole), "");
    for (std::size_t length = 0; length < whole.size(); length += 1 + length / 40) {
        EXPECT_NE(fault(whole.substr(0, length)), "") << "of " << length << " bytes";
    }
    EXPECT_NE(fault(whole.substr(0, whole.size() - 1)), "");
}

TEST_F(ExrDamagedTest, ChangedBytesNeverCrash) {
    const std::string whole = good();
    std::mt19937 random(11);
    for (int i = 0; i < 3000; ++i) {
        std::string changed = whole;
        // Most changes go to the header, where they can do most harm.
        const std::size_t range = i % 4 == 0 ? changed.size() : 420;
        for (int k = 0; k < 1 + i % 3; ++k) changed[random() % range] = static_cast<char>(random());
        fault(changed);
    }
}

TEST_F(ExrDamagedTest, OtherFiles) {
    EXPECT_EQ(fault("P6 is another format"), "not a readable OpenEXR file: it does not start like one");
    EXPECT_EQ(fault(""), "not a readable OpenEXR file: it does not start like one");
}

TEST_F(ExrDamagedTest, DeepPixelsAreRefused) {
    std::string bytes = good();
    bytes[5] = static_cast<char>(bytes[5] | 0x08);  // bit 11 of the version field
    EXPECT_THAT(fault(bytes), HasSubstr("deep pixels"));
}

TEST_F(ExrDamagedTest, PathsThatAreNoFile) {
    EXPECT_THAT(messageOf<InputError>([&] { readExr(in("none.exr")); }),
                HasSubstr("none.exr: error: cannot be read: No such file or directory"));
    std::filesystem::create_directory(in("folder"));
    EXPECT_THAT(messageOf<InputError>([&] { readExr(in("folder")); }),
                HasSubstr("cannot be read: Is a directory"));
    ASSERT_EQ(::mkfifo(in("pipe").c_str(), 0600), 0);
    EXPECT_THAT(messageOf<InputError>([&] { readExr(in("pipe")); }), HasSubstr("cannot be read"));
}

TEST_F(ExrDamagedTest, WindowsBeyondTheFile) {
    const std::string whole = good();
    constexpr std::size_t right = 8;
    constexpr std::size_t bottom = 12;
    for (const std::string& window : {dataWindow, displayWindow}) {
        std::string wide = withAttribute(whole, window, right, 1 << 20);
        wide = withAttribute(wide, window, bottom, 1 << 20);
        EXPECT_THAT(fault(wide), HasSubstr("more than its"));
        EXPECT_THAT(fault(withAttribute(whole, window, right, 0x7fffffff)), HasSubstr("more than its"));
        EXPECT_THAT(fault(withAttribute(whole, window, right, -1)), HasSubstr("its window is empty"));
    }
    // Few enough pixels, but each row needs an entry in a table that is not there.
    EXPECT_THAT(fault(withAttribute(whole, dataWindow, bottom, 300000)), HasSubstr("ends before its pixels"));
}

TEST_F(ExrDamagedTest, AttributeLongerThanTheFile) {
    std::string bytes = good();
    const std::string name("scene\0string\0", 13);
    const std::int32_t size = 0x7ffffff0;
    std::memcpy(bytes.data() + bytes.find(name) + name.size(), &size, sizeof(size));
    EXPECT_EQ(fault(bytes), "not a readable OpenEXR file: the file ends within its header");
}

TEST_F(ExrDamagedTest, TilesBeyondTheFile) {
    Imf::Header header(8, 8);
    header.channels().insert("Y", Imf::Channel(Imf::FLOAT));
    header.setTileDescription(Imf::TileDescription(8, 8, Imf::ONE_LEVEL));
    { const Imf::TiledOutputFile file(in("tiled.exr").c_str(), header); }
    const std::string whole = contents(in("tiled.exr"));
    const std::string tiles("tiles\0tiledesc\0", 15);
    EXPECT_THAT(fault(withAttribute(withAttribute(whole, tiles, 0, 0x7fffffff), tiles, 4, 0x7fffffff)),
                HasSubstr("more than its"));
    EXPECT_THAT(fault(withAttribute(whole, tiles, 0, 0)), HasSubstr("its tiles are empty"));
}

TEST_F(ExrDamagedTest, SubsampledChannelsAreRefused) {
    // The first channel's record: its name "A", then type and flags (8 bytes), then the sampling in x and in
    // y.
    const std::string channels("channels\0chlist\0", 16);
    const std::size_t samplingX = std::string("A").size() + 1 + 8;
    EXPECT_THAT(fault(withAttribute(good(), channels, samplingX, 2)), HasSubstr("subsampled channels"));
}

}  // namespace
}  // namespace nephrite::image
