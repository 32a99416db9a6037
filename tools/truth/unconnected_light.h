// Light that reaches a medium by paths that connect() leaves out: focused light, and light that was refracted
// out and in again or mirrored, inside an object or by another's surface, before its first scattering.
//
// Photons leave each light on a jittered grid over the cone that holds the scene. What they bring is kept as
// points that each carry a share of the fluence.
#pragma once

#include <cstdint>
#include <vector>

#include "truth/photon.h"
#include "truth/world.h"

namespace nephrite::truth {

struct UnconnectedLight {
    std::vector<std::vector<FluencePoint>> points;  ///< by object
    /// Its part of the fluence behind refracting boundaries, 0 to 1.
    double share = 0;
};

/// Whether there is such light: a translucent object has a boundary that refracts.
bool hasUnconnectedLight(const World& world);

/// An independent set of photons.
struct PhotonSet {
    std::uint32_t photons = 1 << 18;  ///< from each light, about: exactly the square below
    std::uint64_t seed = 1;
    std::uint32_t number = 0;  ///< of those with this seed
};

/// Depends on world and set alone, not on the threads.
UnconnectedLight traceUnconnectedLight(const World& world, const PhotonSet& set, unsigned threads);

}  // namespace nephrite::truth
