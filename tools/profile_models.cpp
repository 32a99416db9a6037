// From a model's name to its numbers.
#include "profile_models.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "scattering/better_dipole.h"
#include "scattering/burley.h"
#include "scattering/dipole.h"
#include "scattering/fresnel.h"
#include "scattering/gaussian_sum.h"
#include "scattering/photon_beam_diffusion.h"
#include "text/diagnostics.h"

namespace nephrite::tools {
namespace {

using namespace scattering;

/// A profile of any type, evaluated.
template<class Model>
Profile evaluated(const Model& model, std::span<const double> radii) {
    Profile profile;
    profile.totals.totalReflectance = {model.total(), 0};
    profile.radii.assign(radii.begin(), radii.end());
    for (const double radius : radii) profile.values.push_back({model.exitance(radius), 0});
    return profile;
}

Profile evaluatedBeam(const Medium& medium, std::span<const double> radii) {
    const PhotonBeamDiffusion model(medium);
    Profile profile = evaluated(model, radii);
    profile.totals.singleReflectance = Estimate{model.single().total(), 0};
    return profile;
}

using Evaluate = Profile (*)(const Medium&, std::span<const double>);

struct Model {
    std::string_view name;
    ModelKind kind;
    Evaluate evaluate;  ///< nothing for Monte Carlo
};

constexpr std::array models{
    Model{"dipole", ModelKind::halfSpace,
          [](const Medium& medium, std::span<const double> radii) {
              return evaluated(Dipole(medium, InternalReflection::fitted), radii);
          }},
    Model{"better-dipole", ModelKind::halfSpace,
          [](const Medium& medium, std::span<const double> radii) {
              return evaluated(BetterDipole(medium), radii);
          }},
    Model{"photon-beam-diffusion", ModelKind::halfSpace, evaluatedBeam},
    Model{
        "burley", ModelKind::halfSpace,
        [](const Medium& medium, std::span<const double> radii) { return evaluated(Burley(medium), radii); }},
    Model{"sum-of-gaussians", ModelKind::halfSpace,
          [](const Medium& medium, std::span<const double> radii) {
              return evaluated(fittedGaussians(medium), radii);
          }},
    Model{"skin-red", ModelKind::measured,
          [](const Medium&, std::span<const double> radii) {
              return evaluated(skinGaussians(ColorChannel::red), radii);
          }},
    Model{"skin-green", ModelKind::measured,
          [](const Medium&, std::span<const double> radii) {
              return evaluated(skinGaussians(ColorChannel::green), radii);
          }},
    Model{"skin-blue", ModelKind::measured,
          [](const Medium&, std::span<const double> radii) {
              return evaluated(skinGaussians(ColorChannel::blue), radii);
          }},
    Model{"montecarlo", ModelKind::monteCarlo, nullptr},
};

constexpr auto names = [] {
    std::array<std::string_view, models.size()> list{};
    for (std::size_t i = 0; i < models.size(); ++i) list[i] = models[i].name;
    return list;
}();

const Model& findModel(const std::string& name) {
    const auto found =
        std::find_if(models.begin(), models.end(), [&](const Model& model) { return model.name == name; });
    if (found == models.end())
        throw InputError({"--model"}, fmt::format("expected one of {}, found {}{}", fmt::join(names, ", "),
                                                  inQuotes(name), suggestion(name, names)));
    return *found;
}

}  // namespace

std::span<const std::string_view> modelNames() {
    return names;
}

ModelKind modelKind(const std::string& model) {
    return findModel(model).kind;
}

Profile evaluateProfile(const std::string& model, const Medium& medium, std::span<const double> radii) {
    const Model& chosen = findModel(model);
    Profile profile = chosen.evaluate(medium, radii);
    if (chosen.kind == ModelKind::halfSpace)
        profile.totals.specularReflectance = reflectanceFromOutside(1, medium.eta);
    return profile;
}

std::optional<Profile> simulateProfile(const LayerStack& stack, std::span<const double> radii,
                                       const MonteCarloSettings& settings) {
    const MonteCarloResult result = simulate(stack, radii, settings);
    if (!result.complete) return std::nullopt;
    Profile profile;
    profile.totals = {.totalReflectance = result.totalReflectance,
                      .totalTransmittance = result.totalTransmittance,
                      .singleReflectance = result.singleReflectance,
                      .specularReflectance = result.specularReflectance,
                      .absorptance = result.absorptance,
                      .lost = result.lost};
    profile.radii.assign(radii.begin(), radii.end());
    profile.values = result.exitance;
    return profile;
}

}  // namespace nephrite::tools
