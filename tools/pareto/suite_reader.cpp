// Reads a suite file.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>

#include "graph/value_readers.h"
#include "pareto/file_readers.h"
#include "pareto/suite.h"

namespace nephrite::pareto {
namespace {

using json::ObjectReader;
using json::Value;

/// Parameter values of one method, multiplied out.
constexpr std::size_t mostPoints = 256;

std::optional<truth::Mode> modeCalled(const std::string& name, const SourceLocation& where,
                                      Diagnostics& diagnostics) {
    if (const auto mode = truth::parseMode(name)) return mode;
    static constexpr std::array<std::string_view, 3> known{"volume", "dipole", "single"};
    diagnostics.error(where,
                      fmt::format("expected a reference (\"volume\", \"dipole\", \"single\"), found {}{}",
                                  inQuotes(name), suggestion(name, known)));
    return std::nullopt;
}

ReferenceSettings readReference(truth::Mode mode, const Value& value, Diagnostics& diagnostics) {
    ReferenceSettings settings;
    settings.mode = mode;
    ObjectReader object(value, "a reference", diagnostics);
    readCount(object, "spp", 1, 1U << 24, settings.samples);
    std::uint32_t seed = 1;
    readCount(object, "seed", 0, std::numeric_limits<std::uint32_t>::max(), seed);
    settings.seed = seed;
    if (mode == truth::Mode::Dipole) readCount(object, "fluxPoints", 1, 1U << 26, settings.fluxPoints);
    object.finish();
    return settings;
}

class SuiteReader {
  public:
    explicit SuiteReader(const Value& value)
        : root_(value, "a suite", diagnostics_),
          folder_(std::filesystem::path(value.where().file).parent_path()) {
        suite_.file = value.where().file;
    }

    Suite read() {
        suite_.name = readName(root_, "a suite");
        readSize();
        readCount(root_, "frames", 1, 100000, suite_.frames);
        readCount(root_, "warmup", 0, 100000, suite_.warmup);
        readScenes();
        readMethods();
        readBaseline();
        root_.finish();
        diagnostics_.throwIfErrors();
        return std::move(suite_);
    }

  private:
    void readSize() {
        const auto size = root_.optional("size");
        const auto extent = size ? readExtent(*size, diagnostics_) : std::nullopt;
        if (!extent) return;
        suite_.width = extent->width;
        suite_.height = extent->height;
    }

    // ---- scenes

    void readScenes() {
        const auto scenes = root_.required("scenes");
        if (!scenes) return;
        for (const auto& [name, value] : membersOf(*scenes, "scenes", diagnostics_)) {
            checkName(name, "a scene", value, diagnostics_);
            suite_.scenes.push_back(readScene(name, value));
        }
        if (scenes->isObject() && suite_.scenes.empty())
            diagnostics_.error(scenes->where(), "a suite needs at least one scene");
    }

    SuiteScene readScene(const std::string& name, const Value& value) {
        SuiteScene scene;
        scene.name = name;
        scene.where = value.whereKey();
        ObjectReader object(value, "a scene of a suite", diagnostics_);
        if (const auto file = object.required("scene"))
            scene.file = readPath(*file, "a scene file's name", folder_, diagnostics_);
        readCount(object, "bins", 1, largestSide, scene.bins);
        if (const auto references = object.optional("references"))
            for (const auto& [mode, settings] : membersOf(*references, "references", diagnostics_))
                if (const auto known = modeCalled(mode, settings.whereKey(), diagnostics_))
                    scene.references.push_back(readReference(*known, settings, diagnostics_));
        object.finish();
        return scene;
    }

    // ---- methods

    void readMethods() {
        const auto methods = root_.required("methods");
        if (!methods) return;
        for (const auto& [name, value] : membersOf(*methods, "methods", diagnostics_)) {
            checkName(name, "a method", value, diagnostics_);
            suite_.methods.push_back(readMethod(name, value));
        }
        if (methods->isObject() && suite_.methods.empty())
            diagnostics_.error(methods->where(), "a suite needs at least one method");
    }

