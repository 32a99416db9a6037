// Reads a sweep file.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "pareto/file_readers.h"
#include "sweep/sweep.h"
#include "text/json_write.h"

namespace nephrite::sweep {
namespace {

using json::ObjectReader;
using json::Value;
using namespace std::string_view_literals;

constexpr std::size_t mostRuns = 100000;

class SweepReader {
  public:
    explicit SweepReader(const Value& value)
        : root_(value, "a sweep", sweepKeys(), diagnostics_),
          folder_(std::filesystem::path(value.where().file).parent_path()) {
        sweep_.file = value.where().file;
    }

    Sweep read() {
        sweep_.name = pareto::readName(root_, "a sweep");
        readNamed("scenes", "a scene", [this](const std::string& name, const Value& value) {
            sweep_.scenes.push_back(readScene(name, value));
        });
        readNamed("graphs", "a graph", [this](const std::string& name, const Value& value) {
            sweep_.graphs.push_back(readGraph(name, value));
        });
        readSizes();
        readGrid();
        readList();
        readFrames();
        readOutputs();
        requireFewRuns();
        root_.finish();
        diagnostics_.throwIfErrors();
        return std::move(sweep_);
    }

  private:
    // ---- scenes and graphs

    template<class Read>
    void readNamed(std::string_view key, std::string_view what, Read read) {
        const auto all = root_.optional(key);
        if (!all) return;
        for (const auto& [name, value] :
             pareto::membersOf(*all, fmt::format("{} by name", key), diagnostics_)) {
            pareto::checkName(name, what, value, diagnostics_);
            read(name, value);
        }
        if (all->isObject() && all->size() == 0)
            diagnostics_.error(all->where(), fmt::format("a sweep needs at least one of its {}", key));
    }

    std::filesystem::path path(const Value& value, std::string_view what) {
        return pareto::readPath(value, what, folder_, diagnostics_);
    }

    SweepScene readScene(const std::string& name, const Value& value) {
        SweepScene scene;
        scene.name = name;
        scene.where = value.where();
        if (value.isString()) {
            scene.file = path(value, "a scene file's name");
            return scene;
        }
        ObjectReader object(value, "a scene of a sweep", sceneKeys(), diagnostics_);
        if (const auto file = object.optional("scene")) {
            scene.file = path(*file, "a scene file's name");
            scene.where = file->where();
        }
        if (const auto reference = object.optional("reference")) {
            scene.reference = path(*reference, "the name of an EXR file");
            scene.referenceWhere = reference->where();
        }
        if (const auto half = object.optional("secondHalf")) {
            scene.secondHalf = path(*half, "the name of an EXR file");
            scene.secondHalfWhere = half->where();
            if (scene.reference.empty())
                diagnostics_.error(half->where(), "there is no \"reference\" that this could be the half of");
        }
        pareto::readCount(object, "bins", 1, pareto::largestSide, scene.bins);
        object.finish();
        return scene;
    }

    SweepGraph readGraph(const std::string& name, const Value& value) {
        SweepGraph graph;
        graph.name = name;
        graph.where = value.where();
        if (value.isString()) {
            graph.file = path(value, "a graph file's name");
            return graph;
        }
        ObjectReader object(value, "a graph of a sweep", graphKeys(), diagnostics_);
        if (const auto file = object.optional("graph")) {
            graph.file = path(*file, "a graph file's name");
            graph.where = file->where();
        }
        if (const auto set = object.optional("set")) graph.settings = readSettings(*set);
        if (const auto skip = object.optional("skip"))
            graph.skip = skip->boolean(diagnostics_, "true or false").value_or(true);
        object.finish();
        return graph;
    }

    // ---- values

    std::vector<Setting> readSettings(const Value& set) {
        std::vector<Setting> settings;
        for (const auto& [name, value] : pareto::membersOf(set, "values by parameter", diagnostics_))
            settings.push_back({name, value.raw(), value.where()});
        return settings;
    }

    void readSizes() {
        const auto sizes = root_.optional("sizes");
        if (!sizes) return;
        sweep_.sizes.clear();
        for (const Value& element : pareto::elementsOf(*sizes, "sizes", diagnostics_)) {
            const auto extent = pareto::readExtent(element, diagnostics_);
            if (!extent) continue;
            if (std::find(sweep_.sizes.begin(), sweep_.sizes.end(), *extent) != sweep_.sizes.end())
                diagnostics_.error(element.where(), "this size is there already");
            sweep_.sizes.push_back(*extent);
        }
    }

