// `nephrite sweep`, run as a user would, in one piece, in parts, and killed.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <json/reader.h>

#include <chrono>
#include <fstream>
#include <map>
#include <sstream>
#include <thread>
#include <vector>

#include "image/exr.h"
#include "program.h"
#include "running.h"
#include "slurm.h"

namespace nephrite::tools::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

Json::Value parsed(const fs::path& file) {
    Json::Value value;
    std::istringstream(contents(file)) >> value;
    return value;
}

/// A graph that adds its parameters up and one that counts frames, whose rows are the same every time.
class Sweeping : public testing::Test {
  protected:
    Sweeping() {
        place_.write("passes/sum.json",
                     R"({"kind": "pixel", "shader": "sum.glsl", "outputs": {"color": {"format": "rgba32f"}},
            "parameters": {"a": {"type": "float", "default": 1, "range": [0, 100]}, "b": {"type": "float", "default": 2, "specialize": true}}})");
        writeShader("params.a + params.b");
        place_.write("passes/count.json",
                     R"({"kind": "pixel", "shader": "count.glsl", "inputs": {"before": {}},
            "outputs": {"color": {"format": "rgba32f", "neutral": [0, 0, 0, 0]}}, "parameters": {"a": {"type": "float", "default": 1}}})");
        place_.write("passes/count.glsl",
                     "void pixel(ivec2 p) { store(color, p, load(before, p) + vec4(params.a)); }");
        place_.write("sum.json",
                     R"({"name": "sum", "nodes": {"n": {"pass": "sum"}}, "outputs": {"color": "n.color"}})");
        place_.write("count.json", R"json({"name": "count", "nodes": {"n": {"pass": "count",
            "in": {"before": "previous(n.color)"}}}, "outputs": {"color": "n.color"}})json");
        image::Image reference{16, 16, {"R", "G", "B"}, std::vector<float>(16 * 16 * 3, 4.0F)};
        image::writeExr(place_.path() / "four.exr", reference);
    }

    void writeShader(const std::string& value) const {
        place_.write("passes/sum.glsl", "void pixel(ivec2 p) { store(color, p, vec4(" + value + ")); }");
    }

    void writeSweep(const std::string& more) const {
        place_.write("sweep.json", R"({ "sizes": [[16, 16]], "timings": false,
            "scenes": {"s": {"scene": ")" +
                                       std::string(NEPHRITE_SOURCE_DIR) +
                                       R"(/graphs/scenes/opaque.json", "reference": "four.exr"}}, )" + more +
                                       "}");
    }

    Answer sweep(const std::string& options) const {
        return place_.run("sweep sweep.json --pass-path passes " + options);
    }

    const Workplace place_;
};

const std::string twoGraphs = R"("graphs": {"sum": "sum.json", "count": "count.json"}, "pictures": "exr",
    "frames": 3, "grid": {"n.a": [1, 2, 3]})";

TEST_F(Sweeping, WritesARowForEachRun) {
    writeSweep(R"("graphs": {"sum": {"graph": "sum.json", "set": {"n.b": 1}}}, "grid": {"n.a": [3, 1]})");
    const Answer answer = sweep("-o out");
    ASSERT_EQ(answer.status, 0) << answer.errors;
    EXPECT_EQ(answer.output, "2 runs are done: out/sweep.csv\n");
    const Json::Value rows = parsed(place_.path() / "out/sweep.json")["runs"];
    ASSERT_EQ(rows.size(), 2U);
    EXPECT_EQ(rows[0]["parameters"]["n.a"], 3);
    EXPECT_EQ(rows[0]["metrics"]["rmse"], 0);
    EXPECT_EQ(rows[1]["metrics"]["rmse"], 2);
    EXPECT_EQ(rows[1]["error"], 0.5);
    EXPECT_FALSE(rows[1]["commit"].asString().empty());
    EXPECT_FALSE(rows[1]["device"].asString().empty());
    EXPECT_FALSE(rows[1].isMember("wallMs"));
    EXPECT_THAT(contents(place_.path() / "out/sweep.csv"),
                HasSubstr("id,scene,graph,width,height,parameters.n.a,error"));
}

