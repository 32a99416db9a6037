// The weighted sum of the five terms (Eq. 3).
#include "reference/literal/composite.h"

namespace nephrite::reference {

glm::dvec3 composite(const std::array<Texels, 5>& terms, const std::array<double, 5>& weights, int width,
                     int height, int x, int y) {
    glm::dvec3 sum(0);
    for (std::size_t i = 0; i < terms.size(); ++i) {
        const Texels& term = terms[i];
        if (term.width() == 0) continue;
        const bool same = term.width() == width && term.height() == height;
        const glm::dvec2 texel((x + 0.5) / width * term.width(), (y + 0.5) / height * term.height());
        sum += weights[i] * glm::dvec3(same ? term.at(x, y) : term.filtered(texel));
    }
    return sum;
}

}  // namespace nephrite::reference
