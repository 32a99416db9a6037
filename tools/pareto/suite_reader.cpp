// Reads a suite file.
#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "graph/value_readers.h"
#include "pareto/file_readers.h"
#include "pareto/method_reader.h"
#include "pareto/suite.h"
#include "pareto/suite_values.h"

namespace nephrite::pareto {
namespace {

using json::ObjectReader;
using json::Value;

ReferenceSettings readReference(truth::Mode mode, const Value& value, Diagnostics& diagnostics) {
    ReferenceSettings settings;
    settings.mode = mode;
    settings.where = value.whereKey();
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
        ObjectReader object(value, "a scene of a suite", diagnostics_);
        if (const auto file = object.required("scene")) {
            scene.file = readPath(*file, "a scene file's name", folder_, diagnostics_);
            scene.where = file->where();
        }
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
            suite_.methods.push_back(readMethod(name, value, folder_, diagnostics_));
        }
        if (methods->isObject() && suite_.methods.empty())
            diagnostics_.error(methods->where(), "a suite needs at least one method");
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
