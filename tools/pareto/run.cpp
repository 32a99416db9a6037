// One scene after the other; the points of a scene side by side.
#include "pareto/run.h"

#include <fmt/format.h>

#include <algorithm>

#include "pareto/measure.h"
#include "pareto/reference_store.h"
#include "runtime/graph_loading.h"

namespace nephrite::pareto {
namespace {

/// A scene that can be rendered, and what is measured of it.
struct Task {
    const SuiteScene* scene = nullptr;
    std::vector<Point> points;
};

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

scene::Scene loadScene(const SuiteScene& scene, const runtime::DataFolders& folders) {
    try {
        return runtime::loadScene(scene.file, 0, folders);
    } catch (const InputError& error) {
        std::vector<Diagnostic> faults = error.faults();
        faults.push_back({scene.where, fmt::format("cannot use the scene {}", scene.file.string())});
        throw InputError(std::move(faults));
    }
}

/// Every scene and every graph is read once before the first is rendered.
std::vector<Task> prepare(const Suite& suite, const RunOptions& options, const Progress& progress,
                          std::vector<LeftOutScene>& leftOut) {
    const auto folders = runtime::DataFolders::find();
    std::vector<Task> tasks;
    bool isSelected = false;
    for (const SuiteScene& scene : suite.scenes) {
        std::vector<Point> points = pointsOf(suite, scene, options.selection);
        if (points.empty()) continue;
        isSelected = true;
        if (const auto model = missingModel(scene.file, folders.models)) {
            leftOut.push_back(
                {scene.name, fmt::format("the model {} is not at hand: set NEPHRITE_MODELS to the "
                                         "folder that has it",
                                         *model)});
            progress.say(fmt::format("{}: left out, {}", scene.name, leftOut.back().why));
            continue;
        }
        loadScene(scene, folders);
        for (const Point& point : points)
            if (point.method->isTimed()) runtime::loadGraph(point.method->graph, point.settings, folders, {});
        tasks.push_back({&scene, std::move(points)});
    }
    if (!isSelected) throw InputError({"--only"}, "this pattern selects no scene and method of the suite");
    return tasks;
}

PointResult emptyResult(const Point& point) {
    PointResult result;
    result.name = point.name;
    result.method = point.method->name;
    result.graph = point.method->graph;
    result.parameters = point.parameters;
    result.settings = point.settings;
    result.skip = point.method->skip;
    result.isFirst = point.isFirst;
    return result;
}

/// The mean of a reference's halves, red, green and blue.
image::Image meanOf(const Reference& reference) {
    const image::Image& first = reference.halves[0];
    const image::Image& second = reference.halves[1];
    image::Image mean{first.width, first.height, {"R", "G", "B"}, {}};
    for (std::uint32_t y = 0; y < first.height; ++y)
        for (std::uint32_t x = 0; x < first.width; ++x)
            for (std::uint32_t c = 0; c < 3; ++c)
                mean.pixels.push_back((first.at(x, y, c) + second.at(x, y, c)) / 2);
    return mean;
}

class SceneRun {
  public:
    SceneRun(const Suite& suite, const Task& task, const RunOptions& options, const Progress& progress)
        : task_(task), options_(options), progress_(progress), scene_(*task.scene) {
        settings_ = {{suite.width, suite.height}, suite.frames, suite.warmup, options.device};
        baseline_ = suite.baseline;
    }

    SceneResult run() {
        result_.name = scene_.name;
        result_.file = scene_.file;
        result_.bins = scene_.bins;
        for (const Point& point : task_.points) result_.points.push_back(emptyResult(point));
        // Pictures first: what is wrong with a graph shows before hours of references.
        std::vector<std::map<std::string, image::Image>> pictures;
        for (const Point& point : task_.points) {
            pictures.push_back(point.method->isTimed() ? renderPictures(point, scene_.file, settings_)
                                                       : std::map<std::string, image::Image>());
        }
        renderReferences();
        compare(pictures);
        measure();
        markFronts(result_);
        return std::move(result_);
    }

