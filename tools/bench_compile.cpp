// `nephrite bench compile`: microseconds that the graph compiler takes a pass, on made-up graphs of several
// sizes and shapes, beside the least a program could take.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <json/json.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdio>
#include <ctime>
#include <optional>

#include "bench.h"
#include "graph/bench/compile_floor.h"
#include "graph/bench/synthetic_graph.h"
#include "graph/compile.h"
#include "image/output_file.h"
#include "text/diagnostics.h"

namespace nephrite::tools {
namespace {

using graph::GraphShape;

constexpr graph::Index mostPasses = 10'000'000;
constexpr std::array policies{graph::Policy::Barriers, graph::Policy::Memory};

struct CompileArguments {
    std::string passes = "10,100,1000,10000,100000";
    std::string shape;
    std::string policy{name(graph::Policy::Barriers)};
    std::filesystem::path json;
};

struct Row {
    GraphShape shape = GraphShape::Random;
    graph::Index passes = 0;
    double microseconds = 0;  ///< a pass
    double floor = 0;         ///< microseconds a pass
    graph::Plan plan;         ///< of the first graph
};

std::vector<graph::Index> passCounts(const std::string& text) {
    std::vector<graph::Index> counts;
    const char* at = text.data();
    const char* const end = at + text.size();
    while (true) {
        graph::Index count = 0;
        const auto [after, failure] = std::from_chars(at, end, count);
        const bool isRight = failure == std::errc{} && count > 0 && count <= mostPasses;
        if (!isRight || (after != end && *after != ','))
            throw InputError({"--passes"},
                             fmt::format("expected numbers from 1 to {} with commas between, found {}",
                                         mostPasses, inQuotes(text)));
        counts.push_back(count);
        if (after == end) return counts;
        at = after + 1;
    }
}

std::vector<GraphShape> chosenShapes(const std::string& wanted) {
    if (wanted.empty()) return {graph::graphShapes.begin(), graph::graphShapes.end()};
    if (const auto shape = graph::graphShapeNamed(wanted)) return {*shape};
    std::vector<std::string_view> names;
    for (const GraphShape shape : graph::graphShapes) names.push_back(name(shape));
    throw InputError({"--shape"},
                     fmt::format("expected {}, found {}{}", fmt::join(names, ", "), inQuotes(wanted),
                                 suggestion(wanted, std::span<const std::string_view>(names))));
}

graph::Policy chosenPolicy(const std::string& wanted) {
    for (const graph::Policy policy : policies) {
        if (name(policy) == wanted) return policy;
    }
    throw InputError({"--policy"}, fmt::format("expected {} or {}, found {}", name(policies[0]),
                                               name(policies[1]), inQuotes(wanted)));
}

/// The graphs of one shape and size, ready to be compiled in both ways.
struct Specimens {
    std::vector<graph::CompileRequest> requests;
    std::vector<graph::FloorGraph> floors;

