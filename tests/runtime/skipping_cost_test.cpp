// What skipping saves, measured: a scene should not pay for what it does not need.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <vector>

#include "runtime/session.h"
#include "scratch_folder.h"

namespace nephrite::runtime {
namespace {

const std::string sources = NEPHRITE_SOURCE_DIR;

/// The sphere of radius 10 seen from `distance`, lit from the right above.
std::string sphereScene(double distance, const std::string& material) {
    return fmt::format(R"({{
      "camera": {{"position": [0, 0, {}], "target": [0, 0, 0], "up": [0, 1, 0], "fovY": 36, "near": 0.5, "far": 1000}},
      "lights": [{{"type": "point", "position": [60, 60, 60], "intensity": [5000, 5000, 5000]}}],
      "environment": {{"radiance": [1, 1, 1]}},
      "objects": [{{"mesh": {{"procedural": "sphere", "radius": 10}}, "material": {}}}] }})",
                       distance, material);
}

SessionOptions optionsFor(const std::filesystem::path& graph, const std::filesystem::path& scene) {
    SessionOptions options;
    options.graph = graph;
    options.scene = scene;
    options.size = {512, 512};
    return options;
}

/// The least GPU milliseconds so far of each pass that runs once a pixel of the camera's image, lists of
/// tiles included. A pass lasts a few milliseconds, so a busy moment spoils one measurement of some passes,
/// seldom every one of any.
class PixelPasses {
  public:
    void measure(Session& session) {
        const FrameTimes times = session.renderFrame(0);
        const graph::Plan& plan = session.plan();
        least_.resize(plan.passes.size(), std::numeric_limits<double>::max());
        for (std::size_t i = 0; i < plan.passes.size(); ++i) {
            const graph::PlannedPass& pass = plan.passes[i];
            const bool isOfLight = pass.forEach == graph::ForEach::Lights ||
                                   plan.nameOf(pass).find("light") != std::string::npos;
            const bool counts = plan.typeOf(pass).kind != graph::PassKind::Raster && !isOfLight;
            least_[i] = counts ? std::min(least_[i], times.passes[i].gpuMs) : 0;
        }
    }

    double sum() const { return std::accumulate(least_.begin(), least_.end(), 0.0); }

  private:
    std::vector<double> least_;
};

/// The least of `frames` measurements each, taken in turn so that a busy moment meets both.
template<class MeasureA, class MeasureB>
std::pair<double, double> leastInTurn(int frames, MeasureA measureA, MeasureB measureB) {
    std::pair least{std::numeric_limits<double>::max(), std::numeric_limits<double>::max()};
    for (int i = 0; i < frames; ++i) {
        least.first = std::min(least.first, measureA());
        least.second = std::min(least.second, measureB());
    }
    return least;
}

TEST(SkippingCost, ATenthOfTheScreenPaysAtMostAFifth) {
    const ScratchFolder folder;
    // The silhouette's radius is 0.357 of half the image's height: pi / 4 * 0.357^2 is a tenth of the image.
    const auto far = folder.write("far.json", sphereScene(86.8, "\"apple\""));
    const auto near = folder.write("near.json", sphereScene(15, "\"apple\""));
    SessionOptions options = optionsFor(sources + "/graphs/paper.json", far);
    options.profile = true;
    Session tenth(options);
    options.scene = near;
    Session full(options);
    for (Session* session : {&tenth, &full}) session->renderFrame(0);
    PixelPasses small, large;
    double ratio = std::numeric_limits<double>::max();
    for (int series = 0; series < 4 && ratio > 0.2; ++series) {
        for (int frame = 0; frame < 12; ++frame) {
            small.measure(tenth);
            large.measure(full);
        }
        ratio = small.sum() / large.sum();
    }
    RecordProperty("tenthMs", fmt::format("{:.3f}", small.sum()));
    RecordProperty("fullMs", fmt::format("{:.3f}", large.sum()));
    EXPECT_LE(ratio, 0.2) << small.sum() << " ms of " << large.sum() << " ms";
}

/// The paper's graph with only what an opaque scene shows: no node of scattering is in it.
constexpr const char* opaqueGraph = R"({
  "parameters": {"weights": {"value": [0.3, 0.3, 0.05, 0.05, 0.3]}, "lightSize": {"value": 512}},
  "nodes": {
    "light": {"pass": "gbuffer", "view": "light", "forEach": "lights", "size": ["$lightSize", "$lightSize"]},
    "gbuffer": {"pass": "gbuffer", "view": "camera"},
    "direct": {"pass": "direct", "in": {"position": "gbuffer.position", "normal": "gbuffer.normal", "lightPosition": "light.position"}},
    "ssao": {"pass": "ssao", "in": {"position": "gbuffer.position", "normal": "gbuffer.normal", "surface": "gbuffer.surface", "irradiance": "direct.irradiance"}},
    "specular": {"pass": "specular", "in": {"position": "gbuffer.position", "normal": "gbuffer.normal", "surface": "gbuffer.surface", "lightPosition": "light.position"}},
    "composite": {"pass": "composite", "in": {"position": "gbuffer.position", "diffuse": "ssao.radiance", "specular": "specular.radiance"}, "set": {"weights": "$weights"}} },
  "outputs": {"color": "composite.color"} })";

TEST(SkippingCost, AnOpaqueSceneDoesNotPayForScattering) {
    const ScratchFolder folder;
    const auto scene =
        folder.write("opaque.json", sphereScene(40, R"({"diffuse": [0.7, 0.5, 0.3], "roughness": 0.4})"));
    Session paper(optionsFor(sources + "/graphs/paper.json", scene));
    Session bare(optionsFor(folder.write("bare.json", opaqueGraph), scene));
    const auto frame = [](Session& session) { return session.renderFrame(0).wallMs; };
    for (Session* session : {&paper, &bare}) frame(*session);
    double ratio = std::numeric_limits<double>::max();
    for (int series = 0; series < 3 && ratio > 1.05; ++series) {
        const auto [whole, least] = leastInTurn(
            25, [&] { return frame(paper); }, [&] { return frame(bare); });
        ratio = std::min(ratio, whole / least);
    }
    RecordProperty("ratio", fmt::format("{:.4f}", ratio));
    EXPECT_LE(ratio, 1.05);
}

}  // namespace
}  // namespace nephrite::runtime
