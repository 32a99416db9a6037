// GLSL templates of image ports. `layer` in fetch, filter and put counts through the whole image.
#include "runtime/image_port.h"

#include <fmt/format.h>

#include "runtime/glsl_template.h"

namespace nephrite::runtime {
namespace {

constexpr std::string_view fetchFromStorage = R"(
ivec2 extent_@NAME@() { return imageSize(input_@NAME@).xy; }
int levels_@NAME@() { return 1; }
@VECTOR@ fetch_@NAME@(ivec2 p, int layer, int level) {
    p = clamp(p, ivec2(0), extent_@NAME@() - 1);
    return imageLoad(input_@NAME@, @COORDINATE@);
}
)";

constexpr std::string_view fetchFromSampler = R"(
ivec2 extent_@NAME@() { return textureSize(sampler_@NAME@, 0).xy; }
int levels_@NAME@() { return textureQueryLevels(sampler_@NAME@); }
@VECTOR@ fetch_@NAME@(ivec2 p, int layer, int level) {
    level = clamp(level, 0, levels_@NAME@() - 1);
    p = clamp(p, ivec2(0), textureSize(sampler_@NAME@, level).xy - 1);
    return texelFetch(sampler_@NAME@, @COORDINATE@, level);
}
)";

constexpr std::string_view loads = R"(
@VECTOR@ load_@NAME@(ivec2 p) { return fetch_@NAME@(p, @FIRST@, 0); }
@VECTOR@ load_@NAME@(ivec2 p, int level) { return fetch_@NAME@(p, @FIRST@, level); }
@VECTOR@ loadLevel_@NAME@(ivec2 p, int level) { return fetch_@NAME@(p, @FIRST@, level); }
@VECTOR@ loadLayer_@NAME@(ivec2 p, int layer) { return fetch_@NAME@(p, @LAYER@, 0); }
int layers_@NAME@() { return @LAYERS@; }
)";

constexpr std::string_view filterOnDevice = R"(
vec4 filter_@NAME@(vec2 uv, int layer, float level) { return textureLod(sampler_@NAME@, @UV@, level); }
)";

// Some devices cannot filter 32-bit floats: the four texels are mixed here then, on the nearest level.
constexpr std::string_view filterByHand = R"(
vec4 filter_@NAME@(vec2 uv, int layer, float level) {
    int l = int(level + 0.5);
    vec2 t = uv * vec2(textureSize(sampler_@NAME@, l).xy) - 0.5;
    ivec2 p = ivec2(floor(t));
    vec2 f = t - floor(t);
    vec4 upper = mix(fetch_@NAME@(p, layer, l), fetch_@NAME@(p + ivec2(1, 0), layer, l), f.x);
    vec4 lower = mix(fetch_@NAME@(p + ivec2(0, 1), layer, l), fetch_@NAME@(p + ivec2(1, 1), layer, l), f.x);
    return mix(upper, lower, f.y);
}
)";

constexpr std::string_view samples = R"(
vec4 sample_@NAME@(vec2 uv) { return filter_@NAME@(uv, @FIRST@, 0.0); }
vec4 sampleLevel_@NAME@(vec2 uv, float level) { return filter_@NAME@(uv, @FIRST@, level); }
vec4 sampleLayer_@NAME@(vec2 uv, int layer) { return filter_@NAME@(uv, @LAYER@, 0.0); }
)";

constexpr std::string_view stores = R"(
void put_@NAME@(ivec2 p, int layer, int level, @VECTOR@ value) {
    switch (level) {
@CASES@    }
}
void store_@NAME@(ivec2 p, @VECTOR@ value) { put_@NAME@(p, @FIRST@, 0, value); }
void storeLevel_@NAME@(ivec2 p, int level, @VECTOR@ value) { put_@NAME@(p, @FIRST@, level, value); }
void storeLayer_@NAME@(ivec2 p, int layer, @VECTOR@ value) { put_@NAME@(p, @LAYER@, 0, value); }
ivec2 extent_@NAME@() { return imageSize(output_@NAME@_0).xy; }
int levels_@NAME@() { return @LEVELS@; }
int layers_@NAME@() { return @LAYERS@; }
)";

