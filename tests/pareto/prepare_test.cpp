// What is wrong with what a suite names is found before anything is rendered, at its place in the suite.
#include "pareto/prepare.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scratch_folder.h"
#include "text/faults.h"

namespace nephrite::pareto {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

const std::string graphs = NEPHRITE_SOURCE_DIR "/graphs/";
const std::string sphere = "{\"scene\": \"" + graphs + "scenes/sphere.json\"}";

void prepare(const std::string& text, const std::string& file) {
    const Suite suite = readSuite(json::parse(text, file));
    prepareSuite(suite, Selection(), {});
}

std::string suiteOf(const std::string& scenes, const std::string& method) {
    return "{\"scenes\": {" + scenes + "},\n \"methods\": {\"m\": " + method + "}}";
}

/// The last fault is at the @ of the suite; faults of a file that the suite names stand before it.
void expectFault(const std::string& marked, const std::string& message, std::size_t count = 1) {
    const ScratchFolder folder;
    const std::string file = (folder.path() / "suite.json").string();
    const tests::MarkedText text = tests::unmarked(marked);
    const auto faults = tests::faultsOf([&] { prepare(text.text, file); });
    ASSERT_EQ(faults.size(), count) << marked;
    EXPECT_THAT(faults.back(), StartsWith(file + ":" + text.place + ": error: ")) << marked;
    EXPECT_THAT(faults, Contains(HasSubstr(message))) << marked;
}

/// A fault of a method "m" whose graph is one of the project's.
void expectMethodFault(const std::string& graph, const std::string& members, const std::string& message) {
    expectFault(suiteOf("\"s\": " + sphere, "{\"graph\": \"" + graphs + graph + "\",\n  " + members + "}"),
                message);
}

TEST(Preparation, NamesTheSuitesLineOfAFileThatIsMissing) {
    expectFault(suiteOf("\"s\": {\"scene\": @\"nofile.json\"}", "{\"graph\": \"g.json\"}"),
                "cannot use the scene", 2);
    expectFault(suiteOf("\"s\": " + sphere, "{\"graph\": @\"nofile.json\"}"),
                "the method \"m\" cannot use the graph", 2);
}

TEST(Preparation, NamesThePlaceOfASetting) {
    expectMethodFault("lambert-albedo.json", "\"set\": {@\"lightSiz\": 1}", "did you mean \"lightSize\"?");
    expectMethodFault("lambert-albedo.json", "\"vary\": {\"lightSize\": [64, @\"big\"]}", "a number");
    expectMethodFault("lambert-albedo.json", "\"vary\": {@\"lightSiz\": [64]}", "lightSize");
    expectMethodFault("paper.json", "\"set\": {\"weights\": [1,\n 2, 3, @true, 1]}", "expected");
    expectMethodFault("lambert-albedo.json", "\"set\": {@\"gbufer.x\": 1}", "no node \"gbufer\"");
}

TEST(Preparation, NamesThePlaceOfAPort) {
    expectMethodFault("screen-space.json", "\"against\": {\"dipole\": @\"multipel.radiance\"}",
                      "did you mean \"multiple\"?");
    expectMethodFault("screen-space.json", "\"against\": {\"volume\": @\"colour\"}",
                      "did you mean \"color\"?");
    expectMethodFault("screen-space.json", "\"against\": {\"volume\": @\"a.b.c\"}", "a.b.c");
}

/// The second scene's fault is found although the first could be rendered for hours.
TEST(Preparation, RefusesADipoleOfATexturedLayer) {
    const ScratchFolder folder;
    const auto scene = folder.write("textured.json", R"({"camera": {"position": [0, 0, 40]},
 "objects": [{"mesh": {"procedural": "sphere", "radius": 1}, "material": {"layers": [
   {"absorption": {"texture": "nowhere.exr", "channel": "R", "scale": 1}, "scattering": [1, 1, 1]}]}}]})");
    image::writeExr(folder.path() / "nowhere.exr", {1, 1, {"R"}, {1}});
    const auto textured = [&](const std::string& reference) {
        return suiteOf(
            "\"s\": " + sphere + ", \"t\": {\"scene\": \"" + scene.string() + "\", \"references\": {" +
                reference + ": {}}}",
            "{\"graph\": \"" + graphs + "screen-space.json\", \"against\": {\"dipole\": \"color\"}}");
    };
    expectFault(textured("@\"dipole\""), "this layer is textured", 2);
    EXPECT_THAT(tests::faultsOf([&] { prepare(textured("\"volume\""), "suite.json"); }), ElementsAre());
}

TEST(Preparation, HasEveryPoint) {
    const Suite suite = readSuite(json::parse(
        suiteOf("\"s\": " + sphere,
                "{\"graph\": \"" + graphs +
                    "screen-space.json\", \"vary\": {\"mostTaps\": [8, "
                    "16]}, \"against\": {\"dipole\": \"multiple.radiance\", \"volume\": \"color\"}}"),
        "suite.json"));
    const Preparation preparation = prepareSuite(suite, Selection(), {});
    ASSERT_EQ(preparation.tasks.size(), 1U);
    EXPECT_EQ(preparation.tasks[0].points.size(), 2U);
    EXPECT_TRUE(preparation.leftOut.empty());
}

}  // namespace
}  // namespace nephrite::pareto
