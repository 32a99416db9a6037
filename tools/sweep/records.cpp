// Records as JSON files.
#include "sweep/records.h"

#include <system_error>

#include "image/output_file.h"
#include "text/digest.h"
#include "text/json_write.h"
#include "truth/run_record.h"

namespace nephrite::sweep {
namespace {

Json::Value recordAt(const std::filesystem::path& file) {
    std::error_code ignored;
    if (!std::filesystem::exists(file, ignored)) return {};
    try {
        return json::parseFile(file).raw();
    } catch (const InputError&) {
        return {};  // not ours, or of a disk that was full: made anew
    }
}

/// The same from whichever folder the program is called.
std::string relativeTo(const Sweep& sweep, const std::filesystem::path& file) {
    if (file.empty()) return {};
    const std::filesystem::path folder = std::filesystem::absolute(sweep.file).parent_path();
    return std::filesystem::absolute(file).lexically_proximate(folder).string();
}

}  // namespace

Json::Value requestOf(const Sweep& sweep, const Run& run) {
    Json::Value request;
    request["scene"] = relativeTo(sweep, run.scene->file);
    request["reference"] = relativeTo(sweep, run.scene->reference);
    request["secondHalf"] = relativeTo(sweep, run.scene->secondHalf);
    request["bins"] = run.scene->bins;
    request["graph"] = relativeTo(sweep, run.graph->file);
    request["skip"] = run.graph->skip;
    request["settings"] = Json::arrayValue;
    for (const std::string& setting : run.settings()) request["settings"].append(setting);
    request["width"] = run.size.width;
    request["height"] = run.size.height;
    request["frames"] = sweep.frames;
    request["warmup"] = sweep.warmup;
    request["time"] = sweep.time;
    request["timings"] = sweep.timings;
    request["passes"] = sweep.passes;
    request["port"] = sweep.port;
    request["pictures"] = static_cast<int>(sweep.pictures);
    return request;
}

std::filesystem::path Records::fileOf(const Run& run) const {
    return folder_ / "runs" / (run.id() + ".json");
}

std::string Records::digestOf(const std::filesystem::path& file) {
    std::error_code missing;
    const auto written = std::filesystem::last_write_time(file, missing);
    if (missing || !std::filesystem::is_regular_file(file, missing)) return "missing";
    KnownFile& known = known_[file];
    if (known.digest.empty() || known.written != written) known = {written, truth::digestOf({file})};
    return known.digest;
}

std::string Records::digestOf(const std::vector<std::filesystem::path>& files) {
    Digest all;
    for (const std::filesystem::path& file : files) all.add(digestOf(file) + " ");
    return all.text();
}

std::optional<Json::Value> Records::find(const Sweep& sweep, const Run& run) {
    const Json::Value record = recordAt(fileOf(run));
    if (!record.isObject() || !record["files"].isArray() || !record["row"].isObject()) return std::nullopt;
    // Compared as text: a whole number that was read may be of another type than the one written.
    if (json::toText(record["request"]) != json::toText(requestOf(sweep, run))) return std::nullopt;
    std::vector<std::filesystem::path> files;
    for (const Json::Value& file : record["files"])
        if (file.isString()) files.emplace_back(file.asString());
    if (record["filesDigest"] != digestOf(files)) return std::nullopt;
    const Json::Value& picture = record["row"]["picture"];
    std::error_code ignored;
    if (picture.isString() && !std::filesystem::exists(folder_ / picture.asString(), ignored))
        return std::nullopt;
    return record["row"];
}

void Records::write(const Sweep& sweep, const Run& run, const std::vector<std::filesystem::path>& files,
                    const Json::Value& row) {
    Json::Value record;
    record["request"] = requestOf(sweep, run);
    record["files"] = Json::arrayValue;
    for (const std::filesystem::path& file : files) record["files"].append(file.string());
    record["filesDigest"] = digestOf(files);
    record["row"] = row;
    image::writeFile(fileOf(run), json::toText(record));
}

}  // namespace nephrite::sweep
