// A tiny suite for the tests of `nephrite bench pareto`, and the files that it leaves.
#pragma once

#include <json/json.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace nephrite::tools::test {

inline const std::string graphs = NEPHRITE_SOURCE_DIR "/graphs/";

/// A suite of one sphere. The maps of the lights are small, so that frames take milliseconds.
inline std::string suite(const std::string& members = "", const std::string& samples = "2",
                         const std::string& scene = graphs + "scenes/sphere.json") {
    return R"({ "name": "tiny", "size": [16, 16], "frames": 4, "warmup": 1, "baseline": "screen-space",
 "scenes": {"sphere": {"scene": ")" +
           scene + R"(", "bins": 4,
   "references": {"volume": {"spp": )" +
           samples + R"(}, "dipole": {"spp": 1, "fluxPoints": 4096}}}},
 "methods": {
   "screen-space": {"graph": ")" +
           graphs + R"(screen-space.json", "skip": false, "set": {"lightSize": 64},
                    "against": {"volume": "color", "dipole": "multiple.radiance"}},
   "lambert": {"graph": ")" +
           graphs + R"(lambert-albedo.json", "vary": {"lightSize": [32, 64]}},
   "exact": {"references": ["dipole"]} })" +
           members + "}";
}

inline Json::Value readJson(const std::filesystem::path& file) {
    Json::Value value;
    std::ifstream(file) >> value;
    return value;
}

inline std::string bytesOf(const std::filesystem::path& file) {
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
}

}  // namespace nephrite::tools::test
