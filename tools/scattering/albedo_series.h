// Reflectance of a half space for every albedo at once.
//
// Where photons go does not depend on the albedo; only how much is left of them does. So one Monte Carlo run
// without absorption that notes after how many scatterings light leaves gives R(albedo) = sum_n R_n albedo^n
// for all albedos.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "scattering/montecarlo.h"

namespace nephrite::scattering {

/// The sum above over `albedo`, for perpendicular entry, isotropic scattering and the relative index `eta`:
/// the fraction of *entering* power that leaves again, divided by the albedo. That quotient has a limit at 0:
/// the share of single scattering. One estimate an albedo; those of one run are correlated. Scatterings
/// beyond `longestSeries` are left out, so albedos should stay below 0.999. `settings.photons` are rounded up
/// to whole batches of 4,096. Returns nothing if `settings.work.proceed` stopped the run.
std::vector<Estimate> reflectanceOverAlbedo(double eta, std::span<const double> albedos,
                                            const MonteCarloSettings& settings);

/// 0.999 to this power is 2e-9.
inline constexpr std::uint32_t longestSeries = 20000;

}  // namespace nephrite::scattering