    const std::string& device() const { return times_.device; }
    const std::string& driver() const { return times_.driver; }

  private:
    /// Whether a point is held against the reference or made of it.
    bool isNeeded(truth::Mode mode) const {
        return std::any_of(task_.points.begin(), task_.points.end(), [mode](const Point& point) {
            const auto& sum = point.method->references;
            const auto& against = point.method->against;
            return std::find(sum.begin(), sum.end(), mode) != sum.end() ||
                   std::any_of(against.begin(), against.end(),
                               [mode](const ComparedPort& port) { return port.reference == mode; });
        });
    }

    void renderReferences() {
        if (scene_.references.empty()) return;
        const scene::Scene scene = loadScene(scene_, runtime::DataFolders::find());
        const ReferenceStore store({options_.folder / "references", settings_.size.width,
                                    settings_.size.height, options_.commit, options_.threads});
        for (const ReferenceSettings& settings : scene_.references) {
            if (!isNeeded(settings.mode)) continue;
            references_.push_back(store.get(scene_, scene, settings, progress_));
            result_.references.push_back(references_.back().result);
        }
    }

    const Reference* find(truth::Mode mode) const {
        for (const Reference& reference : references_)
            if (reference.result.mode == mode) return &reference;
        return nullptr;
    }

    image::Image sumOf(const std::vector<truth::Mode>& modes) const {
        image::Image sum = meanOf(*find(modes.front()));
        for (std::size_t i = 1; i < modes.size(); ++i) {
            const image::Image more = meanOf(*find(modes[i]));
            std::transform(sum.pixels.begin(), sum.pixels.end(), more.pixels.begin(), sum.pixels.begin(),
                           std::plus<>());
        }
        return sum;
    }

    void compare(std::vector<std::map<std::string, image::Image>>& pictures) {
        image::MetricsOptions metrics;
        metrics.bins = scene_.bins;
        for (std::size_t i = 0; i < task_.points.size(); ++i) {
            const Method& method = *task_.points[i].method;
            if (!method.isTimed()) pictures[i]["color"] = sumOf(method.references);
            for (const ComparedPort& compared : method.against) {
                const Reference* reference = find(compared.reference);
                if (reference == nullptr) continue;
                result_.points[i].comparisons.push_back(
                    {compared.reference, compared.port,
                     image::compareImages(pictures[i].at(compared.port), reference->halves[0],
                                          &reference->halves[1], metrics),
                     false});
            }
        }
    }

    void measure() {
        const bool isTimed = std::any_of(task_.points.begin(), task_.points.end(),
                                         [](const Point& point) { return point.method->isTimed(); });
        if (!isTimed) return;
        times_ = measureTimes(task_.points, scene_.file, settings_, progress_);
        result_.rounds = times_.rounds;
        for (std::size_t i = 0; i < task_.points.size(); ++i) {
            result_.points[i].wallMs = times_.wallMs[i];
            result_.points[i].passes = times_.passes[i];
        }
        // The baseline's points come first.
        if (result_.points.front().method == baseline_) setRatios(result_.points, 0);
    }

    const Task& task_;
    const RunOptions& options_;
    const Progress& progress_;
    const SuiteScene& scene_;
    FrameSettings settings_;
    std::string baseline_;
    std::vector<Reference> references_;
    SceneTimes times_;
    SceneResult result_;
};

}  // namespace

SuiteResult runSuite(const Suite& suite, const RunOptions& options, const Progress& progress) {
    SuiteResult result;
    result.suite = suite.name;
    result.baseline = suite.baseline;
    result.commit = options.commit;
    result.width = suite.width;
    result.height = suite.height;
    result.frames = suite.frames;
    result.warmup = suite.warmup;
    const std::vector<Task> tasks = prepare(suite, options, progress, result.leftOut);
    for (const Task& task : tasks) {
        SceneRun run(suite, task, options, progress);
        result.scenes.push_back(run.run());
        if (run.device().empty()) continue;
        result.device = run.device();
        result.driver = run.driver();
    }
    return result;
}

}  // namespace nephrite::pareto
