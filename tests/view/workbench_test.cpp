// Changes of what a window would show, without the window.
#include "view/workbench.h"

#include <gmock/gmock.h>

#include "scratch_folder.h"
#include "text/diagnostics.h"

namespace nephrite::view {
namespace {

class WorkbenchTest : public testing::Test {
  protected:
    /// A pass that fills every level of its output, whose chain ends at one texel.
    void addPass(const std::string& name, const std::string& value) const {
        folder_.write("passes/" + name + ".json",
                      R"({"kind": "pixel", "shader": ")" + name +
                          R"(.glsl", "outputs": {"color": {"format": "rgba32f", "mips": 0}}})");
        folder_.write("passes/" + name + ".glsl",
                      "void pixel(ivec2 p) { store(color, p, " + value + "); }\n");
    }
    runtime::SessionOptions options() const {
        addPass("even", "vec4(1.0)");
        addPass("dark", "vec4(0.25)");
        addPass("broken", "nothing");
        runtime::SessionOptions options;
        options.graph = folder_.write("graph.json", text_);
        options.passPaths = {folder_.path() / "passes"};
        options.size = {16, 16};
        return options;
    }

    static std::string valuedWith(const std::string& value, const std::string& greatest) {
        return R"({"parameters": {"k": {"value": )" + value + R"(, "range": [0, )" + greatest +
               R"(]}}, "nodes": {"fill": {"pass": "even", "forEach": "mips"}}, "outputs": {"color": "fill.color"}})";
    }

    const std::string text_ =
        R"({"nodes": {"fill": {"pass": "even", "forEach": "mips"}}, "outputs": {"color": "fill.color"}})";
    ScratchFolder folder_;
    Workbench bench_{options(), [] {}};
};

TEST_F(WorkbenchTest, AnEditThatCannotBeShownIsNotMade) {
    EXPECT_THROW(bench_.swapPass("fill", "broken"), InputError);
    EXPECT_EQ(bench_.document().text(), text_);
    EXPECT_FALSE(bench_.document().isModified());
    bench_.render();
    EXPECT_EQ(bench_.values().at(0, 0, 0), 1.0F);
    bench_.swapPass("fill", "dark");
    bench_.render();
    EXPECT_EQ(bench_.values().at(0, 0, 0), 0.25F);
    folder_.write("passes/even.glsl", "broken");
    EXPECT_THROW(bench_.undo(), InputError) << "the pass of before has been broken since";
    EXPECT_NE(bench_.document().text(), text_);
}

TEST_F(WorkbenchTest, SaysWhatBecameOfEditsWhenOthersSavedToo) {
    const std::string file = folder_.write("valued.json", valuedWith("1", "9"));
    runtime::SessionOptions valued = options();
    valued.graph = file;
    Workbench bench(valued, [] {});
    bench.set("k", "4", document::Gesture::Starts);
    EXPECT_EQ(bench.document().savedParameters().at(0).value.components.at(0), 1);
    EXPECT_TRUE(bench.takeNotes().empty());
    folder_.write("valued.json", valuedWith("2", "9"));
    bench.save();
    EXPECT_THAT(bench.takeNotes(), testing::ElementsAre(testing::HasSubstr("the edit here stands")));
    bench.set("k", "7", document::Gesture::Starts);
    folder_.write("valued.json", valuedWith("3", "5"));
    bench.save();
    EXPECT_THAT(bench.takeNotes(), testing::ElementsAre(testing::HasSubstr("was dropped")));
    EXPECT_TRUE(bench.takeNotes().empty());
}

TEST_F(WorkbenchTest, KnowsWhichFilesItReads) {
    EXPECT_TRUE(bench_.reads(folder_.path() / "graph.json"));
    EXPECT_TRUE(bench_.reads(folder_.path() / "passes/even.glsl"));
    EXPECT_FALSE(bench_.reads(folder_.write("passes/dark.txt", "")));
    EXPECT_FALSE(bench_.reads(folder_.path() / "new.exr"));
}

TEST_F(WorkbenchTest, LevelsAndLayersAreThoseOfThePort) {
    bench_.render();
    PictureChoice choice = bench_.choice();
    choice.level = 4;  // 16, 8, 4, 2, 1
    bench_.look(choice);
    bench_.render();
    EXPECT_EQ(bench_.values().width, 1U);
    choice.level = 5;
    EXPECT_THROW(bench_.look(choice), InputError);
    choice.level = 0;
    choice.layer = 1;
    EXPECT_THROW(bench_.look(choice), InputError);
    EXPECT_EQ(bench_.choice().level, 4U);
}

TEST_F(WorkbenchTest, ALevelThatIsGoneGivesWayToTheLastThereIs) {
    PictureChoice choice = bench_.choice();
    choice.level = 4;
    bench_.look(choice);
    bench_.resize({4, 4});
    bench_.render();
    EXPECT_EQ(bench_.choice().level, 2U);
    EXPECT_EQ(bench_.values().width, 1U);
}

}  // namespace
}  // namespace nephrite::view
