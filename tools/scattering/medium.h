// A homogeneous participating medium and the coefficients that follow from it: one colour channel, lengths in
// mm.
#pragma once

namespace nephrite::scattering {

/// What light meets inside a material. Coefficients are as given: `g` still applies to `scattering`.
struct Medium {
    double absorption = 0;  ///< sigma_a, 1/mm
    double scattering = 0;  ///< sigma_s, 1/mm
    double g = 0;           ///< mean cosine of the scattering angle, -1 to 1
    double eta = 1;         ///< refractive index inside over the one outside
};

/// sigma_t = sigma_a + sigma_s, 1/mm; 0 below 1e-100, as if the medium were clear.
double extinction(const Medium& medium);
/// sigma_s / sigma_t; 0 for a clear medium.
double albedo(const Medium& medium);
/// sigma_s' = (1 - g) sigma_s, 1/mm: the isotropic scattering that spreads light as fast.
double reducedScattering(const Medium& medium);
/// sigma_t' = sigma_s' + sigma_a, 1/mm; 0 below 1e-100.
double reducedExtinction(const Medium& medium);
/// alpha' = sigma_s' / sigma_t'; 0 where the medium neither scatters nor absorbs.
double reducedAlbedo(const Medium& medium);
/// 1 - alpha' = sigma_a / sigma_t', exact also where alpha' rounds to 1.
double reducedAbsorption(const Medium& medium);
/// sigma_tr = sqrt(3 sigma_a sigma_t'), 1/mm: how fast classical diffusion decays.
double transportCoefficient(const Medium& medium);
/// The medium with g = 0 and the same reduced coefficients (similarity).
Medium reduced(const Medium& medium);

}  // namespace nephrite::scattering
