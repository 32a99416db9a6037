// What a run's frames took, and how that is written: JSON, CSV, Chrome trace.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "graph/plan.h"
#include "runtime/frame/timings.h"

namespace nephrite::timings {

/// A node that no frame runs.
struct SkippedNode {
    std::string name;
    std::string why;
};

/// Something that happened between frames, say a reload.
struct Mark {
    std::chrono::steady_clock::time_point time;
    std::string name;
    std::string detail;
};

struct Frame {
    runtime::FrameTimes times;
    std::size_t plan = 0;  ///< whose passes these are: an index into Report::plans
};

/// A run of frames of one graph and scene.
struct Report {
    std::string device;
    std::string driver;
    std::string commit;
    std::string graph;
    std::string scene;
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::uint32_t warmup = 0;
    bool profiled = false;
    std::vector<std::string> passes;                ///< names of the passes of all plans
    std::vector<std::vector<std::uint32_t>> plans;  ///< the passes of each, as indices into `passes`
    std::vector<SkippedNode> skipped;               ///< of the last plan
    graph::SkipCounts skips;                        ///< what the last plan leaves out
    std::vector<Frame> frames;                      ///< after the warm-up
    std::vector<Mark> marks;
};

/// From here on frames are of this plan: to be called before the first, and whenever the plan changes.
void usePlan(Report& report, const graph::Plan& plan);
/// Adds a frame of the plan used last.
void addFrame(Report& report, runtime::FrameTimes times);

/// The JSON other programs rely on, and two rows beside the passes: "recording" (CPU time up to the submit)
/// and "waiting" (submit and wait without the GPU's own time). With profiling, passes and rows add up to the
/// wall time.
std::string asJson(const Report& report);
/// One line a pass or row: name,gpu median,p95,min,cpu median,p95,min (milliseconds).
std::string asCsv(const Report& report);
/// Chrome's trace event format: a CPU and a GPU lane, passes nested in frames; what was left out and the
/// marks as instants.
std::string asTrace(const Report& report);

/// Throws InputError unless the name ends in .json or .csv, or has no ending (a device, written as JSON).
void requireName(const std::filesystem::path& file);
/// Writes by the name's ending: .csv, .trace.json, else .json. Throws RunError.
void write(const std::filesystem::path& file, const Report& report);

}  // namespace nephrite::timings
