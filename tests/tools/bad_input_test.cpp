// What the program does with bad input: one clear line at the right place, status 2, nothing written.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "image/exr.h"
#include "program.h"

namespace nephrite::tools::test {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using testing::MatchesRegex;
using testing::Not;

const std::string camera =
    R"("camera": {"position": [0, 0, 40], "target": [0, 0, 0], "fovY": 36, "near": 1, "far": 100})";
const std::string light =
    R"("lights": [{"type": "point", "position": [30, 30, 10], "intensity": [1, 1, 1]}])";

std::string sceneWith(const std::string& objects, const std::string& cameraText = camera) {
    return "{" + cameraText + ", " + light + R"(, "materials": {}, "objects": [)" + objects + "]}";
}

class BadInput : public testing::Test {
  protected:
    /// Renders and expects a refusal: status 2, `where` (file:line:col or file), the words, and no picture.
    void expectRefused(const std::string& graph, const std::string& scene, const std::string& where,
                       const std::vector<std::string>& words) {
        const Answer answer = place_.run("render " + graph + (scene.empty() ? "" : " --scene " + scene) +
                                         " --size 64x64 -o picture.exr");
        EXPECT_EQ(answer.status, 2) << answer.errors;
        EXPECT_THAT(answer.errors, HasSubstr(where));
        EXPECT_THAT(answer.errors, HasSubstr(": error: "));
        for (const std::string& word : words) EXPECT_THAT(answer.errors, HasSubstr(word));
        EXPECT_FALSE(place_.isThere("picture.exr"));
        EXPECT_THAT(answer.errors, Not(HasSubstr("terminate")));
    }
    void expectGraphRefused(const std::string& text, const std::string& where,
                            const std::vector<std::string>& words) {
        place_.write("g.json", text);
        expectRefused("g.json", "", "g.json" + where, words);
    }
    void expectSceneRefused(const std::string& text, const std::string& where,
                            const std::vector<std::string>& words) {
        place_.write("s.json", text);
        expectRefused(graphFile("gbuffer.json"), "s.json", where, words);
    }

    std::string contents(const std::string& name) const {
        std::ostringstream text;
        text << std::ifstream(place_.path() / name, std::ios::binary).rdbuf();
        return text.str();
    }

