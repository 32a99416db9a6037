// Scattering by sources placed by geometry, in double precision and patch by patch, as docs/model.md has it:
// what the passes light-gather-geometric-* approximate through a tree and a grid.
#pragma once

#include <glm/vec3.hpp>
#include <span>

#include "reference/dumped_flux_tree.h"
#include "reference/literal/dipole.h"

namespace nephrite::reference {

/// A point that is looked at, and the light on it. Unit vectors; lengths in mm.
struct LitPoint {
    glm::dvec3 position{0};
    glm::dvec3 normal{0, 0, 1};
    glm::dvec3 toViewer{0, 0, 1};
    glm::dvec3 light{0};
    double intensity = 0;   ///< W/sr
    double visibility = 1;  ///< of the light
};

/// L_ss + L_ms, W/mm^2/sr, in one channel. Leaves are taken as points. `reflectance` is the total of a half
/// space lit perpendicularly.
double geometricRadiance(const LitPoint& point, std::span<const FluxNode> leaves, const Medium& medium,
                         double reflectance);

}  // namespace nephrite::reference
