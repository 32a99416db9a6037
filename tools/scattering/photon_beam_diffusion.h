// Photon beam diffusion of Habel, Christensen and Jarosz (2013): better dipoles all along the refracted ray
// instead of one at a mean free path, damped where diffusion cannot hold, and exact single scattering.
#pragma once

#include <vector>

#include "scattering/better_dipole.h"
#include "scattering/single_scattering.h"

namespace nephrite::scattering {

/// All per unit of power that enters the medium; radii in mm.
class PhotonBeamDiffusion {
  public:
    /// `depths` sources stand for the ray, one at the middle of each equal share of its first collisions.
    explicit PhotonBeamDiffusion(const Medium& medium, int depths = 100);

    /// R_d(r): radiant exitance, 1/mm^2, single scattering included; see there for what happens on the axis.
    double exitance(double radius) const { return multipleExitance(radius) + single_.exitance(radius); }
    double total() const { return multipleTotal_ + single_.total(); }
    double fractionWithin(double radius) const;
    /// A radius distributed as 2 pi r R_d(r) / total, exactly. The total must not be 0.
    double sampleRadius(Random& random) const;

    const SingleScattering& single() const { return single_; }

  private:
    double multipleExitance(double radius) const;
    double multipleWithin(double radius) const;
    double dampedWithin(double radius) const;
    double sampleMultiple(Random& random) const;
    double damping(const MirroredSource& source, double radius) const;

    double extinction_;  ///< sigma_t'
    double strength_;    ///< of each source: alpha'^2 over their number
    std::vector<MirroredSource> sources_;
    std::vector<double> running_;  ///< undamped totals of the sources so far, for choosing among them
    SingleScattering single_;
    double multipleTotal_ = 0;
};

}  // namespace nephrite::scattering
