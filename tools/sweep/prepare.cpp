// Checks a sweep against the files that it names.
#include "sweep/prepare.h"

#include <fmt/format.h>

#include <algorithm>

#include "graph/value_readers.h"
#include "image/exr.h"
#include "image/metrics/color_planes.h"
#include "runtime/loading/graph_loading.h"

namespace nephrite::sweep {
namespace {

using runtime::DataFolders;
using runtime::LoadedGraph;

class Preparation {
  public:
    Preparation(const Sweep& sweep, const std::vector<std::filesystem::path>& passPaths)
        : sweep_(sweep), passPaths_(passPaths), folders_(DataFolders::find()) {}

    std::vector<SceneReference> run() {
        for (const SweepGraph& graph : sweep_.graphs) checkGraph(graph);
        std::vector<SceneReference> references;
        for (const SweepScene& scene : sweep_.scenes) {
            collect(scene.where, [&] { runtime::loadScene(scene.file, sweep_.time, folders_); });
            references.push_back(readReferences(scene));
        }
        diagnostics_.throwIfErrors();
        return references;
    }

  private:
    /// Does something; its faults, and the place in the sweep that led there.
    template<class Work>
    void collect(const SourceLocation& where, Work work) {
        try {
            work();
        } catch (const InputError& error) {
            for (const Diagnostic& fault : error.faults()) diagnostics_.error(fault.where, fault.message);
            diagnostics_.error(where, "cannot be used");
        }
    }

    std::optional<LoadedGraph> load(const SweepGraph& graph) {
        std::optional<LoadedGraph> loaded;
        collect(graph.where, [&] { loaded = runtime::loadGraph(graph.file, {}, folders_, passPaths_); });
        return loaded;
    }

    void checkGraph(const SweepGraph& graph) {
        const std::optional<LoadedGraph> loaded = load(graph);
        if (!loaded) return;
        checkPort(*loaded->graph, graph);
        for (const Setting& setting : graph.settings) checkSetting(graph, setting);
        for (const std::vector<Setting>& set : sweep_.list)
            for (const Setting& setting : set) checkSetting(graph, setting);
        for (const Axis& axis : sweep_.grid)
            for (const Setting& setting : axis.values) checkSetting(graph, setting);
    }

    void checkSetting(const SweepGraph& graph, const Setting& setting) {
        try {
            runtime::loadGraph(graph.file, {setting.text()}, folders_, passPaths_);
        } catch (const InputError& error) {
            for (const Diagnostic& fault : error.faults())
                diagnostics_.error(setting.where, fmt::format("{}: {}", graph.name, fault.message));
        }
    }

    void checkPort(const graph::LinkedGraph& graph, const SweepGraph& named) {
        const auto& description = graph.description;
        const std::size_t dot = sweep_.port.find('.');
        if (dot == std::string::npos) {
            std::vector<std::string> outputs;
            for (const auto& output : description.outputs) outputs.push_back(output.first);
            if (std::find(outputs.begin(), outputs.end(), sweep_.port) == outputs.end())
                fault(named,
                      fmt::format("no output {}{}", inQuotes(sweep_.port), suggestion(sweep_.port, outputs)));
            return;
        }
        const std::string node = sweep_.port.substr(0, dot);
        const std::string port = sweep_.port.substr(dot + 1);
        const auto* found = graph::findNamed(description.nodes, node);
        if (found == nullptr)
            return fault(named, fmt::format("no node {}{}", inQuotes(node),
                                            graph::suggestionAmong(node, description.nodes)));
        const auto index = static_cast<std::size_t>(found - description.nodes.data());
        const auto& outputs = graph.nodes[index].type->outputs;
        if (graph::findNamed(outputs, port) == nullptr)
            fault(named, fmt::format("no port {} at its node {}{}", inQuotes(port), inQuotes(node),
                                     graph::suggestionAmong(port, outputs)));
    }

    void fault(const SweepGraph& graph, const std::string& what) {
        const bool isNamed = sweep_.portWhere.line != 0;
        diagnostics_.error(isNamed ? sweep_.portWhere : graph.where,
                           fmt::format("the graph {} has {}", graph.file.string(), what));
    }

    SceneReference readReferences(const SweepScene& scene) {
        SceneReference result;
        if (scene.reference.empty()) return result;
        result.reference = readReference(scene.reference, scene.referenceWhere);
        if (!scene.secondHalf.empty())
            result.secondHalf = readReference(scene.secondHalf, scene.secondHalfWhere);
        return result;
    }

    image::Image readReference(const std::filesystem::path& file, const SourceLocation& where) {
        image::Image picture;
        collect(where, [&] {
            picture = image::readExr(file).image;
            image::requireComparable(picture, file.string(), picture, file.string());
        });
        for (const graph::Extent& size : sweep_.sizes)
            if (!picture.channels.empty() && (picture.width != size.width || picture.height != size.height))
                diagnostics_.error(
                    where,
                    fmt::format("{} has {} x {} pixels, pictures of the sweep have {} x {}", file.string(),
                                picture.width, picture.height, size.width, size.height));
        return picture;
    }

    const Sweep& sweep_;
    const std::vector<std::filesystem::path>& passPaths_;
    DataFolders folders_;
    Diagnostics diagnostics_;
};

}  // namespace

std::vector<SceneReference> prepare(const Sweep& sweep, const std::vector<std::filesystem::path>& passPaths) {
    return Preparation(sweep, passPaths).run();
}

}  // namespace nephrite::sweep
