// `nephrite bench compare-timings`: which pass changed between two timing dumps.
#include <fmt/format.h>

#include <array>
#include <cmath>

#include "bench.h"
#include "image/output_file.h"
#include "options.h"
#include "text/diagnostics.h"
#include "timings/comparison.h"

namespace nephrite::tools {
namespace {

struct CompareTimingsArguments {
    std::filesystem::path before;
    std::filesystem::path after;
    bool wantsJson = false;
    std::filesystem::path json;  ///< empty: standard output
    double threshold = 5;        ///< percent
    double leastMs = timings::ComparisonOptions().leastMs;
};

void requireAtLeastZero(const std::string& option, double value) {
    if (!(value >= 0 && std::isfinite(value)))
        throw InputError({option}, fmt::format("expected a number not below 0, found {}", value));
}

void compareTimings(const CompareTimingsArguments& arguments) {
    requireAtLeastZero("--threshold", arguments.threshold);
    requireAtLeastZero("--least", arguments.leastMs);
    requireOther(arguments.json, std::array{arguments.before, arguments.after});
    const timings::Dump before = timings::readDump(arguments.before);
    const timings::Dump after = timings::readDump(arguments.after);
    timings::ComparisonOptions options;
    options.threshold = arguments.threshold / 100;
    options.leastMs = arguments.leastMs;
    const timings::Comparison comparison = timings::compare(before, after, options);
    for (const std::string& warning : comparison.warnings)
        fmt::print(stderr, "{}\n", toLine({{after.file}, warning}, "warning"));
    const std::string json = timings::asJson(comparison, before, after);
    if (!arguments.json.empty()) image::writeFile(arguments.json, json);
    const bool printsJson = arguments.wantsJson && arguments.json.empty();
    fmt::print("{}", printsJson ? json : timings::asTable(comparison));
}

}  // namespace

void addBenchCompareTimings(CLI::App& bench, Action& action) {
    CLI::App* verb = bench.add_subcommand("compare-timings",
                                          "Which pass changed beyond the noise between two timing dumps");
    auto arguments = std::make_shared<CompareTimingsArguments>();
    verb->add_option("before", arguments->before, "A: JSON written by render --timings")->required();
    verb->add_option("after", arguments->after, "B: another")->required();
    CLI::Option* json = verb->add_option("--json", arguments->json,
                                         "Write JSON to this file, or print it instead of the table")
                            ->expected(0, 1);
    verb->add_option("--threshold", arguments->threshold, "Changes below so many percent do not count")
        ->capture_default_str();
    verb->add_option("--least", arguments->leastMs, "Changes below so many milliseconds do not count")
        ->capture_default_str();
    verb->callback([&action, arguments, json] {
        arguments->wantsJson = json->count() > 0;
        action = [arguments] { compareTimings(*arguments); };
    });
}

}  // namespace nephrite::tools
