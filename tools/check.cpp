// `nephrite check FILE...`: reads graphs, manifests and scenes and reports every fault of all of them.
#include <fmt/format.h>

#include <cstdio>

#include "graph/description.h"
#include "runtime/loading/graph_loading.h"
#include "scene/material_reader.h"
#include "text/json.h"
#include "verbs.h"

namespace nephrite::tools {
namespace {

struct CheckArguments {
    std::vector<std::filesystem::path> files;
    std::vector<std::filesystem::path> passPaths;
};

enum class FileKind { Graph, Manifest, Scene, Material };

/// Each format is told by a key that it must have and the others cannot.
FileKind kindOf(const std::filesystem::path& file) {
    const json::Value value = json::parseFile(file);
    if (value.isObject()) {
        if (value.find("nodes")) return FileKind::Graph;
        if (value.find("kind")) return FileKind::Manifest;
        if (value.find("camera") || value.find("objects") || value.find("lights")) return FileKind::Scene;
        if (value.find("layers") || value.find("diffuse")) return FileKind::Material;
    }
    throw InputError(value.where(),
                     "expected a graph (\"nodes\"), a pass manifest (\"kind\"), a scene (\"camera\") or a "
                     "material (\"layers\"), found " +
                         value.describe());
}

void checkFile(const std::filesystem::path& file, const CheckArguments& arguments,
               const runtime::DataFolders& folders, Diagnostics& diagnostics) {
    switch (kindOf(file)) {
        case FileKind::Graph:
            runtime::loadGraph(file, {}, folders, arguments.passPaths);
            break;
        case FileKind::Manifest:
            graph::readPassType(file, folders.shaders);
            break;
        case FileKind::Material:
            scene::readMaterial(json::parseFile(file), file.stem().string(), file.parent_path(),
                                scene::PresetFolder(folders.materials), diagnostics);
            break;
        case FileKind::Scene: {
            const scene::Scene scene = runtime::loadScene(file, 0, folders);
            for (const Diagnostic& warning : scene.warnings())
                diagnostics.warning(warning.where, warning.message);
            break;
        }
    }
}

void checkFiles(const CheckArguments& arguments) {
    const auto folders = runtime::DataFolders::find();
    Diagnostics all;
    for (const std::filesystem::path& file : arguments.files) {
        try {
            checkFile(file, arguments, folders, all);
        } catch (const InputError& error) {
            for (const Diagnostic& fault : error.faults()) all.error(fault.where, fault.message);
        }
    }
    for (const Diagnostic& warning : all.warnings()) fmt::print(stderr, "{}\n", toLine(warning, "warning"));
    all.throwIfErrors();
}

}  // namespace

void addCheckVerb(CLI::App& app, Action& action) {
    CLI::App* verb =
        app.add_subcommand("check", "Report every fault of graphs, pass manifests, scenes and materials");
    auto arguments = std::make_shared<CheckArguments>();
    verb->add_option("files", arguments->files, "Files to check")->required();
    verb->add_option("--pass-path", arguments->passPaths, "Another folder of pass manifests")
        ->expected(1)
        ->take_all();
    verb->callback([&action, arguments] { action = [arguments] { checkFiles(*arguments); }; });
}

}  // namespace nephrite::tools
