// One photon's way through a layer stack: flights, collisions, boundaries, roulette.
//
// A photon carries weight. Collisions take the absorbed share of it, boundaries let the transmitted share out
// and reflect the rest, and roulette ends what is no longer worth following. A tally hears where every share
// goes.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "scattering/layer_stack.h"
#include "scattering/random.h"

namespace nephrite::scattering {

/// Weight that leaves through the front or the back.
struct Exit {
    double weight = 0;
    double radius = 0;              ///< from the axis of entry, mm
    std::uint32_t scatterings = 0;  ///< how often it was scattered
};

/// A stack made ready to be walked through. The tally has these members:
///
///     void reflected(const Exit&);      // through the front
///     void transmitted(const Exit&);    // through the back, or in a half space to where nothing scatters or
///     absorbs void absorbed(double weight); void lost(double weight);         // by roulette; negative what
///     survivors gain, so that the mean is 0
///
/// What a tally hears of one photon adds up to 1, but for rounding.
class PhotonWalk {
  public:
    explicit PhotonWalk(const LayerStack& stack);

    /// Follows a photon of weight 1 that has just entered perpendicularly.
    template<class Tally>
    void follow(Random& random, Tally& tally) const;

  private:
    struct Slice {
        double top;
        double bottom;
        double extinction;
        double albedo;
        double absorbedShare;
    };
    struct Photon {
        double x = 0, y = 0, z = 0;
        double dx = 0, dy = 0, dz = 1;
        double weight = 1;
        std::uint32_t slice = 0;
        std::uint32_t scatterings = 0;
        bool alive = true;
    };

    template<class Tally>
    void fly(Photon& photon, Random& random, Tally& tally) const;
    template<class Tally>
    void collide(Photon& photon, Random& random, Tally& tally) const;
    template<class Tally>
    void meetBoundary(Photon& photon, Random& random, Tally& tally) const;
    template<class Tally>
    static void playRoulette(Photon& photon, double survival, Random& random, Tally& tally);

    static double distanceToBoundary(const Photon& photon, const Slice& slice);
    static void advance(Photon& photon, double distance);
    void turn(Photon& photon, Random& random) const;
    double boundaryReflectance(double cosineInside) const;

    std::vector<Slice> slices_;
    double g_;
    double eta_;
};

template<class Tally>
void PhotonWalk::follow(Random& random, Tally& tally) const {
    Photon photon;
    while (photon.alive) {
        fly(photon, random, tally);
        if (photon.alive) collide(photon, random, tally);
    }
}

/// Moves to the next collision, through any number of layers and boundaries.
template<class Tally>
void PhotonWalk::fly(Photon& photon, Random& random, Tally& tally) const {
    double opticalDepth = random.exponential();
    while (photon.alive) {
        const Slice& slice = slices_[photon.slice];
        const double distance = distanceToBoundary(photon, slice);
        if (slice.extinction > 0 && opticalDepth < slice.extinction * distance) {
            advance(photon, opticalDepth / slice.extinction);
            return;
        }
        if (std::isinf(distance)) {
            tally.transmitted({photon.weight, 0, photon.scatterings});
            photon.alive = false;
            return;
        }
        opticalDepth -= slice.extinction * distance;
        advance(photon, distance);
        meetBoundary(photon, random, tally);
    }
}

template<class Tally>
void PhotonWalk::collide(Photon& photon, Random& random, Tally& tally) const {
    constexpr std::uint32_t manyScatterings = 1u << 10;
    constexpr std::uint32_t tooManyScatterings = 1u << 26;
    const Slice& slice = slices_[photon.slice];
    tally.absorbed(photon.weight * slice.absorbedShare);
    photon.weight *= slice.albedo;
    ++photon.scatterings;
    // How long a photon wanders where nothing absorbs has no mean: from a thousand scatterings on, each
    // doubling must be survived.
    const bool doubled = (photon.scatterings & (photon.scatterings - 1)) == 0;
    if (photon.scatterings >= tooManyScatterings || photon.weight == 0) {
        tally.lost(photon.weight);
        photon.alive = false;
    } else if (doubled && photon.scatterings >= manyScatterings) {
        playRoulette(photon, std::sqrt(0.5), random, tally);
    }
    playRoulette(photon, photon.weight < 0.1 ? 0.5 : 1, random, tally);
    if (photon.alive) turn(photon, random);
}

/// Between layers nothing happens; at the front and the back part of the weight leaves and the rest turns
/// around.
template<class Tally>
void PhotonWalk::meetBoundary(Photon& photon, Random& random, Tally& tally) const {
    const bool down = photon.dz > 0;
    const Slice& slice = slices_[photon.slice];
    photon.z = down ? slice.bottom : slice.top;
    if (down && photon.slice + 1 < slices_.size()) {
        ++photon.slice;
        return;
    }
    if (!down && photon.slice > 0) {
        --photon.slice;
        return;
    }
    const double reflectance = boundaryReflectance(std::abs(photon.dz));
    const Exit exit{photon.weight * (1 - reflectance), std::hypot(photon.x, photon.y), photon.scatterings};
    if (down)
        tally.transmitted(exit);
    else
        tally.reflected(exit);
    photon.weight -= exit.weight;
    photon.dz = -photon.dz;
    photon.alive = photon.weight > 0;
    playRoulette(photon, photon.weight < 0.1 ? 0.5 : 1, random, tally);
}

template<class Tally>
void PhotonWalk::playRoulette(Photon& photon, double survival, Random& random, Tally& tally) {
    if (!photon.alive || survival >= 1) return;
    const double before = photon.weight;
    photon.alive = random.uniform() < survival;
    photon.weight = photon.alive ? before / survival : 0;
    tally.lost(before - photon.weight);
}

}  // namespace nephrite::scattering
