// What of a photon's walk does not depend on who counts.
#include "scattering/photon_walk.h"

#include <algorithm>
#include <limits>
#include <numbers>

#include "scattering/fresnel.h"
#include "scattering/phase.h"

namespace nephrite::scattering {
namespace {

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
        slices_.push_back({top, top + layer.thickness, extinction(medium), albedo(medium), absorbedShare});
        top += layer.thickness;
    }
    // A stack of no thickness: light passes between its two boundaries.
    if (slices_.empty()) slices_.push_back({0, 0, 0, 0, 0});
}

double PhotonWalk::distanceToBoundary(const Photon& photon, const Slice& slice) {
    if (photon.dz == 0) return std::numeric_limits<double>::infinity();
    const double boundary = photon.dz > 0 ? slice.bottom : slice.top;
    return std::max(0.0, (boundary - photon.z) / photon.dz);
}

void PhotonWalk::advance(Photon& photon, double distance) {
    photon.x += photon.dx * distance;
    photon.y += photon.dy * distance;
    photon.z += photon.dz * distance;
}

void PhotonWalk::turn(Photon& photon, Random& random) const {
    const double cosine = sampleHenyeyGreenstein(g_, random.uniform());
    const double azimuth = 2 * std::numbers::pi * random.uniform();
    const Vector next = deflected({photon.dx, photon.dy, photon.dz}, cosine, azimuth);
    // Rounding must not add up over a million turns.
    const double length = std::sqrt(next.x * next.x + next.y * next.y + next.z * next.z);
    photon.dx = next.x / length;
    photon.dy = next.y / length;
    photon.dz = next.z / length;
}

double PhotonWalk::boundaryReflectance(double cosineInside) const {
    return reflectanceFromInside(cosineInside, eta_);
}

}  // namespace nephrite::scattering
