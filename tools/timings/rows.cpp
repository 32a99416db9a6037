// Times of frames, sorted by what took them.
#include "timings/rows.h"

namespace nephrite::timings {
namespace {

std::vector<double> ofFrames(const Report& report, double runtime::FrameTimes::*value) {
    std::vector<double> values;
    for (const Frame& frame : report.frames) values.push_back(frame.times.*value);
    return values;
}

}  // namespace

std::vector<PassRow> passRows(const Report& report) {
    std::vector<PassRow> rows;
    for (const std::string& name : report.passes) rows.push_back({name, {}, {}, {}});
    for (const Frame& frame : report.frames) {
        const std::vector<std::uint32_t>& passes = report.plans[frame.plan];
        for (std::size_t i = 0; i < passes.size(); ++i) {
            const runtime::PassTime& time = frame.times.passes[i];
            if (!time.ran) continue;
            PassRow& row = rows[passes[i]];
            row.gpuMs.push_back(time.gpuMs);
            row.cpuMs.push_back(time.cpuMs);
            row.counts = time.counts;
        }
    }
    return rows;
}

std::vector<FrameRow> frameRows(const Report& report) {
    return {{"recording", ofFrames(report, &runtime::FrameTimes::recordMs)},
            {"waiting", ofFrames(report, &runtime::FrameTimes::waitMs)}};
}

std::vector<double> wallTimes(const Report& report) {
    return ofFrames(report, &runtime::FrameTimes::wallMs);
}

std::vector<double> gpuTimes(const Report& report) {
    std::vector<double> sums;
    for (const Frame& frame : report.frames) {
        double sum = 0;
        for (const runtime::PassTime& pass : frame.times.passes) sum += pass.gpuMs;
        sums.push_back(sum);
    }
    return sums;
}

}  // namespace nephrite::timings
