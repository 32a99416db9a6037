// Levels, layers, modified inputs and imported images, on the device under synchronization validation.
#include <array>

#include "image/exr.h"
#include "pass_folder.h"

namespace nephrite::runtime {
namespace {

using test::valueAt;

/// Both ways of reading images.
class Resources : public test::WithPasses, public testing::WithParamInterface<graph::InputReads> {
  protected:
    Session render(const std::string& members) const {
        SessionOptions options = graph(members);
        options.inputReads = GetParam();
        Session session(options);
        for (int frame = 0; frame < 2; ++frame) session.renderFrame(0);
        return session;
    }
    void addRamp() const {
        addPass("ramp", "pixel", R"("outputs": {"color": {"format": "rgba32f"}})",
                "void pixel(ivec2 p) { store(color, p, vec4(p, 0.0, 1.0)); }");
    }
};

// The mean of a 16 x 16 ramp x + 16 y is 7.5 + 16 * 7.5.
TEST_P(Resources, APassMakesEachLevelFromTheOneAbove) {
    addPass("ramp16", "pixel", R"("outputs": {"color": {"format": "r32f"}})",
            "void pixel(ivec2 p) { store(color, p, vec4(p.x + 16 * p.y)); }");
    addPass("pyramid", "pixel", R"("forEach": "mips", "inputs": {"source": {}},
                "outputs": {"color": {"format": "r32f", "mips": 0}})",
            R"(void pixel(ivec2 p) {
                   if (iteration == 0u) { store(color, p, load(source, p)); return; }
                   int above = int(iteration) - 1;
                   vec4 sum = vec4(0.0);
                   for (int i = 0; i < 4; ++i) sum += load(color, 2 * p + ivec2(i & 1, i >> 1), above);
                   store(color, p, sum / 4.0);
               })");
    addPass("top", "pixel",
            R"("inputs": {"last": {}, "second": {}}, "outputs": {"color": {"format": "rg32f"}})",
            "void pixel(ivec2 p) { store(color, p, vec4(load(last, ivec2(0)).x, load(second, ivec2(7, 7)).x, "
            "0.0, 0.0)); }");
    Session session = render(R"json("nodes": {"source": {"pass": "ramp16"},
        "pyramid": {"pass": "pyramid", "in": {"source": "source.color"}},
        "top": {"pass": "top", "in": {"last": "mip(pyramid.color, 4)", "second": "mip(pyramid.color, 1)"}}},
        "outputs": {"color": "top.color", "level": "mip(pyramid.color, 1)"})json");
    EXPECT_EQ(valueAt(session, "color", 0, 0, 0), 7.5F + 16 * 7.5F);
    EXPECT_EQ(valueAt(session, "color", 0, 0, 1), 14.5F + 16 * 14.5F);
    EXPECT_EQ(session.read("level").width, 8U);
    EXPECT_EQ(valueAt(session, "level", 0, 0), 0.5F + 16 * 0.5F);
}

TEST_P(Resources, OneLayerAloneIsAnImage) {
    addPass(
        "stack", "pixel", R"("outputs": {"color": {"format": "rgba32f", "layers": 3}})",
        "void pixel(ivec2 p) { for (int i = 0; i < 3; ++i) storeLayer(color, p, i, vec4(p, 10 + i, 1.0)); }");
    addPass("pick", "pixel",
            R"("inputs": {"first": {}, "last": {}}, "outputs": {"color": {"format": "rgba32f"}})",
            "void pixel(ivec2 p) { store(color, p, vec4(load(first, p).z, load(last, p).z, layers(last), "
            "0.0)); }");
    Session session = render(R"json("nodes": {"stack": {"pass": "stack"},
        "pick": {"pass": "pick", "in": {"first": "layer(stack.color, 0)", "last": "layer(stack.color, 2)"}}},
        "outputs": {"color": "pick.color", "middle": "layer(stack.color, 1)"})json");
    EXPECT_EQ(valueAt(session, "color", 5, 6, 0), 10);
    EXPECT_EQ(valueAt(session, "color", 5, 6, 1), 12);
    EXPECT_EQ(valueAt(session, "color", 5, 6, 2), 1);
    EXPECT_EQ(valueAt(session, "middle", 5, 6, 2), 11);
}

