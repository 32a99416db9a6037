// One scene after the other; the points of a scene side by side.
#include "pareto/run.h"

#include <fmt/format.h>

#include <algorithm>

#include "pareto/measure.h"
#include "pareto/reference_store.h"
#include "runtime/loading/graph_loading.h"

namespace nephrite::pareto {
namespace {

PointResult emptyResult(const Point& point) {
    PointResult result;
    result.name = point.name;
    result.method = point.method->name;
    result.graph = point.method->graph;
    result.parameters = point.parameters;
    result.settings = point.settingTexts();
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
    void renderReferences() {
        if (scene_.references.empty()) return;
        const scene::Scene scene = runtime::loadScene(scene_.file, 0, runtime::DataFolders::find());
        const ReferenceStore store({options_.folder / "references", settings_.size.width,
                                    settings_.size.height, options_.commit, options_.threads});
        for (const ReferenceSettings& settings : scene_.references) {
            if (!needs(task_.points, settings.mode)) continue;
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

SuiteResult runSuite(const Suite& suite, const Preparation& preparation, const RunOptions& options,
                     const Progress& progress) {
    SuiteResult result;
    result.suite = suite.name;
    result.baseline = suite.baseline;
    result.commit = options.commit;
    result.width = suite.width;
    result.height = suite.height;
    result.frames = suite.frames;
    result.warmup = suite.warmup;
    result.leftOut = preparation.leftOut;
    for (const Task& task : preparation.tasks) {
        SceneRun run(suite, task, options, progress);
        result.scenes.push_back(run.run());
        if (run.device().empty()) continue;
        result.device = run.device();
        result.driver = run.driver();
    }
    return result;
}

}  // namespace nephrite::pareto
