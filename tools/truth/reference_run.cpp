// Rendering a reference to its file.
#include "truth/reference_run.h"

#include <fmt/format.h>

#include <array>
#include <chrono>
#include <fstream>
#include <sstream>

#include "image/output_file.h"
#include "text/diagnostics.h"
#include "truth/run_record.h"

namespace nephrite::truth {
namespace {

constexpr std::array modes{Mode::Single, Mode::Dipole, Mode::Volume};

/// The file beside the output from which an interrupted run continues.
class Unfinished {
  public:
    Unfinished(const std::filesystem::path& picture, const ReferenceRequest& request, image::Metadata record)
        : file_(picture.string() + ".unfinished") {
        record["size"] = fmt::format("{}x{}", request.width, request.height);
        heading_ = toText(record);
    }

    /// Throws InputError if there is one of another run.
    void load(Rendering& rendering) const {
        std::ifstream stream(file_, std::ios::binary);
        if (!stream) return;
        std::ostringstream text;
        text << stream.rdbuf();
        const std::string saved = text.str();
        const bool isOurs = saved.starts_with(heading_);
        if (!isOurs || !rendering.restore(std::string_view(saved).substr(heading_.size())))
            throw InputError({file_.string()},
                             "holds the unfinished work of another command; remove it to start anew");
    }
    void save(const Rendering& rendering) const { image::writeFile(file_, heading_ + rendering.save()); }
    void remove() const {
        std::error_code ignored;
        std::filesystem::remove(file_, ignored);
    }
    const std::filesystem::path& file() const { return file_; }

  private:
    std::filesystem::path file_;
    std::string heading_;
};

/// Renders until finished; what is done is saved every minute. Throws RunError when stopped.
void renderAll(Rendering& rendering, const Unfinished& unfinished, unsigned threads, const Watcher& watcher) {
    using Clock = std::chrono::steady_clock;
    constexpr auto betweenSaves = std::chrono::minutes(1);
    Clock::time_point nextSave = Clock::now() + betweenSaves;
    Watcher untilSave = watcher;
    untilSave.stop = [&] { return watcher.stop() || Clock::now() >= nextSave; };
    while (!rendering.isFinished()) {
        rendering.run(threads, untilSave);
        if (rendering.isFinished()) break;
        unfinished.save(rendering);
        nextSave = Clock::now() + betweenSaves;
        if (watcher.stop())
            throw RunError(fmt::format("{}: error: interrupted; the same command continues from here",
                                       unfinished.file().string()));
    }
}

}  // namespace

std::string_view name(Mode mode) {
    switch (mode) {
        case Mode::Single:
            return "single";
        case Mode::Dipole:
            return "dipole";
        case Mode::Volume:
            break;
    }
    return "volume";
}

std::optional<Mode> parseMode(std::string_view text) {
    for (const Mode mode : modes)
        if (name(mode) == text) return mode;
    return std::nullopt;
}

image::Metadata recordOf(const ReferenceRequest& request, const scene::Scene& scene) {
    image::Metadata record{{"mode", std::string(name(request.estimator.mode))},
                           {"scene", request.scene.string()},
                           {"sceneDigest", digestOf(scene.files())},
                           {"samples", fmt::format("{}", request.samples)},
                           {"seed", fmt::format("{}", request.estimator.seed)},
                           {"time", fmt::format("{:.17g}", request.time)},
                           {"commit", request.commit}};
    if (request.estimator.mode == Mode::Dipole)
        record["fluxPoints"] = fmt::format("{}", request.estimator.fluxPoints);
    else
        record["photons"] = fmt::format("{}", request.estimator.photons);
    if (request.part) record["part"] = toText(*request.part);
    return record;
}

void renderReference(const ReferenceRequest& request, const scene::Scene& scene, const ReferenceFiles& files,
                     unsigned threads, const Watcher& watcher) {
    const World world(scene, request.time);
    const auto estimator = makeEstimator(world, request.estimator, scene);
    const Camera camera(scene.description().camera, request.width, request.height);
    Rendering rendering(world, camera, *estimator, request.part.value_or(Part{}), request.samples);

    image::Metadata record = recordOf(request, scene);
    const Unfinished unfinished(files.picture, request, record);
    // So that hours of work do not end at a folder that is not there.
    image::OutputFile(files.picture);
    if (!files.standardErrors.empty()) image::OutputFile(files.standardErrors);
    unfinished.load(rendering);
    renderAll(rendering, unfinished, threads, watcher);
    record["content"] = "radiance";
    image::writeExr(files.picture, rendering.picture(), record);
    record["content"] = "standard error";
    if (!files.standardErrors.empty())
        image::writeExr(files.standardErrors, rendering.standardErrors(), record);
    unfinished.remove();
}

}  // namespace nephrite::truth
