// `nephrite compare` as a user meets it: its JSON, its table, its heat map, and what it says to bad input.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>

#include "image/exr.h"
#include "image/metrics/heat_map.h"
#include "image/metrics/metrics.h"
#include "program.h"
#include "text/json.h"

namespace nephrite::tools::test {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr std::uint32_t size = 24;

/// A disc on black with alpha, its values scaled by `factor(index)`.
template<class Factor>
image::Image disc(Factor&& factor, std::vector<std::string> channels = {"R", "G", "B", "A"}) {
    image::Image image{size, size, std::move(channels), {}};
    for (std::uint32_t y = 0; y < size; ++y)
        for (std::uint32_t x = 0; x < size; ++x) {
            const float distance = std::hypot(static_cast<float>(x) - 11.5F, static_cast<float>(y) - 11.5F);
            const float value = distance < 9 ? (1 + static_cast<float>(x) / size) * factor(x + y) : 0;
            for (std::size_t c = 0; c < image.channels.size(); ++c)
                image.pixels.push_back(c == 3 ? static_cast<float>(distance < 9)
                                              : value / static_cast<float>(c + 1));
        }
    return image;
}

class CompareVerb : public testing::Test {
  protected:
    CompareVerb() {
        image::writeExr(place_.path() / "picture.exr", picture_);
        image::writeExr(place_.path() / "a.exr", a_);
        image::writeExr(place_.path() / "b.exr", b_);
    }

    /// What the program prints; it must not fail.
    std::string output(const std::string& arguments) const {
        const Answer answer = place_.run("compare " + arguments);
        EXPECT_EQ(answer.status, 0) << answer.errors;
        EXPECT_EQ(answer.errors, "");
        return answer.output;
    }
    Json::Value printed(const std::string& arguments) const {
        return json::parse(output(arguments), "stdout").raw();
    }
    std::string bytes(const std::string& name) const {
        std::ostringstream text;
        text << std::ifstream(place_.path() / name, std::ios::binary).rdbuf();
        return text.str();
    }
    void expectRefused(const std::string& arguments, const std::string& words) const {
        const Answer answer = place_.run("compare " + arguments);
        EXPECT_EQ(answer.status, 2) << arguments;
        EXPECT_EQ(answer.output, "");
        EXPECT_THAT(answer.errors, HasSubstr("error: "));
        EXPECT_THAT(answer.errors, HasSubstr(words));
        EXPECT_EQ(std::count(answer.errors.begin(), answer.errors.end(), '\n'), 1) << answer.errors;
        EXPECT_FALSE(place_.isThere("out.json"));
        EXPECT_FALSE(place_.isThere("out.png"));
    }

