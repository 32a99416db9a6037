// One photon's way through a layer stack: flights, collisions, boundaries, roulette.
//
// A photon carries weight. On every flight towards the front or the back the share that would leave does
// leave; the rest is reflected there or collides before, by chance which. Collisions take the absorbed share
// of the weight, and roulette ends what is no longer worth following. A tally hears where every share goes.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "scattering/fresnel.h"
#include "scattering/layer_stack.h"
#include "scattering/random.h"

namespace nephrite::scattering {

/// Weight that leaves through the front or the back.
struct Exit {
    double weight = 0;
    double radius = 0;              ///< from the axis of entry, mm
    std::uint32_t scatterings = 0;  ///< how often it was scattered
};

/// Where, in [0, 1), the first two random choices of a photon lie: how deep it collides and by how much it
/// turns there. Chosen evenly over many photons they make their mean less noisy.
struct FirstChoices {
    double depth = 0;
    double turn = 0;
};

/// A stack made ready to be walked through. The tally has these members:
///
///     void reflected(const Exit&);
///     void transmitted(const Exit&);
///     void absorbed(double weight);
///     void lost(double weight);
///
/// `reflected` is what leaves through the front, `transmitted` through the back, or in a half space to where
/// nothing scatters or absorbs. `lost` is what roulette takes, negative what it gives to survivors, so that
/// its mean is 0. What a tally hears of one photon adds up to 1, but for rounding.
class PhotonWalk {
  public:
    explicit PhotonWalk(const LayerStack& stack);

    /// Follows a photon of weight 1 that has just entered perpendicularly.
    template<class Tally>
    void follow(Random& random, Tally& tally) const {
        const double depth = random.uniform();
        follow({depth, random.uniform()}, random, tally);
    }
    template<class Tally>
    void follow(const FirstChoices& first, Random& random, Tally& tally) const;

  private:
    struct Slice {
        double top;     ///< mm
        double bottom;  ///< mm
        double extinction;
        double albedo;
        double absorbedShare;
        double depthAbove;  ///< optical, of all slices above
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
    void fly(Photon& photon, double choice, Random& random, Tally& tally) const;
    template<class Tally>
    double leave(Photon& photon, double reaching, Tally& tally) const;
    template<class Tally>
    void collide(Photon& photon, Random& random, Tally& tally) const;
    template<class Tally>
    static void playRoulette(Photon& photon, double survival, Random& random, Tally& tally);

    double opticalDepthAhead(const Photon& photon) const;
    double distanceAhead(const Photon& photon) const;
    void advance(Photon& photon, double opticalDepth) const;
    void turnBack(Photon& photon) const;
    void turn(Photon& photon, double choice, Random& random) const;

    std::vector<Slice> slices_;
    double depth_ = 0;  ///< optical, of all slices
    double g_;
    double eta_;
};

template<class Tally>
void PhotonWalk::follow(const FirstChoices& first, Random& random, Tally& tally) const {
    Photon photon;
    fly(photon, first.depth, random, tally);
    if (photon.alive) collide(photon, random, tally);
    if (photon.alive) turn(photon, first.turn, random);
    while (photon.alive) {
        fly(photon, random.uniform(), random, tally);
        if (photon.alive) collide(photon, random, tally);
        if (photon.alive) turn(photon, random.uniform(), random);
    }
}

/// Moves to the next collision, through any number of layers and reflections. `choice`, in [0, 1), is made
/// among what does not leave.
template<class Tally>
void PhotonWalk::fly(Photon& photon, double choice, Random& random, Tally& tally) const {
    constexpr double opaque = 40;  // what gets through is below the smallest choice
    while (photon.alive) {
        const double ahead = opticalDepthAhead(photon);
        const double colliding = ahead < opaque ? -std::expm1(-ahead) : 1;
        const double leaving = ahead < opaque ? leave(photon, 1 - colliding, tally) : 0;
        if (!photon.alive) return;
        const double chosen = choice * (1 - leaving);
        if (chosen < colliding) return advance(photon, std::min(-std::log1p(-chosen), ahead));
        turnBack(photon);
        playRoulette(photon, photon.weight < 0.1 ? 0.5 : 1, random, tally);
        choice = random.uniform();
    }
}

/// Lets out what of the share `reaching` of the weight the boundary ahead lets through; gives the share of
/// the weight that has left.
template<class Tally>
double PhotonWalk::leave(Photon& photon, double reaching, Tally& tally) const {
    const double distance = distanceAhead(photon);
    const bool isEndless = std::isinf(distance);
    const double share =
        isEndless ? reaching : reaching * (1 - reflectanceFromInside(std::abs(photon.dz), eta_));
    const double radius =
        isEndless ? 0 : std::hypot(photon.x + distance * photon.dx, photon.y + distance * photon.dy);
    const Exit exit{photon.weight * share, radius, photon.scatterings};
    if (photon.dz < 0)
        tally.reflected(exit);
    else
        tally.transmitted(exit);
    photon.weight -= exit.weight;
    photon.alive = photon.weight > 0;
    return share;
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
