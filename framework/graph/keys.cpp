// See keys.h. "#/definitions/..." are made in graph_schema.cpp and pass_schema.cpp.
#include "graph/keys.h"

#include <array>

namespace nephrite::graph::keys {
namespace {

using json::Key;

constexpr std::string_view text = R"({"type": "string"})";
constexpr std::string_view fileName = R"({"type": "string", "minLength": 1})";
constexpr std::string_view boolean = R"({"type": "boolean"})";
constexpr std::string_view expression = R"({"$ref": "#/definitions/expression"})";
constexpr std::string_view size = R"({"$ref": "#/definitions/size"})";
constexpr std::string_view format = R"({"$ref": "#/definitions/format"})";
constexpr std::string_view neutral = R"({"$ref": "#/definitions/neutral"})";
constexpr std::string_view range = R"({"$ref": "#/definitions/range"})";
constexpr std::string_view forEach = R"({"enum": ["lights", "mips"]})";
constexpr std::string_view element = R"({"$ref": "#/definitions/bufferElement"})";

constexpr std::array graphKeys{
    Key{"name", text, "what the graph is called; its file's name if absent"},
    Key{"doc", text, "what the graph computes"},
    Key{"parameters", R"({"$ref": "#/definitions/parameters"})",
        "values nodes may use as \"$NAME\" and expressions as graph.NAME"},
    Key{"imports", R"({"$ref": "#/definitions/imports"})",
        "images from outside, which nodes read as \"import(NAME)\""},
    Key{"nodes", R"({"$ref": "#/definitions/nodes"})",
        "the passes, by the names the rest of the graph calls them; it may be empty where there is an import",
        true},
    Key{"outputs",
        R"({"type": "object", "minProperties": 1, "additionalProperties": {"$ref": "#/definitions/port"}})",
        "what the graph computes: a name, and the port it comes from; \"color\" is the picture", true},
};

constexpr std::array graphParameterKeys{
    Key{"value", R"({"$ref": "#/definitions/value"})", "a boolean, a number or an array of numbers", true},
    Key{"range", range, "least and greatest value of each number"},
    Key{"doc", text, "what it means, with its unit"},
};

constexpr std::array graphImportKeys{
    Key{"image", fileName,
        "an OpenEXR file beside the graph; without it the program that uses the graph hands one over"},
    Key{"format", R"({"$ref": "#/definitions/importFormat"})", "pixel format; rgba32f if absent"},
    Key{"doc", text, "what it holds, with its unit"},
};

constexpr std::array nodeKeys{
    Key{"pass", text, "the pass type: the name of a manifest", true},
    Key{"view", R"({"enum": ["camera", "light"]})",
        "from where a raster pass draws; \"light\" needs forEach"},
    Key{"forEach", forEach,
        "runs once for each view of each light, or for each level of its outputs; the pass type's if absent"},
    Key{"in", R"({"type": "object", "additionalProperties": {"$ref": "#/definitions/port"}})",
        "input ports, each with the \"node.port\" it reads, or previous(...), mip(...), layer(...) of one"},
    Key{"set", R"({"type": "object", "additionalProperties": {"$ref": "#/definitions/setting"}})",
        "parameters of the pass type: a value, or \"$NAME\" of a graph parameter"},
    Key{"size", size, "of every output of the node"},
    Key{"format", R"({"type": "object", "additionalProperties": {"$ref": "#/definitions/format"}})",
        "output ports whose pixel format differs from the manifest's"},
    Key{"when", expression, "the node is skipped where this is 0 or false"},
    Key{"doc", text, "why the node is there"},
};

constexpr std::array manifestKeys{
    Key{"kind", R"({"enum": ["pixel", "compute", "raster", "native"]})",
        "how it runs: once a pixel, as raw compute, drawing the scene, or in C++", true},
    Key{"shader", fileName,
        "GLSL file beside the manifest, or in the shader folder; every kind but native needs it"},
    Key{"doc", text, "what the pass computes, with the equation it implements"},
    Key{"inputs", R"({"$ref": "#/definitions/inputs"})", "the images and buffers it reads"},
    Key{"outputs", R"({"$ref": "#/definitions/outputs"})", "the images and buffers it writes"},
    Key{"parameters", R"({"$ref": "#/definitions/parameters"})", "values a graph may set"},
    Key{"skipWhen", expression, "where this is true the pass does not run and its outputs are neutral"},
    Key{"sideEffect", boolean, "true: it runs although nothing reads its outputs"},
    Key{"forEach", forEach,
        "runs once for each view of each light, or for each level of its outputs, unless its node says "
        "otherwise"},
    Key{"domain", text, "an input of a pixel pass: where its last channel is 0 every output is neutral"},
    Key{"raster", R"({"$ref": "#/definitions/raster"})", "how a raster pass draws"},
};

constexpr std::array inputKeys{
    Key{"doc", text, "what it expects, with its unit"},
    Key{"optional", boolean, "true: a graph may leave it unconnected"},
    Key{"neutral", neutral, "what it reads as when it is unconnected or its source is skipped"},
    Key{"neededWhen", expression, "where this is false the input is not needed and reads as neutral"},
    Key{"format", format, "r32u if it is read as unsigned integers"},
    Key{"buffer", element, "it is a buffer of this GLSL type"},
};

constexpr std::array outputKeys{
    Key{"doc", text, "what it holds, with its unit"},
    Key{"format", format, "pixel format; rgba16f if absent"},
    Key{"size", size, "the first input's if absent, else the view's"},
    Key{"neutral", neutral, "what its readers get when the pass is skipped"},
    Key{"mips", R"({"$ref": "#/definitions/mips"})", "levels, 0 for all down to one pixel"},
    Key{"layers", R"({"$ref": "#/definitions/layers"})",
        "array layers, for each iteration of a forEach node"},
    Key{"buffer", element, "it is a buffer of this GLSL type"},
    Key{"count", R"({"$ref": "#/definitions/count"})", "elements of the buffer"},
    Key{"modifies", R"({"type": "string", "minLength": 1})",
        "an input: the output is that image or buffer, written again in place"},
};

constexpr std::array parameterKeys{
    Key{"type", R"({"$ref": "#/definitions/parameterType"})",
        "bool, int, uint, float, vec2, vec3, vec4 or float[N]", true},
    Key{"default", R"({"$ref": "#/definitions/value"})", "its value where a graph does not set it", true},
    Key{"range", range, "least and greatest value of each component"},
    Key{"specialize", boolean,
        "true: a constant of the compiled shader, so code it switches off costs nothing"},
    Key{"doc", text, "what it means, with its unit"},
};

constexpr std::array rasterKeys{
    Key{"keep", R"({"enum": ["nearest", "farthest"]})", "which surface along a ray is kept"},
    Key{"cull", R"({"enum": ["none", "back", "front"]})", "which side of triangles is left out"},
};

}  // namespace

std::span<const Key> graph() {
    return graphKeys;
}
std::span<const Key> graphParameter() {
    return graphParameterKeys;
}
std::span<const Key> graphImport() {
    return graphImportKeys;
}
std::span<const Key> node() {
    return nodeKeys;
}
std::span<const Key> manifest() {
    return manifestKeys;
}
std::span<const Key> input() {
    return inputKeys;
}
std::span<const Key> output() {
    return outputKeys;
}
std::span<const Key> parameter() {
    return parameterKeys;
}
std::span<const Key> raster() {
    return rasterKeys;
}

}  // namespace nephrite::graph::keys
