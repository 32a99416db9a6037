// See changing_scenes.h.
#include "changing_scenes.h"

#include <fmt/format.h>

#include "runtime/random_device_graphs.h"
#include "runtime/random_device_passes.h"

namespace nephrite::runtime::test {
namespace {

constexpr std::size_t randomGraphs = 5;  ///< of each small scene

constexpr const char* runningMean = R"json(
{ "name": "mean",
  "nodes": {
    "light":   {"pass": "gbuffer", "view": "light", "forEach": "lights", "size": [32, 32]},
    "gbuffer": {"pass": "gbuffer", "view": "camera"},
    "direct":  {"pass": "direct", "in": {"position": "gbuffer.position", "normal": "gbuffer.normal", "lightPosition": "light.position"}},
    "mean":    {"pass": "mean", "in": {"now": "direct.irradiance", "before": "previous(mean.color, 2)"}} },
  "outputs": {"color": "mean.color"} })json";

constexpr const char* meanManifest = R"json(
{ "kind": "pixel", "shader": "mean.glsl", "inputs": {"now": {}, "before": {}},
  "outputs": {"color": {"format": "rgba32f", "size": {"like": "now"}}},
  "parameters": {"share": {"type": "float", "default": 0.1, "range": [0, 1]}} })json";

constexpr const char* meanShader =
    "void pixel(ivec2 p) { store(color, p, mix(load(before, p), load(now, p), params.share)); }";

ChangingGraph paper() {
    const std::string weights = "weights=[0.3, 0.3, 0.05, 0.05, 0.3]";
    return {{std::filesystem::path(NEPHRITE_SOURCE_DIR) / "graphs/paper.json",
             {"lightSize=32", "steps=4", "taps=5", weights},
             {"gbuffer.position"}},
            {weights, "weights=[0.3, 0.3, 0.05, 0, 0.3]", "weights=[0.3, 0, 0, 0.1, 0]",
             "weights=[1, 0, 0, 0, 0]", "lightSize=32", "lightSize=48", "steps=2", "steps=5", "taps=4",
             "taps=6", "shadowBias=1", "shadowBias=2.5", "aoRadius=1", "aoRadius=3"}};
}

ChangingGraph mean(const ScratchFolder& folder) {
    folder.write("passes/mean.json", meanManifest);
    folder.write("passes/mean.glsl", meanShader);
    return {{folder.write("mean.json", runningMean), {}, {}},
            {"mean.share=0.05", "mean.share=0.2", "mean.share=1"}};
}

/// Adds graphs of random passes to the small scenes that they are made for.
void addRandomGraphs(std::vector<ChangingScene>& small, const ScratchFolder& folder) {
    const graph::PassLibrary library({folder.path() / "passes"}, folder.path() / "passes");
    std::size_t missing = small.size() * randomGraphs;
    for (std::uint64_t seed = 1; missing > 0; ++seed) {
        const RandomDeviceGraph random = randomDeviceGraph(seed, library);
        std::vector<ChangingGraph>& graphs = small[random.scene].graphs;
        if (graphs.size() == randomGraphs) continue;
        const auto file = folder.write(fmt::format("random{}.json", seed), random.json);
        graphs.push_back({{file, {}, random.dumps},
                          {"shift=0.1", "shift=0.9", "flag=0", "flag=1", "n0.seed=0.3", "n1.amount=0",
                           "n1.amount=1", "n2.amount=0", "n2.seed=0.7"}});
        --missing;
    }
}

}  // namespace

std::vector<ChangingScene> changingScenes(const ScratchFolder& folder) {
    writeRandomPasses(folder);
    writeRandomScenes(folder);
    std::vector<ChangingScene> small;
    for (std::size_t i = 0; i < std::size(lightViewsOfScene); ++i)
        small.push_back({folder.path() / fmt::format("scene{}.json", i), {}});
    addRandomGraphs(small, folder);
    std::vector<ChangingScene> scenes = std::move(small);
    for (const char* name : {"sphere", "moving", "several-lights", "opaque"})
        scenes.push_back(
            {std::filesystem::path(NEPHRITE_SOURCE_DIR) / "graphs/scenes" / fmt::format("{}.json", name),
             {paper(), mean(folder), paper()}});
    return scenes;
}

std::filesystem::path writeBrokenGraph(const ScratchFolder& folder) {
    folder.write("passes/broken.json",
                 R"({"kind": "pixel", "shader": "broken.glsl", "outputs": {"color": {}}})");
    folder.write("passes/broken.glsl", "void pixel(ivec2 p) { store(color, p, nothing); }");
    return folder.write(
        "broken.json",
        R"({"name": "broken", "nodes": {"noise": {"pass": "noise"}, "broken": {"pass": "broken"}},
        "outputs": {"one": "noise.color", "other": "broken.color"}})");
}

}  // namespace nephrite::runtime::test
