// Collects frames, and chooses how a report is written.
#include "timings/report.h"

#include <fmt/format.h>

#include <algorithm>

#include "image/output_file.h"
#include "text/diagnostics.h"

namespace nephrite::timings {
namespace {

/// The index of a name, added if it is new.
std::uint32_t indexOf(const std::string& name, std::vector<std::string>& names) {
    const auto known = std::find(names.begin(), names.end(), name);
    const auto index = static_cast<std::uint32_t>(known - names.begin());
    if (known == names.end()) names.push_back(name);
    return index;
}

}  // namespace

void usePlan(Report& report, const graph::Plan& plan) {
    std::vector<std::uint32_t>& passes = report.plans.emplace_back();
    std::vector<bool> hasPass(plan.nodes.size(), false);
    for (const graph::PlannedPass& pass : plan.passes) {
        passes.push_back(indexOf(plan.nameOf(pass), report.passes));
        hasPass[pass.node] = true;
    }
    // A skipped node whose output is wanted still has a pass, which clears it.
    report.skipped.clear();
    for (graph::Index node = 0; node < plan.nodes.size(); ++node)
        if (plan.nodes[node].state == graph::NodeState::Skipped && !hasPass[node])
            report.skipped.push_back({plan.graph->nodeName(node), graph::whyOf(plan, node)});
    report.skips = plan.skips;
}

void addFrame(Report& report, runtime::FrameTimes times) {
    report.frames.push_back({std::move(times), report.plans.size() - 1});
}

void requireName(const std::filesystem::path& file) {
    const std::string extension = file.extension().string();
    if (extension == ".csv" || extension == ".json" || extension.empty()) return;
    throw InputError(
        {file.string()},
        fmt::format("expected a name ending in .json, .csv or .trace.json, found \"{}\"", extension));
}

void write(const std::filesystem::path& file, const Report& report) {
    if (file.extension() == ".csv") return image::writeFile(file, asCsv(report));
    const bool trace = file.extension() == ".json" && file.stem().extension() == ".trace";
    image::writeFile(file, trace ? asTrace(report) : asJson(report));
}

}  // namespace nephrite::timings
