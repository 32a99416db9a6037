// Ports made visible: the pass `display` against the CPU's tone map, and the nodes that show a port.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "image/exr.h"
#include "image/tone_map.h"
#include "pass_folder.h"

namespace nephrite::runtime::test {
namespace {

class Displays : public WithPasses {
  protected:
    /// Colours from deep black to far above white, some not finite, in two levels of two layers.
    SessionOptions colors() const {
        addPass("colors", "pixel", R"("outputs": {"color": {"format": "rgba32f", "mips": 2, "layers": 2},
                                                  "count": {"format": "r32u"}, "list": {"buffer": "uint", "count": 4}})",
                R"(void pixel(ivec2 p) {
                       float nan = uintBitsToFloat(0x7fc00000u);
                       float infinity = uintBitsToFloat(0x7f800000u);
                       for (int layer = 0; layer < 2; ++layer)
                           for (int level = 0; level < 2; ++level) {
                               vec3 value = vec3(p, 3) * exp2(float(p.x - 8)) * (p.y == 5 ? -1.0 : 1.0);
                               value += float(10 * layer + level);
                               if (p == ivec2(3, 2)) value.g = nan;
                               if (p == ivec2(4, 2)) value.b = -infinity;
                               storeLayer(color, p, layer, vec4(value, 0.25));
                               if (layer == 0) storeLevel(color, p / 2, 1, vec4(7, 0, 0, 1));
                           }
                       store(count, p, uvec4(p.x * 100, 0, 0, 0));
                       if (p.x < 4 && p.y == 0) list[p.x] = 1u;
                   })");
        return graph(R"("nodes": {"source": {"pass": "colors"}}, "outputs": {"color": "source.color"})");
    }
};

TEST_F(Displays, ShowWhatThePngWouldShow) {
    SessionOptions options = colors();
    options.display = graph::Display{"source.color", {}, {"exposure=0.7"}};
    Session session(options);
    session.renderFrame(0);
    const image::Image picture = session.read(graph::pictureName);
    const image::Image values = session.read(graph::valuesName, 0, 0);
    const image::ByteImage expected = image::toneMap(values, {0.7F, image::ToneCurve::PbrNeutral});
    for (std::uint32_t y = 0; y < 16; ++y) {
        for (std::uint32_t x = 0; x < 16; ++x) {
            if (x == 4 && y == 2) continue;  // not finite: below
            for (std::uint32_t c = 0; c < 3; ++c)
                EXPECT_NEAR(255 * picture.at(x, y, c), expected.pixels[(16 * y + x) * 3 + c], 1.01)
                    << x << " " << y << " " << c;
        }
    }
    const auto color = [&](std::uint32_t x, std::uint32_t y) {
        return std::array{picture.at(x, y, 0), picture.at(x, y, 1), picture.at(x, y, 2)};
    };
    EXPECT_EQ(color(3, 2), (std::array{1.0F, 0.0F, 1.0F}));
    EXPECT_EQ(color(4, 2), (std::array{0.0F, 1.0F, 0.0F}));
}

TEST_F(Displays, ShowOneChannelOfOneLevelAndLayer) {
    SessionOptions options = colors();
    options.display = graph::Display{"source.color", {}, {"curve=0", "channel=1"}};
    Session session(options);
    session.renderFrame(0);
    const float exposure = 0.5F / 17;
    session.set("(picture).exposure=" + std::to_string(exposure));
    session.set("(picture).layer=1");
    session.renderFrame(0);
    const image::Image values = session.read(graph::valuesName, 0, 1);
    const image::Image picture = session.read(graph::pictureName);
    for (const std::uint32_t c : {0U, 1U, 2U})
        EXPECT_NEAR(picture.at(6, 7, c), image::encodeSrgb(values.at(6, 7, 0) * exposure), 0.005);
    EXPECT_THROW(session.read(graph::valuesName, 0, 2), RunError);
    EXPECT_THROW(session.read(graph::valuesName, 2, 0), RunError);
}

TEST_F(Displays, ShowTheDistanceFromAReference) {
    image::Image reference{16, 16, {"R", "G", "B"}, std::vector<float>(16 * 16 * 3, 2)};
    image::writeExr(folder_.path() / "reference.exr", reference);
    SessionOptions options = colors();
    options.display = graph::Display{
        "source.color", folder_.path() / "reference.exr", {"curve=0", "exposure=0.1", "difference=true"}};
    Session session(options);
    session.renderFrame(0);
    const image::Image values = session.read(graph::valuesName, 0, 0);
    const image::Image picture = session.read(graph::pictureName);
    EXPECT_NEAR(picture.at(8, 8, 0), image::encodeSrgb(0.1F * std::abs(values.at(8, 8, 0) - 2)), 0.005);
    EXPECT_NEAR(session.read(graph::referenceName).at(8, 8, 0), image::encodeSrgb(0.2F), 0.005);
}

TEST_F(Displays, ShowUnsignedIntegers) {
    SessionOptions options = colors();
    options.display = graph::Display{"source.count", {}, {"curve=0", "channel=1", "exposure=0.001"}};
    Session session(options);
    session.renderFrame(0);
    EXPECT_NEAR(session.read(graph::pictureName).at(5, 3, 2), image::encodeSrgb(0.5F), 0.005);
}

TEST_F(Displays, ABufferIsNoPicture) {
    SessionOptions options = colors();
    options.display = graph::Display{"source.list", {}, {}};
    EXPECT_THROW(Session{options}, InputError);
}

TEST_F(Displays, APortThatIsGoneGivesWayToTheFirstOutput) {
    SessionOptions options = colors();
    options.display = graph::Display{"nobody.color", {}, {}};
    Session session(options);
    session.renderFrame(0);
    EXPECT_EQ(session.read(graph::valuesName, 0, 0).at(2, 1, 2), session.read("color", 0, 0).at(2, 1, 2));
    ASSERT_TRUE(session.exported(graph::pictureName));
    EXPECT_EQ(session.exported(graph::pictureName)->part.layers, 1U);
}

}  // namespace
}  // namespace nephrite::runtime::test
