// What each of the five layers of skipping leaves out, by name.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "graph/plan.h"
#include "runtime/frame/timings.h"

namespace nephrite::view {

struct LeftOut {
    std::string node;
    std::string why;
};

struct SkipLayer {
    const char* name;
    const char* meaning;
    std::vector<LeftOut> nodes;
};

/// Of a plan and its last frame (whose times may be of no pass: then nothing is known of layer 3).
std::array<SkipLayer, 5> skipLayers(const graph::Plan& plan, const runtime::FrameTimes& last);

}  // namespace nephrite::view
