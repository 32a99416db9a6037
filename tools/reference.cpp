// `nephrite reference`: pictures of a scene that passes are held against, rendered on the CPU.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fstream>
#include <sstream>
#include <thread>

#include "commit.h"
#include "image/output_file.h"
#include "interrupt.h"
#include "options.h"
#include "progress_bar.h"
#include "runtime/graph_loading.h"
#include "truth/rendering.h"
#include "truth/run_record.h"
#include "verbs.h"

namespace nephrite::tools {
namespace {

struct ReferenceArguments {
    std::filesystem::path scene;
    std::string mode;
    std::string size = "512x512";
    std::string part;
    std::filesystem::path output;
    std::filesystem::path standardErrors;
    std::uint32_t samples = 16;
    std::uint64_t seed = 1;
    std::uint32_t fluxPoints = 1 << 20;
    unsigned threads = 0;
    double time = 0;
};

truth::Mode modeOf(const std::string& name) {
    if (name == "dipole") return truth::Mode::Dipole;
    return name == "single" ? truth::Mode::Single : truth::Mode::Volume;
}

truth::Part partOf(const std::string& text) {
    if (text.empty()) return {};
    const auto part = truth::parsePart(text);
    if (!part)
        throw InputError({"--part"},
                         fmt::format("expected I/N with 1 <= I <= N <= 1000000, found {}", inQuotes(text)));
    return *part;
}

void requireExrName(const std::string& option, const std::filesystem::path& name) {
    if (name.extension() != ".exr")
        throw InputError({option},
                         fmt::format("expected a name ending in .exr, found \"{}\"", name.string()));
}

void requireOutputs(const ReferenceArguments& arguments) {
    requireExrName("-o", arguments.output);
    if (arguments.standardErrors.empty()) return;
    requireExrName("--stderr", arguments.standardErrors);
    if (arguments.standardErrors.lexically_normal() == arguments.output.lexically_normal())
        throw InputError({arguments.output.string()}, "two outputs would be written to this file");
    if (arguments.samples < 2) throw InputError({"--stderr"}, "standard errors need --spp 2 or more");
}

/// What identifies the run, except for what picture of it a file holds.
image::Metadata recordOf(const ReferenceArguments& arguments, const scene::Scene& scene) {
    image::Metadata record{{"mode", arguments.mode},
                           {"scene", arguments.scene.string()},
                           {"sceneDigest", truth::digestOf(scene.files())},
                           {"samples", fmt::format("{}", arguments.samples)},
                           {"seed", fmt::format("{}", arguments.seed)},
                           {"time", fmt::format("{:.17g}", arguments.time)},
                           {"commit", commit}};
    if (arguments.mode == "dipole") record["fluxPoints"] = fmt::format("{}", arguments.fluxPoints);
    if (!arguments.part.empty()) record["part"] = truth::toText(partOf(arguments.part));
    return record;
}

/// The file beside the output from which an interrupted run continues.
class Unfinished {
  public:
    Unfinished(const ReferenceArguments& arguments, image::Metadata record)
        : file_(arguments.output.string() + ".unfinished") {
        record["size"] = arguments.size;
        heading_ = truth::toText(record);
    }

