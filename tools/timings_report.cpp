// Statistics over frames and the three ways they are written.
#include "timings_report.h"

#include <fmt/format.h>
#include <json/json.h>

#include <algorithm>
#include <functional>

#include "image/output_file.h"
#include "runtime/time_statistics.h"
#include "text/diagnostics.h"

namespace nephrite::tools {
namespace {

using runtime::FrameTimes;
using runtime::timeStatistics;
using runtime::TimeStatistics;

TimeStatistics over(const TimingsReport& report, const std::function<double(const FrameTimes&)>& value) {
    std::vector<double> values;
    for (const FrameTimes& frame : report.frames) values.push_back(value(frame));
    return timeStatistics(std::move(values));
}

double gpuSum(const FrameTimes& frame) {
    double sum = 0;
    for (const auto& pass : frame.passes) sum += pass.gpuMs;
    return sum;
}

/// A line of the report: a pass, or one of the rows around them.
struct Row {
    std::string name;
    TimeStatistics gpu;
    TimeStatistics cpu;
    std::size_t ran = 0;  ///< frames in which a pass ran; its statistics are of these
};

Row passRow(const TimingsReport& report, std::size_t pass) {
    std::vector<double> gpu;
    std::vector<double> cpu;
    for (const FrameTimes& frame : report.frames) {
        if (!frame.passes[pass].ran) continue;
        gpu.push_back(frame.passes[pass].gpuMs);
        cpu.push_back(frame.passes[pass].cpuMs);
    }
    const std::size_t ran = gpu.size();
    return {report.passes[pass], timeStatistics(std::move(gpu)), timeStatistics(std::move(cpu)), ran};
}

std::vector<Row> passRows(const TimingsReport& report) {
    std::vector<Row> rows;
    for (std::size_t i = 0; i < report.passes.size(); ++i) rows.push_back(passRow(report, i));
    return rows;
}

/// How often each layer of skipping left something out: passes of the plan, and pass by pass of all frames
/// for what had not changed.
Json::Value skipCounts(const TimingsReport& report) {
    std::size_t unchanged = 0;
    for (const Row& row : passRows(report)) unchanged += report.frames.size() - row.ran;
    Json::Value counts;
    counts["notNeeded"] = report.skips.notNeeded;
    counts["neutral"] = report.skips.neutral;
    counts["unchanged"] = static_cast<Json::UInt64>(unchanged);
    counts["tiled"] = report.skips.tiled;
    counts["specialized"] = report.skips.specialized;
    return counts;
}

std::vector<Row> frameRows(const TimingsReport& report) {
    return {{"recording", {}, over(report, [](const FrameTimes& f) { return f.recordMs; }), 0},
            {"waiting", {}, over(report, [](const FrameTimes& f) { return f.waitMs; }), 0}};
}

Json::Value asJson(const TimeStatistics& statistics) {
    Json::Value value;
    value["median"] = statistics.median;
    value["p95"] = statistics.p95;
    value["min"] = statistics.min;
    return value;
}

std::string written(const Json::Value& value) {
    Json::StreamWriterBuilder builder;
    builder["indentation"] = "  ";
    builder["precision"] = 17;
    return Json::writeString(builder, value) + "\n";
}

Json::Value passEntry(const Row& row, std::size_t frames) {
    Json::Value entry;
    entry["name"] = row.name;
    entry["gpuMs"] = asJson(row.gpu);
    entry["cpuMs"] = asJson(row.cpu);
    entry["ran"] = static_cast<Json::UInt64>(row.ran);
    entry["skipped"] = static_cast<Json::UInt64>(frames - row.ran);
    return entry;
}

Json::Value traceEvent(std::string_view name, int lane, double startMs, double durationMs) {
    Json::Value event;
    event["name"] = std::string(name);
    event["ph"] = "X";
    event["pid"] = 1;
    event["tid"] = lane;
    event["ts"] = startMs * 1000;
    event["dur"] = durationMs * 1000;
    return event;
}

Json::Value laneName(int lane, const char* name) {
    Json::Value event;
    event["name"] = "thread_name";
    event["ph"] = "M";
    event["pid"] = 1;
    event["tid"] = lane;
    event["args"]["name"] = name;
    return event;
}

constexpr int cpuLane = 1;
constexpr int gpuLane = 2;

/// The GPU's part of a frame is drawn right after recording: the waiting time is its own lead and tail.
void appendFrame(Json::Value& events, const TimingsReport& report, std::size_t index, double start) {
    const FrameTimes& frame = report.frames[index];
    const std::string name = fmt::format("frame {}", index);
    events.append(traceEvent(name, cpuLane, start, frame.wallMs));
    events.append(traceEvent("recording", cpuLane, start, frame.recordMs));
    events.append(traceEvent("waiting", cpuLane, start + frame.recordMs, frame.wallMs - frame.recordMs));
    double at = start + frame.recordMs + frame.waitMs / 2;
    events.append(traceEvent(name, gpuLane, at, gpuSum(frame)));
    for (std::size_t i = 0; i < report.passes.size(); ++i) {
        events.append(traceEvent(report.passes[i], gpuLane, at, frame.passes[i].gpuMs));
        at += frame.passes[i].gpuMs;
    }
}

}  // namespace

std::string timingsAsJson(const TimingsReport& report) {
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
    root["wallMs"] = asJson(over(report, [](const FrameTimes& f) { return f.wallMs; }));
    root["gpuMs"] = asJson(over(report, gpuSum));
    root["cpuMs"] = asJson(over(report, [](const FrameTimes& f) { return f.recordMs; }));
    root["passes"] = Json::arrayValue;
    for (const Row& row : passRows(report)) root["passes"].append(passEntry(row, report.frames.size()));
    for (const std::string& name : report.skipped)
        root["passes"].append(passEntry({name, {}, {}, 0}, report.frames.size()));
    root["skips"] = skipCounts(report);
    root["rows"] = Json::arrayValue;
    for (const Row& row : frameRows(report)) {
        Json::Value entry;
        entry["name"] = row.name;
        entry["cpuMs"] = asJson(row.cpu);
        root["rows"].append(entry);
    }
    return written(root);
}

std::string timingsAsCsv(const TimingsReport& report) {
    std::string text = "name,gpuMedianMs,gpuP95Ms,gpuMinMs,cpuMedianMs,cpuP95Ms,cpuMinMs\n";
    std::vector<Row> rows = passRows(report);
    for (Row& row : frameRows(report)) rows.push_back(std::move(row));
    rows.push_back({"wall", {}, over(report, [](const FrameTimes& f) { return f.wallMs; }), 0});
    for (const Row& row : rows)
        text += fmt::format("{},{:.17g},{:.17g},{:.17g},{:.17g},{:.17g},{:.17g}\n", row.name, row.gpu.median,
                            row.gpu.p95, row.gpu.min, row.cpu.median, row.cpu.p95, row.cpu.min);
    return text;
}

std::string timingsAsTrace(const TimingsReport& report) {
    Json::Value root;
    Json::Value& events = root["traceEvents"];
    events.append(laneName(cpuLane, "CPU"));
    events.append(laneName(gpuLane, "GPU"));
    double start = 0;
    for (std::size_t i = 0; i < report.frames.size(); ++i) {
        appendFrame(events, report, i, start);
        start += report.frames[i].wallMs;
    }
    root["displayTimeUnit"] = "ms";
    return written(root);
}

void requireTimingsName(const std::filesystem::path& file) {
    const std::string extension = file.extension().string();
    if (extension == ".csv" || extension == ".json" || extension.empty()) return;
    throw InputError(
        {file.string()},
        fmt::format("expected a name ending in .json, .csv or .trace.json, found \"{}\"", extension));
}

void writeTimings(const std::filesystem::path& file, const TimingsReport& report) {
    if (file.extension() == ".csv") return image::writeFile(file, timingsAsCsv(report));
    const bool trace = file.extension() == ".json" && file.stem().extension() == ".trace";
    image::writeFile(file, trace ? timingsAsTrace(report) : timingsAsJson(report));
}

}  // namespace nephrite::tools
