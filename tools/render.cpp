// `nephrite render`: renders frames of a graph and writes pictures, dumps and timings.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <functional>
#include <optional>
#include <span>

#include "commit.h"
#include "gpu/device.h"
#include "image/exr.h"
#include "image/frame_name.h"
#include "image/output_file.h"
#include "image/png.h"
#include "image/tone_map.h"
#include "interrupt.h"
#include "options.h"
#include "runtime/exposure.h"
#include "runtime/reload/live_reload.h"
#include "runtime/session.h"
#include "text/fault_lines.h"
#include "timings/report.h"
#include "verbs.h"

namespace nephrite::tools {
namespace {

struct RenderArguments {
    GraphArguments graph;
    std::vector<std::string> outputs;
    std::vector<std::string> dumps;
    std::filesystem::path timings;
    std::string device;
    std::string validation = "off";
    double time = 0;
    std::uint32_t frames = 1;
    double framesPerSecond = 30;
    std::optional<std::uint32_t> warmup;
    std::optional<std::uint32_t> omitBarrier;
    std::optional<std::uint32_t> loseDevice;
    bool profile = false;
    bool noSkip = false;
    bool auditSkips = false;
    bool watch = false;
};

/// A port of the session and the file it goes to.
struct Target {
    std::string port;
    image::FrameName file;
};

void requirePictureName(const std::string& option, const std::string& name) {
    const std::string extension = std::filesystem::path(name).extension().string();
    if (extension != ".exr" && extension != ".png")
        throw InputError({option}, fmt::format("expected a name ending in .exr or .png, found \"{}\"", name));
}

/// What so many frames are written to, and the timings.
std::vector<std::filesystem::path> filesOf(const RenderArguments& arguments,
                                           const std::vector<Target>& targets, std::uint32_t frames) {
    std::vector<std::filesystem::path> files;
    for (const Target& target : targets)
        for (std::uint32_t frame = 0; frame < (target.file.isNumbered() ? frames : 1); ++frame)
            files.push_back(target.file.of(frame));
    if (!arguments.timings.empty()) files.push_back(arguments.timings);
    return files;
}

void requireDistinct(std::vector<std::filesystem::path> files) {
    for (std::filesystem::path& file : files) file = file.lexically_normal();
    std::sort(files.begin(), files.end());
    const auto twice = std::adjacent_find(files.begin(), files.end());
    if (twice != files.end())
        throw InputError({twice->string()}, "two outputs would be written to this file");
}

void requireOthers(const std::vector<std::filesystem::path>& files, const runtime::Session& session) {
    const std::vector<std::filesystem::path> inputs = session.files();
    for (const std::filesystem::path& file : files) requireOther(file, inputs);
}

/// Tries each output before the first frame is rendered, so that a failure leaves nothing behind. Devices and
/// pipes are written in place and cannot be tried.
void tryOutputs(const std::vector<std::filesystem::path>& files) {
    for (const std::filesystem::path& file : files) {
        std::error_code ignored;
        const auto status = std::filesystem::status(file, ignored);
        if (!std::filesystem::is_other(status)) image::OutputFile trial(file);
    }
}

std::vector<Target> targetsOf(const RenderArguments& arguments) {
    std::vector<Target> targets;
    for (const std::string& output : arguments.outputs) {
        requirePictureName("-o", output);
        targets.push_back({"color", image::FrameName(output)});
    }
    for (const std::string& dump : arguments.dumps) {
        const auto [port, file] = splitAssignment("--dump", dump);
        requirePictureName("--dump", file);
        targets.push_back({port, image::FrameName(file)});
    }
    requireDistinct(filesOf(arguments, targets, 1));
    arguments.graph.requireOther(arguments.timings);
    return targets;
}

runtime::SessionOptions sessionOptions(const RenderArguments& arguments) {
    runtime::SessionOptions options;
    options.graph = arguments.graph.graph;
    options.scene = arguments.graph.scene;
    options.size = arguments.graph.extent();
    options.settings = arguments.graph.settings;
    options.passPaths = arguments.graph.passPaths;
    for (const std::string& dump : arguments.dumps)
        options.dumps.push_back(splitAssignment("--dump", dump).first);
    options.time = arguments.time;
    options.device = arguments.device;
    options.validation = validationNamed(arguments.validation);
    options.skip = !arguments.noSkip;
    options.profile = arguments.profile;
    options.omitBarrier = arguments.omitBarrier;
    options.loseDeviceAtSubmit = arguments.loseDevice;
    options.auditSkips = arguments.auditSkips;
    // A profile is of the passes, so all of them run in every frame.
    options.reuse = (arguments.frames > 1 || arguments.auditSkips || arguments.watch) && !arguments.profile;
    return options;
}

/// The value of the first running pass's parameter `weights`: what the picture was really composed with.
const graph::ParameterValue* usedWeights(const runtime::Session& session) {
    const graph::Plan& plan = session.plan();
    for (const graph::PlannedPass& pass : plan.passes) {
        const auto& declarations = plan.typeOf(pass).parameters;
        for (graph::Index i = 0; i < declarations.size(); ++i)
            if (declarations[i].name == "weights")
                return &plan.graph->valueOf(pass.node, i, session.parameters());
    }
    return nullptr;
}

/// What a reader of the EXR has to know to make it again.
image::Metadata metadata(const RenderArguments& arguments, const runtime::Session& session) {
    image::Metadata data{
        {"graph", arguments.graph.graph.string()},
        {"scene", arguments.graph.scene.empty() ? "default" : arguments.graph.scene.string()},
        {"commit", commit},
        {"time", fmt::format("{:.17g}", arguments.time)},
        {"device", session.deviceName()}};
    for (const std::string& setting : arguments.graph.settings)
        data["settings"] += (data["settings"].empty() ? "" : " ") + setting;
    if (const auto* weights = usedWeights(session)) {
        std::string list;
        for (const double weight : weights->components)
            list += fmt::format("{}{:.17g}", list.empty() ? "" : " ", weight);
        data["weights"] = list;
    }
    return data;
}

void writeTarget(const Target& target, std::uint32_t frame, const RenderArguments& arguments,
                 runtime::Session& session) {
    const image::Image image = session.read(target.port);
    const std::filesystem::path file = target.file.of(frame);
    if (file.extension() == ".png")
        image::writePng(file, image::toneMap(image, runtime::toneMapping(session.plan())));
    else
        image::writeExr(file, image, metadata(arguments, session));
}

timings::Report emptyReport(const RenderArguments& arguments, const runtime::Session& session) {
    timings::Report report;
    report.device = session.deviceName();
    report.driver = session.driverName();
    report.commit = commit;
    report.graph = arguments.graph.graph.string();
    report.scene = arguments.graph.scene.empty() ? "default" : arguments.graph.scene.string();
    report.width = session.plan().view.width;
    report.height = session.plan().view.height;
    report.profiled = arguments.profile;
    timings::usePlan(report, session.plan());
    return report;
}

void requireOutput(const runtime::Session& session, const RenderArguments& arguments) {
    if (arguments.outputs.empty()) return;
    const auto& requested = session.plan().requested;
    if (std::none_of(requested.begin(), requested.end(),
                     [](const auto& output) { return output.name == "color"; }))
        throw InputError({arguments.graph.graph.string()},
                         "-o writes the output \"color\", which this graph does not have");
}

void requireFinite(const RenderArguments& arguments) {
    if (!std::isfinite(arguments.time)) throw InputError({"--time"}, "expected a finite number of seconds");
    if (arguments.framesPerSecond <= 0 || !std::isfinite(arguments.framesPerSecond))
        throw InputError({"--fps"}, "expected a number above 0");
}

void printWarnings(const runtime::Session& session) {
    for (const Diagnostic& warning : session.diagnostics().warnings())
        fmt::print(stderr, "{}\n", toLine(warning, "warning"));
}

using Write = std::function<void(const Target& target, std::uint32_t frame)>;

/// Renders the frames that were asked for, less the warm-up and those that an interruption leaves out, and
/// has written what was asked for. Adds the times of the frames to the report.
void renderFrames(const RenderArguments& arguments, const std::vector<Target>& targets, std::uint32_t warmup,
                  runtime::Session& session, timings::Report& report, const Write& write) {
    for (std::uint32_t i = 0; i < warmup && !interrupted(); ++i) session.renderFrame(arguments.time);
    for (std::uint32_t frame = 0; frame < arguments.frames && !interrupted(); ++frame) {
        timings::addFrame(report, session.renderFrame(arguments.time + frame / arguments.framesPerSecond));
        for (const Target& target : targets)
            if (target.file.isNumbered() || frame + 1 == arguments.frames) write(target, frame);
    }
}

/// What a user of --watch sees of it, beside the picture.
void printFrames(std::span<const timings::Frame> frames) {
    if (frames.empty()) return;
    double sum = 0;
    for (const timings::Frame& frame : frames) sum += frame.times.wallMs;
    fmt::print(stderr, "rendered {} frame{} in {:.0f} ms, the first in {:.0f} ms\n", frames.size(),
               frames.size() == 1 ? "" : "s", sum, frames.front().times.wallMs);
}

/// What could not be rendered or written now may be after the next save; not so when the device is at fault.
void attempt(const runtime::Session& session, const std::function<void()>& work) {
    try {
        work();
    } catch (const std::exception& error) {
        if (session.device().lost() || session.device().validationMessages() != 0) throw;
        for (const std::string& line : linesOf(error)) fmt::print(stderr, "{}\n", line);
    }
}

/// Renders and writes everything again, each output for itself, and the timings with these frames behind
/// those before.
void renderAnew(const RenderArguments& arguments, const std::vector<Target>& targets,
                runtime::Session& session, timings::Report& report) {
    requireOutput(session, arguments);
    requireOthers(filesOf(arguments, targets, arguments.frames), session);
    timings::usePlan(report, session.plan());
    const std::size_t before = report.frames.size();
    renderFrames(arguments, targets, 0, session, report, [&](const Target& target, std::uint32_t frame) {
        attempt(session, [&] { writeTarget(target, frame, arguments, session); });
    });
    printFrames(std::span(report.frames).subspan(before));
    if (!arguments.timings.empty()) attempt(session, [&] { timings::write(arguments.timings, report); });
}

/// Renders anew whenever a file is saved, until it is interrupted.
void keepRendering(const RenderArguments& arguments, const std::vector<Target>& targets,
                   runtime::Session& session, timings::Report& report) {
    constexpr std::chrono::milliseconds untilNextLook{100};  // at whether it was interrupted
    runtime::LiveReload reload(session, {}, filesOf(arguments, targets, arguments.frames));
    while (!interrupted()) {
        if (!reload.wait(untilNextLook)) continue;
        const std::optional<runtime::Reload> saved = reload.poll();
        if (!saved) continue;
        const std::vector<std::string> lines = toLines(*saved);
        for (const std::string& line : lines) fmt::print(stderr, "{}\n", line);
        report.marks.push_back({std::chrono::steady_clock::now(), saved->shown ? "reload" : "reload refused",
                                fmt::format("{}", fmt::join(lines, "; "))});
        if (!saved->shown) continue;
        printWarnings(session);
        attempt(session, [&] { renderAnew(arguments, targets, session, report); });
    }
}

void render(const RenderArguments& arguments) {
    requireFinite(arguments);
    const std::vector<Target> targets = targetsOf(arguments);
    if (!arguments.timings.empty()) timings::requireName(arguments.timings);
    runtime::Session session(sessionOptions(arguments));
    printWarnings(session);
    requireOutput(session, arguments);
    requireOthers(filesOf(arguments, targets, arguments.frames), session);
    tryOutputs(filesOf(arguments, targets, 1));

    timings::Report report = emptyReport(arguments, session);
    report.warmup = arguments.warmup.value_or(arguments.timings.empty() ? 0 : 3);
    catchInterrupts();
    renderFrames(
        arguments, targets, report.warmup, session, report,
        [&](const Target& target, std::uint32_t frame) { writeTarget(target, frame, arguments, session); });
    const bool complete = report.frames.size() == arguments.frames;
    if (!complete && !arguments.watch)
        throw RunError(
            fmt::format("interrupted after {} of {} frames", report.frames.size(), arguments.frames));
    if (!arguments.timings.empty() && complete) timings::write(arguments.timings, report);
    if (arguments.watch) keepRendering(arguments, targets, session, report);
}

}  // namespace

void addRenderVerb(CLI::App& app, Action& action) {
    CLI::App* verb = app.add_subcommand("render", "Render frames of a graph to files");
    auto arguments = std::make_shared<RenderArguments>();
    arguments->graph.addTo(*verb);
    verb->add_option("-o,--output", arguments->outputs,
                     "Where output \"color\" goes: F.exr or F.png; %04d numbers the frames")
        ->expected(1)
        ->take_all();
    verb->add_option("--dump", arguments->dumps, "Write any port: NODE.PORT=F.exr")->expected(1)->take_all();
    verb->add_option("--time", arguments->time, "Seconds of the scene's animation at the first frame")
        ->capture_default_str();
    verb->add_option("--frames", arguments->frames, "How many frames")
        ->check(CLI::Range(1U, 1000000U))
        ->capture_default_str();
    verb->add_option("--fps", arguments->framesPerSecond, "Frames a second of the animation")
        ->capture_default_str();
    verb->add_option("--timings", arguments->timings, "Write times: F.json, F.csv or F.trace.json");
    verb->add_option("--warmup", arguments->warmup,
                     "Frames rendered before the first that counts (default: 3 with --timings, else 0)");
    verb->add_flag("--profile", arguments->profile, "Time each pass alone: a full barrier around it");
    verb->add_option("--validation", arguments->validation, "off, core or sync")
        ->check(CLI::IsMember({"off", "core", "sync"}))
        ->capture_default_str();
    verb->add_flag("--no-skip", arguments->noSkip,
                   "Run every needed pass, also those the scene does not need");
    verb->add_flag("--audit-skips", arguments->auditSkips,
                   "Render each frame with and without skipping and fail if a picture differs");
    verb->add_flag("--watch", arguments->watch,
                   "Go on: render and write again whenever a shader, manifest, graph, scene, mesh or texture "
                   "is saved, until interrupted");
    // For the program's own tests: not in the help.
    verb->add_option("--lose-device", arguments->loseDevice, "Lose the device after N submissions")
        ->group("");
    verb->add_option("--omit-barrier", arguments->omitBarrier,
                     "Leave out barrier N of the plan, to see that --validation sync notices");
    verb->add_option("--device", arguments->device, "Part of the name of the device to use");
    verb->callback([&action, arguments] { action = [arguments] { render(*arguments); }; });
}

}  // namespace nephrite::tools
