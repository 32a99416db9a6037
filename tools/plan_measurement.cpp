// See plan_measurement.h. Two sessions of one graph: one keeps results, as a viewer does, so its plan is the
// one that is shown; the other times each pass alone and hands out every image, which takes a plan of its
// own.
#include "plan_measurement.h"

#include <fmt/format.h>

#include <algorithm>

#include "graph/plan_page.h"
#include "image/thumbnail.h"
#include "runtime/frame/time_statistics.h"
#include "runtime/loading/graph_loading.h"

namespace nephrite::tools {
namespace {

constexpr std::uint32_t warmupFrames = 3;
constexpr std::uint32_t measuredFrames = 5;
constexpr std::uint32_t pictureSide = 96;

/// An output port whose image can be read after the frame: not a buffer, and nothing overwrites it.
struct Port {
    graph::Index index;  ///< as LinkedNode::formats
    std::string name;
};

bool isReadable(const graph::LinkedGraph& graph, const std::string& name) {
    try {
        graph.find(runtime::dumpReference(name));
        return true;
    } catch (const InputError&) {
        return false;
    }
}

std::vector<Port> readablePorts(const graph::Plan& plan) {
    std::vector<Port> ports;
    const auto add = [&](graph::Index node, graph::Index port) {
        const std::string name = plan.graph->portName(node, port);
        if (isReadable(*plan.graph, name))
            ports.push_back({plan.graph->nodes[node].formats.first + port, name});
    };
    for (const graph::PlannedPass& pass : plan.passes) {
        const auto outputs = graph::slice(plan.outputs, pass.outputs);
        for (graph::Index port = 0; port < outputs.size(); ++port)
            if (!plan.resources[outputs[port]].isBuffer) add(pass.node, port);
    }
    for (const graph::Resource& resource : plan.resources)
        if (resource.kind == graph::ResourceKind::Imported) add(resource.node, resource.port);
    return ports;
}

/// By pass: whether it is left out of a frame in which nothing has changed.
std::vector<bool> restingPasses(runtime::Session& session, double time) {
    std::vector<bool> rests;
    for (std::uint32_t i = 0; i < warmupFrames; ++i) {
        rests.clear();
        for (const runtime::PassTime& pass : session.renderFrame(time).passes) rests.push_back(!pass.ran);
    }
    return rests;
}

/// Medians of one pass over frames.
graph::PassFigures figuresOf(const std::vector<runtime::FrameTimes>& frames, std::size_t pass) {
    std::vector<double> gpu, cpu;
    for (const runtime::FrameTimes& frame : frames) {
        gpu.push_back(frame.passes[pass].gpuMs);
        cpu.push_back(frame.passes[pass].cpuMs);
    }
    return {runtime::timeStatistics(gpu).median, runtime::timeStatistics(cpu).median, false};
}

std::vector<runtime::FrameTimes> timedFrames(runtime::Session& session, double time) {
    for (std::uint32_t i = 0; i < warmupFrames; ++i) session.renderFrame(time);
    std::vector<runtime::FrameTimes> frames;
    for (std::uint32_t i = 0; i < measuredFrames; ++i) frames.push_back(session.renderFrame(time));
    return frames;
}

/// The figures of `shown`'s passes, which `session`, of the same graph, runs too.
void measureTimes(const graph::Plan& shown, runtime::Session& session, double time,
                  graph::PlanMeasurements& measured) {
    const std::vector<runtime::FrameTimes> frames = timedFrames(session, time);
    std::vector<double> walls;
    for (const runtime::FrameTimes& frame : frames) walls.push_back(frame.wallMs);
    measured.frames = measuredFrames;
    measured.frameMs = runtime::timeStatistics(walls).median;
    const std::vector<graph::PlannedPass>& timed = session.plan().passes;
    for (const graph::PlannedPass& pass : shown.passes) {
        const auto found = std::find_if(timed.begin(), timed.end(),
                                        [&](const auto& other) { return other.node == pass.node; });
        measured.passes.push_back(found == timed.end()
                                      ? graph::PassFigures{}
                                      : figuresOf(frames, static_cast<std::size_t>(found - timed.begin())));
    }
}

void readPictures(const std::vector<Port>& ports, runtime::Session& session,
                  graph::PlanMeasurements& measured) {
    measured.pictures.resize(session.plan().graph->formats.size());
    for (const Port& port : ports) {
        const image::Thumbnail small = image::thumbnailOf(session.read(port.name), pictureSide);
        measured.pictures[port.index] = {image::encodePng(small.picture), small.scale};
    }
}

}  // namespace

std::string measuredPage(const runtime::SessionOptions& options) {
    runtime::SessionOptions keeping = options;
    keeping.reuse = true;
    runtime::Session shown(keeping);
    const std::vector<bool> rests = restingPasses(shown, options.time);
    const std::vector<Port> ports = readablePorts(shown.plan());

    runtime::SessionOptions profiling = options;
    profiling.profile = true;
    for (const Port& port : ports) profiling.dumps.push_back(port.name);
    runtime::Session timed(profiling);
    graph::PlanMeasurements measured;
    measured.device = fmt::format("{}, {}", timed.deviceName(), timed.driverName());
    measureTimes(shown.plan(), timed, options.time, measured);
    for (std::size_t i = 0; i < rests.size(); ++i) measured.passes[i].rests = rests[i];
    readPictures(ports, timed, measured);
    return graph::planAsHtml(shown.plan(), measured);
}

}  // namespace nephrite::tools