    Workplace place_;
};

TEST_F(BadInput, MalformedJson) {
    expectGraphRefused("{\"name\": \"x\",\n  \"nodes\": {,}}", ":2:13", {});
}

TEST_F(BadInput, UnknownKey) {
    expectGraphRefused("{\"name\": \"x\",\n \"nodse\": {}, \"nodes\": {}, \"outputs\": {}}", ":2:2",
                       {"nodse", "did you mean \"nodes\"?"});
}

TEST_F(BadInput, DuplicateKey) {
    expectGraphRefused("{\"name\": \"x\",\n \"nodes\": {},\n \"nodes\": {}, \"outputs\": {}}", ":3:2",
                       {"nodes"});
}

TEST_F(BadInput, UnknownPass) {
    expectGraphRefused(
        "{\"name\": \"x\", \"nodes\": {\n \"a\": {\"pass\": \"gbufer\"}}, \"outputs\": {\"color\": "
        "\"a.normal\"}}",
        ":2:16", {"gbufer", "did you mean \"gbuffer\"?"});
}

TEST_F(BadInput, UnknownPort) {
    expectGraphRefused(
        "{\"name\": \"x\", \"nodes\": {\"a\": {\"pass\": \"gbuffer\"}},\n \"outputs\": {\"color\": "
        "\"a.normals\"}}",
        ":2:23", {"normals", "did you mean \"normal\"?"});
}

TEST_F(BadInput, RequiredInputUnconnected) {
    expectGraphRefused(
        "{\"name\": \"x\", \"nodes\": {\n \"a\": {\"pass\": \"layers\"}}, \"outputs\": {\"color\": "
        "\"a.thickness\"}}",
        ":2:", {"surface"});
}

TEST_F(BadInput, ParameterOfTheWrongType) {
    expectGraphRefused(
        "{\"name\": \"x\", \"nodes\": {\"g\": {\"pass\": \"gbuffer\"}, \"l\": {\"pass\": \"layers\", \"in\": "
        "{\"surface\": \"g.surface\"}},\n"
        " \"d\": {\"pass\": \"dipole-literal\", \"in\": {\"position\": \"g.position\", \"irradiance\": "
        "\"g.normal\", \"surface\": \"g.surface\",\n"
        " \"absorption\": \"l.absorption\", \"scattering\": \"l.scattering\"}, \"set\": {\"taps\": "
        "\"many\"}}},\n"
        " \"outputs\": {\"color\": \"d.radiance\"}}",
        ":3:79", {"taps", "many"});
}

TEST_F(BadInput, CycleNamedWhole) {
    place_.write(
        "p/copy.json",
        R"({"kind": "pixel", "shader": "copy.glsl", "doc": "A copy.", "inputs": {"source": {}}, "outputs": {"color": {"format": "rgba32f"}}})");
    place_.write("p/copy.glsl", "void pixel(ivec2 p) { store(color, p, load(source, p)); }");
    place_.write(
        "g.json",
        R"({"name": "x", "nodes": {"a": {"pass": "copy", "in": {"source": "c.color"}}, "b": {"pass": "copy", "in": {"source": "a.color"}},
        "c": {"pass": "copy", "in": {"source": "b.color"}}}, "outputs": {"color": "c.color"}})");
    const Answer answer = place_.run("render g.json --pass-path p -o picture.exr");
    EXPECT_EQ(answer.status, 2);
    EXPECT_THAT(answer.errors,
                MatchesRegex("g.json:[0-9]+:[0-9]+: error: [^\n]*(a -> b -> c -> a|b -> c -> a -> b|c -> a "
                             "-> b -> c|a -> c -> b -> a|b -> a -> c -> b|c -> b -> a -> c)[^\n]*\n"));
}

TEST_F(BadInput, Sizes) {
    for (const std::string size : {"[-4, 64]", "[64, 100000000]", "[0.5, 64]", "{\"scale\": -1}",
                                   "{\"scale\": 0}", "{\"scale\": 1e9}"})
        expectGraphRefused("{\"name\": \"x\", \"nodes\": {\"a\": {\"pass\": \"gbuffer\", \"size\": " + size +
                               "}},\n \"outputs\": {\"color\": \"a.normal\"}}",
                           ":1:", {});
    for (const std::string size : {"0x64", "-1x5", "64", "99999x2", "64x64x64", "axb"}) {
        const Answer answer =
            place_.run("render " + graphFile("paper.json") + " --size=" + size + " -o picture.exr");
        EXPECT_EQ(answer.status, 2) << size;
        EXPECT_THAT(answer.errors, HasSubstr("--size: error: "));
    }
}

