// `nephrite plan`: what a graph will do for a scene, without rendering it.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <cstdio>
#include <optional>

#include "graph/explain.h"
#include "graph/plan_page.h"
#include "graph/plan_writer.h"
#include "image/output_file.h"
#include "options.h"
#include "plan_measurement.h"
#include "runtime/loading/graph_loading.h"
#include "runtime/resources/imports.h"
#include "text/fault_lines.h"
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
    std::string device;
    bool noMeasure = false;
};

graph::Policy policyOf(const PlanArguments& arguments) {
    return arguments.policy == "memory" ? graph::Policy::Memory : graph::Policy::Barriers;
}

runtime::SessionOptions sessionOptions(const PlanArguments& arguments) {
    runtime::SessionOptions options;
    options.graph = arguments.graph.graph;
    options.scene = arguments.graph.scene;
    options.size = arguments.graph.extent();
    options.settings = arguments.graph.settings;
    options.passPaths = arguments.graph.passPaths;
    options.dumps = arguments.dumps;
    options.device = arguments.device;
    options.skip = !arguments.noSkip;
    options.policy = policyOf(arguments);
    return options;
}

/// The page, with times and pictures. Where the graph cannot be rendered it has none, and says why; so does a
/// warning. If a device was asked for by name that is an error.
std::string planWithPictures(const PlanArguments& arguments, const graph::Plan& plan) {
    graph::PlanMeasurements none;
    none.note = "Nothing was rendered: there are no times and pictures, and no result is kept over frames.";
    if (arguments.noMeasure) return graph::planAsHtml(plan, none);
    std::string reason;
    try {
        return measuredPage(sessionOptions(arguments));
    } catch (const std::exception& error) {
        if (!arguments.device.empty()) throw;
        reason = fmt::format("{}", fmt::join(linesOf(error), "\n"));
    }
    fmt::print(stderr, "{}: warning: without times and pictures: {}\n", arguments.output.string(), reason);
    none.note += "\n" + reason;
    return graph::planAsHtml(plan, none);
}

/// How a plan is written under a name that ends so.
struct PlanFormat {
    std::string_view extension;
    std::string (*write)(const PlanArguments&, const graph::Plan&);
};

template<std::string (*write)(const graph::Plan&)>
std::string planAlone(const PlanArguments&, const graph::Plan& plan) {
    return write(plan);
}

constexpr std::array<PlanFormat, 5> formats{{{".txt", planAlone<graph::planAsText>},
                                             {".json", planAlone<graph::planAsJson>},
                                             {".dot", planAlone<graph::planAsDot>},
                                             {".svg", planAlone<graph::planAsSvg>},
                                             {".html", planWithPictures}}};

const PlanFormat& formatOf(const std::filesystem::path& output) {
    if (output.empty()) return formats.front();
    for (const PlanFormat& format : formats)
        if (output.extension() == format.extension) return format;
    throw InputError({output.string()},
                     fmt::format("expected a name ending in .txt, .json, .dot, .svg or .html, found \"{}\"",
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
    request.policy = policyOf(arguments);
    for (const std::string& dump : arguments.dumps) request.dumps.push_back(runtime::dumpReference(dump));
    request.imports = runtime::importedImages(loaded.graph->description);
    return compileForBoth(request);
}

std::string contents(const PlanArguments& arguments, const PlanFormat& format, const graph::Plan& plan) {
    return arguments.why.empty() ? format.write(arguments, plan) : graph::explain(plan, arguments.why);
}

void writePlan(const PlanArguments& arguments) {
    const PlanFormat& format = formatOf(arguments.output);
    arguments.graph.requireOther(arguments.output);
    const auto folders = runtime::DataFolders::find();
    const auto loaded = runtime::loadGraph(arguments.graph.graph, arguments.graph.settings, folders,
                                           arguments.graph.passPaths);
    const graph::Plan plan = makePlan(arguments, folders, loaded);
    if (arguments.output.empty()) {
        fmt::print("{}", contents(arguments, format, plan));
        return;
    }
    image::OutputFile file(arguments.output);  // tried before anything is rendered
    file.write(contents(arguments, format, plan));
    file.commit();
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
    verb->add_flag("--no-measure", arguments->noMeasure,
                   "F.html without times and pictures: nothing is rendered");
    verb->add_option("--device", arguments->device,
                     "Render F.html's pictures on the device whose name contains this");
    verb->add_option("-o,--output", arguments->output,
                     "F.txt, F.json, F.dot, F.svg or F.html (default: text on standard output)");
    verb->callback([&action, arguments] { action = [arguments] { writePlan(*arguments); }; });
}

}  // namespace nephrite::tools
