// Statistics of passes, and how they are written.
#include "pareto/pass_times.h"

namespace nephrite::pareto {

std::vector<PassResult> passTimes(const graph::Plan& plan, const std::vector<runtime::FrameTimes>& frames) {
    std::vector<PassResult> passes;
    for (std::size_t i = 0; i < plan.passes.size(); ++i) {
        std::vector<double> gpu;
        std::vector<double> cpu;
        for (const runtime::FrameTimes& frame : frames) {
            gpu.push_back(frame.passes[i].gpuMs);
            cpu.push_back(frame.passes[i].cpuMs);
        }
        passes.push_back({plan.nameOf(plan.passes[i]), runtime::timeStatistics(std::move(gpu)),
                          runtime::timeStatistics(std::move(cpu))});
    }
    return passes;
}

Json::Value toJson(const runtime::TimeStatistics& statistics) {
    Json::Value value;
    value["median"] = statistics.median;
    value["p95"] = statistics.p95;
    value["min"] = statistics.min;
    return value;
}

Json::Value toJson(const PassResult& pass) {
    Json::Value value;
    value["name"] = pass.name;
    value["gpuMs"] = toJson(pass.gpuMs);
    value["cpuMs"] = toJson(pass.cpuMs);
    return value;
}

}  // namespace nephrite::pareto
