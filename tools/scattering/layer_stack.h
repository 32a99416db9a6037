// A stack of plane layers and what Monte Carlo asks for along a way through it.
#pragma once

#include <limits>
#include <vector>

#include "scattering/medium.h"

namespace nephrite::scattering {

/// One layer: coefficients in 1/mm as given (g applies to `scattering`), thickness in mm.
struct Layer {
    double thickness = std::numeric_limits<double>::infinity();
    double absorption = 0;
    double scattering = 0;
};

/// Layers from the surface inward, all of one phase function and one refractive index, in air above and
/// below. An infinite last layer makes a half space, a finite one a slab.
struct LayerStack {
    std::vector<Layer> layers;
    double g = 0;
    double eta = 1;  ///< index inside over the one outside
};

/// One layer of `medium`.
LayerStack layerStackOf(const Medium& medium, double thickness = std::numeric_limits<double>::infinity());

}  // namespace nephrite::scattering
