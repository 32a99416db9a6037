// `nephrite bench pareto`: what methods cost against how wrong they are.
#include <fmt/format.h>

#include <algorithm>
#include <system_error>
#include <thread>

#include "bench.h"
#include "commit.h"
#include "image/output_file.h"
#include "interrupt.h"
#include "options.h"
#include "pareto/child_program.h"
#include "pareto/report.h"
#include "pareto/run.h"
#include "progress_bar.h"

namespace nephrite::tools {
namespace {

struct ParetoArguments {
    std::filesystem::path suite;
    std::filesystem::path folder = "pareto";
    std::filesystem::path json;
    std::string size;
    std::string only;
    std::string device;
    std::uint32_t frames = 0;  ///< 0: as the suite says
    unsigned threads = 0;
};

pareto::Suite suiteOf(const ParetoArguments& arguments) {
    pareto::Suite suite = pareto::readSuite(arguments.suite);
    if (arguments.frames != 0) suite.frames = arguments.frames;
    if (arguments.size.empty()) return suite;
    const graph::Extent size = pictureSize(arguments.size);
    suite.width = size.width;
    suite.height = size.height;
    return suite;
}

/// What is written must not replace what it is made from: a suite may well be called pareto.json.
void requireOtherFiles(const pareto::Suite& suite, const ParetoArguments& arguments) {
    std::vector<std::filesystem::path> inputs{suite.file};
    for (const pareto::SuiteScene& scene : suite.scenes) inputs.push_back(scene.file);
    for (const pareto::Method& method : suite.methods) inputs.push_back(method.graph);
    for (const char* name : {"pareto.json", "pareto.csv", "passes.csv", "table.md", "pareto.gp"})
        requireOther(arguments.folder / name, inputs);
    requireOther(arguments.json, inputs);
}

/// The output folder, made if it is missing, and every file of it can be written.
void requireFolder(const ParetoArguments& arguments) {
    std::error_code ignored;
    std::filesystem::create_directories(arguments.folder, ignored);
    image::OutputFile(arguments.folder / "pareto.json");
    if (!arguments.json.empty()) image::OutputFile(arguments.json);
}

pareto::SuiteResult run(const ParetoArguments& arguments) {
    const pareto::Suite suite = suiteOf(arguments);
    requireOtherFiles(suite, arguments);
    std::optional<ProgressBar> bar;
    std::string shown;
    pareto::Progress progress;
    progress.stop = interrupted;
    progress.show = [&](std::string_view what, double done) {
        if (shown != what) bar.emplace(shown = what);
        bar->show(done);
    };
    progress.say = [](const std::string& line) { fmt::print(stderr, "{}\n", line); };
    const auto preparation = pareto::prepareSuite(suite, pareto::Selection(arguments.only), progress);
    requireFolder(arguments);
    const pareto::RunOptions options{
        arguments.folder, arguments.device, commit,
        arguments.threads != 0 ? arguments.threads : std::max(1U, std::thread::hardware_concurrency())};
    return pareto::runSuite(suite, preparation, options, progress);
}

/// Draws the script by gnuplot, if there is one.
void draw(const std::filesystem::path& script) {
    for (const std::string format : {"svg", "png"}) {
        std::filesystem::path file = script;
        file.replace_extension(format);
        const auto picture =
            pareto::outputOf({"gnuplot", "-e", fmt::format("format='{}'", format), script.string()});
        if (!picture) {
            fmt::print(stderr, "{}: not drawn, there is no gnuplot (package gnuplot-nox)\n", file.string());
            return;
        }
        image::writeFile(file, *picture);
    }
}

void benchPareto(const ParetoArguments& arguments) {
    catchInterrupts();
    const pareto::SuiteResult result = run(arguments);
    const std::string json = pareto::resultsAsJson(result);
    image::writeFile(arguments.folder / "pareto.json", json);
    if (!arguments.json.empty()) image::writeFile(arguments.json, json);
    image::writeFile(arguments.folder / "pareto.csv", pareto::resultsAsCsv(result));
    image::writeFile(arguments.folder / "passes.csv", pareto::passesAsCsv(result));
    const std::string table = pareto::resultsAsTable(result);
    image::writeFile(arguments.folder / "table.md", table);
    if (const std::string script = pareto::resultsAsPlot(result); !script.empty()) {
        image::writeFile(arguments.folder / "pareto.gp", script);
        draw(arguments.folder / "pareto.gp");
    }
    fmt::print("{}", table);
}

}  // namespace

void addBenchPareto(CLI::App& bench, Action& action) {
    CLI::App* verb =
        bench.add_subcommand("pareto", "Time and error of methods, over scenes and parameter values");
    auto arguments = std::make_shared<ParetoArguments>();
    verb->add_option("suite", arguments->suite, "Suite file: what is measured")->required();
    verb->add_option("-o,--output", arguments->folder, "Folder for tables, plot and references")
        ->capture_default_str();
    verb->add_option("--json", arguments->json, "Write pareto.json to this file, too");
    verb->add_option("--frames", arguments->frames, "Frames measured of each point (default: the suite's)")
        ->check(CLI::Range(1U, 100000U));
    verb->add_option("--size", arguments->size, "Picture size, WIDTHxHEIGHT (default: the suite's)");
    verb->add_option("--only", arguments->only, "SCENE or SCENE/METHOD, with wildcards * and ?");
    verb->add_option("--device", arguments->device, "Part of the name of the device to use");
    verb->add_option("--threads", arguments->threads, "Threads of the references (default: one a core)")
        ->check(CLI::Range(1U, 1024U));
    verb->callback([&action, arguments] { action = [arguments] { benchPareto(*arguments); }; });
}

}  // namespace nephrite::tools
