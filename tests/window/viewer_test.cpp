// The viewer in a real window, with a real mouse.
#include <gmock/gmock.h>

#include <chrono>
#include <thread>

#include "image/exr.h"
#include "running_viewer.h"
#include "screen.h"

namespace nephrite::view {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

class ViewerWindow : public testing::Test {
  protected:
    void SetUp() override {
        if (!test::Screen::isAvailable()) GTEST_SKIP() << "needs Xvfb and openbox";
        screen_ = std::make_unique<test::Screen>();
        viewer_ = std::make_unique<test::RunningViewer>();
        window_ = screen_->windowNamed("paper.json - Nephrite");
        ASSERT_NE(window_, 0U) << viewer_->condition() << "; " << viewer_->errors();
        ASSERT_EQ(viewer_->tell("capture first.exr"), "ok") << viewer_->errors();
        ASSERT_EQ(viewer_->tell("frame"), "ok") << viewer_->errors();
        std::this_thread::sleep_for(300ms);  // the window manager is done with it
    }

    /// The true values of the picture of now.
    image::Image picture() {
        EXPECT_EQ(viewer_->tell("capture now.exr"), "ok");
        return image::readExr(viewer_->folder() / "now.exr").image;
    }
    static double meanOf(const image::Image& image) {
        double sum = 0;
        for (const float value : image.pixels) sum += static_cast<double>(value);
        return sum / static_cast<double>(image.pixels.size());
    }
    template<class Condition>
    static bool comesTrue(Condition condition) {
        for (int i = 0; i < 400 && !condition(); ++i) std::this_thread::sleep_for(25ms);
        return condition();
    }
    void quit() {
        screen_->close(window_);
        EXPECT_EQ(viewer_->waitForEnd(), 0) << viewer_->errors();
    }

    static constexpr int middleX = 512;
    static constexpr int middleY = 300;

