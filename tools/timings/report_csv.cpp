// A report as comma-separated values.
#include <fmt/format.h>

#include "runtime/frame/time_statistics.h"
#include "timings/rows.h"

namespace nephrite::timings {
namespace {

std::string line(const std::string& name, const std::vector<double>& gpuMs,
                 const std::vector<double>& cpuMs) {
    const runtime::TimeStatistics gpu = runtime::timeStatistics(gpuMs);
    const runtime::TimeStatistics cpu = runtime::timeStatistics(cpuMs);
    return fmt::format("{},{:.17g},{:.17g},{:.17g},{:.17g},{:.17g},{:.17g}\n", name, gpu.median, gpu.p95,
                       gpu.min, cpu.median, cpu.p95, cpu.min);
}

}  // namespace

std::string asCsv(const Report& report) {
    std::string text = "name,gpuMedianMs,gpuP95Ms,gpuMinMs,cpuMedianMs,cpuP95Ms,cpuMinMs\n";
    for (const PassRow& row : passRows(report)) text += line(row.name, row.gpuMs, row.cpuMs);
    for (const FrameRow& row : frameRows(report)) text += line(row.name, {}, row.cpuMs);
    return text + line("wall", {}, wallTimes(report));
}

}  // namespace nephrite::timings
