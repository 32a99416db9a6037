// GLSL templates of image ports. `layer` in fetch, filter and put counts through the whole image.
#include "runtime/interface/image_port.h"

#include <fmt/format.h>

#include "runtime/interface/glsl_template.h"

namespace nephrite::runtime {
namespace {

constexpr std::string_view fetchFromStorage = R"(
ivec2 size_@NAME@(int level) { return imageSize(input_@NAME@).xy; }
ivec2 extent_@NAME@() { return size_@NAME@(0); }
int levels_@NAME@() { return 1; }
@VECTOR@ fetch_@NAME@(ivec2 p, int layer, int level) {
    p = clamp(p, ivec2(0), extent_@NAME@() - 1);
    return imageLoad(input_@NAME@, @COORDINATE@);
}
)";

constexpr std::string_view fetchFromSampler = R"(
ivec2 size_@NAME@(int level) { return textureSize(sampler_@NAME@, level).xy; }
ivec2 extent_@NAME@() { return size_@NAME@(0); }
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
@VECTOR@ loadLayer_@NAME@(ivec2 p, int layer, int level) { return fetch_@NAME@(p, @LAYER@, level); }
int layers_@NAME@() { return @LAYERS@; }
)";

constexpr std::string_view filterOnDevice = R"(
vec4 filter_@NAME@(vec2 uv, int layer, float level) { return textureLod(sampler_@NAME@, @UV@, level); }
)";

// Some devices cannot filter 32-bit floats: the four texels are mixed here then, on the nearest level.
constexpr std::string_view filterByHand = R"(
vec4 filter_@NAME@(vec2 uv, int layer, float level) {
    int l = int(level + 0.5);
    vec2 t = uv * vec2(size_@NAME@(l)) - 0.5;
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

constexpr std::string_view put = R"(
void put_@NAME@(ivec2 p, int layer, int level, @VECTOR@ value) {
@LIMIT@    switch (level) {
@STORES@    }
}
)";

constexpr std::string_view stores = R"(
void store_@NAME@(ivec2 p, @VECTOR@ value) { put_@NAME@(p, @FIRST@, 0, value); }
void storeLevel_@NAME@(ivec2 p, int level, @VECTOR@ value) { put_@NAME@(p, @FIRST@, level, value); }
void storeLayer_@NAME@(ivec2 p, int layer, @VECTOR@ value) { put_@NAME@(p, @LAYER@, 0, value); }
int layers_@NAME@() { return @LAYERS@; }
)";

// An iteration over mips writes its own level and no other.
constexpr std::string_view storesToIteration = R"(
void store_@NAME@(ivec2 p, @VECTOR@ value) { put_@NAME@(p, @FIRST@, int(iteration), value); }
void storeLayer_@NAME@(ivec2 p, int layer, @VECTOR@ value) { put_@NAME@(p, @LAYER@, int(iteration), value); }
int layers_@NAME@() { return @LAYERS@; }
)";

constexpr std::string_view outputExtent = R"(
ivec2 size_@NAME@(int level) { return max(imageSize(output_@OUTPUT@_0).xy >> level, ivec2(1)); }
ivec2 extent_@NAME@() { return size_@NAME@(0); }
int levels_@NAME@() { return @LEVELS@; }
)";

// Levels that are storage images of their own.
constexpr std::string_view fetchFromOutput = R"(
@VECTOR@ fetch_@NAME@(ivec2 p, int layer, int level) {
    switch (clamp(level, 0, @LEVELS@ - 1)) {
@FETCHES@    }
    return @VECTOR@(0);
}
)";

