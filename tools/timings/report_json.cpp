// A report as JSON: docs/measuring.md has the keys.
#include <cmath>

#include "runtime/frame/time_statistics.h"
#include "text/json_write.h"
#include "timings/rows.h"

namespace nephrite::timings {
namespace {

/// Clocks count nanoseconds; more digits only fill the file.
double toNanosecond(double milliseconds) {
    return std::round(milliseconds * 1e6) / 1e6;
}

Json::Value timesAsJson(const std::vector<double>& times) {
    const runtime::TimeStatistics statistics = runtime::timeStatistics(times);
    Json::Value value;
    value["median"] = statistics.median;
    value["p95"] = statistics.p95;
    value["min"] = statistics.min;
    value["samples"] = Json::arrayValue;
    for (const double time : times) value["samples"].append(toNanosecond(time));
    return value;
}

Json::Value countsAsJson(const gpu::PipelineCounts& counts) {
    Json::Value value;
    value["vertex"] = static_cast<Json::UInt64>(counts.vertexInvocations);
    value["clipping"] = static_cast<Json::UInt64>(counts.clippingInvocations);
    value["fragment"] = static_cast<Json::UInt64>(counts.fragmentInvocations);
    value["compute"] = static_cast<Json::UInt64>(counts.computeInvocations);
    return value;
}

Json::Value rowAsJson(const PassRow& row, std::size_t frames) {
    Json::Value entry;
    entry["name"] = row.name;
    entry["gpuMs"] = timesAsJson(row.gpuMs);
    entry["cpuMs"] = timesAsJson(row.cpuMs);
    entry["ran"] = static_cast<Json::UInt64>(row.gpuMs.size());
    entry["skipped"] = static_cast<Json::UInt64>(frames - row.gpuMs.size());
    if (row.counts) entry["invocations"] = countsAsJson(*row.counts);
    return entry;
}

/// How often each layer of skipping left something out: passes of the plan, and pass by pass of all frames
/// for what had not changed.
Json::Value skipCounts(const Report& report) {
    std::size_t unchanged = 0;
    for (const Frame& frame : report.frames)
        for (const runtime::PassTime& pass : frame.times.passes) unchanged += pass.ran ? 0 : 1;
    Json::Value counts;
    counts["notNeeded"] = report.skips.notNeeded;
    counts["neutral"] = report.skips.neutral;
    counts["unchanged"] = static_cast<Json::UInt64>(unchanged);
    counts["tiled"] = report.skips.tiled;
    counts["specialized"] = report.skips.specialized;
    return counts;
}

}  // namespace

std::string asJson(const Report& report) {
    const std::vector<FrameRow> rows = frameRows(report);
    Json::Value root;
    root["device"] = report.device;
    root["driver"] = report.driver;
    root["commit"] = report.commit;
    root["graph"] = report.graph;
    root["scene"] = report.scene;
    root["width"] = report.width;
    root["height"] = report.height;
    root["frames"] = static_cast<Json::UInt64>(report.frames.size());
    root["warmup"] = report.warmup;
    root["profiled"] = report.profiled;
    root["wallMs"] = timesAsJson(wallTimes(report));
    root["gpuMs"] = timesAsJson(gpuTimes(report));
    root["cpuMs"] = timesAsJson(rows.front().cpuMs);
    root["passes"] = Json::arrayValue;
    for (const PassRow& row : passRows(report)) root["passes"].append(rowAsJson(row, report.frames.size()));
    for (const SkippedNode& node : report.skipped)
        root["passes"].append(rowAsJson({node.name, {}, {}, {}}, report.frames.size()));
    root["skips"] = skipCounts(report);
    root["rows"] = Json::arrayValue;
    for (const FrameRow& row : rows) {
        Json::Value entry;
        entry["name"] = row.name;
        entry["cpuMs"] = timesAsJson(row.cpuMs);
        root["rows"].append(entry);
    }
    return json::toText(root);
}

}  // namespace nephrite::timings
