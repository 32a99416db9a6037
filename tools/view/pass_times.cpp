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
    std::vector<float> ran;
    for (std::size_t i = 0; i < gpuMs.size(); ++i)
        if (gpuMs[i] > 0) ran.push_back(gpuMs[i]);
    if (ran.empty()) return 0;
    const auto middle = ran.begin() + static_cast<std::ptrdiff_t>(ran.size() / 2);
    std::nth_element(ran.begin(), middle, ran.end());
    return *middle;
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