// An iteration over mips writes one level, and reads the levels above it through images of their own.
constexpr std::string_view iterationFunctions = R"(
ivec2 size_@NAME@(int level) { return max(imageSize(above_@NAME@_0).xy >> level, ivec2(1)); }
ivec2 extent_@NAME@() { return size_@NAME@(0); }
int levels_@NAME@() { return @LEVELS@; }
int layers_@NAME@() { return @LAYERS@; }
void put_@NAME@(ivec2 p, int layer, @VECTOR@ value) {
@LIMIT@    imageStore(output_@NAME@_0, @COORDINATE@, value);
}
void store_@NAME@(ivec2 p, @VECTOR@ value) { put_@NAME@(p, @FIRST@, value); }
void storeLayer_@NAME@(ivec2 p, int layer, @VECTOR@ value) { put_@NAME@(p, @LAYER@, value); }
@VECTOR@ fetch_@NAME@(ivec2 p, int layer, int level) {
    if (iteration == 0u) return @VECTOR@(0);
    switch (clamp(level, 0, int(iteration) - 1)) {
@ABOVE@    }
    return @VECTOR@(0);
}
@VECTOR@ loadLevel_@NAME@(ivec2 p, int level) { return fetch_@NAME@(p, @FIRST@, level); }
@VECTOR@ load_@NAME@(ivec2 p, int level) { return fetch_@NAME@(p, @FIRST@, level); }
@VECTOR@ load_@NAME@(ivec2 p) { return fetch_@NAME@(p, @FIRST@, int(iteration) - 1); }
@VECTOR@ loadLayer_@NAME@(ivec2 p, int layer) { return fetch_@NAME@(p, @LAYER@, int(iteration) - 1); }
@VECTOR@ loadLayer_@NAME@(ivec2 p, int layer, int level) { return fetch_@NAME@(p, @LAYER@, level); }
)";

constexpr std::string_view attachmentExtent = R"(
ivec2 extent_@NAME@() { return ivec2(dispatch.width, dispatch.height); }
)";
constexpr std::string_view attachmentStore = R"(
void store_@NAME@(ivec2 p, @VECTOR@ value) {
@LIMIT@    output_@NAME@ = value;
}
)";

/// Where a bright value exceeds what a short float holds, devices may store infinity, and 0 times that is no
/// number. What is infinite already stays, so that it is not taken for light.
std::string limitTo(float greatest) {
    return fmt::format(
        "    value = mix(value, clamp(value, vec4(-{0:.1f}), vec4({0:.1f})), "
        "lessThan(abs(value), vec4(3.4e38)));\n",
        greatest);
}

std::string limitOf(graph::Format format) {
    switch (format) {
        case graph::Format::r16f:
        case graph::Format::rg16f:
        case graph::Format::rgba16f:
            return limitTo(65504);
        case graph::Format::r11g11b10f:
            return limitTo(64512);
        default:
            return {};
    }
}

}  // namespace

PortImage PortImage::of(const graph::Resource& resource, std::uint16_t mip, std::uint16_t layer) {
    PortImage image{resource.format, resource.mips, resource.layers, resource.layersPerIteration};
    if (mip != graph::every) image.mips = 1;
    if (layer != graph::every) image.layers = image.layersPerIteration = 1;
    return image;
}

ImagePort::ImagePort(std::string name, const PortImage& image, bool perIteration)
    : name_(std::move(name)), image_(image), perIteration_(perIteration) {
    const bool isInteger = graph::info(image.format).isUnsignedInteger;
    vector_ = isInteger ? "uvec4" : "vec4";
    prefix_ = isInteger ? "u" : "";
    array_ = image.layers > 1 ? "Array" : "";
    coordinate_ = image.layers > 1 ? "ivec3(p, layer)" : "p";
}

std::string ImagePort::readonlyImage(std::uint32_t binding) const {
    return fmt::format("layout(set = 1, binding = {}, {}) uniform readonly {}image2D{} input_{};\n", binding,
                       graph::info(image_.format).glslQualifier, prefix_, array_, name_);
}

std::string ImagePort::sampler(std::uint32_t binding) const {
    return fmt::format("layout(set = 1, binding = {}) uniform {}sampler2D{} sampler_{};\n", binding, prefix_,
                       array_, name_);
}