    std::unique_ptr<test::Screen> screen_;
    std::unique_ptr<test::RunningViewer> viewer_;
    unsigned long window_ = 0;
};

TEST_F(ViewerWindow, TheMouseMovesTheCamera) {
    const image::Image first = picture();
    EXPECT_GT(meanOf(first), 0.01);
    screen_->drag(window_, middleX, middleY, middleX + 150, middleY + 40);
    const image::Image turned = picture();
    EXPECT_NE(turned.pixels, first.pixels);
    EXPECT_GT(meanOf(turned), 0.01);
    screen_->wheel(window_, middleX, middleY, 3);
    EXPECT_NE(picture().pixels, turned.pixels);
    EXPECT_EQ(viewer_->tell("frame"), "ok");
    quit();
}

TEST_F(ViewerWindow, ADoubleClickInTheGraphShowsANode) {
    const image::Image first = picture();
    EXPECT_EQ(viewer_->tell("tab graph"), "ok");
    EXPECT_EQ(viewer_->tell("frame"), "ok");
    // Columns of nodes stand left of the middle, with no more than a node's height between them.
    bool isOther = false;
    for (int x = 100; x <= 500 && !isOther; x += 50) {
        screen_->doubleClick(window_, x, 600);
        ASSERT_EQ(viewer_->tell("tab graph"), "ok") << viewer_->condition() << "; " << viewer_->errors();
        isOther = picture().pixels != first.pixels;
    }
    EXPECT_TRUE(isOther);
    screen_->wheel(window_, middleX, 600, 4);
    screen_->drag(window_, 500, 700, 400, 650);
    EXPECT_EQ(viewer_->tell("window graph.png"), "ok");
    quit();
}

TEST_F(ViewerWindow, TheFirstCommandSeesThePicture) {
    EXPECT_GT(meanOf(image::readExr(viewer_->folder() / "first.exr").image), 0.01);
    EXPECT_THAT(viewer_->tell("faults"), "ok");
    EXPECT_THAT(viewer_->tell("set nothing=1"), HasSubstr("no parameter"));
    EXPECT_THAT(viewer_->tell("faults"), HasSubstr("no parameter")) << "asking changes nothing";
    EXPECT_EQ(viewer_->tell("exposure 1"), "ok");
    EXPECT_THAT(viewer_->tell("exposure 1e300"), HasSubstr("expected a factor from 0 to 1e+30"));
    EXPECT_EQ(viewer_->tell("show mip(light.depth, 0)"), "ok");
    EXPECT_EQ(viewer_->tell("set taps = 12"), "ok");
    EXPECT_EQ(viewer_->tell("quit"), "ok");
    EXPECT_EQ(viewer_->waitForEnd(), 0);
}

TEST_F(ViewerWindow, EditsAreSeenUndoneAndSaved) {
    const image::Image first = picture();
    const std::string file = viewer_->textOf("graphs/paper.json");
    EXPECT_EQ(viewer_->tell("set weights=[0, 0, 0, 0, 1]"), "ok");
    EXPECT_NE(picture().pixels, first.pixels);
    EXPECT_EQ(viewer_->tell("node dipole off"), "ok");
    EXPECT_EQ(meanOf(picture()), meanOf(picture()));
    EXPECT_EQ(viewer_->tell("undo"), "ok");
    EXPECT_EQ(viewer_->tell("swap ssao lambert-albedo"), "ok");
    EXPECT_EQ(viewer_->tell("save"), "ok");
    const std::string saved = viewer_->textOf("graphs/paper.json");
    EXPECT_THAT(saved, HasSubstr("\"weights\":      {\"value\": [0, 0, 0, 0, 1], \"doc\""));
    EXPECT_THAT(saved, HasSubstr("\"pass\": \"lambert-albedo\""));
    EXPECT_THAT(saved, HasSubstr("// Light space: what each light sees"));
    EXPECT_EQ(viewer_->tell("undo"), "ok");
    EXPECT_EQ(viewer_->tell("undo"), "ok");
    EXPECT_EQ(picture().pixels, first.pixels);
    EXPECT_EQ(viewer_->tell("save"), "ok");
    EXPECT_EQ(viewer_->textOf("graphs/paper.json"), file);
    quit();
}

TEST_F(ViewerWindow, NothingTypedIntoItEndsIt) {
    const image::Image first = picture();
    EXPECT_THAT(viewer_->tell("set nothing=1"), HasSubstr("the graph has no parameter \"nothing\""));
    EXPECT_THAT(viewer_->tell("swap dipole gbuffer"), Not("ok"));
    EXPECT_THAT(viewer_->tell("show no.where"), Not("ok"));
    EXPECT_THAT(viewer_->tell("level 1"), HasSubstr("it has no level but 0"));
    EXPECT_THAT(viewer_->tell("layer 1"), HasSubstr("it has no layer but 0"));
    EXPECT_THAT(viewer_->tell("reset dipole.nothing"), HasSubstr("has no parameter \"nothing\""));
    EXPECT_THAT(viewer_->tell("set dipole.taps=oops"), StartsWith("set dipole.taps=oops: error: "));
    EXPECT_THAT(viewer_->tell("set taps=0"), StartsWith("set taps=0: error: "));
    EXPECT_THAT(viewer_->tell("set dipole.taps=0"), StartsWith("set dipole.taps=0: error: "));
    EXPECT_THAT(viewer_->tell("orbit x y"), HasSubstr("found \"x\""));
    EXPECT_THAT(viewer_->tell("reference missing.exr"), HasSubstr("missing.exr"));
    EXPECT_THAT(viewer_->tell("orbitt 1 1"), HasSubstr("did you mean \"orbit\"?"));
    EXPECT_THAT(viewer_->tell("set taps=\"x"), Not("ok"));
    EXPECT_EQ(viewer_->tell("size 64 32"), "ok");
    EXPECT_EQ(picture().width, 64U);
    EXPECT_EQ(viewer_->tell("size 96 96"), "ok");
    EXPECT_EQ(picture().pixels, first.pixels);
    const std::string graph = viewer_->textOf("graphs/paper.json");
    EXPECT_THAT(viewer_->tell("screenshot graphs/paper.json"), HasSubstr("ends in .png"));
    EXPECT_THAT(viewer_->tell("window graphs/paper.json"), HasSubstr("ends in .png"));
    EXPECT_THAT(viewer_->tell("capture graphs/paper.json"), HasSubstr("ends in .exr"));
    EXPECT_EQ(viewer_->textOf("graphs/paper.json"), graph);
    EXPECT_EQ(viewer_->tell("reference first.exr"), "ok");
    EXPECT_THAT(viewer_->tell("capture first.exr"), HasSubstr("a file that is not read"));
    quit();
}

TEST_F(ViewerWindow, EditsThatAreNotSavedAreNotDroppedWithoutAWord) {
    EXPECT_EQ(viewer_->tell("set taps=3"), "ok");
    EXPECT_THAT(viewer_->tell("quit"), HasSubstr("paper.json: error: it has edits that are not saved"));
    EXPECT_EQ(viewer_->tell("set taps=4"), "ok");
    EXPECT_THAT(viewer_->tell("quit"), HasSubstr("not saved")) << "another edit is another question";
    quit();
}

TEST_F(ViewerWindow, CommandsAreAnsweredWhileTimeRuns) {
    EXPECT_EQ(viewer_->tell("play"), "ok");
    EXPECT_EQ(viewer_->tell("orbit 0.1 0"), "ok");
    EXPECT_EQ(viewer_->tell("window playing.png"), "ok");
    EXPECT_TRUE(std::filesystem::exists(viewer_->folder() / "playing.png"));
    EXPECT_EQ(viewer_->tell("play"), "ok");
    quit();
}

TEST_F(ViewerWindow, ABrokenShaderIsNamedAndTheLastPictureStays) {
    const image::Image first = picture();
    const std::string shader = viewer_->textOf("shaders/dipole_literal.glsl");
    viewer_->write("shaders/dipole_literal.glsl", shader + "\nbroken\n");
    EXPECT_TRUE(comesTrue([&] { return viewer_->errors().find("error") != std::string::npos; }));
    EXPECT_THAT(viewer_->errors(), HasSubstr("shaders/dipole_literal.glsl:"));
    EXPECT_EQ(picture().pixels, first.pixels);
    EXPECT_EQ(viewer_->tell("window banner.png"), "ok") << "a file is no fault of the command's";
    EXPECT_TRUE(std::filesystem::exists(viewer_->folder() / "banner.png"));
    EXPECT_THAT(viewer_->tell("faults"), HasSubstr("shaders/dipole_literal.glsl:"));
    EXPECT_THAT(viewer_->tell("no such"), HasSubstr("there is no command"));
    std::string black = shader;
    const std::string store = "store(radiance, p, vec4(sum, point.w));";
    ASSERT_NE(black.find(store), std::string::npos);
    black.replace(black.find(store), store.size(), "store(radiance, p, vec4(0.0, 0.0, 0.0, point.w));");
    viewer_->write("shaders/dipole_literal.glsl", black);
    EXPECT_TRUE(comesTrue([&] { return picture().pixels != first.pixels; }));
    viewer_->write("shaders/dipole_literal.glsl", shader);
    EXPECT_TRUE(comesTrue([&] { return picture().pixels == first.pixels; }));
    EXPECT_EQ(viewer_->tell("faults"), "ok");
    quit();
}

TEST_F(ViewerWindow, AFileSavedByOthersMeetsEditsThatAreNotSaved) {
    EXPECT_EQ(viewer_->tell("set taps=3"), "ok");
    const image::Image edited = picture();
    std::string file = viewer_->textOf("graphs/paper.json");
    file.replace(file.find("[0.3, 0.3, 0.05, 0.05, 0.3]"), 27, "[0.0, 0.0, 0.00, 0.00, 0.3]");
    viewer_->write("graphs/paper.json", file);
    EXPECT_TRUE(comesTrue([&] { return picture().pixels != edited.pixels; }));
    EXPECT_EQ(viewer_->tell("save"), "ok");
    EXPECT_THAT(viewer_->textOf("graphs/paper.json"), HasSubstr("\"taps\":         {\"value\": 3,"));
    EXPECT_THAT(viewer_->textOf("graphs/paper.json"), HasSubstr("[0.0, 0.0, 0.00, 0.00, 0.3]"));
    quit();
}

TEST_F(ViewerWindow, ResizingMinimisingAndLookingAtPorts) {
    screen_->resize(window_, 900, 700);
    EXPECT_EQ(viewer_->tell("show gbuffer.normal"), "ok");
    const image::Image normal = picture();
    screen_->minimise(window_);
    std::this_thread::sleep_for(200ms);
    screen_->restore(window_);
    screen_->resize(window_, 640, 480);
    EXPECT_EQ(viewer_->tell("show light.depth"), "ok");
    EXPECT_EQ(viewer_->tell("channel r"), "ok");
    for (const char* tab : {"tab skips", "tab graph", "tab timings", "help", "lower"})
        EXPECT_EQ(viewer_->tell(tab), "ok");
    EXPECT_EQ(viewer_->tell("show gbuffer.normal"), "ok");
    EXPECT_EQ(picture().pixels, normal.pixels);
    EXPECT_EQ(viewer_->tell("screenshot seen.png"), "ok");
    EXPECT_TRUE(std::filesystem::exists(viewer_->folder() / "seen.png"));
    quit();
}

TEST_F(ViewerWindow, ItSleepsWhenNothingChanges) {
    picture();
    std::this_thread::sleep_for(500ms);
    const double before = viewer_->processorSeconds();
    std::this_thread::sleep_for(3s);
    EXPECT_LT((viewer_->processorSeconds() - before) / 3, 0.02);
    quit();
}

}  // namespace
}  // namespace nephrite::view
