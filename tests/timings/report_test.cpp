// Reports of made-up frames: what the files say, and how the trace's slices lie.
#include "timings/report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "timings/trace_events.h"

namespace nephrite::timings {
namespace {

using namespace std::chrono_literals;
using testing::ElementsAre;
using testing::HasSubstr;

runtime::PassTime ran(double gpuMs, double cpuMs, double cpuStartMs) {
    return {gpuMs, cpuMs, cpuStartMs, true, {}};
}

runtime::PassTime kept() {
    return {0, 0, 0, false, {}};
}

/// Two frames of two passes, the second of which keeps the result of `a`, then one of another plan.
Report threeFrames() {
    Report report;
    report.device = "the device";
    report.graph = "g.json";
    report.scene = "s.json";
    report.passes = {"a", "b", "c"};
    report.plans = {{0, 1}, {2, 1}};
    report.skipped = {{"d", "its skipWhen holds"}};
    report.profiled = true;
    const auto start = std::chrono::steady_clock::time_point(5s);
    runtime::PassTime counted = ran(3, 0.25, 0.5);
    counted.counts = gpu::PipelineCounts{1, 2, 3, 4};
    report.frames.push_back({{start, 6, 1, 1, {ran(1, 0.25, 0.25), counted}}, 0});
    report.frames.push_back({{start + 10ms, 4, 0.5, 0.5, {kept(), ran(3, 0.125, 0.125)}}, 0});
    report.frames.push_back({{start + 20ms, 9, 1, 0, {ran(7, 0.25, 0.25), ran(1, 0.25, 0.5)}}, 1});
    report.marks.push_back({start + 19ms, "reload", "graph g.json"});
    return report;
}

TEST(TimingsJson, HasStatisticsAndSamplesOfTheFramesInWhichAPassRan) {
    const Json::Value root = test::parsed(asJson(threeFrames()));
    EXPECT_EQ(root["frames"], 3);
    EXPECT_EQ(root["wallMs"]["median"], 6);
    EXPECT_EQ(root["wallMs"]["p95"], 9);
    EXPECT_EQ(root["wallMs"]["min"], 4);
    EXPECT_EQ(root["wallMs"]["samples"].size(), 3U);
    EXPECT_EQ(root["gpuMs"]["samples"][2], 8);
    const Json::Value& passes = root["passes"];
    ASSERT_EQ(passes.size(), 4U);
    EXPECT_EQ(passes[0]["name"], "a");
    EXPECT_EQ(passes[0]["ran"], 1);
    EXPECT_EQ(passes[0]["skipped"], 2);
    EXPECT_EQ(passes[0]["gpuMs"]["samples"].size(), 1U);
    EXPECT_EQ(passes[1]["name"], "b");
    EXPECT_EQ(passes[1]["gpuMs"]["samples"][2], 1);
    EXPECT_EQ(passes[2]["gpuMs"]["median"], 7);
    EXPECT_EQ(passes[3]["name"], "d");
    EXPECT_EQ(passes[3]["ran"], 0);
    EXPECT_EQ(root["skips"]["unchanged"], 1);
}

TEST(TimingsJson, HasInvocationsWhereTheyWereCounted) {
    Report report = threeFrames();
    report.frames.resize(1);
    const Json::Value passes = test::parsed(asJson(report))["passes"];
    EXPECT_FALSE(passes[0].isMember("invocations"));
    EXPECT_EQ(passes[1]["invocations"]["vertex"], 1);
    EXPECT_EQ(passes[1]["invocations"]["clipping"], 2);
    EXPECT_EQ(passes[1]["invocations"]["fragment"], 3);
    EXPECT_EQ(passes[1]["invocations"]["compute"], 4);
}

TEST(TimingsJson, KeepsSamplesOfAPassInOneLine) {
    EXPECT_THAT(asJson(threeFrames()), HasSubstr("\"samples\": [3, 3, 1]"));
}

TEST(TimingsCsv, HasALineForEachPassAndRow) {
    const std::string text = asCsv(threeFrames());
    EXPECT_THAT(text, HasSubstr("\nb,3,3,1,0.25,0.25,0.125\n"));
    EXPECT_THAT(text, HasSubstr("\nwall,0,0,0,6,9,4\n"));
}

TEST(Trace, PutsEachFrameWhereItWas) {
    const Json::Value trace = test::parsed(asTrace(threeFrames()));
    std::vector<std::int64_t> begins;
    for (const Json::Value& slice : test::eventsOf(trace, "X"))
        if (slice["tid"] == 1 && slice["cat"] == "frame") begins.push_back(test::beginOf(slice));
    EXPECT_THAT(begins, ElementsAre(0, 10'000'000, 20'000'000));
}

TEST(Trace, HasRecordingWaitingAndThePassesOfEachPlan) {
    const Json::Value trace = test::parsed(asTrace(threeFrames()));
    std::vector<std::string> cpu;
    std::vector<std::string> gpu;
    for (const Json::Value& slice : test::eventsOf(trace, "X"))
        (slice["tid"] == 1 ? cpu : gpu).push_back(slice["name"].asString());
    EXPECT_THAT(
        cpu, ElementsAre("frame 0", "recording", "a", "b", "waiting", "waiting", "frame 1", "recording", "b",
                         "waiting", "waiting", "frame 2", "recording", "c", "b", "waiting", "waiting"));
    EXPECT_THAT(gpu, ElementsAre("frame 0", "a", "b", "frame 1", "b", "frame 2", "c", "b"));
}

TEST(Trace, MarksWhatWasLeftOutAndReloads) {
    const std::vector<Json::Value> instants = test::eventsOf(test::parsed(asTrace(threeFrames())), "i");
    ASSERT_EQ(instants.size(), 3U);
    EXPECT_EQ(instants[0]["name"], "skipped d");
    EXPECT_EQ(instants[0]["args"]["why"], "its skipWhen holds");
    EXPECT_EQ(instants[1]["name"], "kept a");
    EXPECT_EQ(instants[1]["tid"], 2);
    // After a frame's recording of 0.5 ms and half of its waiting.
    EXPECT_EQ(test::beginOf(instants[1]), 10'750'000);
    EXPECT_EQ(instants[2]["name"], "reload");
    EXPECT_EQ(instants[2]["s"], "g");
    EXPECT_EQ(test::beginOf(instants[2]), 19'000'000);
    EXPECT_EQ(instants[2]["args"]["why"], "graph g.json");
}

TEST(Trace, NamesItsLanesAndWhatRan) {
    const std::vector<Json::Value> names = test::eventsOf(test::parsed(asTrace(threeFrames())), "M");
    ASSERT_GE(names.size(), 3U);
    EXPECT_EQ(names[0]["name"], "process_name");
    EXPECT_THAT(names[0]["args"]["name"].asString(), HasSubstr("g.json"));
    EXPECT_EQ(names[1]["args"]["name"], "CPU");
    EXPECT_EQ(names[2]["args"]["name"], "GPU");
}

TEST(Trace, StartsWithAMarkBeforeTheFirstFrame) {
    Report report = threeFrames();
    report.marks[0].time = report.frames[0].times.start - 2ms;
    const Json::Value trace = test::parsed(asTrace(report));
    EXPECT_EQ(test::beginOf(test::eventsOf(trace, "i").back()), 0);
    EXPECT_EQ(test::beginOf(test::eventsOf(trace, "X").front()), 2'000'000);
}

TEST(Trace, NestsWhateverTheDigits) {
    Report report = threeFrames();
    report.frames.clear();
    auto start = std::chrono::steady_clock::time_point(123456789012345ns);
    for (int i = 1; i < 200; ++i) {
        const double unit = 1e-3 * i / 7;
        report.frames.push_back({{start,
                                  13 * unit,
                                  4 * unit,
                                  2 * unit,
                                  {ran(3 * unit, unit, unit), ran(4 * unit, 2 * unit, 2 * unit)}},
                                 0});
        start += std::chrono::nanoseconds(static_cast<std::int64_t>(13e6 * unit));
    }
    const std::vector<Json::Value> slices = test::eventsOf(test::parsed(asTrace(report)), "X");
    for (std::size_t i = 0; i < slices.size(); ++i)
        for (std::size_t j = i + 1; j < std::min(i + 20, slices.size()); ++j)
            if (slices[i]["tid"] == slices[j]["tid"]) {
                EXPECT_TRUE(test::nest(slices[i], slices[j])) << slices[i] << slices[j];
            }
}

TEST(Trace, OfNoFramesIsEmptyButWhole) {
    Report report = threeFrames();
    report.frames.clear();
    report.marks.clear();
    EXPECT_TRUE(test::eventsOf(test::parsed(asTrace(report)), "X").empty());
}

}  // namespace
}  // namespace nephrite::timings