TEST_F(Sweeping, HasTimesOfFramesAndPasses) {
    place_.write("sweep.json",
                 R"({"sizes": [[16, 16], [8, 8]], "frames": 4, "warmup": 1, "passes": true,
        "scenes": {"s": ")" +
                     std::string(NEPHRITE_SOURCE_DIR) +
                     R"(/graphs/scenes/opaque.json"}, "graphs": {"sum": "sum.json"}, "pictures": "png"})");
    ASSERT_EQ(sweep("-o out").status, 0);
    for (const Json::Value& row : parsed(place_.path() / "out/sweep.json")["runs"]) {
        EXPECT_GT(row["wallMs"]["min"].asDouble(), 0);
        EXPECT_LE(row["wallMs"]["median"].asDouble(), row["wallMs"]["p95"].asDouble());
        EXPECT_EQ(row["passes"][0]["name"], "n");
        EXPECT_GT(row["passes"][0]["gpuMs"]["median"].asDouble(), 0);
        EXPECT_TRUE(fs::exists(place_.path() / "out" / row["picture"].asString()));
    }
}

TEST_F(Sweeping, InPartsMakesTheSameTables) {
    writeSweep(twoGraphs);
    ASSERT_EQ(sweep("-o whole").status, 0);
    const Json::Value rows = parsed(place_.path() / "whole/sweep.json")["runs"];
    ASSERT_EQ(rows.size(), 6U);
    // Three frames counted by 1, 2 and 3: nothing went on from the run before.
    for (int i = 0; i < 3; ++i) {
        const image::Image picture =
            image::readExr(place_.path() / "whole" / rows[3 + i]["picture"].asString()).image;
        EXPECT_EQ(picture.at(5, 5, 0), 3.0F * static_cast<float>(i + 1));
    }
    for (const std::string part : {"3", "1", "2"}) {
        EXPECT_FALSE(place_.isThere("parts/sweep.csv"));
        const Answer answer = sweep("--part " + part + "/3 -o parts");
        ASSERT_EQ(answer.status, 0) << answer.errors;
        if (part == "1") {
            EXPECT_EQ(answer.output, "4 of 6 runs are done\n");
        }
    }
    EXPECT_EQ(contents(place_.path() / "parts/sweep.csv"), contents(place_.path() / "whole/sweep.csv"));
    EXPECT_EQ(contents(place_.path() / "parts/sweep.json"), contents(place_.path() / "whole/sweep.json"));
    ASSERT_EQ(submit(place_, "slurm-array.sh", "sweep 2 'by jobs' sweep.json --pass-path passes"), 0)
        << contents(place_.path() / "errors");
    EXPECT_EQ(contents(place_.path() / "by jobs/sweep.csv"), contents(place_.path() / "whole/sweep.csv"));
    EXPECT_NE(submit(place_, "slurm-array.sh", "sweep 2 out sweep.json --part 1/2"), 0);
}

/// When each record was written, by name.
std::map<std::string, fs::file_time_type> recordsIn(const fs::path& folder) {
    std::map<std::string, fs::file_time_type> records;
    std::error_code ignored;
    for (const auto& entry : fs::directory_iterator(folder / "runs", ignored))
        if (entry.path().extension() == ".json")
            records[entry.path().filename().string()] = fs::last_write_time(entry.path());
    return records;
}

TEST_F(Sweeping, ContinuesAfterItWasKilled) {
    writeSweep(R"("graphs": {"sum": "sum.json"}, "frames": 400, "grid": {"n.a": [1, 2, 3, 4, 5, 6, 7, 8]})");
    const fs::path folder = place_.path() / "out";
    Running program(place_.path(), {"sweep", "sweep.json", "--pass-path", "passes", "-o", "out"});
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(60);
    while (recordsIn(folder).size() < 2 && std::chrono::steady_clock::now() < deadline)
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    EXPECT_EQ(program.end(SIGKILL), 128 + SIGKILL) << program.log();
    const auto before = recordsIn(folder);
    ASSERT_GE(before.size(), 2U);
    EXPECT_LT(before.size(), 8U);
    for (const auto& [name, written] : before) EXPECT_TRUE(parsed(folder / "runs" / name)["row"].isObject());
    const Answer answer = sweep("-o out");
    ASSERT_EQ(answer.status, 0) << answer.errors;
    const auto after = recordsIn(folder);
    EXPECT_EQ(after.size(), 8U);
    for (const auto& [name, written] : before)
        EXPECT_EQ(after.at(name), written) << name << " was done again";
    EXPECT_EQ(parsed(folder / "sweep.json")["runs"].size(), 8U);
}

