// `nephrite bench compare-timings`, on times of real renders.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <json/reader.h>

#include <fstream>
#include <map>
#include <sstream>

#include "program.h"

namespace nephrite::tools::test {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

/// A graph of two passes that do as much as they are told to.
class CompareTimings : public testing::Test {
  protected:
    CompareTimings() {
        place_.write("passes/busy.json", R"({"kind": "pixel", "shader": "busy.glsl",
            "outputs": {"color": {"format": "r32f"}},
            "parameters": {"rounds": {"type": "uint", "default": 4000, "range": [1, 100000]}}})");
        place_.write("passes/busy.glsl", R"(void pixel(ivec2 p) {
            float x = float(p.x + 1);
            for (uint i = 0u; i < params.rounds; ++i) x = fract(x * 1.37 + 0.11) + 0.5;
            store(color, p, vec4(x));
        })");
        place_.write("g.json",
                     R"({"name": "g", "nodes": {"steady": {"pass": "busy"}, "work": {"pass": "busy"}},
            "outputs": {"color": "work.color", "other": "steady.color"}})");
    }

    void render(const std::string& name, const std::string& options,
                const std::string& size = "64x64") const {
        const Answer answer = place_.run("render g.json --pass-path passes --size " + size +
                                         " --frames 30 --profile " + options + " --timings " + name);
        ASSERT_EQ(answer.status, 0) << answer.errors;
    }

    std::map<std::string, std::string> verdicts(const std::string& files) const {
        const Answer answer = place_.run("bench compare-timings " + files + " --json");
        EXPECT_EQ(answer.status, 0) << answer.errors;
        EXPECT_EQ(answer.errors, "");
        Json::Value json;
        std::istringstream(answer.output) >> json;
        std::map<std::string, std::string> result;
        for (const Json::Value& row : json["rows"])
            result[row["name"].asString()] = row["verdict"].asString();
        return result;
    }

    const Workplace place_;
};

TEST_F(CompareTimings, SeesTwiceTheWorkAndNothingElse) {
    // A machine that is busy with something else for a while makes runs differ; twice the work shows always.
    std::map<std::string, std::string> same;
    std::map<std::string, std::string> twice;
    for (int attempt = 0; attempt < 4; ++attempt) {
        render("a.json", "");
        render("b.json", "");
        render("c.json", "--set work.rounds=8000");
        same = verdicts("a.json b.json");
        twice = verdicts("a.json c.json");
        ASSERT_EQ(same.size(), 5U);
        if (same["steady"] == "the same" && same["work"] == "the same" && same["wall"] == "the same" &&
            twice["steady"] == "the same" && twice["work"] == "slower" && twice["wall"] == "slower")
            return;
    }
    FAIL() << "same: " << same["steady"] << ", " << same["work"] << ", " << same["wall"]
           << "; twice: " << twice["steady"] << ", " << twice["work"] << ", " << twice["wall"];
}

TEST_F(CompareTimings, WritesATableAndWarns) {
    render("a.json", "");
    render("b.json", "", "32x32");
    const Answer answer = place_.run("bench compare-timings a.json b.json --json out.json");
    EXPECT_EQ(answer.status, 0);
    EXPECT_THAT(answer.errors, HasSubstr("b.json: warning: another size: \"64 x 64\" and \"32 x 32\""));
    EXPECT_THAT(answer.output, HasSubstr("\nsteady "));
    EXPECT_TRUE(place_.isThere("out.json"));
}

TEST_F(CompareTimings, RefusesWhatIsNoDump) {
    place_.write("a.json", R"({"wallMs": {"samples": []}})");
    place_.write("a.csv", "name,gpuMedianMs\nwall,1\n");
    place_.write("broken.json", "{\"device\": }");
    for (const auto& [arguments, message] :
         {std::pair{"none.json a.json", "none.json: error: "},
          std::pair{"broken.json a.json", "broken.json:1:12: "},
          std::pair{"a.json a.json", "a.json:1:1: error: a timing dump needs \"device\""},
          std::pair{"a.csv a.json",
                    "a.csv: error: this is no timings file in JSON but CSV: render --timings F.json"},
          std::pair{"none.csv a.json", "none.csv: error: cannot be read"}, std::pair{"a.json", "after"},
          std::pair{"a.json a.json --threshold -1", "--threshold"},
          std::pair{"a.json a.json --least nan", "--least"}}) {
        const Answer answer = place_.run(std::string("bench compare-timings ") + arguments);
        EXPECT_EQ(answer.status, 2) << arguments;
        EXPECT_THAT(answer.errors, HasSubstr(message)) << arguments;
    }
}

TEST_F(CompareTimings, LeavesWhatItComparesAlone) {
    place_.write("a.json", "{}");
    place_.write("b.json", "{}");
    for (const std::string file : {"a.json", "./b.json"}) {
        const Answer answer = place_.run("bench compare-timings a.json b.json --json " + file);
        EXPECT_EQ(answer.status, 2);
        EXPECT_EQ(answer.errors, file + ": error: this file is read, and would be overwritten\n");
    }
}

}  // namespace
}  // namespace nephrite::tools::test
