// See random_device_passes.h.
#include "runtime/random_device_passes.h"

#include <fmt/format.h>

#include <span>

#include "image/exr.h"

namespace nephrite::runtime::test {
namespace {

struct PassText {
    const char* name;
    const char* kind;
    const char* manifest;  ///< its members but kind, shader and parameters
    const char* shader;
};

// Linear combinations and their fraction: a single wrong bit that is read changes what is written.
constexpr const char* scramble = R"(
vec4 scramble(vec4 a, vec4 b, ivec2 p) {
    return fract(1.37 * a + 2.11 * b.wxyz + 0.173 * vec4(p, p.yx) + params.seed);
}
)";

constexpr PassText pixelPasses[] = {
    {"noise", "pixel", R"("outputs": {"color": {"neutral": [0.1, 0.2, 0.3, 0.4]}})",
     "void pixel(ivec2 p) { store(color, p, scramble(0.31 * vec4(p, p.yx), vec4(0.0), p)); }"},
    {"ticking", "pixel", R"("outputs": {"color": {}})",
     "void pixel(ivec2 p) { store(color, p, scramble(0.31 * vec4(p, p.yx), vec4(time), p)); }"},
    {"blend", "pixel", R"("inputs": {"a": {}}, "outputs": {"color": {}})",
     "void pixel(ivec2 p) { store(color, p, scramble(load(a, p), load(a, p.yx + ivec2(1, 2)), p)); }"},
    {"pair", "pixel",
     R"("inputs": {"a": {}, "b": {"optional": true, "neutral": [0.7, 0.1, 0.2, 0.9]}},
        "outputs": {"color": {"neutral": [0.3, 0.6, 0.2, 0.1]}, "other": {}})",
     R"(void pixel(ivec2 p) {
            store(color, p, scramble(load(a, p), load(b, p + 1), p));
            store(other, p, scramble(load(b, p), load(a, extent(a) - 1 - p), p));
        })"},
    {"triple", "pixel",
     R"("inputs": {"a": {}, "b": {"optional": true, "neutral": [1, 0, 1, 0]},
                   "c": {"optional": true, "neutral": [0.4, 0.4, 0.1, 0.1], "neededWhen": "params.amount > 0"}},
        "outputs": {"color": {"neutral": [0.5, 0.5, 0.5, 0.5]}})",
     "void pixel(ivec2 p) { store(color, p, scramble(scramble(load(a, p), load(b, p), p), load(c, p - 2), "
     "p)); }"},
    {"perhaps", "pixel",
     R"("skipWhen": "inputs.a.neutral || params.amount == 0", "inputs": {"a": {"optional": true}, "b": {}},
        "outputs": {"color": {"neutral": [0.25, 0.5, 0.75, 1]}})",
     "void pixel(ivec2 p) { store(color, p, scramble(load(a, p), load(b, p), p) * params.amount); }"},
    {"enlarge", "pixel", R"("inputs": {"a": {}}, "outputs": {"color": {"size": {"scale": 1.5}}})",
     R"(void pixel(ivec2 p) {
            vec2 uv = (vec2(p) + 0.5) / vec2(extent(color));
            store(color, p, scramble(sample(a, uv), sample(a, uv.yx), p));
        })"},
    {"accumulate", "pixel",
     R"("inputs": {"a": {}, "before": {"optional": true, "neutral": [0.6, 0, 0, 0.6]}},
        "outputs": {"color": {"neutral": [0.9, 0.8, 0.7, 0.6]}})",
     "void pixel(ivec2 p) { store(color, p, scramble(load(a, p), load(before, p + ivec2(0, 1)), p)); }"},
    {"masked", "pixel",
     R"("domain": "mask", "inputs": {"mask": {}, "a": {}},
        "outputs": {"color": {"size": {"like": "mask"}, "neutral": [0.5, 0.25, 0, 0]}})",
     R"(void pixel(ivec2 p) {
            bool inside = load(mask, p).w != 0.0;
            store(color, p, inside ? scramble(load(a, p), load(mask, p), p) : vec4(0.5, 0.25, 0.0, 0.0));
        })"},
    {"sink", "pixel", R"("sideEffect": true, "inputs": {"a": {}}, "outputs": {"color": {}})",
     "void pixel(ivec2 p) { store(color, p, load(a, p)); }"},
    {"integers", "pixel", R"("inputs": {"a": {}}, "outputs": {"count": {"format": "r32u"}})",
     "void pixel(ivec2 p) { store(count, p, uvec4(65536.0 * scramble(load(a, p), load(a, p + 3), p))); }"},
    {"floats", "pixel", R"("inputs": {"n": {"format": "r32u"}}, "outputs": {"color": {}})",
     "void pixel(ivec2 p) { store(color, p, scramble(vec4(load(n, p)) / 65536.0, vec4(load(n, p.yx)) / "
     "65536.0, p)); }"},
};

