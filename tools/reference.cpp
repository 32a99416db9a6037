// `nephrite reference`: pictures of a scene that passes are held against, rendered on the CPU.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <thread>

#include "commit.h"
#include "interrupt.h"
#include "options.h"
#include "progress_bar.h"
#include "runtime/loading/graph_loading.h"
#include "truth/reference_run.h"
#include "truth/run_record.h"
#include "verbs.h"

namespace nephrite::tools {
namespace {

struct ReferenceArguments {
    std::filesystem::path scene;
    std::string mode;
    std::string size = "512x512";
    std::optional<std::string> part;
    std::filesystem::path output;
    std::filesystem::path standardErrors;
    std::uint32_t samples = 16;
    std::uint64_t seed = 1;
    std::uint32_t fluxPoints = 1 << 20;
    std::uint32_t photons = 1 << 18;
    unsigned threads = 0;
    double time = 0;
};

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

truth::ReferenceRequest requestOf(const ReferenceArguments& arguments) {
    if (!std::isfinite(arguments.time)) throw InputError({"--time"}, "expected a finite number of seconds");
    const graph::Extent size = pictureSize(arguments.size);
    truth::ReferenceRequest request;
    request.scene = arguments.scene;
    request.width = size.width;
    request.height = size.height;
    request.time = arguments.time;
    request.samples = arguments.samples;
    request.estimator = {*truth::parseMode(arguments.mode), arguments.seed, arguments.fluxPoints,
                         arguments.photons};
    if (arguments.part) request.part = partOf(*arguments.part);
    request.commit = commit;
    return request;
}

void warn(const scene::Scene& scene, truth::Mode mode) {
    for (const Diagnostic& warning : scene.warnings()) fmt::print(stderr, "{}\n", toLine(warning, "warning"));
    if (mode == truth::Mode::Dipole && scene.facts().environment != 0)
        fmt::print(stderr, "{}\n",
                   toLine({scene.description().environment.where,
                           "the dipole reference leaves out light from the environment"},
                          "warning"));
}

void reference(const ReferenceArguments& arguments) {
    requireOutputs(arguments);
    const truth::ReferenceRequest request = requestOf(arguments);
    catchInterrupts();
    const scene::Scene scene =
        runtime::loadScene(arguments.scene, arguments.time, runtime::DataFolders::find());
    for (const std::filesystem::path& output : {arguments.output, arguments.standardErrors})
        requireOther(output, scene.files());
    warn(scene, request.estimator.mode);
    ProgressBar bar("reference");
    truth::Watcher watcher;
    watcher.stop = interrupted;
    watcher.progress = [&](double done) { bar.show(done); };
    watcher.say = [](const std::string& line) { fmt::print(stderr, "{}\n", line); };
    const unsigned threads =
        arguments.threads != 0 ? arguments.threads : std::max(1U, std::thread::hardware_concurrency());
    truth::renderReference(request, scene, {arguments.output, arguments.standardErrors}, threads, watcher);
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
        ->check(wholeNumber(0, std::numeric_limits<std::uint64_t>::max()))
        ->capture_default_str();
    verb->add_option("--size", arguments->size, "Picture size in pixels, WIDTHxHEIGHT")
        ->capture_default_str();
    verb->add_option_function<std::string>(
        "--part", [arguments](const std::string& part) { arguments->part = part; },
        "I/N: render the I-th of N parts, for `merge`");
    verb->add_option("--time", arguments->time, "Seconds of the scene's animation")->capture_default_str();
    verb->add_option("-o,--output", arguments->output, "The picture: F.exr")->required();
    verb->add_option("--stderr", arguments->standardErrors, "Its standard errors: F.exr");
    verb->add_option("--threads", arguments->threads, "Threads (default: one a core)")
        ->check(CLI::Range(1U, 1024U));
    verb->add_option("--flux-points", arguments->fluxPoints, "Dipole: rays from each light, a sample")
        ->check(CLI::Range(1U, 1U << 26))
        ->capture_default_str();
    verb->add_option("--photons", arguments->photons,
                     "Volume, single: rays from each light, a sample, where boundaries refract; at most")
        ->check(CLI::Range(1U, 1U << 24))
        ->capture_default_str();
    verb->callback([&action, arguments] { action = [arguments] { reference(*arguments); }; });
}

}  // namespace nephrite::tools
