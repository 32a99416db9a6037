// The trace of a real render, read from the file: everything lies where it belongs and adds up.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <set>

#include "runtime/session.h"
#include "scratch_folder.h"
#include "timings/report.h"
#include "timings/trace_events.h"

namespace nephrite::timings {
namespace {

using test::beginOf;
using test::endOf;

Json::Value traceOf(const runtime::SessionOptions& options, const std::filesystem::path& file, int frames) {
    runtime::Session session(options);
    Report report;
    usePlan(report, session.plan());
    for (int i = 0; i < 3; ++i) session.renderFrame(0);
    for (int i = 0; i < frames; ++i) addFrame(report, session.renderFrame(0));
    write(file, report);
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    return test::parsed(text.str());
}

runtime::SessionOptions paperGraph(std::uint32_t side) {
    runtime::SessionOptions options;
    options.graph = std::filesystem::path(NEPHRITE_SOURCE_DIR) / "graphs" / "paper.json";
    options.scene = std::filesystem::path(NEPHRITE_SOURCE_DIR) / "graphs" / "scenes" / "sphere.json";
    options.size = {side, side};
    return options;
}

/// The slices of a lane inside frame `name`, the frame's own first.
std::vector<Json::Value> insideFrame(const std::vector<Json::Value>& slices, const std::string& name,
                                     int lane) {
    std::vector<Json::Value> inside;
    for (const Json::Value& slice : slices)
        if (slice["tid"] == lane && slice["name"] == name) inside.push_back(slice);
    for (const Json::Value& slice : slices)
        if (slice["tid"] == lane && slice["cat"] != "frame" && beginOf(slice) >= beginOf(inside.at(0)) &&
            beginOf(slice) < endOf(inside.at(0)))
            inside.push_back(slice);
    return inside;
}

TEST(ProfiledTrace, AddsUpToTheWallTimeOfEachFrame) {
    const ScratchFolder folder;
    runtime::SessionOptions options = paperGraph(128);
    options.profile = true;
    constexpr int frames = 5;
    const Json::Value trace = traceOf(options, folder.path() / "t.trace.json", frames);
    const std::vector<Json::Value> slices = test::eventsOf(trace, "X");
    std::vector<double> waits;
    for (int i = 0; i < frames; ++i) {
        const std::string name = "frame " + std::to_string(i);
        const auto cpu = insideFrame(slices, name, 1);
        const auto gpu = insideFrame(slices, name, 2);
        EXPECT_GT(gpu.size(), 10U);
        // The GPU's part of a frame lies in the CPU's frame, and no slice leaves the one around it.
        EXPECT_TRUE(beginOf(cpu[0]) <= beginOf(gpu[0]) && endOf(gpu[0]) <= endOf(cpu[0]));
        double sum = 0;
        double waiting = 0;
        for (const auto* lane : {&cpu, &gpu})
            for (std::size_t a = 1; a < lane->size(); ++a) {
                const Json::Value& slice = (*lane)[a];
                EXPECT_LE(endOf(slice), endOf(lane->front())) << slice;
                for (std::size_t b = a + 1; b < lane->size(); ++b)
                    EXPECT_TRUE(test::nest(slice, (*lane)[b])) << slice << (*lane)[b];
                const bool isWait = slice["name"] == "waiting";
                if (isWait) waiting += slice["dur"].asDouble();
                if (isWait || slice["name"] == "recording" || slice["cat"] == "pass")
                    sum += slice["dur"].asDouble();
            }
        const double wall = cpu[0]["dur"].asDouble();
        EXPECT_NEAR(sum / wall, 1, 0.03) << name;
        waits.push_back(waiting / wall);
    }
    // Time that belongs to no pass would hide in the waiting.
    std::sort(waits.begin(), waits.end());
    EXPECT_LT(waits[frames / 2], 0.05);
}

TEST(ProfiledTrace, HasThePassesAndTheirInvocations) {
    const ScratchFolder folder;
    runtime::SessionOptions options = paperGraph(32);
    options.profile = true;
    const Json::Value trace = traceOf(options, folder.path() / "t.trace.json", 1);
    std::set<std::string> passes;
    for (const Json::Value& slice : test::eventsOf(trace, "X")) {
        if (slice["cat"] != "pass") continue;
        passes.insert(slice["name"].asString());
        if (slice.isMember("args") && slice["name"] == "dipole") {
            EXPECT_GT(slice["args"]["computeInvocations"].asInt(), 0);
        }
    }
    EXPECT_TRUE(passes.count("gbuffer") == 1 && passes.count("dipole") == 1);
}

TEST(ReusingTrace, MarksEachKeptPass) {
    const ScratchFolder folder;
    runtime::SessionOptions options = paperGraph(32);
    options.reuse = true;
    const Json::Value trace = traceOf(options, folder.path() / "t.trace.json", 2);
    int kept = 0;
    for (const Json::Value& instant : test::eventsOf(trace, "i")) kept += instant["name"] == "kept dipole";
    EXPECT_EQ(kept, 2);  // a still scene: in both frames
}

}  // namespace
}  // namespace nephrite::timings
