// The models behind `nephrite profile`, by name.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scattering/medium.h"
#include "scattering/montecarlo.h"

namespace nephrite::tools {

/// Totals; of formulas the standard errors are 0.
struct ProfileTotals {
    scattering::Estimate totalReflectance;
    scattering::Estimate totalTransmittance;
    std::optional<scattering::Estimate> singleReflectance;  ///< of models that tell it apart
    double specularReflectance = 0;
    std::optional<scattering::Estimate> absorptance;  ///< of Monte Carlo
    std::optional<scattering::Estimate> lost;         ///< of Monte Carlo, by roulette
};

/// R_d(r) at each radius asked for (mm), per unit of entering power, 1/mm^2, and totals.
struct Profile {
    ProfileTotals totals;
    std::vector<double> radii;
    std::vector<scattering::Estimate> values;
};

enum class ModelKind {
    halfSpace,   ///< a formula for a half space
    measured,    ///< a fixed profile: takes no coefficients
    monteCarlo,  ///< any stack of layers
};

/// The names that --model takes.
std::span<const std::string_view> modelNames();
/// Throws InputError naming --model, with a suggestion, if there is no such model.
ModelKind modelKind(const std::string& model);

/// Evaluates a formula; totals are per unit of entering power. `medium` only matters to models of a half
/// space.
Profile evaluateProfile(const std::string& model, const scattering::Medium& medium,
                        std::span<const double> radii);
/// Monte Carlo; totals are per unit of incident power. Nothing if it was stopped.
std::optional<Profile> simulateProfile(const scattering::LayerStack& stack, std::span<const double> radii,
                                       const scattering::MonteCarloSettings& settings);

}  // namespace nephrite::tools
