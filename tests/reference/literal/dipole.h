// The classical dipole (Jensen et al. 2001) gathered from the nearest pixels (Eqs. 12-13).
#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "reference/literal/texels.h"

namespace nephrite::reference {

/// A homogeneous medium in one colour channel.
struct Medium {
    double absorption = 0;  ///< 1/mm
    double scattering = 0;  ///< 1/mm, not reduced
    double g = 0;
    double eta = 1;
};

/// Depths and coefficients of the two sources of the dipole.
struct Dipole {
    double albedo = 0;        ///< alpha' = sigma_s' / sigma_t'
    double transport = 0;     ///< sigma_tr, 1/mm
    double realDepth = 0;     ///< z_r, mm
    double virtualDepth = 0;  ///< z_v, mm
};
Dipole dipoleOf(const Medium& medium);

/// R_d(r), 1/mm^2; 0 where nothing scatters.
double diffuseReflectance(const Medium& medium, double radius);

/// The integral of R_d over the plane: alpha'/2 (exp(-sigma_tr z_r) + exp(-sigma_tr z_v)).
double totalDiffuseReflectance(const Medium& medium);

/// The `taps` pixel offsets nearest to a pixel, its own left out, ordered by (distance^2, y, x).
std::vector<glm::ivec2> nearestOffsets(std::size_t taps);

/// L_ims at a pixel: sum of R_d(|S - S_j|) E_j over the neighbours that show a surface. `medium` holds R, G
/// and B.
glm::dvec3 gatherDipole(const Texels& position, const Texels& irradiance, glm::ivec2 pixel,
                        const std::array<Medium, 3>& medium, const std::vector<glm::ivec2>& offsets);

}  // namespace nephrite::reference