TEST_F(BadInput, WhatIsReadIsNotWrittenOver) {
    std::filesystem::copy_file(std::filesystem::path(NEPHRITE_SOURCE_DIR) / "graphs/gbuffer.json",
                               place_.path() / "g.json");
    image::writeExr(place_.path() / "env.exr", {4, 2, {"R", "G", "B"}, std::vector<float>(24, 1.0F)});
    place_.write("s.json", "{" + camera + R"(, "environment": {"image": "env.exr"}, "objects": []})");
    place_.write("sweep.json", R"({"scenes": {"s": "s.json"}, "graphs": {"g": "g.json"}})");
    place_.write("pareto.json",
                 R"({"scenes": {"s": {"scene": "s.json"}}, "methods": {"g": {"graph": "g.json"}}})");
    std::filesystem::copy_file(place_.path() / "g.json", place_.path() / "pareto.csv");
    place_.write("suite.json",
                 R"({"scenes": {"s": {"scene": "s.json"}}, "methods": {"g": {"graph": "pareto.csv"}}})");
    for (const auto& [arguments, file] :
         {std::pair{"plan g.json -o g.json", "g.json"},
          std::pair{"render g.json --size 8x8 --timings ./g.json", "g.json"},
          std::pair{"render g.json --scene s.json --size 8x8 -o env.exr", "env.exr"},
          std::pair{"reference s.json --mode single --spp 2 --size 8x8 -o env.exr", "env.exr"},
          std::pair{"reference s.json --mode single --spp 2 --size 8x8 -o o.exr --stderr env.exr", "env.exr"},
          std::pair{"merge env.exr other.exr -o ./env.exr", "env.exr"},
          std::pair{"compare env.exr g.json --json g.json", "g.json"},
          std::pair{"profile --model montecarlo --layers g.json --radii 1 --json g.json", "g.json"},
          std::pair{"sweep sweep.json -o .", "sweep.json"},
          std::pair{"bench pareto pareto.json -o .", "pareto.json"},
          std::pair{"bench pareto pareto.json --json s.json", "s.json"},
          std::pair{"bench pareto suite.json -o .", "pareto.csv"}}) {
        const std::string before = contents(file);
        const Answer answer = place_.run(arguments);
        EXPECT_EQ(answer.status, 2) << arguments;
        EXPECT_THAT(answer.errors,
                    EndsWith(std::string(file) + ": error: this file is read, and would be overwritten\n"));
        EXPECT_EQ(contents(file), before) << arguments;
    }
}

TEST_F(BadInput, CommandLine) {
    EXPECT_THAT(place_.run("rendr").errors, HasSubstr("did you mean \"render\"?"));
    EXPECT_EQ(
        place_.run("render " + graphFile("paper.json") + " -o same.exr --dump gbuffer.position=./same.exr")
            .status,
        2);
    EXPECT_EQ(place_.run("render " + graphFile("paper.json") + " --timings t.txt").status, 2);
    for (const std::string arguments : {"", "paint", "render", "render --no-such-option x",
                                        "render x.json -o picture.gif", "plan x.json -o plan.doc"}) {
        const Answer answer = place_.run(arguments);
        EXPECT_EQ(answer.status, 2) << arguments;
        EXPECT_FALSE(answer.errors.empty());
    }
    EXPECT_EQ(place_.run("render " + graphFile("paper.json") + " --set weights=1 -o picture.exr").status, 2);
    EXPECT_EQ(
        place_.run("render " + graphFile("paper.json") + " --set wieghts=[1,1,1,1,1] -o picture.exr").status,
        2);
    EXPECT_EQ(place_.run("render " + graphFile("paper.json") + " --set dipole.taps=0 -o picture.exr").status,
              2);
    EXPECT_EQ(place_.run("render " + graphFile("paper.json") + " --dump gbuffer.positon=a.exr").status, 2);
    EXPECT_EQ(
        place_.run("render " + graphFile("paper.json") + " --device nosuchdevice -o picture.exr").status, 2);
    EXPECT_EQ(place_.run("render " + graphFile("paper.json") + " --pass-path none -o picture.exr").status, 2);
    EXPECT_FALSE(place_.isThere("picture.exr"));
}

TEST_F(BadInput, MissingFiles) {
    expectRefused("none.json", "", "none.json", {});
    expectRefused(graphFile("paper.json"), "none.json", "none.json", {});
}

