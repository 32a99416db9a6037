// A kept reference is used again only while it is what would be rendered.
#include "pareto/reference_store.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runtime/loading/graph_loading.h"
#include "scratch_folder.h"

namespace nephrite::pareto {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// A folder with the references of a small sphere.
class ReferenceStoreTest : public testing::Test {
  protected:
    ReferenceStoreTest() : file_(folder_.path() / "references" / "sphere-single-1.exr") {
        suiteScene_.name = "sphere";
        suiteScene_.file = NEPHRITE_SOURCE_DIR "/graphs/scenes/sphere.json";
        get();
        lines_.clear();
    }

    void get() {
        const scene::Scene scene = runtime::loadScene(suiteScene_.file, 0, runtime::DataFolders::find());
        Progress progress;
        progress.say = [&](const std::string& line) { lines_.push_back(line); };
        ReferenceSettings settings;
        settings.mode = truth::Mode::Single;
        settings.samples = 1;
        const ReferenceStore store({folder_.path() / "references", 6, 6, commit_, 1});
        store.get(suiteScene_, scene, settings, progress);
    }

    /// Changes the first half's file; it must be rendered anew, to what it was.
    template<class Change>
    void expectRenderedAnew(const std::string& what, Change change) {
        const image::ExrFile before = image::readExr(file_);
        image::ExrFile file = before;
        change(file);
        image::writeExr(file_, file.image, file.metadata);
        lines_.clear();
        get();
        EXPECT_THAT(lines_, ElementsAre(HasSubstr("sphere-single-1.exr: of other settings"))) << what;
        EXPECT_EQ(image::readExr(file_).metadata, before.metadata) << what;
        EXPECT_EQ(image::readExr(file_).image.pixels, before.image.pixels) << what;
    }

    ScratchFolder folder_;
    std::filesystem::path file_;
    SuiteScene suiteScene_;
    std::string commit_ = "one";
    std::vector<std::string> lines_;
};

TEST_F(ReferenceStoreTest, KeepsWhatItHasWhoeverRenderedIt) {
    commit_ = "another";
    get();
    EXPECT_THAT(lines_, ElementsAre());
    EXPECT_EQ(image::readExr(file_).metadata.at("commit"), "one");
}

TEST_F(ReferenceStoreTest, RendersAnewWhatIsOfAnotherRecord) {
    for (const char* name :
         {"mode", "revision", "sceneDigest", "samples", "seed", "time", "photons", "content"}) {
        expectRenderedAnew(name, [name](image::ExrFile& file) { file.metadata.at(name) += "9"; });
        expectRenderedAnew(std::string("no ") + name,
                           [name](image::ExrFile& file) { file.metadata.erase(name); });
    }
    expectRenderedAnew("size", [](image::ExrFile& file) {
        file.image = {3, 3, file.image.channels, std::vector<float>(9 * file.image.channels.size())};
    });
}

/// A part of a split run says what the whole would, but most of its pixels are black.
TEST_F(ReferenceStoreTest, RendersAnewWhatIsOnlyAPart) {
    expectRenderedAnew("part", [](image::ExrFile& file) { file.metadata["part"] = "1/4"; });
}

}  // namespace
}  // namespace nephrite::pareto