TEST_F(Sweeping, DoesAgainWhatWasMadeFromOtherFiles) {
    writeSweep(R"("graphs": {"sum": "sum.json"}, "grid": {"n.a": [1]})");
    const auto error = [this] {
        EXPECT_EQ(sweep("-o out").status, 0);
        return parsed(place_.path() / "out/sweep.json")["runs"][0]["metrics"]["rmse"].asDouble();
    };
    EXPECT_EQ(error(), 1);
    writeShader("params.a + params.b + 0.5");
    EXPECT_EQ(error(), 0.5);
    image::writeExr(place_.path() / "four.exr",
                    {16, 16, {"R", "G", "B"}, std::vector<float>(16 * 16 * 3, 6.0F)});
    EXPECT_EQ(error(), 2.5);
    const fs::path record = place_.path() / "out/runs" / recordsIn(place_.path() / "out").begin()->first;
    std::ofstream(record) << "{ half a rec";
    EXPECT_EQ(error(), 2.5);
}

TEST_F(Sweeping, FindsFaultsBeforeTheFirstRun) {
    writeSweep(R"("graphs": {"sum": "sum.json"},
"grid": {"n.a": [1, 2, 101], "n.taps": [1]}, "list": [{"m.a": 1}], "port": "colour")");
    const Answer answer = sweep("-o out");
    EXPECT_EQ(answer.status, 2);
    EXPECT_THAT(answer.errors, HasSubstr("sweep.json:3:24: error: sum: "));
    EXPECT_THAT(answer.errors, HasSubstr("sweep.json:3:41: error: sum: "));
    EXPECT_THAT(answer.errors, HasSubstr("sweep.json:3:63: error: sum: the graph has no node \"m\""));
    EXPECT_THAT(answer.errors, HasSubstr("no output \"colour\", did you mean \"color\"?"));
    EXPECT_FALSE(place_.isThere("out"));
    for (const auto& [more, message] :
         {std::pair{R"("graphs": {"g": "none.json"})", "none.json: error: "},
          std::pair{R"("graphs": {"g": "sum.json"}, "port": "n.radiance")", "no port \"radiance\""},
          std::pair{R"("graphs": {"g": "sum.json"}, "port": "m.color")", "no node \"m\""}}) {
        writeSweep(more);
        const Answer other = sweep("-o out");
        EXPECT_EQ(other.status, 2) << more;
        EXPECT_THAT(other.errors, HasSubstr(message)) << more;
    }
    place_.write("sweep.json", R"({"sizes": [[8, 8]], "graphs": {"sum": "sum.json"},
        "scenes": {"s": {"scene": "none.json", "reference": "four.exr"}}})");
    const Answer other = sweep("-o out");
    EXPECT_EQ(other.status, 2);
    EXPECT_THAT(other.errors, HasSubstr("none.json: error: "));
    EXPECT_THAT(other.errors, HasSubstr("four.exr has 16 x 16 pixels, pictures of the sweep have 8 x 8"));
    EXPECT_EQ(sweep("-o out --part 3/2").status, 2);
    EXPECT_EQ(place_.run("sweep none.json -o out").status, 2);
    EXPECT_FALSE(place_.isThere("out"));
}

TEST_F(Sweeping, DoesTheOtherRunsIfOneFails) {
    place_.write("sum.json", R"({"name": "sum", "parameters": {"side": {"value": 16}},
        "nodes": {"n": {"pass": "sum", "size": ["$side", "$side"]}}, "outputs": {"color": "n.color"}})");
    place_.write("sweep.json",
                 R"({"timings": false, "graphs": {"sum": "sum.json"}, "grid": {"side": [1000000, 16]},
        "scenes": {"s": ")" +
                     std::string(NEPHRITE_SOURCE_DIR) + R"(/graphs/scenes/opaque.json"}})");
    const Answer answer = sweep("-o out");
    EXPECT_EQ(answer.status, 1);
    EXPECT_THAT(answer.errors, HasSubstr("failed: s/sum/512x512 side=1000000"));
    EXPECT_THAT(answer.errors, HasSubstr("1 of 2 runs failed"));
    EXPECT_EQ(recordsIn(place_.path() / "out").size(), 1U);
    EXPECT_FALSE(place_.isThere("out/sweep.csv"));
}

}  // namespace
}  // namespace nephrite::tools::test
