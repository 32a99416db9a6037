// How a graph wants its pictures to be shown.
#pragma once

#include "graph/plan.h"
#include "image/tone_map.h"

namespace nephrite::runtime {

/// By the graph parameter `exposure`, if it has one; 0 stands for automatic exposure.
image::ToneMapping toneMapping(const graph::Plan& plan);

}  // namespace nephrite::runtime
