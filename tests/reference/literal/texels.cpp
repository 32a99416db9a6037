// Bilinear look-up in a rectangle of texels.
#include "reference/literal/texels.h"

#include <cmath>

namespace nephrite::reference {

glm::dvec4 Texels::filtered(glm::dvec2 texel) const {
    const double left = std::floor(texel.x - 0.5);
    const double top = std::floor(texel.y - 0.5);
    const double s = texel.x - 0.5 - left;
    const double t = texel.y - 0.5 - top;
    const int x = static_cast<int>(left);
    const int y = static_cast<int>(top);
    return (1 - t) * ((1 - s) * at(x, y) + s * at(x + 1, y)) +
           t * ((1 - s) * at(x, y + 1) + s * at(x + 1, y + 1));
}

}  // namespace nephrite::reference
