// The weighted sum of the five terms (Eq. 3).
#pragma once

#include <array>
#include <glm/vec3.hpp>

#include "reference/literal/texels.h"

namespace nephrite::reference {

/// L = sum_i weight_i term_i at a pixel of an output of `width` x `height`: terms in the order L_id, L_is,
/// L_ir, L_iss, L_ims. A term of another size is filtered bilinearly; an empty one adds nothing.
glm::dvec3 composite(const std::array<Texels, 5>& terms, const std::array<double, 5>& weights, int width,
                     int height, int x, int y);

}  // namespace nephrite::reference
