// Two timing dumps held against each other: which pass changed beyond the noise.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "timings/dump.h"
#include "timings/shift.h"

namespace nephrite::timings {

struct ComparisonOptions {
    double confidence = 0.95;  ///< that every interval of a comparison holds
    double threshold = 0.05;   ///< smaller changes, as a share of the time before, do not count
    double leastMs = 0.02;     ///< nor do smaller ones than this
};

enum class Verdict : std::uint8_t { Same, Faster, Slower, OnlyBefore, OnlyAfter, TooFewFrames };

/// "the same", "faster", "slower", "only in A", "only in B", "too few frames".
std::string_view name(Verdict verdict);

struct ComparedSeries {
    std::string name;
    bool isPass = true;
    std::optional<double> before;  ///< median, ms; nothing if it never ran there
    std::optional<double> after;
    std::optional<Shift> shift;  ///< ms; of what ran in both
    Verdict verdict = Verdict::Same;
};

struct Comparison {
    ComparisonOptions options;
    std::vector<ComparedSeries>
        series;  ///< in the order of the later dump, then what only the earlier one has
    std::vector<std::string> warnings;  ///< why the two may not be comparable
};

/// A pass is slower or faster if the whole interval of its shift lies beyond the threshold: the noise of the
/// frames is ruled out as well as a change too small to care about. The intervals hold together, so a graph
/// of many passes finds no more differences by chance than one of few. What never ran in either is left out.
Comparison compare(const Dump& before, const Dump& after, const ComparisonOptions& options);

std::string asTable(const Comparison& comparison);
/// docs/measuring.md has the keys.
std::string asJson(const Comparison& comparison, const Dump& before, const Dump& after);

}  // namespace nephrite::timings
