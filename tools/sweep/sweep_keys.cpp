// The keys of a sweep file: one table for reader and schema.
#include <array>

#include "graph/value_readers.h"
#include "pareto/file_readers.h"
#include "sweep/sweep.h"
#include "text/json_schema.h"

namespace nephrite::sweep {
namespace {

using json::Key;

constexpr std::array sweepTable{
    Key{"name", R"({"type": "string", "pattern": "^[A-Za-z_][A-Za-z0-9_-]*$"})", "default: the file's"},
    Key{"doc", R"({"type": "string"})", "what it is for"},
    Key{"scenes", R"({"allOf": [{"$ref": "#/definitions/scenes"}, {"minProperties": 1}]})",
        "by name: a scene file, or an object", true},
    Key{"graphs", R"({"allOf": [{"$ref": "#/definitions/graphs"}, {"minProperties": 1}]})",
        "by name: a graph file, or an object", true},
    Key{"sizes", R"({"type": "array", "minItems": 1, "items": {"$ref": "#/definitions/size"}})",
        "pictures' sizes, [width, height] each; default [[512, 512]]"},
    Key{"grid", R"({"type": "object", "additionalProperties": {"type": "array", "minItems": 1}})",
        "values by parameter (PARAM or NODE.PARAM): every combination is rendered, the last changing "
        "fastest"},
    Key{"list", R"({"type": "array", "minItems": 1, "items": {"type": "object"}})",
        "sets of values; each goes with every combination of the grid"},
    Key{"frames", R"({"type": "number", "multipleOf": 1, "minimum": 1, "maximum": 100000})",
        "timed in each run; default 10, without timings 1"},
    Key{"warmup", R"({"type": "number", "multipleOf": 1, "minimum": 0, "maximum": 100000})",
        "frames before them; default 3, without timings 0"},
    Key{"time", R"({"type": "number"})", "seconds of the scene's animation; default 0"},
    Key{"timings", R"({"type": "boolean"})", "whether frames are timed; default true"},
    Key{"passes", R"({"type": "boolean"})", "whether passes are timed, too, in frames of their own"},
    Key{"port", R"({"type": "string"})",
        "what is compared and kept: an output of the graph, or NODE.PORT; default \"color\""},
    Key{"pictures", R"({"enum": ["exr", "png", false]})", "kept of each run; default false"}};

constexpr std::array sceneTable{
    Key{"scene", R"({"type": "string"})", "a scene file", true},
    Key{"reference", R"({"type": "string"})", "an EXR that pictures are compared with"},
    Key{"secondHalf", R"({"type": "string"})",
        "an independent reference: errors are also estimated without the noise of either"},
    Key{"bins", R"({"type": "number", "multipleOf": 1, "minimum": 1, "maximum": 16384})",
        "compare means of blocks of so many pixels each way; default 1"}};

constexpr std::array graphTable{
    Key{"graph", R"({"type": "string"})", "a graph file", true},
    Key{"set", R"({"type": "object"})", "parameter values in all of its runs"},
    Key{"skip", R"({"type": "boolean"})", "false: as render --no-skip; default true"}};

constexpr std::string_view passesWithoutTimings = R"({
    "required": ["passes", "timings"],
    "properties": {"passes": {"enum": [true]}, "timings": {"enum": [false]}}})";

/// By name: a file, or the object that the definition describes.
Json::Value filesSchema(std::string_view definition) {
    return json::namedSchema(
        graph::identifierPattern(true),
        json::anyOf({json::schemaFragment(R"({"type": "string"})"), json::definition(definition)}));
}

}  // namespace

std::span<const Key> sweepKeys() {
    return sweepTable;
}
std::span<const Key> sceneKeys() {
    return sceneTable;
}
std::span<const Key> graphKeys() {
    return graphTable;
}

std::string sweepSchema() {
    Json::Value definitions(Json::objectValue);
    definitions["size"] = json::arraySchema(json::wholeNumberSchema(1, pareto::largestSide), 2);
    definitions["scene"] = json::objectSchema(sceneTable, "a scene and what its pictures are compared with");
    definitions["scene"]["dependencies"] = json::schemaFragment(R"({"secondHalf": ["reference"]})");
    definitions["graph"] = json::objectSchema(graphTable, "a graph with fixed parameter values");
    definitions["scenes"] = filesSchema("scene");
    definitions["graphs"] = filesSchema("graph");
    Json::Value schema =
        json::objectSchema(sweepTable, "graphs and scenes, rendered at many parameter values");
    schema["not"] = json::schemaFragment(passesWithoutTimings);
    return json::schemaDocument(std::move(schema), "Nephrite sweep", std::move(definitions));
}

}  // namespace nephrite::sweep
