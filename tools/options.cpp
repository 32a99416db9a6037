// Parsing of shared command-line values.
#include "options.h"

#include <fmt/format.h>

#include <array>
#include <charconv>

#include "text/diagnostics.h"
#include "text/same_file.h"
#include "truth/run_record.h"

namespace nephrite::tools {
namespace {

constexpr std::uint32_t largestSide = 16384;

std::optional<std::uint32_t> side(std::string_view text) {
    std::uint32_t value = 0;
    const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (failure != std::errc{} || end != text.data() + text.size() || value == 0 || value > largestSide)
        return std::nullopt;
    return value;
}

}  // namespace

void GraphArguments::addTo(CLI::App& verb) {
    verb.add_option("graph", graph, "Graph file")->required();
    verb.add_option("--scene", scene, "Scene file (default: the embedded scene)");
    verb.add_option("--size", size, "Output size in pixels, WIDTHxHEIGHT")->capture_default_str();
    verb.add_option("--set", settings, "Set a parameter: NODE.PARAM=JSON or PARAM=JSON")
        ->expected(1)
        ->take_all();
    verb.add_option("--pass-path", passPaths, "Another folder of pass manifests")->expected(1)->take_all();
}

graph::Extent pictureSize(const std::string& text, const std::string& option) {
    const std::size_t cross = text.find('x');
    const auto width = side(std::string_view(text).substr(0, cross));
    const auto height =
        cross == std::string::npos ? std::nullopt : side(std::string_view(text).substr(cross + 1));
    if (!width || !height)
        throw InputError({option}, fmt::format("expected WIDTHxHEIGHT, each from 1 to {}, found \"{}\"",
                                               largestSide, text));
    return {*width, *height};
}

runtime::Validation validationNamed(const std::string& name) {
    if (name == "sync") return runtime::Validation::Sync;
    return name == "core" ? runtime::Validation::Core : runtime::Validation::Off;
}

CLI::Validator wholeNumber(std::uint64_t least, std::uint64_t most) {
    return {[least, most](const std::string& text) {
                std::uint64_t value = 0;
                const char* last = text.data() + text.size();
                const auto [end, failure] = std::from_chars(text.data(), last, value);
                const bool isOne = failure == std::errc{} && end == last && value >= least && value <= most;
                return isOne ? std::string()
                             : fmt::format("expected a whole number from {} to {}, found \"{}\"", least, most,
                                           text);
            },
            "", "whole number"};
}

std::pair<std::string, std::string> splitAssignment(const std::string& option, const std::string& text) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos || equals == 0 || equals + 1 == text.size())
        throw InputError({option}, fmt::format("expected NAME=VALUE, found \"{}\"", text));
    return {text.substr(0, equals), text.substr(equals + 1)};
}

void requireOther(const std::filesystem::path& output, std::span<const std::filesystem::path> inputs) {
    if (isAmong(output, inputs))
        throw InputError({output.string()}, "this file is read, and would be overwritten");
}

void GraphArguments::requireOther(const std::filesystem::path& output) const {
    tools::requireOther(output, std::array{graph, scene});
}

truth::Part partOf(const std::string& text) {
    const auto part = truth::parsePart(text);
    if (!part)
        throw InputError({"--part"},
                         fmt::format("expected I/N with 1 <= I <= N <= 1000000, found {}", inQuotes(text)));
    return *part;
}

}  // namespace nephrite::tools
