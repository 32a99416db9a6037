// How long passes and frames took lately.
#pragma once

#include <deque>
#include <map>
#include <string>
#include <vector>

#include "graph/plan.h"
#include "runtime/frame/timings.h"

namespace nephrite::view {

/// Milliseconds of one thing in the last frames, the oldest first; at most PassTimes::length of them.
struct TimeSeries {
    std::vector<float> gpuMs;
    std::vector<float> cpuMs;
    bool ran = true;  ///< in the last frame
    /// Of the frames in which it ran.
    float medianGpuMs() const;
};

class PassTimes {
  public:
    static constexpr std::size_t length = 120;

    /// `times` are of a frame of that plan.
    void add(const graph::Plan& plan, const runtime::FrameTimes& times);

    std::uint64_t frames() const { return frames_; }
    const std::vector<float>& wallMs() const { return wallMs_; }
    const runtime::FrameTimes& last() const { return last_; }
    /// Passes of the last frame's plan, in execution order.
    const std::vector<std::string>& passes() const { return passes_; }
    const TimeSeries& of(const std::string& pass) const { return series_.at(pass); }
    /// The same, or nullptr for what is no pass of that plan.
    const TimeSeries* find(const std::string& pass) const;

  private:
    std::uint64_t frames_ = 0;
    std::vector<float> wallMs_;
    runtime::FrameTimes last_;
    std::vector<std::string> passes_;
    std::map<std::string, TimeSeries> series_;  ///< of passes_
};

}  // namespace nephrite::view
