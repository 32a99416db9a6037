// Keeping the times of the last frames.
#include "view/pass_times.h"

#include <algorithm>

namespace nephrite::view {
namespace {

void append(std::vector<float>& values, double value) {
    if (values.size() == PassTimes::length) values.erase(values.begin());
    values.push_back(static_cast<float>(value));
}

}  // namespace

float TimeSeries::medianGpuMs() const {
    std::vector<float> frames;
    for (std::size_t i = 0; i < gpuMs.size(); ++i)
        if (gpuMs[i] > 0) frames.push_back(gpuMs[i]);
    if (frames.empty()) return 0;
    const auto middle = frames.begin() + static_cast<std::ptrdiff_t>(frames.size() / 2);
    std::nth_element(frames.begin(), middle, frames.end());
    return *middle;
}

const TimeSeries* PassTimes::find(const std::string& pass) const {
    const auto found = series_.find(pass);
    return found == series_.end() ? nullptr : &found->second;
}

void PassTimes::add(const graph::Plan& plan, const runtime::FrameTimes& times) {
    ++frames_;
    last_ = times;
    append(wallMs_, times.wallMs);
    passes_.clear();
    std::map<std::string, TimeSeries> series;
    for (std::size_t i = 0; i < times.passes.size(); ++i) {
        const std::string& name = plan.nameOf(plan.passes[i]);
        passes_.push_back(name);
        TimeSeries& one = series[name];
        if (const auto known = series_.find(name); known != series_.end()) one = std::move(known->second);
        append(one.gpuMs, times.passes[i].gpuMs);
        append(one.cpuMs, times.passes[i].cpuMs);
        one.ran = times.passes[i].ran;
    }
    series_ = std::move(series);
}

}  // namespace nephrite::view
