// The dipole as Jensen, Marschner, Levoy and Hanrahan (2001) print it, in extended precision: what the double
// version and the shaders' are held against.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scattering/medium.h"

namespace nephrite::scattering {

/// The formulas, with Egan and Hilgeman's fit of F_dr, limited to 0.999 as everywhere.
class PaperDipole {
  public:
    using Real = long double;

    explicit PaperDipole(const Medium& medium) {
        const Real absorption = medium.absorption;
        const Real scattering = (1 - Real(medium.g)) * medium.scattering;
        if (scattering == 0) return;
        const Real extinction = scattering + absorption;
        const Real eta = medium.eta;
        const Real fit = eta >= 1
                             ? -1.440L / (eta * eta) + .710L / eta + .668L + .0636L * eta
                             : -.4399L + .7099L / eta - .3319L / (eta * eta) + .0636L / (eta * eta * eta);
        const Real reflectance = std::min(fit, .999L);
        albedo_ = scattering / extinction;
        decay_ = std::sqrt(3 * absorption * extinction);
        realDepth_ = 1 / extinction;
        virtualDepth_ = realDepth_ * (1 + 4 * (1 + reflectance) / (1 - reflectance) / 3);
    }

    /// R_d(r), 1/mm^2.
    Real exitance(Real radius) const {
        Real sum = 0;
        for (const Real z : {realDepth_, virtualDepth_}) {
            const Real d = std::sqrt(radius * radius + z * z);
            sum += z * (1 + decay_ * d) * std::exp(-decay_ * d) / (d * d * d);
        }
        return albedo_ / (4 * std::numbers::pi_v<Real>)*sum;
    }

    /// The integral of R_d over the surface.
    Real total() const {
        return albedo_ / 2 * (std::exp(-decay_ * realDepth_) + std::exp(-decay_ * virtualDepth_));
    }

  private:
    Real albedo_ = 0;                        ///< alpha'
    Real decay_ = 0;                         ///< sigma_tr, 1/mm
    Real realDepth_ = 1, virtualDepth_ = 1;  ///< mm
};

}  // namespace nephrite::scattering
