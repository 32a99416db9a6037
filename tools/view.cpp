// `nephrite view`: a graph in a window.
#include "view/viewer.h"

#include <fmt/format.h>

#include "options.h"
#include "verbs.h"

namespace nephrite::tools {
namespace {

struct ViewArguments {
    GraphArguments graph;
    std::string device;
    std::string validation = "off";
    double time = 0;
    std::string window = "1280x860";
    std::filesystem::path script;
};

graph::Extent windowSize(const std::string& text) {
    const graph::Extent size = pictureSize(text, "--window");
    if (size.width < view::leastWindowWidth || size.height < view::leastWindowHeight)
        throw InputError({"--window"}, fmt::format("expected at least {}x{}, found \"{}\"",
                                                   view::leastWindowWidth, view::leastWindowHeight, text));
    return size;
}

void view(const ViewArguments& arguments) {
    const graph::Extent window = windowSize(arguments.window);
    view::ViewerOptions options;
    options.session.graph = arguments.graph.graph;
    options.session.scene = arguments.graph.scene;
    options.session.size = arguments.graph.extent();
    options.session.settings = arguments.graph.settings;
    options.session.passPaths = arguments.graph.passPaths;
    options.session.device = arguments.device;
    options.session.validation = validationNamed(arguments.validation);
    options.session.time = arguments.time;
    options.script = arguments.script;
    options.width = static_cast<int>(window.width);
    options.height = static_cast<int>(window.height);
    view::Viewer(options).run();
}

}  // namespace

void addViewVerb(CLI::App& app, Action& action) {
    CLI::App* verb = app.add_subcommand("view", "Show a graph in a window");
    auto arguments = std::make_shared<ViewArguments>();
    arguments->graph.addTo(*verb);
    verb->add_option("--window", arguments->window, "Size of the window, WIDTHxHEIGHT")
        ->capture_default_str();
    verb->add_option("--time", arguments->time, "Seconds of the scene's animation at the start")
        ->capture_default_str();
    verb->add_option("--script", arguments->script, "Commands to run, one a line (- is standard input)");
    verb->add_option("--validation", arguments->validation, "off, core or sync")
        ->check(CLI::IsMember({"off", "core", "sync"}))
        ->capture_default_str();
    verb->add_option("--device", arguments->device, "Part of the name of the device to use");
    verb->callback([&action, arguments] { action = [arguments] { view(*arguments); }; });
}

}  // namespace nephrite::tools