std::string ImagePort::outputImage(std::uint32_t binding, std::uint32_t mip, OutputAccess access) const {
    return fmt::format("layout(set = 1, binding = {}, {}) uniform {}{}image2D{} output_{}_{};\n", binding,
                       graph::info(image_.format).glslQualifier,
                       access == OutputAccess::Modify ? "" : "writeonly ", prefix_, array_, name_, mip);
}

std::string ImagePort::levelAbove(std::uint32_t binding, std::uint32_t mip) const {
    return fmt::format("layout(set = 1, binding = {}, {}) uniform readonly {}image2D{} above_{}_{};\n",
                       binding, graph::info(image_.format).glslQualifier, prefix_, array_, name_, mip);
}

std::string ImagePort::attachment(std::uint32_t location) const {
    return fmt::format("layout(location = {}) out {} output_{};\n", location, vector_, name_);
}

std::string ImagePort::inputFunctions(bool storage, bool filterable) const {
    std::string text = fill(storage ? fetchFromStorage : fetchFromSampler) + fill(loads);
    if (prefix_.empty()) text += fill(filterable ? filterOnDevice : filterByHand) + fill(samples);
    return text;
}

std::string ImagePort::outputFunctions(OutputAccess access) const {
    if (access == OutputAccess::Mips) return fill(iterationFunctions);
    return fill(put) + fill(outputExtent) + fill(stores);
}

std::string ImagePort::modifiedInputFunctions(const std::string& output) const {
    std::string text = fill(outputExtent, output) + fill(fetchFromOutput, output) + fill(loads);
    if (prefix_.empty()) text += fill(filterByHand) + fill(samples);
    return text;
}

std::string ImagePort::attachmentFunctions() const {
    const bool isDepth = graph::info(image_.format).isDepth;
    return fill(attachmentExtent) + (isDepth ? "" : fill(attachmentStore));
}

/// The layer of the whole image that the node means by `index`, clamped to what it may address.
std::string ImagePort::layer(std::string_view index) const {
    const std::uint32_t block = perIteration_ ? image_.layersPerIteration : image_.layers;
    const std::string clamped = fmt::format("clamp({}, 0, {})", index, block - 1);
    return perIteration_ ? fmt::format("int(dispatch.iteration) * {} + {}", block, clamped) : clamped;
}

std::string ImagePort::fetchCase(std::uint32_t level, const std::string& image) const {
    return fmt::format(
        "        case {0}: p = clamp(p, ivec2(0), imageSize({1}).xy - 1); return imageLoad({1}, {2});\n",
        level, image, coordinate_);
}

std::string ImagePort::fill(std::string_view text, const std::string& output) const {
    std::string storeCases;
    std::string fetchCases;
    std::string aboveCases;
    for (std::uint32_t mip = 0; mip < image_.mips; ++mip) {
        storeCases += fmt::format("        case {0}: imageStore(output_{1}_{0}, {2}, value); break;\n", mip,
                                  name_, coordinate_);
        fetchCases += fetchCase(mip, fmt::format("output_{}_{}", output, mip));
        if (mip + 1 < image_.mips) aboveCases += fetchCase(mip, fmt::format("above_{}_{}", name_, mip));
    }
    return fillIn(text,
                  {{"NAME", name_},
                   {"OUTPUT", output},
                   {"VECTOR", vector_},
                   {"COORDINATE", coordinate_},
                   {"UV", image_.layers > 1 ? "vec3(uv, float(layer))" : "uv"},
                   {"FIRST", layer("0")},
                   {"LAYER", layer("layer")},
                   {"LAYERS", std::to_string(perIteration_ ? image_.layersPerIteration : image_.layers)},
                   {"LEVELS", std::to_string(image_.mips)},
                   {"LIMIT", limitOf(image_.format)},
                   {"STORES", storeCases},
                   {"FETCHES", fetchCases},
                   {"ABOVE", aboveCases}});
}

}  // namespace nephrite::runtime
