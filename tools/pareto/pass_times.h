// The times of a graph's passes over many frames.
#pragma once

#include <json/value.h>

#include <string>
#include <vector>

#include "graph/plan.h"
#include "runtime/frame/time_statistics.h"
#include "runtime/frame/timings.h"

namespace nephrite::pareto {

/// A pass of a profiled graph, timed alone.
struct PassResult {
    std::string name;
    runtime::TimeStatistics gpuMs;
    runtime::TimeStatistics cpuMs;
};

/// Of frames in which every pass of the plan ran.
std::vector<PassResult> passTimes(const graph::Plan& plan, const std::vector<runtime::FrameTimes>& frames);

/// {"median", "p95", "min"}.
Json::Value toJson(const runtime::TimeStatistics& statistics);
/// {"name", "gpuMs", "cpuMs"}.
Json::Value toJson(const PassResult& pass);

}  // namespace nephrite::pareto
