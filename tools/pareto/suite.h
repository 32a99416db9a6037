// What a suite file says: scenes with their references, and the methods that are measured on each of them.
//
// Plain data. The reader has made paths relative to the suite file absolute or relative to the working
// folder, and checked names against each other; graphs and scenes are not opened.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "text/diagnostics.h"
#include "text/json.h"
#include "truth/reference_run.h"

namespace nephrite::pareto {

/// A reference of a scene: two halves, independent by their seeds `seed` and `seed + 1`.
struct ReferenceSettings {
    truth::Mode mode = truth::Mode::Volume;
    std::uint32_t samples = 16;  ///< of each pixel, in each half
    std::uint64_t seed = 1;
    std::uint32_t fluxPoints = 1 << 20;  ///< dipole: rays from each light, a sample
    SourceLocation where;
};

struct SuiteScene {
    std::string name;
    std::filesystem::path file;
    std::uint32_t bins = 1;  ///< pictures are compared by means of blocks of bins x bins pixels
    std::vector<ReferenceSettings> references;  ///< each mode at most once; none: only times are measured
    SourceLocation where;                       ///< of the file's name

    const ReferenceSettings* find(truth::Mode mode) const;
};

/// What of a method is held against a reference.
struct ComparedPort {
    truth::Mode reference = truth::Mode::Volume;
    std::string port = "color";  ///< an output of the graph, or "node.port"
    SourceLocation where;
};

/// A parameter and its value, as `--set` has them, and where the suite says so.
struct Setting {
    std::string parameter;  ///< PARAM or NODE.PARAM
    std::string value;      ///< JSON text
    SourceLocation whereParameter;
    SourceLocation whereValue;

    std::string text() const { return parameter + "=" + value; }
};

/// A parameter and the values it takes in turn.
using Variation = std::vector<Setting>;

/// A graph, or the sum of references as if it were one.
struct Method {
    std::string name;
    std::filesystem::path graph;          ///< empty: a sum of references
    std::vector<truth::Mode> references;  ///< the sum
    std::vector<ComparedPort> against;    ///< each mode at most once
    std::vector<Setting> settings;
    std::vector<Variation> variations;  ///< every combination is measured
    bool skip = true;                   ///< false: as `render --no-skip`
    SourceLocation where;
    SourceLocation whereGraph;

    bool isTimed() const { return !graph.empty(); }
};

struct Suite {
    std::string file;
    std::string name;
    std::uint32_t width = 512;
    std::uint32_t height = 512;
    std::uint32_t frames = 30;  ///< measured of each point
    std::uint32_t warmup = 3;   ///< before them
    std::string baseline;       ///< the method whose time others are held against; empty: none
    std::vector<SuiteScene> scenes;
    std::vector<Method> methods;

    const Method* find(std::string_view method) const;
};

/// Reads a suite file. Throws InputError with every fault.
Suite readSuite(const std::filesystem::path& file);
/// The same from text already parsed; relative paths start from the folder of the document's file name.
Suite readSuite(const json::Value& value);

}  // namespace nephrite::pareto
