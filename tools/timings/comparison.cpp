// Verdicts on pairs of time series.
#include "timings/comparison.h"

#include <fmt/format.h>

#include <algorithm>

#include "runtime/frame/time_statistics.h"
#include "text/diagnostics.h"

namespace nephrite::timings {
namespace {

const Series* find(const Dump& dump, const Series& like) {
    for (const Series& series : dump.series)
        if (series.name == like.name && series.isPass == like.isPass && !series.ms.empty()) return &series;
    return nullptr;
}

ComparedSeries compared(const Series* before, const Series* after) {
    const Series& known = after != nullptr ? *after : *before;
    ComparedSeries result{known.name, known.isPass, {}, {}, {}, Verdict::Same};
    if (before != nullptr) result.before = runtime::timeStatistics(before->ms).median;
    if (after != nullptr) result.after = runtime::timeStatistics(after->ms).median;
    if (after == nullptr) result.verdict = Verdict::OnlyBefore;
    if (before == nullptr) result.verdict = Verdict::OnlyAfter;
    return result;
}

Verdict verdictOn(const Shift& shift, double before, const ComparisonOptions& options) {
    const double margin = std::max(options.threshold * before, options.leastMs);
    if (!std::isfinite(shift.least)) return Verdict::TooFewFrames;
    if (shift.least > margin) return Verdict::Slower;
    if (shift.greatest < -margin) return Verdict::Faster;
    return Verdict::Same;
}

void warnIfDifferent(const std::string& what, const std::string& before, const std::string& after,
                     std::vector<std::string>& warnings) {
    if (before != after)
        warnings.push_back(fmt::format("another {}: {} and {}", what, inQuotes(before), inQuotes(after)));
}

std::vector<std::string> warningsOn(const Dump& before, const Dump& after) {
    const auto size = [](const Dump& dump) { return fmt::format("{} x {}", dump.width, dump.height); };
    const auto profiled = [](const Dump& dump) {
        return std::string(dump.profiled ? "profiled" : "not profiled");
    };
    std::vector<std::string> warnings;
    warnIfDifferent("device", before.device, after.device, warnings);
    warnIfDifferent("driver", before.driver, after.driver, warnings);
    warnIfDifferent("scene", before.scene, after.scene, warnings);
    warnIfDifferent("size", size(before), size(after), warnings);
    warnIfDifferent("way of timing", profiled(before), profiled(after), warnings);
    if (!before.profiled && !after.profiled)
        warnings.push_back(
            "not profiled: times of passes are only hints, and of those frames in which they ran");
    return warnings;
}

}  // namespace

std::string_view name(Verdict verdict) {
    switch (verdict) {
        case Verdict::Faster:
            return "faster";
        case Verdict::Slower:
            return "slower";
        case Verdict::OnlyBefore:
            return "only in A";
        case Verdict::OnlyAfter:
            return "only in B";
        case Verdict::TooFewFrames:
            return "too few frames";
        default:
            return "the same";
    }
}

Comparison compare(const Dump& before, const Dump& after, const ComparisonOptions& options) {
    Comparison comparison{options, {}, warningsOn(before, after)};
    std::vector<std::pair<const Series*, const Series*>> pairs;
    for (const Series& series : after.series)
        if (!series.ms.empty()) pairs.emplace_back(find(before, series), &series);
    for (const Series& series : before.series)
        if (!series.ms.empty() && find(after, series) == nullptr) pairs.emplace_back(&series, nullptr);
    std::stable_partition(pairs.begin(), pairs.end(),
                          [](const auto& pair) { return (pair.second ? pair.second : pair.first)->isPass; });
    const auto both =
        std::count_if(pairs.begin(), pairs.end(), [](const auto& pair) { return pair.first && pair.second; });
    const double confidence = confidenceOfEach(options.confidence, static_cast<std::size_t>(both));
    for (const auto& [earlier, later] : pairs) {
        ComparedSeries& series = comparison.series.emplace_back(compared(earlier, later));
        if (earlier == nullptr || later == nullptr) continue;
        series.shift = shiftBetween(earlier->ms, later->ms, confidence);
        series.verdict = verdictOn(*series.shift, *series.before, options);
    }
    return comparison;
}

}  // namespace nephrite::timings
