// `render --watch` as a user has it running beside an editor.
#include <gmock/gmock.h>

#include <chrono>
#include <thread>

#include "image/exr.h"
#include "program.h"
#include "running.h"

namespace nephrite::tools::test {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;

class Watch : public testing::Test {
  protected:
    Watch() {
        place_.write(
            "passes/flat.json",
            R"({"kind": "pixel", "shader": "flat.glsl", "outputs": {"color": {"format": "rgba32f"}}})");
        writeShader("1.0");
        place_.write("graph.json",
                     R"({"nodes": {"flat": {"pass": "flat"}}, "outputs": {"color": "flat.color"}})");
    }
    void writeShader(const std::string& value) const {
        place_.write("passes/flat.glsl",
                     "void pixel(ivec2 p) {\n    store(color, p, vec4(" + value + "));\n}\n");
    }
    std::vector<std::string> arguments() const {
        return {"render", "graph.json", "--pass-path", "passes", "--size", "8x8", "-o", "out.exr", "--watch"};
    }
    float value() const {
        const std::filesystem::path file = place_.path() / "out.exr";
        return std::filesystem::exists(file) ? image::readExr(file).image.at(3, 3, 0) : -1.0F;
    }
    template<class Condition>
    static bool comesTrue(Condition condition) {
        for (int i = 0; i < 600 && !condition(); ++i) std::this_thread::sleep_for(20ms);
        return condition();
    }

    Workplace place_;
};

TEST_F(Watch, WritesThePictureAgainWheneverAFileIsSaved) {
    Running program(place_.path(), arguments());
    EXPECT_TRUE(comesTrue([&] { return value() == 1; }));
    writeShader("2.0");
    EXPECT_TRUE(comesTrue([&] { return value() == 2; })) << program.log();
    EXPECT_TRUE(comesTrue([&] { return program.log().find("rendered 1 frame") != std::string::npos; }));
    EXPECT_THAT(program.log(), HasSubstr("reloaded flat.glsl in "));
    writeShader("wrong");
    EXPECT_TRUE(comesTrue([&] { return program.log().find("error") != std::string::npos; }));
    EXPECT_THAT(program.log(), HasSubstr("passes/flat.glsl:2:26: error: 'wrong'"));
    EXPECT_EQ(value(), 2);
    writeShader("3.0");
    EXPECT_TRUE(comesTrue([&] { return value() == 3; })) << program.log();
    EXPECT_EQ(program.interrupt(), 0);
}

TEST_F(Watch, MarksReloadsInTheTrace) {
    std::vector<std::string> words = arguments();
    words.insert(words.end(), {"--timings", "t.trace.json"});
    Running program(place_.path(), words);
    const auto trace = [this] { return contents(place_.path() / "t.trace.json"); };
    EXPECT_TRUE(comesTrue([&] { return trace().find("frame 0") != std::string::npos; }));
    EXPECT_EQ(trace().find("\"reload\""), std::string::npos);
    writeShader("wrong");
    EXPECT_TRUE(comesTrue([&] { return program.log().find("error") != std::string::npos; }));
    writeShader("3.0");
    EXPECT_TRUE(comesTrue([&] { return trace().find("frame 1") != std::string::npos; })) << program.log();
    EXPECT_THAT(trace(), HasSubstr("\"reload refused\""));
    EXPECT_THAT(trace(), HasSubstr("\"reload\""));
    EXPECT_THAT(trace(), HasSubstr("reloaded flat.glsl in "));
    EXPECT_EQ(program.interrupt(), 0);
}

TEST_F(Watch, AnOutputThatCannotBeWrittenIsNamedAndTriedAgainAtTheNextSave) {
    std::filesystem::create_directory(place_.path() / "out");
    std::vector<std::string> words = arguments();
    words.insert(words.end(), {"--dump", "flat.color=out/dump.exr"});
    Running program(place_.path(), words);
    const std::filesystem::path dump = place_.path() / "out" / "dump.exr";
    EXPECT_TRUE(comesTrue([&] { return std::filesystem::exists(dump); })) << program.log();
    std::filesystem::rename(place_.path() / "out", place_.path() / "moved");
    writeShader("2.0");
    EXPECT_TRUE(comesTrue([&] { return program.log().find("out/dump.exr: error: ") != std::string::npos; }))
        << program.log();
    std::filesystem::create_directory(place_.path() / "out");
    writeShader("3.0");
    EXPECT_TRUE(comesTrue([&] { return std::filesystem::exists(dump); })) << program.log();
    EXPECT_EQ(program.interrupt(), 0);
}

TEST_F(Watch, AnOutputThatCannotBeWrittenDoesNotKeepTheOthersBack) {
    std::vector<std::string> words = arguments();
    words.insert(words.end(), {"--dump", "flat.color=dump.exr", "--timings", "t.json"});
    Running program(place_.path(), words);
    EXPECT_TRUE(comesTrue([&] { return place_.isThere("t.json"); })) << program.log();
    const auto timings = [this] { return contents(place_.path() / "t.json"); };
    const std::string before = timings();
    std::filesystem::remove(place_.path() / "out.exr");
    std::filesystem::create_directory(place_.path() / "out.exr");
    std::filesystem::remove(place_.path() / "dump.exr");
    writeShader("2.0");
    EXPECT_TRUE(comesTrue([&] { return timings() != before; })) << program.log();
    EXPECT_TRUE(place_.isThere("dump.exr"));
    EXPECT_THAT(program.log(), HasSubstr("out.exr: error: "));
    EXPECT_EQ(program.interrupt(), 0);
}

TEST_F(Watch, WhatItWritesItselfIsNoReasonToRenderAgain) {
    std::vector<std::string> words = arguments();
    words.insert(words.end(), {"--timings", "t.json"});
    Running program(place_.path(), words);
    EXPECT_TRUE(comesTrue([&] { return place_.isThere("t.json"); })) << program.log();
    writeShader("2.0");
    EXPECT_TRUE(comesTrue([&] { return value() == 2; })) << program.log();
    std::this_thread::sleep_for(500ms);
    const std::string log = program.log();
    EXPECT_EQ(log.find("rendered"), log.rfind("rendered")) << log;
    EXPECT_EQ(program.interrupt(), 0);
}

TEST_F(Watch, AGraphThatBeginsToReadAnOutputIsNotRendered) {
    Running program(place_.path(), arguments());
    EXPECT_TRUE(comesTrue([&] { return value() == 1; }));
    place_.write("graph.json",
                 R"({"imports": {"before": {"image": "out.exr"}}, "nodes": {"flat": {"pass": "flat"}},
                     "outputs": {"color": "flat.color"}})");
    EXPECT_TRUE(comesTrue([&] { return program.log().find("this file is read") != std::string::npos; }))
        << program.log();
    EXPECT_EQ(program.interrupt(), 0);
}

TEST_F(Watch, AGraphWithoutThePictureIsNamedAndGoesOn) {
    Running program(place_.path(), arguments());
    EXPECT_TRUE(comesTrue([&] { return value() == 1; }));
    place_.write("graph.json",
                 R"({"nodes": {"flat": {"pass": "flat"}}, "outputs": {"other": "flat.color"}})");
    EXPECT_TRUE(comesTrue([&] { return program.log().find("\"color\"") != std::string::npos; }));
    EXPECT_EQ(program.interrupt(), 0);
}

}  // namespace
}  // namespace nephrite::tools::test
