// Reading scenes and graphs, and saying where in the suite their faults come from.
#include "pareto/prepare.h"

#include <fmt/format.h>

#include <algorithm>

#include "graph/value_readers.h"
#include "runtime/loading/graph_loading.h"

namespace nephrite::pareto {
namespace {

/// The first model that a scene names and that is not at hand. Whatever else is wrong with the scene, its
/// reader says.
std::optional<std::string> missingModel(const std::filesystem::path& scene,
                                        const std::filesystem::path& models) {
    const auto objects = json::parseFile(scene).find("objects");
    for (std::size_t i = 0; objects && i < objects->size(); ++i) {
        const auto mesh = objects->isArray() ? objects->at(i).find("mesh") : std::nullopt;
        const auto model = mesh ? mesh->find("model") : std::nullopt;
        if (!model || !model->isString()) continue;
        std::error_code ignored;
        const std::string file = model->raw().asString();
        if (models.empty() || !std::filesystem::exists(models / file, ignored)) return file;
    }
    return std::nullopt;
}

/// What `read` gives; faults that it throws come with a line that says what in the suite led to them.
template<class Read>
auto readFor(const SourceLocation& where, const std::string& what, Read&& read) {
    try {
        return read();
    } catch (const InputError& error) {
        std::vector<Diagnostic> faults = error.faults();
        faults.push_back({where, what});
        throw InputError(std::move(faults));
    }
}

/// Where in the suite a fault of a setting is. The program knows it as a place in "PARAM=JSON".
SourceLocation placeOf(const Setting& setting, const SourceLocation& fault) {
    const auto before = static_cast<std::uint32_t>(setting.parameter.size() + 1);
    if (fault.line <= 1 && fault.column <= before) return setting.whereParameter;
    SourceLocation place = setting.whereValue;
    place.line += fault.line - 1;
    place.column = fault.line == 1 ? place.column + fault.column - before - 1 : fault.column;
    return place;
}

/// The graph of a point. Faults of its settings are named where the suite has them, those of the graph with
/// the suite's line.
runtime::LoadedGraph loadGraph(const Point& point, const runtime::DataFolders& folders) {
    const Method& method = *point.method;
    try {
        return runtime::loadGraph(method.graph, point.settingTexts(), folders, {});
    } catch (const InputError& error) {
        std::vector<Diagnostic> faults = error.faults();
        bool areOfSettings = true;
        for (Diagnostic& fault : faults) {
            const auto setting =
                std::find_if(point.settings.begin(), point.settings.end(),
                             [&](const Setting& one) { return fault.where.file == "--set " + one.text(); });
            if (setting != point.settings.end())
                fault.where = placeOf(*setting, fault.where);
            else
                areOfSettings = false;
        }
        if (!areOfSettings)
            faults.push_back({method.whereGraph, fmt::format("the method {} cannot use the graph {}",
                                                             inQuotes(point.name), method.graph.string())});
        throw InputError(std::move(faults));
    }
}

void requirePort(const graph::LinkedGraph& graph, const Method& method, const ComparedPort& compared) {
    if (compared.port.find('.') == std::string::npos) {
        if (graph::findNamed(graph.outputs, compared.port) != nullptr) return;
        throw InputError(
            compared.where,
            fmt::format("the graph {} has no output {}{}; any port is \"node.port\"", method.graph.string(),
                        inQuotes(compared.port), graph::suggestionAmong(compared.port, graph.outputs)));
    }
    try {
        graph.find(runtime::dumpReference(compared.port));
    } catch (const InputError& error) {
        std::vector<Diagnostic> faults = error.faults();
        for (Diagnostic& fault : faults) fault.where = compared.where;
        throw InputError(std::move(faults));
    }
}

void requireGraph(const Point& point, const runtime::DataFolders& folders) {
    if (!point.method->isTimed()) return;
    const runtime::LoadedGraph loaded = loadGraph(point, folders);
    for (const ComparedPort& compared : point.method->against)
        requirePort(*loaded.graph, *point.method, compared);
}

/// The scene can be read, and each reference that is wanted is defined for it.
void requireScene(const Task& task, const runtime::DataFolders& folders) {
    const SuiteScene& suiteScene = *task.scene;
    const std::string file = suiteScene.file.string();
    const scene::Scene scene = readFor(suiteScene.where, fmt::format("cannot use the scene {}", file),
                                       [&] { return runtime::loadScene(suiteScene.file, 0, folders); });
    for (const ReferenceSettings& reference : suiteScene.references)
        if (needs(task.points, reference.mode))
            readFor(reference.where, fmt::format("there is no such reference of the scene {}", file),
                    [&] { truth::requireSuitable(scene, reference.mode); });
}

}  // namespace

Preparation prepareSuite(const Suite& suite, const Selection& selection, const Progress& progress) {
    const auto folders = runtime::DataFolders::find();
    Preparation preparation;
    bool isSelected = false;
    for (const SuiteScene& scene : suite.scenes) {
        Task task{&scene, pointsOf(suite, scene, selection)};
        if (task.points.empty()) continue;
        isSelected = true;
        const auto model = readFor(scene.where, fmt::format("cannot use the scene {}", scene.file.string()),
                                   [&] { return missingModel(scene.file, folders.models); });
        if (model) {
            preparation.leftOut.push_back(
                {scene.name, fmt::format("the model {} is not at hand: set NEPHRITE_MODELS to the folder "
                                         "that has it",
                                         *model)});
            progress.say(fmt::format("{}: left out, {}", scene.name, preparation.leftOut.back().why));
            continue;
        }
        requireScene(task, folders);
        for (const Point& point : task.points) requireGraph(point, folders);
        preparation.tasks.push_back(std::move(task));
    }
    if (!isSelected) throw InputError({"--only"}, "this pattern selects no scene and method of the suite");
    return preparation;
}

}  // namespace nephrite::pareto
