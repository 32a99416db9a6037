// What a device adds to a plan once its frames were rendered: times and small pictures, as plain data.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace nephrite::graph {

/// Medians over the measured frames.
struct PassFigures {
    double gpuMs = 0;
    double cpuMs = 0;    ///< recording its commands
    bool rests = false;  ///< in a frame in which nothing has changed it does not run
};

/// A small picture of a port's image: its first level and layer.
struct PortPicture {
    std::vector<std::byte> png;  ///< empty: there is none
    std::string scale;           ///< how values became what is seen: "exposure x 2.1"
};

struct PlanMeasurements {
    std::string device;                 ///< and its driver
    std::string note;                   ///< why there are no times or pictures; empty: there are
    std::uint32_t frames = 0;           ///< that were measured; 0: none, and `passes` is empty
    double frameMs = 0;                 ///< median from a frame's start to its end, each pass timed alone
    std::vector<PassFigures> passes;    ///< as Plan::passes
    std::vector<PortPicture> pictures;  ///< by output port (LinkedNode::formats); empty: none at all
};

}  // namespace nephrite::graph
