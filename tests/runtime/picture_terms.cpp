// The terms of the paper's picture are finite and lit, and a request gives the same bits each time.
#include <gtest/gtest.h>

#include <cmath>

#include "picture_support.h"

namespace nephrite::pictures {
namespace {

constexpr int size = 128;
const std::vector<std::string> terms{"ssao.radiance", "specular.radiance", "refraction.radiance",
                                     "single-scatter.radiance", "dipole.radiance"};

SceneText glossyScene() {
    SceneText scene;
    scene.environment = "[0.2, 0.3, 0.4]";
    return scene;
}

TEST(Picture, EveryTermIsFiniteAndLit) {
    runtime::Session session = render(glossyScene(), size, terms);
    for (const std::string& term : terms) {
        const image::Image image = session.read(term);
        for (const float value : image.pixels) {
            ASSERT_TRUE(std::isfinite(value)) << term;
            ASSERT_GE(value, 0) << term;
        }
        EXPECT_GT(brightness(image, {0, 0}, {size, size}), 0) << term << " is black";
    }
}

TEST(Picture, TheSameRequestGivesTheSameBits) {
    runtime::Session first = render(glossyScene(), size, terms);
    runtime::Session second = render(glossyScene(), size, terms);
    for (const std::string& term : terms)
        EXPECT_EQ(first.read(term).pixels, second.read(term).pixels) << term;
    const image::Image before = first.read("color");
    EXPECT_EQ(before.pixels, second.read("color").pixels);
    first.renderFrame(0);
    EXPECT_EQ(first.read("color").pixels, before.pixels) << "the second frame of a session differs";
}

TEST(Picture, WithoutALightOnlyTheEnvironmentShines) {
    SceneText scene = glossyScene();
    scene.light = "";
    runtime::Session session = render(scene, size, terms);
    EXPECT_GT(brightness(session.read("ssao.radiance"), {0, 0}, {size, size}), 0);
    EXPECT_EQ(brightness(session.read("specular.radiance"), {0, 0}, {size, size}), 0);
    EXPECT_EQ(brightness(session.read("single-scatter.radiance"), {0, 0}, {size, size}), 0);
    scene.environment = "[0, 0, 0]";
    EXPECT_EQ(brightness(render(scene, size, {}).read("color"), {0, 0}, {size, size}), 0);
}

}  // namespace
}  // namespace nephrite::pictures
