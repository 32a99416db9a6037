// The colour spaces of FLIP: linear RGB of Rec. 709 under D65, XYZ, YCxCz, and L*a*b* with Hunt's adjustment.
#pragma once

#include <array>

namespace nephrite::image::flip {

using Color = std::array<float, 3>;

/// YCxCz (Flohr et al. 1993) of linear RGB: a luminance linear in light and two opponent colours. White is
/// (100, 0, 0), black (-16, 0, 0).
Color opponentOf(const Color& linear);

/// Linear RGB of YCxCz.
Color linearOf(const Color& opponent);

/// CIE 1976 L*a*b* of linear RGB, with a* and b* scaled by 0.01 L* (Hunt 1952): colours of dark surfaces
/// differ less.
Color huntLabOf(const Color& linear);

/// HyAB (Abasi et al. 2020): |dL| plus the Euclidean distance in a and b.
float hyabDistance(const Color& a, const Color& b);

/// The colour difference of FLIP from a HyAB distance of Hunt-adjusted colours: its 0.7th power, 0..1 of the
/// most that linear RGB allows (green against blue), where the lower 40 % take 95 % of the range.
float redistributed(float hyab);

}  // namespace nephrite::image::flip
