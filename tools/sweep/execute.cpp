// From runs to rows.
#include "sweep/execute.h"

#include <fmt/format.h>

#include <system_error>

#include "image/exr.h"
#include "image/metrics/metrics_report.h"
#include "image/output_file.h"
#include "image/png.h"
#include "pareto/pass_times.h"
#include "pareto/results.h"
#include "runtime/exposure.h"
#include "sweep/prepare.h"
#include "sweep/records.h"
#include "sweep/renderer.h"

namespace nephrite::sweep {
namespace {

using pareto::Progress;
using runtime::FrameTimes;

class Execution {
  public:
    Execution(const Sweep& sweep, const SweepOptions& options, const Progress& progress)
        : sweep_(sweep),
          options_(options),
          progress_(progress),
          references_(prepare(sweep, options.passPaths)),
          runs_(runsOf(sweep)),
          records_(options.folder),
          frames_(sweep, {options.passPaths, options.device, false}),
          passes_(sweep, {options.passPaths, options.device, true}) {
        makeFolders();
    }

    SweepState run() {
        std::size_t failed = 0;
        const std::size_t step = options_.part.count;
        for (std::size_t i = options_.part.index - 1; i < runs_.size(); i += step) {
            if (!records_.find(sweep_, runs_[i])) failed += render(runs_[i]) ? 0 : 1;
            progress_.show("sweep", static_cast<double>(i + 1) / static_cast<double>(runs_.size()));
        }
        if (failed > 0)
            throw RunError(fmt::format("{}: error: {} of {} runs failed", sweep_.file, failed, runs_.size()));
        SweepState state{runs_.size(), {}};
        for (const Run& run : runs_)
            if (auto row = records_.find(sweep_, run)) state.rows.push_back(std::move(*row));
        return state;
    }

  private:
    void makeFolders() const {
        std::error_code ignored;  // a failure shows where a file is written
        std::filesystem::create_directories(options_.folder / "runs", ignored);
        if (sweep_.pictures != Pictures::None)
            std::filesystem::create_directories(options_.folder / "pictures", ignored);
        image::OutputFile(options_.folder / "runs" / "trial");
    }

    /// False if it failed.
    bool render(const Run& run) {
        try {
            renderFrames(run);
            return true;
        } catch (const InputError& error) {
            for (const Diagnostic& fault : error.faults()) progress_.say(toLine(fault));
        } catch (const RunError& error) {
            if (progress_.stop()) throw;
            progress_.say(error.what());
        }
        progress_.say(fmt::format("{}: error: failed: {}", sweep_.file, run.name()));
        frames_.forget();
        passes_.forget();
        return false;
    }

    void renderFrames(const Run& run) {
        runtime::Session& session = frames_.show(run);
        Json::Value row = describe(run, session);
        const std::vector<FrameTimes> times = timesOf(session);
        const image::Image picture = session.read(sweep_.port);
        compare(run, picture, row);
        if (sweep_.timings) addWallTimes(times, row);
        if (sweep_.passes) addPassTimes(run, row);
        if (sweep_.pictures != Pictures::None) row["picture"] = writePicture(run, picture, session.plan());
        std::vector<std::filesystem::path> files = session.files();
        for (const auto& file : {run.scene->reference, run.scene->secondHalf})
            if (!file.empty()) files.push_back(std::filesystem::absolute(file));
        records_.write(sweep_, run, files, row);
    }

    std::vector<FrameTimes> timesOf(runtime::Session& session) const {
        std::vector<FrameTimes> times;
        for (std::uint32_t i = 0; i < sweep_.warmup + sweep_.frames; ++i) {
            if (progress_.stop())
                throw RunError("interrupted; runs that are done are kept, the same command continues");
            FrameTimes frame = session.renderFrame(sweep_.time);
            if (i >= sweep_.warmup) times.push_back(std::move(frame));
        }
        return times;
    }

    Json::Value describe(const Run& run, const runtime::Session& session) const {
        Json::Value row;
        row["id"] = run.id();
        row["scene"] = run.scene->name;
        row["graph"] = run.graph->name;
        row["width"] = run.size.width;
        row["height"] = run.size.height;
        row["parameters"] = Json::objectValue;
        for (const Setting* setting : run.parameters) row["parameters"][setting->parameter] = setting->value;
        row["frames"] = sweep_.frames;
        row["warmup"] = sweep_.warmup;
        row["device"] = session.deviceName();
        row["driver"] = session.driverName();
        row["commit"] = options_.commit;
        return row;
    }

    void compare(const Run& run, const image::Image& picture, Json::Value& row) const {
        const auto index = static_cast<std::size_t>(run.scene - sweep_.scenes.data());
        const SceneReference& reference = references_[index];
        if (!reference.isThere()) return;
        const image::Metrics metrics = image::compareImages(
            picture, reference.reference, reference.hasSecondHalf() ? &reference.secondHalf : nullptr,
            {.bins = run.scene->bins});
        row["error"] = pareto::errorOf(metrics);
        row["metrics"] = image::toJson(metrics);
    }

    static void addWallTimes(const std::vector<FrameTimes>& times, Json::Value& row) {
        std::vector<double> wall;
        for (const FrameTimes& frame : times) wall.push_back(frame.wallMs);
        row["wallMs"] = pareto::toJson(runtime::timeStatistics(std::move(wall)));
    }

    void addPassTimes(const Run& run, Json::Value& row) {
        runtime::Session& session = passes_.show(run);
        const std::vector<FrameTimes> times = timesOf(session);
        row["passes"] = Json::arrayValue;
        for (const pareto::PassResult& pass : pareto::passTimes(session.plan(), times))
            row["passes"].append(pareto::toJson(pass));
    }

    /// The file's name, relative to the folder.
    std::string writePicture(const Run& run, const image::Image& picture, const graph::Plan& plan) const {
        const bool isExr = sweep_.pictures == Pictures::Exr;
        const std::string name = fmt::format("pictures/{}.{}", run.id(), isExr ? "exr" : "png");
        if (isExr)
            image::writeExr(options_.folder / name, picture,
                            {{"run", run.name()}, {"commit", options_.commit}});
        else
            image::writePng(options_.folder / name, image::toneMap(picture, runtime::toneMapping(plan)));
        return name;
    }

    const Sweep& sweep_;
    const SweepOptions& options_;
    const Progress& progress_;
    std::vector<SceneReference> references_;
    std::vector<Run> runs_;
    Records records_;
    Renderer frames_;
    Renderer passes_;  ///< profiled
};

}  // namespace

SweepState execute(const Sweep& sweep, const SweepOptions& options, const Progress& progress) {
    return Execution(sweep, options, progress).run();
}

}  // namespace nephrite::sweep
