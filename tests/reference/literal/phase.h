// The phase function of Eq. 9 as the paper prints it.
#pragma once

namespace nephrite::reference {

/// (1 - g^2) / (4 pi (1 + g cos)^2), |g| limited to 0.999, 1/sr. It is Schlick's function (Blasi, Le Saec and
/// Schlick 1993) with the sign flipped, so g > 0 scatters backward, and with g in place of his k; it still
/// integrates to 1 over the sphere.
double printedPhase(double cosine, double g);

}  // namespace nephrite::reference
