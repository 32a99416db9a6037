// `nephrite compare`: how far a picture is from a reference.
#include <fmt/format.h>
#include <json/writer.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <optional>

#include "image/exr.h"
#include "image/metrics/heat_map.h"
#include "image/metrics/metrics.h"
#include "image/metrics/metrics_report.h"
#include "image/output_file.h"
#include "image/png.h"
#include "options.h"
#include "text/diagnostics.h"
#include "verbs.h"

namespace nephrite::tools {
namespace {

struct CompareArguments {
    std::filesystem::path picture;
    std::filesystem::path reference;
    std::filesystem::path secondHalf;
    bool wantsJson = false;
    std::filesystem::path json;  ///< empty: standard output
    std::filesystem::path heatMap;
    std::optional<double> heatMapRange;
    std::uint32_t bins = 1;
};

void requireEnding(const std::string& option, const std::filesystem::path& name, const std::string& ending) {
    if (name.empty() || name.extension() == ending) return;
    throw InputError({option},
                     fmt::format("expected a name ending in {}, found \"{}\"", ending, name.string()));
}

void requireUsable(const CompareArguments& arguments) {
    requireEnding("--json", arguments.json, ".json");
    requireEnding("--heatmap", arguments.heatMap, ".png");
    for (const std::filesystem::path& output : {arguments.json, arguments.heatMap})
        requireOther(output, std::array{arguments.picture, arguments.reference, arguments.secondHalf});
    if (arguments.bins == 0) throw InputError({"--bins"}, "expected at least 1, found 0");
    if (!arguments.heatMapRange) return;
    const double range = *arguments.heatMapRange;
    if (!(range > 0 && std::isfinite(range)))
        throw InputError({"--heatmap-range"}, fmt::format("expected a number above 0, found {}", range));
    if (arguments.heatMap.empty()) throw InputError({"--heatmap-range"}, "there is no --heatmap");
}

struct Pictures {
    image::Image picture;
    image::Image reference;
    std::optional<image::Image> secondHalf;

    const image::Image* half() const { return secondHalf ? &*secondHalf : nullptr; }
};

std::optional<std::string> attribute(const image::ExrFile& file, const std::string& name) {
    const auto found = file.metadata.find(name);
    return found == file.metadata.end() ? std::nullopt : std::optional(found->second);
}

/// Reads a reference. Throws InputError if it is a part of one: the rest of it is black.
image::ExrFile readReference(const std::filesystem::path& path) {
    image::ExrFile file = image::readExr(path);
    if (const auto part = attribute(file, "part"))
        throw InputError({path.string()},
                         fmt::format("this is part {} of a reference: merge the parts first", *part));
    return file;
}

/// Throws InputError if the halves share their noise, so that it would seem to be none.
void requireIndependent(const CompareArguments& arguments, const image::ExrFile& first,
                        const image::ExrFile& second) {
    const auto fail = [&](const std::string& what) {
        throw InputError({arguments.secondHalf.string()},
                         fmt::format("{} {}: the halves of a reference must be independent", what,
                                     arguments.reference.string()));
    };
    const auto seed = attribute(second, "seed");
    if (seed && seed == attribute(first, "seed")) fail(fmt::format("its seed is {}, as that of", *seed));
    const bool isBlack = std::all_of(first.image.pixels.begin(), first.image.pixels.end(),
                                     [](float value) { return value == 0; });
    if (!isBlack && first.image.pixels == second.image.pixels) fail("it is the same picture as");
}

/// Throws InputError if a file is no picture or does not fit the reference.
Pictures readPictures(const CompareArguments& arguments) {
    const std::string reference = arguments.reference.string();
    const image::ExrFile first = readReference(arguments.reference);
    Pictures pictures{image::readExr(arguments.picture).image, first.image, {}};
    image::requireComparable(pictures.reference, reference, pictures.reference, reference);
    image::requireComparable(pictures.picture, arguments.picture.string(), pictures.reference, reference);
    if (arguments.secondHalf.empty()) return pictures;
    image::ExrFile second = readReference(arguments.secondHalf);
    image::requireComparable(second.image, arguments.secondHalf.string(), pictures.reference, reference);
    requireIndependent(arguments, first, second);
    pictures.secondHalf = std::move(second.image);
    return pictures;
}

struct Comparison {
    image::Metrics metrics;
    std::optional<image::HeatMap> heatMap;
};

std::string jsonOf(const Comparison& comparison, const CompareArguments& arguments) {
    Json::Value json = image::toJson(comparison.metrics);
    json["bins"] = arguments.bins;
    if (comparison.heatMap) json["heatmapRange"] = comparison.heatMap->range;
    Json::StreamWriterBuilder builder;
    builder["indentation"] = "  ";
    builder["precision"] = 17;
    return Json::writeString(builder, json) + "\n";
}

std::string tableOf(const Comparison& comparison, const CompareArguments& arguments) {
    std::string text = image::toTable(comparison.metrics);
    if (arguments.bins > 1) text += fmt::format("all of blocks of {0} x {0} pixels\n", arguments.bins);
    if (comparison.heatMap)
        text +=
            fmt::format("{}: relative error from 0 (dark violet) to {:g} (yellow) of the reference's mean\n",
                        arguments.heatMap.string(), comparison.heatMap->range);
    return text;
}

void compare(const CompareArguments& arguments) {
    requireUsable(arguments);
    const Pictures pictures = readPictures(arguments);
    Comparison comparison{
        image::compareImages(pictures.picture, pictures.reference, pictures.half(), {.bins = arguments.bins}),
        {}};
    if (!arguments.heatMap.empty())
        comparison.heatMap = image::heatMap(pictures.picture, pictures.reference, pictures.half(),
                                            arguments.bins, arguments.heatMapRange);

    // The JSON file appears only once the heat map has been written.
    std::optional<image::OutputFile> json;
    if (!arguments.json.empty()) {
        json.emplace(arguments.json);
        json->write(jsonOf(comparison, arguments));
    }
    if (comparison.heatMap) image::writePng(arguments.heatMap, comparison.heatMap->picture);
    if (json) json->commit();
    const bool printsJson = arguments.wantsJson && arguments.json.empty();
    fmt::print("{}", printsJson ? jsonOf(comparison, arguments) : tableOf(comparison, arguments));
}

}  // namespace

void addCompareVerb(CLI::App& app, Action& action) {
    CLI::App* verb = app.add_subcommand("compare", "Print how far a picture is from a reference");
    auto arguments = std::make_shared<CompareArguments>();
    verb->add_option("image", arguments->picture, "The picture: an EXR file with channels R, G, B")
        ->required();
    verb->add_option("reference", arguments->reference, "What it should be")->required();
    verb->add_option("second-half", arguments->secondHalf,
                     "An independent reference of the same scene: the two are averaged, and errors are also "
                     "estimated without their noise");
    CLI::Option* json = verb->add_option("--json", arguments->json,
                                         "Write JSON to this file (*.json), or print it instead of the table")
                            ->expected(0, 1);
    verb->add_option("--heatmap", arguments->heatMap, "Paint the relative error of each pixel: F.png");
    verb->add_option("--heatmap-range", arguments->heatMapRange,
                     "The relative error that the brightest colour stands for (default: as needed)");
    verb->add_option("--bins", arguments->bins, "Compare means of blocks of N x N pixels")
        ->capture_default_str();
    verb->callback([&action, arguments, json] {
        arguments->wantsJson = json->count() > 0;
        action = [arguments] { compare(*arguments); };
    });
}

}  // namespace nephrite::tools