// The reader's shader has no use for its input, and the compiler of shaders leaves it out.
TEST_P(Resources, WhatComesBehindAReaderThatReadsNothingWaitsForTheWriter) {
    addRamp();
    addPass("deaf", "pixel", R"("inputs": {"image": {}}, "outputs": {"color": {"format": "rgba32f"}})",
            "void pixel(ivec2 p) { store(color, p, vec4(7.0)); }");
    addPass(
        "add", "pixel",
        R"("inputs": {"image": {}, "more": {}}, "outputs": {"color": {"format": "rgba32f", "modifies": "image"}})",
        "void pixel(ivec2 p) { store(color, p, load(image, p) + load(more, p)); }");
    Session session = render(R"json("nodes": {"ramp": {"pass": "ramp"}, "copied": {"pass": "ramp"},
        "deaf": {"pass": "deaf", "in": {"image": "ramp.color"}},
        "deafToo": {"pass": "deaf", "in": {"image": "copied.color"}},
        "add": {"pass": "add", "in": {"image": "ramp.color", "more": "deaf.color"}}},
        "outputs": {"color": "add.color", "copied": "copied.color", "deaf": "deafToo.color"})json");
    EXPECT_EQ(valueAt(session, "color", 3, 4, 0), 3 + 7);
    EXPECT_EQ(valueAt(session, "copied", 3, 4, 1), 4);
    EXPECT_EQ(valueAt(session, "deaf", 3, 4, 1), 7);
}

TEST_P(Resources, AComputePassModifiesItsInput) {
    addRamp();
    addPass("double", "pixel",
            R"("inputs": {"image": {}}, "outputs": {"color": {"format": "rgba32f", "modifies": "image"}})",
            "void pixel(ivec2 p) { if (p.x >= 8) store(color, p, load(image, p) * 2.0); }");
    Session session = render(R"json("nodes": {"ramp": {"pass": "ramp"},
        "once": {"pass": "double", "in": {"image": "ramp.color"}},
        "twice": {"pass": "double", "in": {"image": "once.color"}}},
        "outputs": {"color": "twice.color"})json");
    EXPECT_EQ(valueAt(session, "color", 5, 3, 1), 3) << "not written, so it stays";
    EXPECT_EQ(valueAt(session, "color", 9, 3, 0), 36);
    EXPECT_EQ(valueAt(session, "color", 9, 3, 1), 12);
}

TEST_P(Resources, ReadersOfTheOlderVersionComeBeforeItIsModified) {
    addRamp();
    addPass("double", "pixel",
            R"("inputs": {"image": {}}, "outputs": {"color": {"format": "rgba32f", "modifies": "image"}})",
            "void pixel(ivec2 p) { store(color, p, load(image, p) * 2.0); }");
    addPass("both", "pixel",
            R"("inputs": {"old": {}, "new": {}}, "outputs": {"color": {"format": "rgba32f"}})",
            "void pixel(ivec2 p) { store(color, p, vec4(load(old, p).x, load(new, p).x, 0.0, 0.0)); }");
    addPass("copy", "pixel", R"("inputs": {"source": {}}, "outputs": {"color": {"format": "rgba32f"}})",
            "void pixel(ivec2 p) { store(color, p, load(source, p)); }");
    Session session = render(R"json("nodes": {"ramp": {"pass": "ramp"},
        "double": {"pass": "double", "in": {"image": "ramp.color"}},
        "copy": {"pass": "copy", "in": {"source": "ramp.color"}},
        "both": {"pass": "both", "in": {"old": "copy.color", "new": "double.color"}}},
        "outputs": {"color": "both.color"})json");
    EXPECT_EQ(valueAt(session, "color", 7, 0, 0), 7);
    EXPECT_EQ(valueAt(session, "color", 7, 0, 1), 14);
}

