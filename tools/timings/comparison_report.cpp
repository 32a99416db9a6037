// A comparison as a table and as JSON.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "text/json_write.h"
#include "timings/comparison.h"

namespace nephrite::timings {
namespace {

std::string milliseconds(const std::optional<double>& time) {
    return time ? fmt::format("{:.4g}", *time) : "-";
}

/// A difference as a share of what it is a difference from, in words.
std::string percent(double difference, double of) {
    if (!(of > 0)) return "-";
    if (!std::isfinite(difference)) return difference < 0 ? "-inf" : "+inf";
    return fmt::format("{:+.1f} %", 100 * difference / of);
}

Json::Value share(double difference, double of) {
    return of > 0 ? Json::Value(difference / of) : Json::Value();
}

Json::Value asJson(const ComparedSeries& series) {
    Json::Value value;
    value["name"] = series.name;
    value["kind"] = series.isPass ? "pass" : "frame";
    value["verdict"] = std::string(name(series.verdict));
    value["beforeMs"] = series.before ? Json::Value(*series.before) : Json::Value();
    value["afterMs"] = series.after ? Json::Value(*series.after) : Json::Value();
    if (!series.shift) return value;
    value["shiftMs"] = series.shift->estimate;
    value["shiftIntervalMs"].append(series.shift->least);
    value["shiftIntervalMs"].append(series.shift->greatest);
    value["change"] = share(series.shift->estimate, *series.before);
    value["changeInterval"].append(share(series.shift->least, *series.before));
    value["changeInterval"].append(share(series.shift->greatest, *series.before));
    return value;
}

std::string summaryOf(const Comparison& comparison) {
    std::string changed;
    for (const ComparedSeries& series : comparison.series)
        if (series.verdict != Verdict::Same && series.verdict != Verdict::TooFewFrames)
            changed +=
                fmt::format("{}{} ({})", changed.empty() ? "" : ", ", series.name, name(series.verdict));
    return changed.empty() ? "nothing changed beyond the noise" : "changed: " + changed;
}

}  // namespace

std::string asTable(const Comparison& comparison) {
    std::size_t width = 4;
    for (const ComparedSeries& series : comparison.series) width = std::max(width, series.name.size());
    std::string text = fmt::format("{:<{}}{:>12}{:>12}{:>11}{:>25}  {}\n", "pass", width, "before ms",
                                   "after ms", "change", "interval", "verdict");
    bool isPass = true;
    for (const ComparedSeries& series : comparison.series) {
        if (isPass && !series.isPass) text += "\n";
        isPass = series.isPass;
        std::string change = "-";
        std::string interval = "-";
        if (series.shift) {
            change = percent(series.shift->estimate, *series.before);
            interval = fmt::format("{} to {}", percent(series.shift->least, *series.before),
                                   percent(series.shift->greatest, *series.before));
        }
        text += fmt::format("{:<{}}{:>12}{:>12}{:>11}{:>25}  {}\n", series.name, width,
                            milliseconds(series.before), milliseconds(series.after), change, interval,
                            name(series.verdict));
    }
    return text + fmt::format(
                      "\n{}\nnoise: all intervals together hold with {:g} %; changes below {:g} % or "
                      "{:g} ms do not count\n",
                      summaryOf(comparison), 100 * comparison.options.confidence,
                      100 * comparison.options.threshold, comparison.options.leastMs);
}

std::string asJson(const Comparison& comparison, const Dump& before, const Dump& after) {
    Json::Value value;
    value["before"] = before.file;
    value["after"] = after.file;
    value["confidence"] = comparison.options.confidence;
    value["threshold"] = comparison.options.threshold;
    value["leastMs"] = comparison.options.leastMs;
    value["warnings"] = Json::arrayValue;
    for (const std::string& warning : comparison.warnings) value["warnings"].append(warning);
    value["rows"] = Json::arrayValue;
    for (const ComparedSeries& series : comparison.series) value["rows"].append(asJson(series));
    return json::toText(value);
}

}  // namespace nephrite::timings
