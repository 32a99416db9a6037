// Media and layer stacks at the edges of what there is, for the mathematics of scattering.
#pragma once

#include <string>
#include <vector>

#include "scattering/layer_stack.h"
#include "scattering/medium.h"

namespace nephrite::stress {

struct NamedMedium {
    std::string name;
    scattering::Medium medium;
};

/// Every pair of coefficients with every anisotropy and index of the list.
std::vector<NamedMedium> media();

struct NamedStack {
    std::string name;
    scattering::LayerStack stack;
};

/// Media as slabs and stacks of several thicknesses. Left out is where photons wander without end: strong
/// scattering that neither absorbs nor turns around.
std::vector<NamedStack> stacks();

}  // namespace nephrite::stress