TEST_F(BadInput, Scenes) {
    const std::string sphere = R"({"mesh": {"procedural": "sphere", "radius": 10}, "material": "apple"})";
    expectSceneRefused("{" + light + ", \"objects\": []}", "s.json:1:1", {"camera"});
    expectSceneRefused(
        sceneWith(sphere, R"("camera": {"position": [0,0,40], "target": [0,0,0], "near": 10, "far": 5})"),
        "s.json:1:", {"near"});
    expectSceneRefused(
        sceneWith(sphere, R"("camera": {"position": [0,0,40], "target": [0,0,0], "near": 1e-9, "far": 100})"),
        "s.json:1:", {"near"});
    expectSceneRefused(
        sceneWith(
            R"({"mesh": {"procedural": "sphere", "radius": 10}, "material": {"layers": [{"absorption": [-1, 0, 0], "scattering": [1, 1, 1]}]}})"),
        "s.json:1:293", {"not negative", "-1"});
    expectSceneRefused(sceneWith(R"({"mesh": {"procedural": "sphere", "radius": 10}, "material": "aple"})"),
                       "s.json:1:", {"did you mean \"apple\"?"});
}

TEST_F(BadInput, Meshes) {
    const auto object = [](const std::string& mesh) {
        return sceneWith("{\"mesh\": \"" + mesh + "\", \"material\": \"apple\"}");
    };
    expectSceneRefused(object("none.ply"), "none.ply", {});
    place_.write(
        "cut.ply",
        "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\nproperty float "
        "y\nproperty float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\nabc");
    expectSceneRefused(object("cut.ply"), "cut.ply", {});
    const std::string head =
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float "
        "z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n";
    place_.write("nan.ply", head + "0 0 nan\n1 0 0\n0 1 0\n3 0 1 2\n");
    expectSceneRefused(object("nan.ply"), "nan.ply", {});
    place_.write("range.ply", head + "0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n");
    expectSceneRefused(object("range.ply"), "range.ply", {"7"});
    place_.write("none-left.ply", head + "0 0 0\n1 0 0\n0 1 0\n3 0 1 1\n");
    expectSceneRefused(object("none-left.ply"), "none-left.ply", {"triangle"});
    expectSceneRefused(object("none-left.ply"), "s.json:1:", {});
}

TEST_F(BadInput, BrokenShader) {
    place_.write(
        "p/broken.json",
        R"({"kind": "pixel", "shader": "broken.glsl", "doc": "Broken.", "outputs": {"color": {"format": "rgba32f"}}})");
    place_.write("p/broken.glsl", "void pixel(ivec2 p) {\n    store(color, p, nothing);\n}\n");
    place_.write("g.json",
                 R"({"name": "x", "nodes": {"a": {"pass": "broken"}}, "outputs": {"color": "a.color"}})");
    const Answer answer = place_.run("render g.json --pass-path p -o picture.exr");
    EXPECT_EQ(answer.status, 2);
    EXPECT_THAT(answer.errors, HasSubstr("p/broken.glsl:2:"));
    EXPECT_THAT(answer.errors, HasSubstr("nothing"));
    EXPECT_FALSE(place_.isThere("picture.exr"));
}

TEST_F(BadInput, UnwritableOutputsFailWhileRunning) {
    place_.write("file", "not a folder");
    for (const std::string output : {"file/picture.exr", "no/such/folder/picture.png"}) {
        const Answer answer =
            place_.run("render " + graphFile("gbuffer.json") + " --size 64x64 -o " + output);
        EXPECT_EQ(answer.status, 1) << answer.errors;
        EXPECT_THAT(answer.errors, HasSubstr(output + ": error: "));
    }
    const Answer second =
        place_.run("render " + graphFile("gbuffer.json") + " --size 64x64 -o first.exr -o none/second.exr");
    EXPECT_EQ(second.status, 1);
    EXPECT_FALSE(place_.isThere("first.exr")) << "an output was written although another could not be";
    EXPECT_EQ(place_.run("schema graph > /dev/full #").status, 1);
    const Answer full =
        place_.run("render " + graphFile("gbuffer.json") + " --size 64x64 --timings /dev/full");
    EXPECT_EQ(full.status, 1);
    EXPECT_THAT(full.errors, HasSubstr("/dev/full: error: "));
}

}  // namespace
}  // namespace nephrite::tools::test