constexpr PassText partPasses[] = {
    {"pyramid", "pixel",
     R"("forEach": "mips", "inputs": {"a": {}}, "outputs": {"levels": {"mips": 0}, "others": {"mips": 0}})",
     R"(void pixel(ivec2 p) {
            vec4 value = load(a, p);
            if (iteration > 0u) value = scramble(load(levels, 2 * p), load(levels, 2 * p + 1), p);
            store(levels, p, value);
            store(others, p, scramble(value, load(others, p), p));
        })"},
    {"allLevels", "pixel", R"("inputs": {"a": {}}, "outputs": {"color": {}})",
     R"(void pixel(ivec2 p) {
            vec4 value = vec4(0.0);
            for (int i = 0; i < levels(a); ++i) value = scramble(value, loadLevel(a, p >> i, i), p);
            store(color, p, value);
        })"},
    {"stack", "pixel", R"("inputs": {"a": {}}, "outputs": {"color": {"layers": 3}})",
     "void pixel(ivec2 p) { for (int i = 0; i < 3; ++i) storeLayer(color, p, i, scramble(load(a, p + i), "
     "vec4(i), p)); }"},
    {"allLayers", "pixel", R"("inputs": {"a": {}}, "outputs": {"color": {}})",
     R"(void pixel(ivec2 p) {
            vec4 value = vec4(0.0);
            for (int i = 0; i < layers(a); ++i) value = scramble(value, loadLayer(a, p, i), p);
            store(color, p, value);
        })"},
    {"perLight", "pixel",
     R"("forEach": "lights", "inputs": {"a": {}, "b": {"optional": true}}, "outputs": {"color": {"neutral": [0.3, 0, 0, 0]}})",
     "void pixel(ivec2 p) { store(color, p, scramble(load(a, p), load(b, p) + float(iteration), p)); }"},
    {"perLightStack", "pixel",
     R"("forEach": "lights", "inputs": {"a": {}}, "outputs": {"color": {"layers": 2}})",
     "void pixel(ivec2 p) { for (int i = 0; i < 2; ++i) storeLayer(color, p, i, scramble(load(a, p), "
     "vec4(i), p)); }"},
};

constexpr PassText writingPasses[] = {
    {"gather", "compute", R"("inputs": {"a": {}}, "outputs": {"list": {"buffer": "vec4", "count": 70}})",
     R"(void compute(uvec3 id) {
            ivec2 p = ivec2(id.x % 9u, id.x / 9u);
            if (id.x < 70u) list[id.x] = scramble(load(a, p), load(a, p.yx), p);
        })"},
    {"spread", "pixel", R"("inputs": {"list": {"buffer": "vec4"}}, "outputs": {"color": {}})",
     "void pixel(ivec2 p) { store(color, p, scramble(list[(p.x + 5 * p.y) % list.length()], vec4(1.0), p)); "
     "}"},
    {"listOver", "compute",
     R"("inputs": {"list": {"buffer": "vec4"}, "a": {"optional": true}},
        "outputs": {"over": {"buffer": "vec4", "modifies": "list"}})",
     R"(void compute(uvec3 id) {
            if (id.x < 70u) over[id.x] = scramble(list[id.x], load(a, ivec2(id.xx)), ivec2(id.xx));
        })"},
    {"inPlace", "compute",
     R"("inputs": {"under": {}, "b": {"optional": true}}, "outputs": {"over": {"modifies": "under"}})",
     R"(void compute(uvec3 id) {
            ivec2 p = ivec2(id.xy);
            if (all(lessThan(p, extent(over)))) store(over, p, scramble(load(under, p), load(b, p + 1), p));
        })"},
    {"halfInPlace", "pixel", R"("inputs": {"under": {}}, "outputs": {"over": {"modifies": "under"}})",
     "void pixel(ivec2 p) { if (((p.x + p.y) & 1) == 0) store(over, p, scramble(load(under, p), vec4(2.0), "
     "p)); }"},
    {"integersOver", "pixel",
     R"("inputs": {"n": {"format": "r32u"}}, "outputs": {"over": {"format": "r32u", "modifies": "n"}})",
     "void pixel(ivec2 p) { store(over, p, (5u * load(n, p) + uvec4(p.x + 3 * p.y)) & 0xffffu); }"},
    {"levelsOver", "pixel",
     R"("forEach": "mips", "inputs": {"under": {}}, "outputs": {"over": {"modifies": "under"}})",
     "void pixel(ivec2 p) { store(over, p, scramble(loadLevel(under, p, int(iteration)), load(over, 2 * p), "
     "p)); }"},
    {"perLightOver", "pixel",
     R"("forEach": "lights", "inputs": {"under": {}, "b": {"optional": true}}, "outputs": {"over": {"modifies": "under"}})",
     "void pixel(ivec2 p) { store(over, p, scramble(load(under, p), load(b, p), p)); }"},
};

