// Profiles as sums of Gaussians, which blurs can be made of: d'Eon, Luebke and Enderton, "Efficient rendering
// of human skin" (2007).
#pragma once

#include <vector>

#include "scattering/medium.h"
#include "scattering/random.h"

namespace nephrite::scattering {

/// weight / (2 pi variance) e^(-r^2 / (2 variance)): its integral over the surface is the weight.
struct RadialGaussian {
    double variance = 1;  ///< mm^2
    double weight = 0;
};

/// All per unit of power that enters the medium; radii in mm.
class GaussianSum {
  public:
    /// Variances above 0, weights not below.
    explicit GaussianSum(std::vector<RadialGaussian> terms);

    double exitance(double radius) const;
    double total() const { return total_; }
    double fractionWithin(double radius) const;
    /// A radius distributed as 2 pi r exitance / total, exactly. The total must not be 0.
    double sampleRadius(Random& random) const;

    const std::vector<RadialGaussian>& terms() const { return terms_; }

  private:
    std::vector<RadialGaussian> terms_;
    double total_ = 0;
};

enum class ColorChannel { red, green, blue };

/// The published six Gaussians of skin; white light leaves white, so the weights add up to 1.
GaussianSum skinGaussians(ColorChannel channel);

/// Gaussians for any medium: six variances are spread over the radii of the medium's dipole (with exact
/// Fresnel), and weights not below 0 are chosen to minimise the integral of r (dipole - sum)^2 as the authors
/// do, then scaled to the dipole's total.
GaussianSum fittedGaussians(const Medium& medium);

}  // namespace nephrite::scattering
