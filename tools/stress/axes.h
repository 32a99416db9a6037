// What makes a scene nasty, one value at a time, sorted by what it changes; and sets of scenes in which all
// pairs of such values meet.
#pragma once

#include <string>
#include <vector>

#include "stress/scene_values.h"

namespace nephrite::stress {

struct Nasty {
    std::string name;
    void (*apply)(SceneValues&);
};

/// Values that exclude each other. Not applying any is a value too.
struct Axis {
    std::string name;
    std::vector<Nasty> values;
};

/// Coefficients, phase function, index, layers, lights, view, objects, scale. To be applied in this order.
const std::vector<Axis>& axes();

struct NamedScene {
    std::string name;  ///< what was applied, with + between
    SceneValues scene;
};

/// Each value alone, on a sphere; and on a slab, where the value leaves the object alone.
std::vector<NamedScene> singleScenes();
/// Few scenes in which every pair of values of different axes occurs at least once: a covering array, made
/// greedily, the same each time (Cohen et al., "The AETG system", 1997).
std::vector<NamedScene> pairScenes();

}  // namespace nephrite::stress
