// Phase functions: how scattering spreads light over directions. Cosines are those of the angle between the
// directions of travel before and after; values are per steradian and integrate to 1 over the sphere.
#pragma once

namespace nephrite::scattering {

/// Beyond this |g| a phase function is so narrow that doubles cannot tell it from none; g and k are limited
/// to it.
inline constexpr double largestAnisotropy = 1 - 1e-9;

/// Henyey and Greenstein (1941): (1 - g^2) / (4 pi (1 + g^2 - 2 g c)^1.5), 1/sr.
double henyeyGreenstein(double cosine, double g);
/// The same at `angle` from straight back, 0 to pi: keeps the digits that a cosine loses where g is near -1.
double henyeyGreensteinBackward(double angle, double g);
/// The cosine drawn with density 2 pi henyeyGreenstein(cosine, g) by inverting its integral; `uniform` in [0,
/// 1).
double sampleHenyeyGreenstein(double g, double uniform);

/// k = 1.55 g - 0.55 g^3, limited: Schlick's parameter for a g of Henyey and Greenstein's.
double schlickParameter(double g);
/// Blasi, Le Saec and Schlick (1993): (1 - k^2) / (4 pi (1 - k c)^2), 1/sr.
double schlick(double cosine, double k);
/// The cosine drawn with density 2 pi schlick(cosine, k) by inverting its integral; `uniform` in [0, 1).
double sampleSchlick(double k, double uniform);

}  // namespace nephrite::scattering
