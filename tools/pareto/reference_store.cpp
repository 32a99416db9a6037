// Finding references, and rendering those that are missing.
#include "pareto/reference_store.h"

#include <fmt/format.h>

#include <array>
#include <string_view>
#include <system_error>

#include "truth/run_record.h"

namespace nephrite::pareto {
namespace {

/// Whether a picture is what a request would render; who rendered it, and where the scene lay, does not
/// matter.
bool isOf(const truth::ReferenceRequest& request, const image::Metadata& record,
          const image::ExrFile& found) {
    static constexpr std::array<std::string_view, 2> ignored{"commit", "scene"};
    return found.image.width == request.width && found.image.height == request.height &&
           truth::isOf(record, "radiance", found, ignored);
}

/// The noise of a mean of two halves: half of their difference.
std::array<double, 3> noiseOf(const Reference& reference, std::uint32_t bins) {
    image::MetricsOptions options;
    options.bins = bins;
    options.flip = false;
    std::array<double, 3> noise =
        image::compareImages(reference.halves[0], reference.halves[1], nullptr, options).relRmse;
    for (double& value : noise) value /= 2;
    return noise;
}

}  // namespace

image::ExrFile ReferenceStore::half(const truth::ReferenceRequest& request, const scene::Scene& scene,
                                    const std::filesystem::path& file, const Progress& progress) const {
    std::error_code ignored;
    if (std::filesystem::exists(file, ignored)) {
        image::ExrFile found = image::readExr(file);
        if (isOf(request, truth::recordOf(request, scene), found)) return found;
        progress.say(fmt::format("{}: of other settings or another scene, rendered anew", file.string()));
    }
    std::filesystem::create_directories(settings_.folder,
                                        ignored);  // a failure shows where the file is written
    const std::string what = fmt::format("reference {}", file.stem().string());
    truth::Watcher watcher;
    watcher.stop = progress.stop;
    watcher.progress = [&](double done) { progress.show(what, done); };
    watcher.say = progress.say;
    truth::renderReference(request, scene, {file, {}}, settings_.threads, watcher);
    return image::readExr(file);
}

Reference ReferenceStore::get(const SuiteScene& suiteScene, const scene::Scene& scene,
                              const ReferenceSettings& reference, const Progress& progress) const {
    Reference result;
    result.result.mode = reference.mode;
    for (std::size_t i = 0; i < 2; ++i) {
        truth::ReferenceRequest request;
        request.scene = suiteScene.file;
        request.width = settings_.width;
        request.height = settings_.height;
        request.samples = reference.samples;
        request.estimator = {reference.mode, reference.seed + i, reference.fluxPoints};
        request.commit = settings_.commit;
        const std::filesystem::path file =
            settings_.folder /
            fmt::format("{}-{}-{}.exr", suiteScene.name, truth::name(reference.mode), reference.seed + i);
        image::ExrFile picture = half(request, scene, file, progress);
        result.result.files[i] = file;
        result.halves[i] = std::move(picture.image);
        if (i == 0) result.result.record = std::move(picture.metadata);
    }
    result.result.noise = noiseOf(result, suiteScene.bins);
    return result;
}

}  // namespace nephrite::pareto