    Method readMethod(const std::string& name, const Value& value) {
        Method method;
        method.name = name;
        method.where = value.whereKey();
        ObjectReader object(value, "a method", diagnostics_);
        const auto graph = object.optional("graph");
        const auto references = object.optional("references");
        if (value.isObject() && graph.has_value() == references.has_value())
            diagnostics_.error(value.where(),
                               fmt::format("a method needs either \"graph\" or \"references\"{}",
                                           graph ? ", found both" : ""));
        if (graph) {
            method.graph = readPath(*graph, "a graph file's name", folder_, diagnostics_);
            readGraphSettings(object, method);
        }
        if (references)
            for (const Value& element : elementsOf(*references, "references", diagnostics_))
                if (const auto mode = readMode(element)) method.references.push_back(*mode);
        readComparisons(object, method);
        object.finish();
        return method;
    }

    std::optional<truth::Mode> readMode(const Value& value) {
        const auto name = value.string(diagnostics_, "the name of a reference");
        return name ? modeCalled(*name, value.where(), diagnostics_) : std::nullopt;
    }

    void readGraphSettings(ObjectReader& object, Method& method) {
        if (const auto skip = object.optional("skip"))
            method.skip = skip->boolean(diagnostics_, "true or false").value_or(true);
        if (const auto set = object.optional("set"))
            for (const auto& [name, value] : membersOf(*set, "parameters", diagnostics_))
                method.settings.push_back(fmt::format("{}={}", name, value.sourceText()));
        const auto vary = object.optional("vary");
        if (!vary) return;
        std::size_t points = 1;
        for (const auto& [name, value] : membersOf(*vary, "parameters", diagnostics_)) {
            Variation variation{name, {}};
            for (const Value& element : elementsOf(value, "values", diagnostics_))
                variation.values.emplace_back(element.sourceText());
            points = std::min(points * variation.values.size(), mostPoints + 1);
            method.variations.push_back(std::move(variation));
        }
        if (points > mostPoints)
            diagnostics_.error(vary->where(),
                               fmt::format("these make more than {} combinations", mostPoints));
    }

    void readComparisons(ObjectReader& object, Method& method) {
        const auto against = object.optional("against");
        if (!against) {
            method.against = {{truth::Mode::Volume, "color"}};
            return;
        }
        for (const auto& [name, value] : membersOf(*against, "ports by reference", diagnostics_)) {
            const auto mode = modeCalled(name, value.whereKey(), diagnostics_);
            const auto port = value.string(diagnostics_, "\"color\" or a \"node.port\"");
            if (!mode || !port) continue;
            if (!method.references.empty() && *port != "color")
                diagnostics_.error(
                    value.where(),
                    fmt::format("references have nothing but \"color\", found {}", value.describe()));
            method.against.push_back({*mode, *port});
        }
    }

    void readBaseline() {
        const auto baseline = root_.optional("baseline");
        if (!baseline) return;
        const auto name = baseline->string(diagnostics_, "the name of a method");
        if (!name) return;
        suite_.baseline = *name;
        const Method* method = suite_.find(*name);
        if (method == nullptr)
            diagnostics_.error(baseline->where(), fmt::format("no method is called {}{}", inQuotes(*name),
                                                              graph::suggestionAmong(*name, suite_.methods)));
        else if (!method->isTimed())
            diagnostics_.error(baseline->where(), "the baseline has no time: it is a sum of references");
    }

    Diagnostics diagnostics_;
    ObjectReader root_;
    std::filesystem::path folder_;
    Suite suite_;
};

}  // namespace

const ReferenceSettings* SuiteScene::find(truth::Mode mode) const {
    for (const ReferenceSettings& settings : references)
        if (settings.mode == mode) return &settings;
    return nullptr;
}

const Method* Suite::find(std::string_view method) const {
    return graph::findNamed(methods, method);
}

Suite readSuite(const Value& value) {
    return SuiteReader(value).read();
}

Suite readSuite(const std::filesystem::path& file) {
    return readSuite(json::parseFile(file));
}

}  // namespace nephrite::pareto
