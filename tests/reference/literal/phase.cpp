// The phase function of Eq. 9 as the paper prints it.
#include "reference/literal/phase.h"

#include <algorithm>
#include <numbers>

namespace nephrite::reference {

double printedPhase(double cosine, double g) {
    const double limited = std::clamp(g, -0.999, 0.999);
    const double denominator = 1 + limited * cosine;
    return (1 - limited * limited) / (4 * std::numbers::pi * denominator * denominator);
}

}  // namespace nephrite::reference