constexpr std::string_view attachmentExtent = R"(
ivec2 extent_@NAME@() { return ivec2(dispatch.width, dispatch.height); }
)";
constexpr std::string_view attachmentStore = R"(
void store_@NAME@(ivec2 p, @VECTOR@ value) { output_@NAME@ = value; }
)";

}  // namespace

ImagePort::ImagePort(std::string name, const graph::Resource& resource, bool perIteration)
    : name_(std::move(name)), resource_(resource), perIteration_(perIteration) {
    const bool isInteger = graph::info(resource.format).isUnsignedInteger;
    vector_ = isInteger ? "uvec4" : "vec4";
    prefix_ = isInteger ? "u" : "";
    array_ = resource.layers > 1 ? "Array" : "";
    coordinate_ = resource.layers > 1 ? "ivec3(p, layer)" : "p";
}

std::string ImagePort::readonlyImage(std::uint32_t binding) const {
    return fmt::format("layout(set = 1, binding = {}, {}) uniform readonly {}image2D{} input_{};\n", binding,
                       graph::info(resource_.format).glslQualifier, prefix_, array_, name_);
}

std::string ImagePort::sampler(std::uint32_t binding) const {
    return fmt::format("layout(set = 1, binding = {}) uniform {}sampler2D{} sampler_{};\n", binding, prefix_,
                       array_, name_);
}

std::string ImagePort::writeonlyImage(std::uint32_t binding, std::uint32_t mip) const {
    return fmt::format("layout(set = 1, binding = {}, {}) uniform writeonly {}image2D{} output_{}_{};\n",
                       binding, graph::info(resource_.format).glslQualifier, prefix_, array_, name_, mip);
}

std::string ImagePort::attachment(std::uint32_t location) const {
    return fmt::format("layout(location = {}) out {} output_{};\n", location, vector_, name_);
}

std::string ImagePort::inputFunctions(bool storage, bool filterable) const {
    std::string text = fill(storage ? fetchFromStorage : fetchFromSampler) + fill(loads);
    if (prefix_.empty()) text += fill(filterable ? filterOnDevice : filterByHand) + fill(samples);
    return text;
}

std::string ImagePort::outputFunctions() const {
    return fill(stores);
}

std::string ImagePort::attachmentFunctions() const {
    const bool isDepth = graph::info(resource_.format).isDepth;
    return fill(attachmentExtent) + (isDepth ? "" : fill(attachmentStore));
}

/// The layer of the whole image that the node means by `index`, clamped to what it may address.
std::string ImagePort::layer(std::string_view index) const {
    const std::uint32_t block = perIteration_ ? resource_.layersPerIteration : resource_.layers;
    const std::string clamped = fmt::format("clamp({}, 0, {})", index, block - 1);
    return perIteration_ ? fmt::format("int(dispatch.iteration) * {} + {}", block, clamped) : clamped;
}

std::string ImagePort::fill(std::string_view text) const {
    std::string cases;
    for (std::uint32_t mip = 0; mip < resource_.mips; ++mip)
        cases += fmt::format("        case {0}: imageStore(output_{1}_{0}, {2}, value); break;\n", mip, name_,
                             coordinate_);
    return fillIn(
        text, {{"NAME", name_},
               {"VECTOR", vector_},
               {"COORDINATE", coordinate_},
               {"UV", resource_.layers > 1 ? "vec3(uv, float(layer))" : "uv"},
               {"FIRST", layer("0")},
               {"LAYER", layer("layer")},
               {"LAYERS", std::to_string(perIteration_ ? resource_.layersPerIteration : resource_.layers)},
               {"LEVELS", std::to_string(resource_.mips)},
               {"CASES", cases}});
}

}  // namespace nephrite::runtime