constexpr PassText rasterPasses[] = {
    {"view", "raster",
     R"("outputs": {"color": {"format": "rgba32f"}, "surface": {"neutral": [0.5, 0.5, 0.5, 0]},
                    "depth": {"format": "d32f", "neutral": [1, 1, 1, 1]}})",
     R"(void fragment(Fragment f) {
            store(color, f.pixel, vec4(f.position, 1.0));
            store(surface, f.pixel, vec4(f.normal + params.seed, 1.0));
        })"},
    {"viewOf", "raster", R"("inputs": {"a": {}}, "outputs": {"color": {"neutral": [0.2, 0.4, 0, 0]}})",
     "void fragment(Fragment f) { store(color, f.pixel, scramble(load(a, f.pixel), vec4(f.normal, 1.0), "
     "f.pixel)); }"},
    {"lightView", "raster",
     R"("forEach": "lights", "outputs": {"color": {"format": "rgba32f"}, "depth": {"format": "d32f", "neutral": [1, 1, 1, 1]}})",
     "void fragment(Fragment f) { store(color, f.pixel, vec4(f.position + params.seed, 1.0)); }"},
    {"drawOver", "raster",
     R"("inputs": {"under": {}, "b": {"optional": true}}, "outputs": {"over": {"modifies": "under"}})",
     "void fragment(Fragment f) { store(over, f.pixel, scramble(vec4(f.position, 1.0), load(b, f.pixel), "
     "f.pixel)); }"},
    {"drawTested", "raster",
     R"("inputs": {"before": {}}, "outputs": {"depth": {"format": "d32f", "modifies": "before"},
                                                   "color": {"size": {"like": "before"}, "neutral": [0.7, 0.7, 0, 0]}},
        "raster": {"keep": "nearest", "cull": "front"})",
     "void fragment(Fragment f) { store(color, f.pixel, scramble(vec4(f.normal, 1.0), vec4(3.0), f.pixel)); "
     "}"},
};

constexpr std::span<const PassText> allPasses[] = {pixelPasses, partPasses, writingPasses, rasterPasses};

constexpr const char* parameters = R"("parameters": {"seed": {"type": "float", "default": 0.125},
                                                    "amount": {"type": "float", "default": 1}})";

constexpr const char* outside =
    R"({"type": "point", "position": [30, 30, 30], "intensity": [5000, 5000, 5000]})";
constexpr const char* inside = R"({"type": "point", "position": [0, 2, 0], "intensity": [50, 50, 50]})";

std::string sceneText(const std::string& lights, const std::string& more) {
    return fmt::format(
        R"({{"camera": {{"position": [0, 6, 40], "target": [0, 0, 0], "fovY": 36, "near": 1, "far": 200}},
             "lights": [{}],
             "objects": [{{"mesh": {{"procedural": "cube", "size": 13}}, "material": "apple",
                           "transform": {{"rotate": [20, 30, 0]}}{}}}]}})",
        lights, more);
}

}  // namespace

void writeRandomPasses(const ScratchFolder& folder) {
    for (const auto& passes : allPasses) {
        for (const PassText& pass : passes) {
            const std::string name = pass.name;
            folder.write("passes/" + name + ".json",
                         fmt::format("{{\"kind\": \"{}\", \"shader\": \"{}.glsl\", {}, {}}}", pass.kind, name,
                                     pass.manifest, parameters));
            folder.write("passes/" + name + ".glsl", std::string(scramble) + pass.shader);
        }
    }
}

std::vector<std::string> randomPassNames() {
    std::vector<std::string> names;
    for (const auto& passes : allPasses)
        for (const PassText& pass : passes) names.emplace_back(pass.name);
    return names;
}

void writeRandomScenes(const ScratchFolder& folder) {
    const std::string both = fmt::format("{}, {}", outside, inside);
    const std::string turning =
        R"(, "animation": [{"type": "path", "points": [[4, 0, 0], [0, 3, 4], [-4, 0, 0]], "secondsPerLoop": 5}])";
    folder.write("scene0.json", sceneText(outside, ""));
    folder.write("scene1.json", sceneText(both, ""));
    folder.write("scene2.json", sceneText("", ""));
    folder.write("scene3.json", sceneText(outside, turning));
    image::Image picture{13, 9, {"R", "G", "B", "A"}, {}};
    for (int i = 0; i < 13 * 9 * 4; ++i) picture.pixels.push_back(static_cast<float>(i * 37 % 101) / 128.0F);
    image::writeExr(folder.path() / "picture.exr", picture);
}

}  // namespace nephrite::runtime::test
