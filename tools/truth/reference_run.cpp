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

    /// Continues from the file, if there is one; one that is broken is left alone, with a line to `watcher`.
    /// Throws InputError if it is of another run.
    void load(Rendering& rendering, const Watcher& watcher) const {
        std::ifstream stream(file_, std::ios::binary);
        if (!stream) return;
        std::ostringstream text;
        text << stream.rdbuf();
        const std::string saved = text.str();
        if (!saved.starts_with(heading_))
            throw InputError({file_.string()},
                             "holds the unfinished work of another command; remove it to start anew");
        if (!rendering.restore(std::string_view(saved).substr(heading_.size())))
            watcher.say(fmt::format("{}: is damaged, all starts anew", file_.string()));
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

/// Whether the file is there and says that it is this run's.
bool isFinished(const std::filesystem::path& file, const ReferenceRequest& request,
                const image::Metadata& record, std::string_view content) {
    std::error_code ignored;
    if (!std::filesystem::exists(file, ignored)) return false;
    try {
        const image::ExrFile found = image::readExr(file);
        return found.image.width == request.width && found.image.height == request.height &&
               isOf(record, content, found);
    } catch (const InputError&) {
        return false;
    }
}

bool areFinished(const ReferenceFiles& files, const ReferenceRequest& request,
                 const image::Metadata& record) {
    return isFinished(files.picture, request, record, "radiance") &&
           (files.standardErrors.empty() ||
            isFinished(files.standardErrors, request, record, "standard error"));
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
                           {"revision", fmt::format("{}", revisionOf(request.estimator.mode))},
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
    image::Metadata record = recordOf(request, scene);
    if (areFinished(files, request, record))
        return watcher.say(fmt::format("{}: is finished, by the same command; remove it to render it anew",
                                       files.picture.string()));
    const World world(scene, request.time);
    const auto estimator = makeEstimator(world, request.estimator, scene);
    const Camera camera(scene.description().camera, request.width, request.height);
    Rendering rendering(world, camera, *estimator, request.part.value_or(Part{}), request.samples);

    const Unfinished unfinished(files.picture, request, record);
    // So that hours of work do not end at a folder that is not there.
    image::OutputFile(files.picture);
    if (!files.standardErrors.empty()) image::OutputFile(files.standardErrors);
    unfinished.load(rendering, watcher);
    renderAll(rendering, unfinished, threads, watcher);
    record["content"] = "radiance";
    image::writeExr(files.picture, rendering.picture(), record);
    record["content"] = "standard error";
    if (!files.standardErrors.empty())
        image::writeExr(files.standardErrors, rendering.standardErrors(), record);
    unfinished.remove();
}

}  // namespace nephrite::truth
