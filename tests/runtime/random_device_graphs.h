// Random graph files of the passes in random_device_passes.h, with what happens to them from frame to frame.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "graph/pass_type.h"

namespace nephrite::runtime::test {

struct RandomDeviceGraph {
    std::string json;
    std::vector<std::string> dumps;
    std::uint32_t scene = 0;            ///< of writeRandomScenes
    std::vector<std::string> settings;  ///< of each frame, before it is rendered; "" for none
};

/// The same seed gives the same graph: 6 to 22 nodes, pictures of at most 48 x 48 pixels, three frames. The
/// library has the passes of randomPassNames().
RandomDeviceGraph randomDeviceGraph(std::uint64_t seed, const graph::PassLibrary& library);

}  // namespace nephrite::runtime::test