    Workplace place_;
    const image::Image picture_ = disc([](std::uint32_t) { return 1.1F; });
    const image::Image a_ = disc([](std::uint32_t i) { return i % 2 == 0 ? 0.7F : 1.3F; });
    const image::Image b_ = disc([](std::uint32_t i) { return i % 3 == 0 ? 1.2F : 0.9F; });
};

TEST_F(CompareVerb, JsonHoldsTheMetricsToTheLastDigit) {
    const Json::Value json = printed("picture.exr a.exr --json");
    const image::Metrics metrics = image::compareImages(picture_, a_);
    EXPECT_EQ(json["rmse"].asDouble(), metrics.rmse);
    EXPECT_EQ(json["mae"].asDouble(), metrics.mae);
    EXPECT_EQ(json["relMSE"].asDouble(), metrics.relMse);
    EXPECT_EQ(json["psnr"].asDouble(), metrics.psnr);
    EXPECT_EQ(json["maxAbs"].asDouble(), metrics.maxAbs);
    EXPECT_EQ(json["flip"].asDouble(), metrics.flip.value().mean);
    ASSERT_EQ(json["relRMSE"].size(), 3U);
    ASSERT_EQ(json["meanRatio"].size(), 3U);
    for (Json::ArrayIndex c = 0; c < 3; ++c) {
        EXPECT_EQ(json["relRMSE"][c].asDouble(), metrics.relRmse[c]);
        EXPECT_EQ(json["meanRatio"][c].asDouble(), metrics.meanRatio[c]);
    }
    EXPECT_TRUE(json["nonFinite"].isUInt64());
    EXPECT_EQ(json["nonFinite"].asUInt64(), 0U);
    EXPECT_EQ(json["litPixels"].asUInt64(), metrics.litPixels);
    EXPECT_EQ(json["bins"].asUInt(), 1U);
    EXPECT_EQ(json["flipVariant"].asString(), "HDR");
    EXPECT_EQ(json["flipToneMap"].asString(), "ACES");
    EXPECT_EQ(json["flipExposures"]["start"].asDouble(), metrics.flip->startExposure);
    EXPECT_EQ(json["flipExposures"]["stop"].asDouble(), metrics.flip->stopExposure);
    EXPECT_EQ(json["flipExposures"]["count"].asUInt(), metrics.flip->exposures);
    EXPECT_FALSE(json.isMember("unbiasedMSE"));
}

TEST_F(CompareVerb, JsonGoesToAFileBesideTheTable) {
    const std::string table = output("picture.exr a.exr --json out.json");
    EXPECT_EQ(bytes("out.json"), output("picture.exr a.exr --json"));
    EXPECT_EQ(table, output("picture.exr a.exr"));
    EXPECT_EQ(output("--json out.json picture.exr a.exr"), table);
}

TEST_F(CompareVerb, TheTableNamesWhatFlipIs) {
    const std::string table = output("picture.exr a.exr");
    for (const std::string name : {"relRMSE", "mean ratio", "RMSE", "MAE", "relMSE", "PSNR", "FLIP",
                                   "HDR-FLIP, ACES tone map, 2 exposures from 2^", "not finite"})
        EXPECT_THAT(table, HasSubstr(name));
    EXPECT_THAT(table, Not(HasSubstr("unbiased")));
}

TEST_F(CompareVerb, ASecondHalfGivesTheUnbiasedError) {
    const Json::Value json = printed("picture.exr a.exr b.exr --json");
    const image::Metrics metrics = image::compareImages(picture_, a_, &b_);
    EXPECT_EQ(json["rmse"].asDouble(), metrics.rmse);
    EXPECT_EQ(json["unbiasedMSE"].asDouble(), metrics.unbiased.value().mse);
    EXPECT_EQ(json["unbiasedRelRMSE"][2].asDouble(), metrics.unbiased->relRmse[2]);
    EXPECT_THAT(output("picture.exr a.exr b.exr"), HasSubstr("unbiased relRMSE"));
}

TEST_F(CompareVerb, BlocksAverageNoiseAway) {
    const Json::Value blocks = printed("picture.exr a.exr --bins 4 --json");
    EXPECT_EQ(blocks["bins"].asUInt(), 4U);
    EXPECT_EQ(blocks["rmse"].asDouble(), image::compareImages(picture_, a_, nullptr, {4, false}).rmse);
    EXPECT_LT(blocks["rmse"].asDouble(), printed("picture.exr a.exr --json")["rmse"].asDouble());
    EXPECT_THAT(output("picture.exr a.exr --bins 4"), HasSubstr("blocks of 4 x 4 pixels"));
}

TEST_F(CompareVerb, OtherLayersDoNotMatter) {
    image::writeExr(place_.path() / "layers.exr",
                    disc([](std::uint32_t) { return 1.1F; }, {"R", "G", "B", "A", "multiple.R", "single.R"}));
    EXPECT_EQ(printed("layers.exr picture.exr --json")["maxAbs"].asDouble(), 0);
    EXPECT_EQ(printed("picture.exr layers.exr --json")["maxAbs"].asDouble(), 0);
}

TEST_F(CompareVerb, WhatHasNoFiniteValueIsNull) {
    const Json::Value json = printed("a.exr a.exr --json");
    EXPECT_EQ(json["rmse"].asDouble(), 0);
    EXPECT_TRUE(json.isMember("psnr"));
    EXPECT_TRUE(json["psnr"].isNull());
}

TEST_F(CompareVerb, CountsPixelsThatAreNotFinite) {
    image::Image broken = picture_;
    broken.pixels[(12 * size + 12) * 4] = std::nanf("");
    broken.pixels[(12 * size + 13) * 4 + 1] = HUGE_VALF;
    image::writeExr(place_.path() / "broken.exr", broken);
    const Json::Value json = printed("broken.exr a.exr --json");
    EXPECT_EQ(json["nonFinite"].asUInt64(), 2U);
    EXPECT_GT(json["rmse"].asDouble(), 0);
}

TEST_F(CompareVerb, WritesAHeatMapAndSaysItsScale) {
    const std::string table = output("picture.exr a.exr b.exr --heatmap map.png");
    const double range = image::heatMap(picture_, a_, &b_, 1).range;
    EXPECT_THAT(table, HasSubstr("map.png: relative error from 0 (dark violet) to " +
                                 fmt::format("{:g}", range) + " (yellow)"));
    EXPECT_TRUE(bytes("map.png").starts_with("\x89PNG"));
    const Json::Value json = printed("picture.exr a.exr --heatmap other.png --heatmap-range 0.25 --json");
    EXPECT_EQ(json["heatmapRange"].asDouble(), 0.25);
    EXPECT_NE(bytes("other.png"), bytes("map.png"));
}

TEST_F(CompareVerb, RefusesHalvesThatAreNotIndependent) {
    const std::string outputs = " --json out.json --heatmap out.png";
    image::writeExr(place_.path() / "copy.exr", a_);
    expectRefused("picture.exr a.exr copy.exr" + outputs,
                  "copy.exr: error: it is the same picture as a.exr: the halves");
    expectRefused("picture.exr a.exr a.exr" + outputs, "a.exr: error: it is the same picture");
    image::writeExr(place_.path() / "one.exr", a_, {{"seed", "7"}, {"samples", "16"}});
    image::writeExr(place_.path() / "more.exr", b_, {{"seed", "7"}, {"samples", "32"}});
    image::writeExr(place_.path() / "two.exr", b_, {{"seed", "8"}, {"samples", "16"}});
    expectRefused("picture.exr one.exr more.exr" + outputs,
                  "more.exr: error: its seed is 7, as that of one.exr: the halves");
    EXPECT_THAT(output("picture.exr one.exr two.exr"), HasSubstr("unbiased"));
    const image::Image black{size, size, {"R", "G", "B"}, std::vector<float>(size * size * 3)};
    image::writeExr(place_.path() / "black.exr", black);
    EXPECT_THAT(output("picture.exr black.exr black.exr"), HasSubstr("unbiased"));
}

TEST_F(CompareVerb, RefusesAPartOfAReference) {
    const std::string outputs = " --json out.json --heatmap out.png";
    image::writeExr(place_.path() / "part.exr", a_, {{"part", "1/2"}});
    expectRefused("picture.exr part.exr" + outputs, "part.exr: error: this is part 1/2 of a reference");
    expectRefused("picture.exr b.exr part.exr" + outputs, "part.exr: error: this is part 1/2");
}

TEST_F(CompareVerb, RefusesWhatItCannotCompare) {
    const std::string outputs = " --json out.json --heatmap out.png";
    image::writeExr(place_.path() / "wide.exr", {2, 1, {"R", "G", "B"}, std::vector<float>(6)});
    image::writeExr(place_.path() / "grey.exr", {size, size, {"Y"}, std::vector<float>(size * size)});
    place_.write("text.exr", "not a picture");
    expectRefused("wide.exr a.exr" + outputs,
                  "wide.exr: error: expected 24x24 pixels as in a.exr, found 2x1");
    expectRefused("picture.exr a.exr wide.exr" + outputs, "wide.exr: error: ");
    expectRefused("picture.exr grey.exr" + outputs, "grey.exr: error: expected channels R, G and B, found Y");
    expectRefused("grey.exr a.exr" + outputs, "grey.exr: error: ");
    expectRefused("text.exr a.exr" + outputs, "text.exr: error: not a readable OpenEXR file");
    expectRefused("picture.exr none.exr" + outputs, "none.exr: error: cannot be read");
    expectRefused("picture.exr" + outputs, "reference is required");
    expectRefused("picture.exr a.exr --bins 0" + outputs, "--bins: error: expected at least 1");
    expectRefused("picture.exr a.exr --bins -2" + outputs, "--bins");
    expectRefused("picture.exr a.exr --heatmap-range 0" + outputs, "--heatmap-range: error: ");
    expectRefused("picture.exr a.exr --heatmap-range nan" + outputs, "--heatmap-range: error: ");
    expectRefused("picture.exr a.exr --heatmap-range 1", "--heatmap-range: error: there is no --heatmap");
    expectRefused("picture.exr a.exr --json out.json --heatmap out.gif", "expected a name ending in .png");
}

TEST_F(CompareVerb, NeverWritesOverAPictureThatFollowsJson) {
    const std::string before = bytes("picture.exr");
    expectRefused("--json picture.exr a.exr b.exr", "expected a name ending in .json, found \"picture.exr\"");
    EXPECT_EQ(bytes("picture.exr"), before);
    EXPECT_GT(printed("--json picture.exr a.exr")["rmse"].asDouble(), 0);
}

TEST_F(CompareVerb, WritesBothOutputsOrNone) {
    for (const std::string outputs :
         {"--json out.json --heatmap no/such/out.png", "--json no/such/out.json --heatmap out.png"}) {
        const Answer answer = place_.run("compare picture.exr a.exr " + outputs);
        EXPECT_EQ(answer.status, 1);
        EXPECT_EQ(answer.output, "");
        EXPECT_THAT(answer.errors, HasSubstr("no/such/out."));
        EXPECT_FALSE(place_.isThere("out.json"));
        EXPECT_FALSE(place_.isThere("out.png"));
    }
}

}  // namespace
}  // namespace nephrite::tools::test