    /// Throws InputError if there is one of another run.
    void load(truth::Rendering& rendering) const {
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
    void save(const truth::Rendering& rendering) const {
        image::writeFile(file_, heading_ + rendering.save());
    }
    void remove() const {
        std::error_code ignored;
        std::filesystem::remove(file_, ignored);
    }
    const std::filesystem::path& file() const { return file_; }

  private:
    std::filesystem::path file_;
    std::string heading_;
};

void warn(const scene::Scene& scene, const truth::World& world, const ReferenceArguments& arguments) {
    for (const Diagnostic& warning : scene.warnings()) fmt::print(stderr, "{}\n", toLine(warning, "warning"));
    if (arguments.mode == "dipole" && world.hasEnvironment())
        fmt::print(stderr, "{}\n",
                   toLine({scene.description().environment.where,
                           "the dipole reference leaves out light from the environment"},
                          "warning"));
}

/// Renders until finished; what is done is saved every minute. Throws RunError when interrupted.
void renderAll(truth::Rendering& rendering, const Unfinished& unfinished, unsigned threads) {
    using Clock = std::chrono::steady_clock;
    constexpr auto betweenSaves = std::chrono::minutes(1);
    ProgressBar bar("reference");
    Clock::time_point nextSave = Clock::now() + betweenSaves;
    truth::Watcher watcher;
    watcher.stop = [&] { return interrupted() || Clock::now() >= nextSave; };
    watcher.progress = [&](double done) { bar.show(done); };
    while (!rendering.isFinished()) {
        rendering.run(threads, watcher);
        if (rendering.isFinished()) break;
        unfinished.save(rendering);
        nextSave = Clock::now() + betweenSaves;
        if (interrupted())
            throw RunError(fmt::format("{}: error: interrupted; the same command continues from here",
                                       unfinished.file().string()));
    }
}

void reference(const ReferenceArguments& arguments) {
    if (!std::isfinite(arguments.time)) throw InputError({"--time"}, "expected a finite number of seconds");
    requireOutputs(arguments);
    const graph::Extent size = pictureSize(arguments.size);
    const truth::Part part = partOf(arguments.part);
    const auto folders = runtime::DataFolders::find();
    const scene::Scene scene = runtime::loadScene(arguments.scene, arguments.time, folders);
    const truth::World world(scene, arguments.time);
    warn(scene, world, arguments);
    const auto estimator =
        truth::makeEstimator(world, {modeOf(arguments.mode), arguments.seed, arguments.fluxPoints}, scene);
    const truth::Camera camera(scene.description().camera, size.width, size.height);
    truth::Rendering rendering(world, camera, *estimator, part, arguments.samples);

    image::Metadata record = recordOf(arguments, scene);
    const Unfinished unfinished(arguments, record);
    image::OutputFile(arguments.output);  // so that hours of work do not end at a folder that is not there
    unfinished.load(rendering);
    catchInterrupts();
    renderAll(rendering, unfinished,
              arguments.threads != 0 ? arguments.threads : std::max(1U, std::thread::hardware_concurrency()));
    record["content"] = "radiance";
    image::writeExr(arguments.output, rendering.picture(), record);
    record["content"] = "standard error";
    if (!arguments.standardErrors.empty())
        image::writeExr(arguments.standardErrors, rendering.standardErrors(), record);
    unfinished.remove();
}

}  // namespace

void addReferenceVerb(CLI::App& app, Action& action) {
    CLI::App* verb =
        app.add_subcommand("reference", "Render a scene's scattered light on the CPU, by definition");
    auto arguments = std::make_shared<ReferenceArguments>();
    verb->add_option("scene", arguments->scene, "Scene file")->required();
    verb->add_option(
            "--mode", arguments->mode,
            "volume: Monte Carlo; dipole: Jensen's, integrated over the surface; single: one scattering")
        ->required()
        ->check(CLI::IsMember({"volume", "dipole", "single"}));
    verb->add_option("--spp", arguments->samples, "Samples of each pixel; dipole: sets of flux points")
        ->check(CLI::Range(1U, 1U << 24))
        ->capture_default_str();
    verb->add_option("--seed", arguments->seed, "Names the random numbers; another seed is independent")
        ->capture_default_str();
    verb->add_option("--size", arguments->size, "Picture size in pixels, WIDTHxHEIGHT")
        ->capture_default_str();
    verb->add_option("--part", arguments->part, "I/N: render the I-th of N parts, for `merge`");
    verb->add_option("--time", arguments->time, "Seconds of the scene's animation")->capture_default_str();
    verb->add_option("-o,--output", arguments->output, "The picture: F.exr")->required();
    verb->add_option("--stderr", arguments->standardErrors, "Its standard errors: F.exr");
    verb->add_option("--threads", arguments->threads, "Threads (default: one a core)")
        ->check(CLI::Range(1U, 1024U));
    verb->add_option("--flux-points", arguments->fluxPoints, "Dipole: rays from each light, a sample")
        ->check(CLI::Range(1U, 1U << 26))
        ->capture_default_str();
    verb->callback([&action, arguments] { action = [arguments] { reference(*arguments); }; });
}

}  // namespace nephrite::tools
