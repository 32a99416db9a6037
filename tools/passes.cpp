// `nephrite passes [TYPE] [--json]`: the pass types there are, or all about one of them.
#include <fmt/format.h>

#include <cstdio>

#include "graph/pass_listing.h"
#include "runtime/loading/graph_loading.h"
#include "verbs.h"

namespace nephrite::tools {
namespace {

struct PassesArguments {
    std::string type;
    bool json = false;
    std::vector<std::filesystem::path> passPaths;
};

const graph::PassType& findType(const graph::PassLibrary& library, const std::string& name) {
    if (const graph::PassType* type = library.find(name)) return *type;
    const std::vector<std::string> names = library.names();
    const std::vector<std::string_view> known(names.begin(), names.end());
    throw InputError({"passes"},
                     fmt::format("expected a pass type, found \"{}\"{}", name, suggestion(name, known)));
}

void printPasses(const PassesArguments& arguments) {
    const auto library = runtime::loadPassTypes(runtime::DataFolders::find(), arguments.passPaths);
    Diagnostics diagnostics;
    if (!arguments.type.empty()) {
        const graph::PassType& type = findType(*library, arguments.type);
        fmt::print("{}\n", arguments.json ? graph::describePassAsJson(type) : graph::describePass(type));
    } else {
        fmt::print("{}\n", arguments.json ? graph::listPassesAsJson(*library, diagnostics)
                                          : graph::listPasses(*library, diagnostics));
    }
    diagnostics.throwIfErrors();
}

}  // namespace

void addPassesVerb(CLI::App& app, Action& action) {
    CLI::App* verb = app.add_subcommand("passes", "List the pass types, or describe one");
    auto arguments = std::make_shared<PassesArguments>();
    verb->add_option("type", arguments->type, "The pass type to describe");
    verb->add_flag("--json", arguments->json, "As JSON");
    verb->add_option("--pass-path", arguments->passPaths, "Another folder of pass manifests")
        ->expected(1)
        ->take_all();
    verb->callback([&action, arguments] { action = [arguments] { printPasses(*arguments); }; });
}

}  // namespace nephrite::tools
