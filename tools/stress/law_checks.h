// The checks of laws that hold between pictures, apart from the scenes they are held against.
#pragma once

#include <string>
#include <vector>

#include "stress/device.h"
#include "stress/outcome.h"
#include "stress/scene_values.h"

namespace nephrite::stress {

/// Scenes whose pictures must have the same means as that of their limit.
struct Limit {
    std::string name;
    std::vector<SceneValues> scenes;
    SceneValues limit;
    double tolerance;  ///< relative
};

void checkLimit(const Limit& law, const std::vector<GraphChoice>& graphs, const Place& place,
                Outcome& outcome);

/// The more of absorption, 0 to 10 /mm, the darker the picture of a sphere, in each channel.
void checkFallsWithAbsorption(const MaterialValues& material, const std::vector<GraphChoice>& graphs,
                              const Place& place, Outcome& outcome);

/// The mean of the picture is the same at 256 x 256 and 1024 x 1024 pixels within 1 %.
void checkSameAtEverySize(const SceneValues& scene, const std::vector<GraphChoice>& graphs,
                          const Place& place, Outcome& outcome);

/// A sphere of the material, which absorbs nothing, sends out no more than 3 % more than what enters it from
/// a point light, and more than a third: what leaves is summed over all directions.
void checkKeepsPower(const MaterialValues& material, const GraphChoice& graph, const Place& place,
                     Outcome& outcome);

}  // namespace nephrite::stress
