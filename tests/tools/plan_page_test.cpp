// `nephrite plan -o F.html`: times and pictures of a rendered graph, and what is written where none can be
// had.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <json/reader.h>

#include <fstream>
#include <sstream>

#include "browser/browser.h"
#include "program.h"

namespace nephrite::tools::test {
namespace {

using testing::HasSubstr;

std::string textOf(const std::filesystem::path& file) {
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
}

Json::Value dataOf(const std::filesystem::path& page) {
    const std::string text = textOf(page);
    const std::string start = "id=\"data\">";
    const std::size_t begin = text.find(start) + start.size();
    std::istringstream stream(text.substr(begin, text.find("</script>", begin) - begin));
    Json::Value data;
    stream >> data;
    return data;
}

TEST(PlanPageOfProgram, HasATimeOfEachPassAndAPictureOfEachImage) {
    const Workplace place;
    const Answer answer = place.run("plan " + graphFile("paper.json") + " --size 48x40 -o page.html");
    ASSERT_EQ(answer.status, 0) << answer.errors;
    EXPECT_EQ(answer.errors, "");
    const Json::Value data = dataOf(place.path() / "page.html");
    EXPECT_GT(data["frameMs"].asDouble(), 0);
    int kept = 0, pictures = 0;
    for (const Json::Value& node : data["nodes"]) {
        if (node["state"] == "output") continue;
        EXPECT_TRUE(node.isMember("gpuMs")) << node["name"].asString();
        kept += node["state"] == "kept" ? 1 : 0;
        for (const Json::Value& output : node["outputs"]) {
            const Json::Value& resource = data["resources"][output["resource"].asUInt()];
            EXPECT_EQ(output.isMember("picture"), !resource["isBuffer"].asBool())
                << node["name"].asString() << '.' << output["name"].asString();
            pictures += output.isMember("picture") ? 1 : 0;
        }
    }
    EXPECT_GT(kept, 0);
    EXPECT_GT(pictures, 20);
}

TEST(PlanPageOfProgram, PicturesAreShownAndDecoded) {
    if (tests::findBrowser().empty()) GTEST_SKIP() << "there is no Chromium here";
    const Workplace place;
    ASSERT_EQ(place.run("plan " + graphFile("gbuffer.json") + " --size 40x30 -o page.html").status, 0);
    tests::Browser browser(1200, 800);
    browser.open(place.path() / "page.html", "document.documentElement?.dataset.readyMs !== undefined");
    EXPECT_GT(browser.evaluate("document.querySelectorAll('.thumbnail').length").asInt(), 0);
    EXPECT_EQ(browser.evaluate("[...document.images].filter((image) => image.naturalWidth != 40).length"), 0);
    EXPECT_EQ(browser.complaints(), std::vector<std::string>());
}

TEST(PlanPageOfProgram, NeedsNoDevice) {
    const Workplace place;
    const Answer answer =
        place.run("plan " + graphFile("paper.json") + " --no-measure --device none -o page.html");
    ASSERT_EQ(answer.status, 0) << answer.errors;
    const Json::Value data = dataOf(place.path() / "page.html");
    EXPECT_EQ(data["frames"], 0);
    EXPECT_THAT(data["note"].asString(), HasSubstr("Nothing was rendered"));
    EXPECT_FALSE(data["nodes"][0].isMember("gpuMs"));
}

TEST(PlanPageOfProgram, AShaderWithAFaultLeavesThePageWithoutPictures) {
    const Workplace place;
    place.write("passes/broken.json",
                R"({"kind": "pixel", "shader": "broken.glsl", "outputs": {"color": {}}})");
    place.write("passes/broken.glsl", "void pixel(ivec2 p) { store(color, p, nothing); }\n");
    place.write("g.json", R"({"nodes": {"a": {"pass": "broken"}}, "outputs": {"color": "a.color"}})");
    const Answer answer = place.run("plan g.json --pass-path passes --size 8x8 -o page.html");
    ASSERT_EQ(answer.status, 0);
    EXPECT_THAT(answer.errors, HasSubstr("page.html: warning: without times and pictures: "));
    EXPECT_THAT(answer.errors, HasSubstr("broken.glsl:1:"));
    EXPECT_THAT(dataOf(place.path() / "page.html")["note"].asString(), HasSubstr("broken.glsl:1:"));
}

TEST(PlanPageOfProgram, ADeviceThatIsNotThereIsAnErrorAndNothingIsWritten) {
    const Workplace place;
    const Answer answer =
        place.run("plan " + graphFile("gbuffer.json") + " --size 8x8 --device none-such -o page.html");
    EXPECT_NE(answer.status, 0);
    EXPECT_THAT(answer.errors, HasSubstr("none-such"));
    EXPECT_FALSE(place.isThere("page.html"));
}

TEST(PlanPageOfProgram, AFolderThatIsNotThereIsNoticedBeforeAnythingIsRendered) {
    const Workplace place;
    const Answer answer = place.run("plan " + graphFile("gbuffer.json") + " -o nowhere/page.html");
    EXPECT_EQ(answer.status, 1);
    EXPECT_THAT(answer.errors, HasSubstr("nowhere/page.html: error: cannot be written"));
}

}  // namespace
}  // namespace nephrite::tools::test
