// `nephrite plan`: what a graph will do for a scene, without rendering it.
#include <fmt/format.h>

#include <array>
#include <cstdio>

#include "graph/plan_writer.h"
#include "image/output_file.h"
#include "options.h"
#include "runtime/graph_loading.h"
#include "verbs.h"

namespace nephrite::tools {
namespace {

struct PlanArguments {
    GraphArguments graph;
    std::vector<std::string> dumps;
    std::filesystem::path output;
    bool noSkip = false;
};

struct PlanFormat {
    std::string_view extension;
    std::string (*write)(const graph::Plan&);
};

constexpr std::array<PlanFormat, 4> formats{{{".txt", graph::planAsText},
                                             {".json", graph::planAsJson},
                                             {".dot", graph::planAsDot},
                                             {".svg", graph::planAsSvg}}};

const PlanFormat& formatOf(const std::filesystem::path& output) {
    if (output.empty()) return formats.front();
    for (const PlanFormat& format : formats)
        if (output.extension() == format.extension) return format;
    throw InputError({output.string()},
                     fmt::format("expected a name ending in .txt, .json, .dot or .svg, found \"{}\"",
                                 output.extension().string()));
}

graph::Plan makePlan(const PlanArguments& arguments, const runtime::DataFolders& folders,
                     const runtime::LoadedGraph& loaded) {
    const scene::Scene scene = runtime::loadScene(arguments.graph.scene, 0, folders);
    graph::CompileRequest request;
    request.graph = loaded.graph;
    request.facts = runtime::sceneFacts(scene.facts());
    request.view = arguments.graph.extent();
    request.skip = !arguments.noSkip;
    for (const std::string& dump : arguments.dumps) request.dumps.push_back(runtime::dumpReference(dump));
    return graph::compile(request);
}

void writePlan(const PlanArguments& arguments) {
    const PlanFormat& format = formatOf(arguments.output);
    const auto folders = runtime::DataFolders::find();
    const auto loaded = runtime::loadGraph(arguments.graph.graph, arguments.graph.settings, folders,
                                           arguments.graph.passPaths);
    const std::string text = format.write(makePlan(arguments, folders, loaded));
    if (arguments.output.empty())
        fmt::print("{}", text);
    else
        image::writeFile(arguments.output, text);
}

}  // namespace

void addPlanVerb(CLI::App& app, Action& action) {
    CLI::App* verb =
        app.add_subcommand("plan", "Show what a graph will do: passes, reasons, resources, barriers");
    auto arguments = std::make_shared<PlanArguments>();
    arguments->graph.addTo(*verb);
    verb->add_option("--dump", arguments->dumps, "A port wanted beside the outputs: NODE.PORT")
        ->expected(1)
        ->take_all();
    verb->add_flag("--no-skip", arguments->noSkip,
                   "Plan every needed pass, also those the scene does not need");
    verb->add_option("-o,--output", arguments->output,
                     "F.txt, F.json, F.dot or F.svg (default: text on standard output)");
    verb->callback([&action, arguments] { action = [arguments] { writePlan(*arguments); }; });
}

}  // namespace nephrite::tools
