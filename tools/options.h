// Command-line values that several verbs read the same way.
#pragma once

#include <CLI/CLI.hpp>

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "graph/plan.h"
#include "runtime/session.h"
#include "truth/tiles.h"

namespace nephrite::tools {

/// Width and height of "WxH". Throws InputError unless both are whole numbers from 1 to 16384.
graph::Extent pictureSize(const std::string& text, const std::string& option = "--size");

/// Refuses a value of an option that is no whole number from `least` to `most`. CLI11's own conversion takes
/// -1 for 2^64 - 1, and every number that is too large for the same.
CLI::Validator wholeNumber(std::uint64_t least, std::uint64_t most);

/// Throws InputError if the output is one of the files that are read, which would be lost. Empty paths are
/// none.
void requireOther(const std::filesystem::path& output, std::span<const std::filesystem::path> inputs);

/// What names a graph, a scene and an output size.
struct GraphArguments {
    std::filesystem::path graph;
    std::filesystem::path scene;
    std::string size = "512x512";
    std::vector<std::string> settings;
    std::vector<std::filesystem::path> passPaths;

    void addTo(CLI::App& verb);
    /// See pictureSize.
    graph::Extent extent() const { return pictureSize(size); }
    /// The same for the graph's and the scene's file.
    void requireOther(const std::filesystem::path& output) const;
};

/// `I/N` of --part. Throws InputError unless 1 <= I <= N <= 1000000.
truth::Part partOf(const std::string& text);

/// "sync", "core" or "off".
runtime::Validation validationNamed(const std::string& name);

/// `NAME=REST` split at the first `=`. Throws InputError if there is none.
std::pair<std::string, std::string> splitAssignment(const std::string& option, const std::string& text);

}  // namespace nephrite::tools
