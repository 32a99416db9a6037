// Monte Carlo light transport in a half space, a slab or a layer stack under a perpendicular beam: the truth
// for plane geometry, with standard errors.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "scattering/batches.h"
#include "scattering/layer_stack.h"

namespace nephrite::scattering {

/// A mean and its standard error.
struct Estimate {
    double value = 0;
    double standardError = 0;
};

struct MonteCarloSettings {
    std::uint64_t photons = 1000000;
    std::uint64_t seed = 1;
    WorkSettings work;  ///< does not change the result
};

/// Totals are per unit of *incident* power and add up, with specularReflectance, to 1. `exitance` is per unit
/// of *entering* power, 1/mm^2, one for each radius asked for.
struct MonteCarloResult {
    double specularReflectance = 0;  ///< at the first meeting with the surface, by Fresnel's formula
    Estimate totalReflectance;       ///< through the front, without the specular part
    Estimate
        singleReflectance;  ///< the share scattered exactly once, reflected at boundaries any number of times
    Estimate totalTransmittance;  ///< through the back, with the unscattered
    Estimate absorptance;
    Estimate lost;  ///< by roulette: 0 but for its noise, unless photons were given up after 2^26 scatterings
    std::vector<Estimate> exitance;
    bool complete = true;  ///< false if it was stopped; the rest then means nothing
};

/// The ring over which the exitance at `radius` is averaged: 2 % to either side; around 0 a disc of a
/// hundredth of the first layer's mean free path. Unscattered light, which comes back on the axis, does not
/// count.
struct Ring {
    double inner = 0;
    double outer = 0;
};
Ring ringAround(double radius, const LayerStack& stack);

/// Follows the photons. The same stack, photons, seed and radii give the same result to the last bit on any
/// number of threads.
MonteCarloResult simulate(const LayerStack& stack, std::span<const double> radii,
                          const MonteCarloSettings& settings);

}  // namespace nephrite::scattering
