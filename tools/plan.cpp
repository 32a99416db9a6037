// `nephrite plan`: what a graph will do for a scene, without rendering it.
#include <fmt/format.h>

#include <array>
#include <cstdio>

#include "graph/explain.h"
#include "graph/plan_writer.h"
#include "image/output_file.h"
#include "options.h"
#include "runtime/graph_loading.h"
#include "runtime/imports.h"
#include "verbs.h"

namespace nephrite::tools {
namespace {

struct PlanArguments {
    GraphArguments graph;
    std::vector<std::string> dumps;
    std::filesystem::path output;
    bool noSkip = false;
    std::string why;
    std::string policy = "barriers";
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

/// The plan asked for, with the figures of the other policy beside its own.
graph::Plan compileForBoth(graph::CompileRequest& request) {
    graph::Plan plan = graph::compile(request);
    request.policy =
        request.policy == graph::Policy::Memory ? graph::Policy::Barriers : graph::Policy::Memory;
    plan.otherPolicy = graph::compile(request).figures();
    return plan;
}

graph::Plan makePlan(const PlanArguments& arguments, const runtime::DataFolders& folders,
                     const runtime::LoadedGraph& loaded) {
    const scene::Scene scene = runtime::loadScene(arguments.graph.scene, 0, folders);
    graph::CompileRequest request;
    request.graph = loaded.graph;
    request.facts = runtime::sceneFacts(scene.facts());
    request.view = arguments.graph.extent();
    request.skip = !arguments.noSkip;
    request.policy = arguments.policy == "memory" ? graph::Policy::Memory : graph::Policy::Barriers;
    for (const std::string& dump : arguments.dumps) request.dumps.push_back(runtime::dumpReference(dump));
    request.imports = runtime::importedImages(loaded.graph->description);
    return compileForBoth(request);
}

void writePlan(const PlanArguments& arguments) {
    const PlanFormat& format = formatOf(arguments.output);
    const auto folders = runtime::DataFolders::find();
    const auto loaded = runtime::loadGraph(arguments.graph.graph, arguments.graph.settings, folders,
                                           arguments.graph.passPaths);
    const graph::Plan plan = makePlan(arguments, folders, loaded);
    const std::string text = arguments.why.empty() ? format.write(plan) : graph::explain(plan, arguments.why);
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
    verb->add_option(
        "--why", arguments->why,
        "Tell why NODE runs, stands where it stands and has its barriers and memory, or NODE.PORT");
    verb->add_option("--policy", arguments->policy,
                     "Order passes for few barriers (default) or for little memory")
        ->check(CLI::IsMember({"barriers", "memory"}));
    verb->add_option("-o,--output", arguments->output,
                     "F.txt, F.json, F.dot or F.svg (default: text on standard output)");
    verb->callback([&action, arguments] { action = [arguments] { writePlan(*arguments); }; });
}

}  // namespace nephrite::tools
