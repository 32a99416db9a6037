// See random_device_check.h.
#include "runtime/random_device_check.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstring>
#include <random>
#include <stdexcept>

#include "runtime/random_device_passes.h"

namespace nephrite::runtime::test {
namespace {

constexpr std::array<double, 3> times{0, 0.5, 1};

void renderFrames(Session& session, const RandomDeviceGraph& graph, bool flying) {
    for (std::size_t frame = 0; frame < times.size(); ++frame) {
        if (!graph.settings[frame].empty()) session.set(graph.settings[frame]);
        if (flying)
            session.startFrame(times[frame]);
        else
            session.renderFrame(times[frame]);
    }
    session.waitForFrames();
}

/// Where two images differ first, or "".
std::string difference(const image::Image& one, const image::Image& other) {
    if (one.width != other.width || one.height != other.height || one.channels != other.channels)
        return "another size";
    for (std::size_t i = 0; i < one.pixels.size(); ++i) {
        if (std::memcmp(&one.pixels[i], &other.pixels[i], sizeof(float)) == 0) continue;
        const std::size_t texel = i / one.channels.size();
        return fmt::format("{} of texel ({}, {}) is {}, expected {}", one.channels[i % one.channels.size()],
                           texel % one.width, texel / one.width, one.pixels[i], other.pixels[i]);
    }
    return "";
}

std::string describe(std::uint64_t seed, const SessionOptions& options, const RandomDeviceGraph& graph) {
    return fmt::format(
        "\nseed {}, {}, {}, reuse {}, size {} x {}, dumps [{}], scene{}, settings [{}]\n{}", seed,
        options.policy == graph::Policy::Memory ? "memory" : "barriers",
        options.inputReads == graph::InputReads::SampledImage ? "sampled images" : "storage images",
        options.reuse, options.size.width, options.size.height, fmt::join(options.dumps, ", "), graph.scene,
        fmt::join(graph.settings, ", "), graph.json);
}

}  // namespace

RandomDeviceCheck::RandomDeviceCheck() {
    writeRandomPasses(folder_);
    writeRandomScenes(folder_);
    library_ = std::make_unique<graph::PassLibrary>(std::vector{folder_.path() / "passes"},
                                                    folder_.path() / "passes");
}

SessionOptions RandomDeviceCheck::optionsFor(std::uint64_t seed, const RandomDeviceGraph& graph) const {
    SessionOptions options;
    options.graph = folder_.write("graph.json", graph.json);
    options.scene = folder_.path() / fmt::format("scene{}.json", graph.scene);
    options.passPaths = {folder_.path() / "passes"};
    options.dumps = graph.dumps;
    options.size = {8 + static_cast<std::uint32_t>(seed * 7 % 41),
                    8 + static_cast<std::uint32_t>(seed * 5 % 41)};
    options.validation = Validation::Sync;
    options.inputReads = seed % 2 == 0 ? graph::InputReads::StorageImage : graph::InputReads::SampledImage;
    options.policy = seed / 2 % 2 == 0 ? graph::Policy::Barriers : graph::Policy::Memory;
    options.reuse = seed / 4 % 3 == 0;
    return options;
}

testing::AssertionResult RandomDeviceCheck::check(std::uint64_t seed) {
    const RandomDeviceGraph graph = graphOf(seed);
    const SessionOptions options = optionsFor(seed, graph);
    try {
        compare(options, graph, seed / 4 % 2 == 0);
    } catch (const std::exception& error) {
        return testing::AssertionFailure() << error.what() << describe(seed, options, graph);
    }
    ++figures_.graphs;
    return testing::AssertionSuccess();
}

void RandomDeviceCheck::compare(const SessionOptions& options, const RandomDeviceGraph& graph, bool flying) {
    Session planned(options);
    count(planned.plan());
    renderFrames(planned, graph, flying);
    SessionOptions plainOptions = options;
    plainOptions.plain = true;
    plainOptions.profile = true;
    plainOptions.reuse = false;
    plainOptions.validation = Validation::Off;
    Session plain(plainOptions);
    renderFrames(plain, graph, false);
    for (const graph::RequestedOutput& output : planned.plan().requested) {
        const std::string found = difference(planned.read(output.name), plain.read(output.name));
        if (!found.empty()) throw std::runtime_error(fmt::format("{}: {}", output.name, found));
        ++figures_.images;
    }
}

void RandomDeviceCheck::count(const graph::Plan& plan) {
    figures_.passes += plan.passes.size();
    figures_.barriers += plan.schedule.barriers.size();
    bool shares = false;
    for (const graph::Resource& resource : plan.resources) {
        shares |= resource.memoryUsedUntil != graph::noIndex;
        if (resource.kind == graph::ResourceKind::History) ++figures_.histories;
    }
    if (shares) ++figures_.sharingGraphs;
    for (const graph::PlannedPass& pass : plan.passes) {
        if (pass.tileList != graph::noIndex) ++figures_.tiled;
        if (pass.iterations > 0) figures_.passTypes.insert(plan.typeOf(pass).name);
    }
}

void checkRandomDeviceGraphs(std::uint64_t first, std::uint32_t count) {
    RandomDeviceCheck check;
    const std::uint64_t fresh = std::random_device{}();
    fmt::print("fresh seed {}\n", fresh);
    for (std::uint32_t i = 0; i < count; ++i) EXPECT_TRUE(check.check(i + 1 < count ? first + i : fresh));
    const RandomDeviceFigures& figures = check.figures();
    fmt::print(
        "{} graphs, {} passes of {} types, {} over tiles, {} histories, {} barriers, {} graphs share memory, "
        "{} images compared\n",
        figures.graphs, figures.passes, figures.passTypes.size(), figures.tiled, figures.histories,
        figures.barriers, figures.sharingGraphs, figures.images);
    // The test could tell nothing of graphs that are all alike.
    const std::size_t types = randomPassNames().size();
    EXPECT_GE(figures.passTypes.size(), count < 300 ? types * 3 / 4 : types * 9 / 10);
    EXPECT_GT(figures.passes, 4 * count);
    EXPECT_GT(figures.histories, count / 10);
    EXPECT_GT(figures.tiled, count / 20);
    EXPECT_GT(figures.sharingGraphs, count / 3);
}

}  // namespace nephrite::runtime::test
