// A timing dump read back: what `render --timings F.json` wrote.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "text/json.h"

namespace nephrite::timings {

/// Times of one thing, frame after frame, in milliseconds.
struct Series {
    std::string name;
    bool isPass = true;  ///< false: a part of the frame, or all of it
    std::vector<double> ms;
};

struct Dump {
    std::string file;
    std::string device;
    std::string driver;
    std::string scene;
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    bool profiled = false;
    std::vector<Series> series;  ///< passes in their order, then "recording", "waiting" and "wall"
};

/// Throws InputError with every fault of what is needed, or one line if it is something else altogether;
/// other keys are not looked at.
Dump readDump(const json::Value& value);
Dump readDump(const std::filesystem::path& file);

}  // namespace nephrite::timings