    void readGrid() {
        const auto grid = root_.optional("grid");
        if (!grid) return;
        for (const auto& [name, value] : pareto::membersOf(*grid, "values by parameter", diagnostics_)) {
            Axis axis{name, {}};
            for (const Value& element : pareto::elementsOf(value, "values", diagnostics_)) {
                Setting setting{name, element.raw(), element.where()};
                requireNew(setting, axis.values);
                axis.values.push_back(std::move(setting));
            }
            sweep_.grid.push_back(std::move(axis));
        }
    }

    /// The same run twice would be one row.
    void requireNew(const Setting& setting, const std::vector<Setting>& others) {
        for (const Setting& other : others)
            if (other.text() == setting.text())
                return diagnostics_.error(setting.where, fmt::format("{} is there already", setting.text()));
    }

    void readList() {
        const auto list = root_.optional("list");
        if (!list) return;
        for (const Value& element : pareto::elementsOf(*list, "sets of values", diagnostics_)) {
            std::vector<Setting> set = readSettings(element);
            for (const Setting& setting : set)
                for (const Axis& axis : sweep_.grid)
                    if (axis.parameter == setting.parameter)
                        diagnostics_.error(setting.where,
                                           fmt::format("the grid has values of {}, too", setting.parameter));
            for (const std::vector<Setting>& other : sweep_.list)
                if (std::equal(set.begin(), set.end(), other.begin(), other.end(),
                               [](const Setting& a, const Setting& b) { return a.text() == b.text(); }))
                    diagnostics_.error(element.where(), "this set is there already");
            sweep_.list.push_back(std::move(set));
        }
    }

    void requireFewRuns() {
        double count = static_cast<double>(sweep_.scenes.size() * sweep_.graphs.size() * sweep_.sizes.size() *
                                           std::max<std::size_t>(sweep_.list.size(), 1));
        for (const Axis& axis : sweep_.grid) count *= static_cast<double>(axis.values.size());
        if (count > mostRuns)
            diagnostics_.error(root_.value().where(),
                               fmt::format("this makes {:g} runs, more than {}", count, mostRuns));
    }

    // ---- what is done and written

    void readFrames() {
        if (const auto timings = root_.optional("timings"))
            sweep_.timings = timings->boolean(diagnostics_, "true or false").value_or(true);
        if (!sweep_.timings) {
            sweep_.frames = 1;
            sweep_.warmup = 0;
        }
        pareto::readCount(root_, "frames", 1, 100000, sweep_.frames);
        pareto::readCount(root_, "warmup", 0, 100000, sweep_.warmup);
        if (const auto time = root_.optional("time"))
            sweep_.time = time->number(diagnostics_, "seconds").value_or(0);
        const auto passes = root_.optional("passes");
        if (!passes) return;
        sweep_.passes = passes->boolean(diagnostics_, "true or false").value_or(false);
        if (sweep_.passes && !sweep_.timings)
            diagnostics_.error(passes->where(), "passes cannot be timed without \"timings\"");
    }

    void readOutputs() {
        if (const auto port = root_.optional("port")) {
            sweep_.port = port->string(diagnostics_, "an output or a \"node.port\"").value_or("color");
            sweep_.portWhere = port->where();
        }
        const auto pictures = root_.optional("pictures");
        if (!pictures || (pictures->isBool() && !pictures->raw().asBool())) return;
        if (pictures->isString() && pictures->raw().asString() == "exr"sv)
            sweep_.pictures = Pictures::Exr;
        else if (pictures->isString() && pictures->raw().asString() == "png"sv)
            sweep_.pictures = Pictures::Png;
        else
            diagnostics_.error(pictures->where(), fmt::format("expected \"exr\", \"png\" or false, found {}",
                                                              pictures->describe()));
    }

    Diagnostics diagnostics_;
    ObjectReader root_;
    std::filesystem::path folder_;
    Sweep sweep_;
};

}  // namespace

std::string Setting::text() const {
    std::string json = json::toText(value);
    json.pop_back();  // its line break
    return fmt::format("{}={}", parameter, json);
}

Sweep readSweep(const Value& value) {
    return SweepReader(value).read();
}

Sweep readSweep(const std::filesystem::path& file) {
    return readSweep(json::parseFile(file));
}

}  // namespace nephrite::sweep