TEST_P(Resources, ABufferIsModifiedInPlace) {
    addPass("numbers", "compute", R"("outputs": {"list": {"buffer": "float", "count": 100}})",
            "void compute(uvec3 id) { if (id.x < 100u) list[id.x] = float(id.x); }");
    addPass(
        "squares", "compute",
        R"("inputs": {"list": {"buffer": "float"}}, "outputs": {"squared": {"buffer": "float", "modifies": "list"}})",
        "void compute(uvec3 id) { if (id.x < 100u) squared[id.x] = list[id.x] * list[id.x]; }");
    addPass("show", "pixel",
            R"("inputs": {"list": {"buffer": "float"}}, "outputs": {"color": {"format": "r32f"}})",
            "void pixel(ivec2 p) { store(color, p, vec4(p.y < 6 ? list[p.x + 16 * p.y] : 0.0)); }");
    Session session = render(R"json("nodes": {"numbers": {"pass": "numbers"},
        "squares": {"pass": "squares", "in": {"list": "numbers.list"}},
        "show": {"pass": "show", "in": {"list": "squares.squared"}}}, "outputs": {"color": "show.color"})json");
    EXPECT_EQ(valueAt(session, "color", 3, 2), 35 * 35);
}

TEST_P(Resources, ARasterPassDrawsOverItsInput) {
    addRamp();
    addPass("draw", "raster",
            R"("inputs": {"image": {}}, "outputs": {"color": {"format": "rgba32f", "modifies": "image"}})",
            "void fragment(Fragment f) { store(color, f.pixel, vec4(-1.0)); }");
    Session session = render(
        R"json("nodes": {"ramp": {"pass": "ramp"}, "draw": {"pass": "draw", "in": {"image": "ramp.color"}}},
        "outputs": {"color": "draw.color"})json");
    EXPECT_EQ(valueAt(session, "color", 15, 0, 0), 15) << "the object does not cover the corner";
    EXPECT_EQ(valueAt(session, "color", 8, 8, 0), -1);
}

TEST_P(Resources, AnImportedImageIsReadAndGivenBack) {
    image::Image picture;
    picture.width = 4;
    picture.height = 3;
    picture.channels = {"R", "G", "B", "A"};
    for (int i = 0; i < 4 * 3 * 4; ++i) picture.pixels.push_back(static_cast<float>(i) * 0.125F);
    image::writeExr(folder_.path() / "table.exr", picture);
    addPass(
        "copy", "pixel",
        R"("inputs": {"source": {}}, "outputs": {"color": {"format": "rgba32f", "size": {"like": "source"}}})",
        "void pixel(ivec2 p) { store(color, p, load(source, p)); }");
    for (const char* format : {"rgba32f", "rgba16f"}) {
        Session session =
            render(std::string(R"json("imports": {"table": {"image": "table.exr", "format": ")json") +
                   format + R"json("}},
            "nodes": {"copy": {"pass": "copy", "in": {"source": "import(table)"}}},
            "outputs": {"color": "copy.color", "table": "import(table)"})json");
        EXPECT_EQ(session.read("color").pixels, picture.pixels) << format;
        EXPECT_EQ(session.read("table").pixels, picture.pixels) << format;
    }
}

INSTANTIATE_TEST_SUITE_P(BothWaysOfReading, Resources,
                         testing::Values(graph::InputReads::StorageImage, graph::InputReads::SampledImage),
                         [](const auto& way) {
                             return way.param == graph::InputReads::StorageImage ? "storage" : "sampled";
                         });

}  // namespace
}  // namespace nephrite::runtime
