// What a sweep file says: graphs and scenes, and the parameter values at which they are rendered.
//
// Plain data. The reader has made paths relative to the sweep file usable and checked names against each
// other; graphs, scenes and references are not opened.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "graph/plan.h"
#include "text/diagnostics.h"
#include "text/json.h"

namespace nephrite::sweep {

/// A parameter and a value for it.
struct Setting {
    std::string parameter;  ///< `PARAM` or `NODE.PARAM`
    Json::Value value;
    SourceLocation where;  ///< of the value

    /// `PARAM=JSON`, as runtime::SessionOptions::settings; the same for the same value, however it is
    /// written.
    std::string text() const;
};

/// A parameter and the values it takes in turn.
struct Axis {
    std::string parameter;
    std::vector<Setting> values;
};

struct SweepGraph {
    std::string name;
    std::filesystem::path file;
    std::vector<Setting> settings;  ///< in all of its runs
    bool skip = true;               ///< false: as `render --no-skip`
    SourceLocation where;
};

struct SweepScene {
    std::string name;
    std::filesystem::path file;
    std::filesystem::path reference;   ///< EXR; empty: nothing is compared
    std::filesystem::path secondHalf;  ///< an independent one; empty: none
    std::uint32_t bins = 1;  ///< pictures are compared by means of blocks of so many pixels each way
    SourceLocation where;
    SourceLocation referenceWhere;
    SourceLocation secondHalfWhere;
};

/// Whether pictures are kept, and as what.
enum class Pictures : std::uint8_t { None, Exr, Png };

struct Sweep {
    std::string file;
    std::string name;
    std::vector<SweepScene> scenes;
    std::vector<SweepGraph> graphs;
    std::vector<graph::Extent> sizes{{512, 512}};
    std::vector<std::vector<Setting>> list;  ///< sets of values; empty: one set without any
    std::vector<Axis> grid;                  ///< every combination, with every set of the list
    std::uint32_t frames = 10;               ///< timed in each run
    std::uint32_t warmup = 3;                ///< before them
    double time = 0;                         ///< seconds of the scene's animation
    bool timings = true;                     ///< false: no times, so rows are the same on every machine
    bool passes = false;                     ///< times of passes too, from frames of their own
    std::string port = "color";  ///< what is compared and kept: an output of the graph, or `node.port`
    SourceLocation portWhere;
    Pictures pictures = Pictures::None;
};

/// The keys of a sweep file, its scenes and its graphs; for the reader and for the schema.
std::span<const json::Key> sweepKeys();
std::span<const json::Key> sceneKeys();
std::span<const json::Key> graphKeys();

/// Reads a sweep file. Throws InputError with every fault.
Sweep readSweep(const std::filesystem::path& file);
/// The same from text already parsed; relative paths start from the folder of the document's file name.
Sweep readSweep(const json::Value& value);

/// The JSON Schema of sweep files.
std::string sweepSchema();

}  // namespace nephrite::sweep
