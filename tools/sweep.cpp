// `nephrite sweep`: renders graphs and scenes at many parameter values, a row a run.
#include <fmt/format.h>

#include <optional>

#include "commit.h"
#include "image/output_file.h"
#include "interrupt.h"
#include "options.h"
#include "progress_bar.h"
#include "sweep/execute.h"
#include "sweep/table.h"
#include "verbs.h"

namespace nephrite::tools {
namespace {

struct SweepArguments {
    std::filesystem::path file;
    std::filesystem::path folder;
    std::string part;
    std::string device;
    std::vector<std::filesystem::path> passPaths;
};

/// The tables must not replace what they are made from: a sweep file may well be called sweep.json.
void requireOtherTables(const sweep::Sweep& sweep, const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> inputs{sweep.file};
    for (const sweep::SweepGraph& graph : sweep.graphs) inputs.push_back(graph.file);
    for (const sweep::SweepScene& scene : sweep.scenes)
        inputs.insert(inputs.end(), {scene.file, scene.reference, scene.secondHalf});
    for (const char* table : {"sweep.json", "sweep.csv"}) requireOther(folder / table, inputs);
}

void sweepRuns(const SweepArguments& arguments) {
    const sweep::Sweep sweep = sweep::readSweep(arguments.file);
    requireOtherTables(sweep, arguments.folder);
    sweep::SweepOptions options{arguments.folder, {}, arguments.passPaths, arguments.device, commit};
    if (!arguments.part.empty()) options.part = partOf(arguments.part);
    catchInterrupts();
    sweep::SweepState state;
    {
        ProgressBar bar(sweep.name);
        pareto::Progress progress;
        progress.stop = interrupted;
        progress.show = [&](std::string_view, double done) { bar.show(done); };
        progress.say = [](const std::string& line) { fmt::print(stderr, "{}\n", line); };
        state = sweep::execute(sweep, options, progress);
    }
    if (!state.isComplete()) {
        fmt::print("{} of {} runs are done\n", state.rows.size(), state.runs);
        return;
    }
    image::writeFile(arguments.folder / "sweep.json", sweep::rowsAsJson(sweep.name, state.rows));
    image::writeFile(arguments.folder / "sweep.csv", sweep::rowsAsCsv(state.rows));
    fmt::print("{} runs are done: {}\n", state.runs, (arguments.folder / "sweep.csv").string());
}

}  // namespace

void addSweepVerb(CLI::App& app, Action& action) {
    CLI::App* verb =
        app.add_subcommand("sweep", "Render graphs and scenes at many parameter values, a row a run");
    auto arguments = std::make_shared<SweepArguments>();
    verb->add_option("file", arguments->file, "Sweep file: what is rendered")->required();
    verb->add_option("-o,--output", arguments->folder,
                     "Folder for rows, tables and pictures; the same again continues")
        ->required();
    verb->add_option("--part", arguments->part, "I/N: every N-th run from the I-th, on this machine");
    verb->add_option("--device", arguments->device, "Part of the name of the device to use");
    verb->add_option("--pass-path", arguments->passPaths, "Another folder of pass manifests")
        ->expected(1)
        ->take_all();
    verb->callback([&action, arguments] { action = [arguments] { sweepRuns(*arguments); }; });
}

}  // namespace nephrite::tools