    /// So many different graphs that no branch predictor learns them by heart, and so few that they stay in
    /// the processor's cache: what is measured is the compiler, not the memory that descriptions lie in. The
    /// floor has a tenth of the compiler's branches, and needs more graphs.
    Specimens(GraphShape shape, graph::Index passes, graph::Policy policy, const graph::PassLibrary& types) {
        constexpr graph::Index enough = 5'000;  // passes altogether
        constexpr graph::Index enoughOfFloor = 20'000;
        const auto count = [&](graph::Index all) { return std::max(graph::Index{3}, all / passes); };
        for (std::uint64_t seed = 1; seed <= count(enough); ++seed) {
            graph::CompileRequest& request = requests.emplace_back();
            request.graph = syntheticGraph(shape, passes, seed, types);
            request.view = {1920, 1080};
            request.policy = policy;
        }
        for (std::uint64_t seed = 1; seed <= count(enoughOfFloor); ++seed)
            floors.emplace_back(*syntheticGraph(shape, passes, seed, types));
    }
};

/// Microseconds of processor time a pass that `compileAll` takes for `graphs` graphs, repeated until the
/// clock's grain and a short disturbance matter little. Other programs on the machine do not count.
template<class CompileAll>
double timed(std::size_t graphs, graph::Index passes, const CompileAll& compileAll) {
    constexpr double longEnough = 0.02;  // seconds
    const std::clock_t start = std::clock();
    double seconds = 0;
    std::size_t rounds = 0;
    while (seconds < longEnough) {
        compileAll();
        ++rounds;
        seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    }
    const std::size_t compiled = rounds * graphs * passes;
    return seconds * 1e6 / static_cast<double>(compiled);
}

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

/// The compiler and its floor by turns, so that both meet the same disturbances.
Row measure(GraphShape shape, graph::Index passes, graph::Policy policy, const graph::PassLibrary& types) {
    constexpr int samples = 5;
    const Specimens specimens(shape, passes, policy, types);
    Row row{shape, passes, 0, 0, graph::compile(specimens.requests.front())};
    std::size_t made = 0;  // what is compiled is looked at, so that none of it may be left out
    std::vector<double> compiler;
    std::vector<double> floor;
    for (int i = 0; i < samples; ++i) {
        compiler.push_back(timed(specimens.requests.size(), passes, [&] {
            for (const auto& request : specimens.requests) made += graph::compile(request).passes.size();
        }));
        floor.push_back(timed(specimens.floors.size(), passes, [&] {
            for (const auto& bare : specimens.floors) made += graph::compileFloor(bare).order.size();
        }));
    }
    if (made == 0) throw RunError("bench: error: nothing was compiled");
    row.microseconds = median(compiler);
    row.floor = median(floor);
    return row;
}

double heapOverPeak(const graph::Plan& plan) {
    if (plan.peakLiveBytes == 0) return 1;
    return static_cast<double>(plan.heapBytes) / static_cast<double>(plan.peakLiveBytes);
}

Json::Value asJson(const Row& row) {
    Json::Value value;
    value["shape"] = std::string(name(row.shape));
    value["passes"] = row.passes;
    value["microsecondsPerPass"] = row.microseconds;
    value["heapBytes"] = Json::Value::UInt64{row.plan.heapBytes};
    value["peakLiveBytes"] = Json::Value::UInt64{row.plan.peakLiveBytes};
    value["barrierBatches"] = row.plan.schedule.batchCount;
    value["naiveBarriers"] = row.plan.naiveBarriers;
    value["policy"] = std::string(name(row.plan.policy));
    value["floorMicrosecondsPerPass"] = row.floor;
    value["heapOverPeak"] = heapOverPeak(row.plan);
    return value;
}

std::string asText(const std::vector<Row>& rows) {
    Json::Value array = Json::arrayValue;
    for (const Row& row : rows) array.append(asJson(row));
    Json::StreamWriterBuilder builder;
    builder["indentation"] = "  ";
    builder["precision"] = 17;
    return Json::writeString(builder, array) + "\n";
}

void printHead() {
    fmt::print("{:<12}{:>8}{:>10}{:>10}{:>8}{:>11}{:>10}{:>10}\n", "shape", "passes", "us/pass", "floor",
               "ratio", "heap/peak", "batches", "naive");
}

void printRow(const Row& row) {
    fmt::print("{:<12}{:>8}{:>10.3f}{:>10.3f}{:>8.2f}{:>11.3f}{:>10}{:>10}\n", name(row.shape), row.passes,
               row.microseconds, row.floor, row.microseconds / row.floor, heapOverPeak(row.plan),
               row.plan.schedule.batchCount, row.plan.naiveBarriers);
    std::fflush(stdout);
}

void benchCompile(const CompileArguments& arguments) {
    const std::vector<graph::Index> sizes = passCounts(arguments.passes);
    const std::vector<GraphShape> shapes = chosenShapes(arguments.shape);
    const graph::Policy policy = chosenPolicy(arguments.policy);
    std::optional<image::OutputFile> file;
    if (!arguments.json.empty()) file.emplace(arguments.json);
    const graph::PassLibrary types = graph::syntheticTypes();
    std::vector<Row> rows;
    printHead();
    for (const GraphShape shape : shapes) {
        for (const graph::Index passes : sizes) {
            rows.push_back(measure(shape, passes, policy, types));
            printRow(rows.back());
        }
    }
    if (!file) return;
    file->write(asText(rows));
    file->commit();
}

}  // namespace

void addBenchCompile(CLI::App& bench, Action& action) {
    CLI::App* verb = bench.add_subcommand(
        "compile", "Microseconds a pass that the graph compiler takes, beside the least possible");
    auto arguments = std::make_shared<CompileArguments>();
    verb->add_option("--passes", arguments->passes, "Sizes of the graphs, in nodes: N,N,...")
        ->capture_default_str();
    verb->add_option("--shape", arguments->shape, "random, chain, ladder, fan or dead-chains (default: all)");
    verb->add_option("--policy", arguments->policy, "barriers or memory")->capture_default_str();
    verb->add_option("--json", arguments->json, "Write the figures to this file");
    verb->callback([&action, arguments] { action = [arguments] { benchCompile(*arguments); }; });
}

}  // namespace nephrite::tools
