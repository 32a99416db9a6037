// What is looked at, and how it is made visible.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "graph/display.h"

namespace nephrite::view {

/// Members that the pass `display` has too mean the same here.
struct PictureChoice {
    std::string port;  ///< as a graph file names it
    double exposure = 1;
    std::uint32_t channel = 0;
    std::uint32_t curve = 1;
    std::uint32_t level = 0;
    std::uint32_t layer = 0;
    bool difference = false;
    std::filesystem::path reference;  ///< an EXR file; empty: none

    friend bool operator==(const PictureChoice&, const PictureChoice&) = default;
};

/// `PARAM=JSON` for the pass `display`.
std::vector<std::string> displaySettings(const PictureChoice& choice);
graph::Display displayOf(const PictureChoice& choice);

}  // namespace nephrite::view
