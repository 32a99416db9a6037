// Light reflected by a half space of isotropic scattering under a smooth boundary: the exact solution of
// radiative transfer, to which Monte Carlo must come and which the dipoles approximate.
#pragma once

#include "scattering/medium.h"

namespace nephrite::scattering {

/// The fraction of perpendicularly entering power that leaves again, for a medium taken with its reduced
/// coefficients and g = 0; single scattering is part of it. Chandrasekhar, "Radiative Transfer" (1950), gives
/// the reflection of the open half space by his H function; what the boundary sends back into the medium is
/// an integral equation on top, solved here to about 1e-9.
double halfSpaceReflectance(const Medium& medium);

}  // namespace nephrite::scattering
