// What a run's frames took, as JSON, CSV or a Chrome trace.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "graph/plan.h"
#include "runtime/timings.h"

namespace nephrite::tools {

/// A run of frames of one graph and scene.
struct TimingsReport {
    std::string device;
    std::string driver;
    std::string commit;
    std::string graph;
    std::string scene;
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::uint32_t warmup = 0;
    bool profiled = false;
    std::vector<std::string> passes;          ///< names, as FrameTimes::passes
    std::vector<std::string> skipped;         ///< nodes the plan skipped
    graph::SkipCounts skips;                  ///< what the plan leaves out
    std::vector<runtime::FrameTimes> frames;  ///< after the warm-up
};

/// The JSON other programs rely on, and two rows beside the passes: "recording" (CPU time up to the submit)
/// and "waiting" (submit and wait without the GPU's own time). With profiling, passes and rows add up to the
/// wall time.
std::string timingsAsJson(const TimingsReport& report);
/// One line a pass or row: name,gpu median,p95,min,cpu median,p95,min (milliseconds).
std::string timingsAsCsv(const TimingsReport& report);
/// Chrome's trace event format: a CPU and a GPU lane, passes nested in frames.
std::string timingsAsTrace(const TimingsReport& report);

/// Throws InputError unless the name ends in .json or .csv, or has no ending (a device, written as JSON).
void requireTimingsName(const std::filesystem::path& file);
/// Writes by the name's ending: .csv, .trace.json, else .json. Throws RunError.
void writeTimings(const std::filesystem::path& file, const TimingsReport& report);

}  // namespace nephrite::tools
