// What of a photon's walk does not depend on who counts.
#include "scattering/photon_walk.h"

#include <algorithm>
#include <limits>
#include <numbers>

#include "scattering/phase.h"

namespace nephrite::scattering {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

struct Vector {
    double x, y, z;
};

/// The direction at an angle to the unit vector `axis`, given its cosine and its azimuth around the axis. The
/// basis is that of Duff et al. (2017), which has no singular direction.
Vector deflected(const Vector& axis, double cosine, double azimuth) {
    const double sign = std::copysign(1.0, axis.z);
    const double a = -1 / (sign + axis.z);
    const double b = axis.x * axis.y * a;
    const Vector first{1 + sign * axis.x * axis.x * a, sign * b, -sign * axis.x};
    const Vector second{b, sign + axis.y * axis.y * a, -axis.y};
    const double sine = std::sqrt(std::max(0.0, (1 - cosine) * (1 + cosine)));
    const double p = sine * std::cos(azimuth);
    const double q = sine * std::sin(azimuth);
    return {first.x * p + second.x * q + axis.x * cosine, first.y * p + second.y * q + axis.y * cosine,
            first.z * p + second.z * q + axis.z * cosine};
}

}  // namespace

PhotonWalk::PhotonWalk(const LayerStack& stack) : g_(stack.g), eta_(stack.eta) {
    double top = 0;
    for (const Layer& layer : stack.layers) {
        if (layer.thickness <= 0) continue;
        // Scattering straight ahead is none.
        const double scattering = stack.g < 1 ? layer.scattering : 0;
        const Medium medium{layer.absorption, scattering, stack.g, stack.eta};
        const double absorbedShare = extinction(medium) > 0 ? layer.absorption / extinction(medium) : 0;
        slices_.push_back(
            {top, top + layer.thickness, extinction(medium), albedo(medium), absorbedShare, depth_});
        top += layer.thickness;
        if (extinction(medium) > 0) depth_ += extinction(medium) * layer.thickness;
    }
    // A stack of no thickness: light passes between its two boundaries.
    if (slices_.empty()) slices_.push_back({0, 0, 0, 0, 0, 0});
}

/// Along the way to the front or the back.
double PhotonWalk::opticalDepthAhead(const Photon& photon) const {
    const Slice& slice = slices_[photon.slice];
    if (photon.dz == 0) return slice.extinction > 0 ? infinity : 0;
    const double depth = slice.depthAbove + slice.extinction * (photon.z - slice.top);
    return std::max(0.0, photon.dz < 0 ? depth : depth_ - depth) / std::abs(photon.dz);
}

/// The same in mm.
double PhotonWalk::distanceAhead(const Photon& photon) const {
    if (photon.dz == 0) return infinity;
    const double boundary = photon.dz < 0 ? 0 : slices_.back().bottom;
    return std::max(0.0, (boundary - photon.z) / photon.dz);
}

/// By an optical depth that is not more than is ahead.
void PhotonWalk::advance(Photon& photon, double opticalDepth) const {
    double distance = 0;
    double z = photon.z;
    for (;;) {
        const Slice& slice = slices_[photon.slice];
        const double boundary = photon.dz < 0 ? slice.top : slice.bottom;
        const double across = photon.dz == 0 ? infinity : std::max(0.0, (boundary - z) / photon.dz);
        const bool isLast = photon.dz < 0 ? photon.slice == 0 : photon.slice + 1 == slices_.size();
        if (isLast || opticalDepth < slice.extinction * across) {
            if (slice.extinction > 0) distance += std::min(across, opticalDepth / slice.extinction);
            break;
        }
        opticalDepth -= slice.extinction * across;
        distance += across;
        z = boundary;
        photon.slice += photon.dz < 0 ? -1 : 1;
    }
    photon.x += distance * photon.dx;
    photon.y += distance * photon.dy;
    photon.z += distance * photon.dz;
}

/// At the front or the back, whichever is ahead.
void PhotonWalk::turnBack(Photon& photon) const {
    const double distance = distanceAhead(photon);
    photon.x += distance * photon.dx;
    photon.y += distance * photon.dy;
    photon.slice = photon.dz < 0 ? 0 : static_cast<std::uint32_t>(slices_.size() - 1);
    photon.z = photon.dz < 0 ? 0 : slices_.back().bottom;
    photon.dz = -photon.dz;
}

/// To a direction whose angle `choice`, in [0, 1), picks from the phase function.
void PhotonWalk::turn(Photon& photon, double choice, Random& random) const {
    const double cosine = sampleHenyeyGreenstein(g_, choice);
    const double azimuth = 2 * std::numbers::pi * random.uniform();
    const Vector next = deflected({photon.dx, photon.dy, photon.dz}, cosine, azimuth);
    // Rounding must not add up over a million turns.
    const double length = std::sqrt(next.x * next.x + next.y * next.y + next.z * next.z);
    photon.dx = next.x / length;
    photon.dy = next.y / length;
    photon.dz = next.z / length;
}

}  // namespace nephrite::scattering
