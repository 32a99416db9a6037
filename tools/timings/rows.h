// The lines of a report: what each pass, and each part of a frame around them, took in every frame.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "timings/report.h"

namespace nephrite::timings {

/// A pass. Its times are of the frames in which it ran.
struct PassRow {
    std::string name;
    std::vector<double> gpuMs;
    std::vector<double> cpuMs;
    std::optional<gpu::PipelineCounts> counts;  ///< of the last frame in which it ran
};

/// A part of every frame that no pass accounts for.
struct FrameRow {
    std::string name;
    std::vector<double> cpuMs;
};

/// In the order of execution; passes that only an earlier plan had stay where that put them.
std::vector<PassRow> passRows(const Report& report);
/// "recording" and "waiting".
std::vector<FrameRow> frameRows(const Report& report);

std::vector<double> wallTimes(const Report& report);
/// The sum of each frame's passes.
std::vector<double> gpuTimes(const Report& report);

}  // namespace nephrite::timings
