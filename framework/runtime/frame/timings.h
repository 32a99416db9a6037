// What a frame took: passes on the GPU and the CPU, and the named rows around them.
#pragma once

#include <chrono>
#include <optional>
#include <vector>

#include "gpu/pipeline_counts.h"

namespace nephrite::runtime {

struct PassTime {
    double gpuMs = 0;
    double cpuMs = 0;       ///< recording its commands
    double cpuStartMs = 0;  ///< from the start of the frame to the start of that
    bool ran = true;        ///< false: nothing it reads had changed, its last results are kept
    /// With profiling, where the device can count them.
    std::optional<gpu::PipelineCounts> counts = {};
};

/// Times of one frame. Without profiling neighbouring passes may overlap and their GPU times are only a hint.
struct FrameTimes {
    std::chrono::steady_clock::time_point start;
    double wallMs = 0;    ///< from the start of the frame to its images being ready
    double recordMs = 0;  ///< CPU: scene update and command recording up to the submit
    double waitMs = 0;    ///< submit and wait, less the time from the first to the last GPU timestamp
    std::vector<PassTime> passes;  ///< as Plan::passes
};

}  // namespace nephrite::runtime
