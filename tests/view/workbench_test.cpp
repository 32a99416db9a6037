// Changes of what a window would show, without the window.
#include "view/workbench.h"

#include <gtest/gtest.h>

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
