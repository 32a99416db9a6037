// See cpu.h.
#include "stress/cpu.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "runtime/loading/graph_loading.h"
#include "scattering/better_dipole.h"
#include "scattering/burley.h"
#include "scattering/dipole.h"
#include "scattering/gaussian_sum.h"
#include "scattering/montecarlo.h"
#include "scattering/photon_beam_diffusion.h"
#include "truth/rendering.h"

namespace nephrite::stress {
namespace {

using namespace scattering;

template<class Profile>
void checkProfile(const Profile& profile, const std::string& name, double mostTotal, Outcome& outcome) {
    ProfileFigures figures{name, {}, profile.total(), mostTotal};
    for (const double radius : {0.0, 1e-12, 1e-6, 1e-3, 1.0, 1e3, 1e6})
        figures.exitances.push_back(profile.exitance(radius));
    checkFigures(figures, outcome);
}

struct ReferenceMode {
    std::string_view name;
    truth::Mode mode;
};

constexpr std::array referenceModes{ReferenceMode{"volume", truth::Mode::Volume},
                                    ReferenceMode{"single", truth::Mode::Single},
                                    ReferenceMode{"dipole", truth::Mode::Dipole}};

void checkReference(const scene::Scene& scene, const ReferenceMode& mode, Outcome& outcome) {
    constexpr std::uint32_t size = 8;
    constexpr std::uint32_t samples = 2;
    const truth::World world(scene, 0);
    const auto estimator = truth::makeEstimator(world, {mode.mode, 1, 1 << 8}, scene);
    const truth::Camera camera(scene.description().camera, size, size);
    truth::Rendering rendering(world, camera, *estimator, {}, samples);
    rendering.run(1, {});
    checkPicture(rendering.picture(), fmt::format("reference {}", mode.name), outcome);
}

}  // namespace

void checkFigures(const ProfileFigures& figures, Outcome& outcome) {
    for (const double exitance : figures.exitances)
        outcome.check(std::isfinite(exitance) && exitance >= 0,
                      fmt::format("{}: exitance {}", figures.name, exitance));
    outcome.check(
        figures.total >= 0 && figures.total <= figures.mostTotal * (1 + 1e-9),
        fmt::format("{}: total {}, expected 0 to {}", figures.name, figures.total, figures.mostTotal));
}

void checkPowers(const MonteCarloResult& result, Outcome& outcome) {
    const double sum = result.specularReflectance + result.totalReflectance.value +
                       result.totalTransmittance.value + result.absorptance.value + result.lost.value;
    outcome.check(std::abs(sum - 1) <= 1e-9, fmt::format("powers add up to {:.12g}", sum));
    for (const Estimate& estimate :
         {result.totalReflectance, result.singleReflectance, result.totalTransmittance, result.absorptance})
        // Roulette makes some photons heavier than they were: a share is within its noise of at most 1.
        outcome.check(estimate.value >= 0 && estimate.value <= 1 + 1e-9 + 6 * estimate.standardError &&
                          std::isfinite(estimate.standardError),
                      fmt::format("a share of {} +- {}", estimate.value, estimate.standardError));
    for (const Estimate& exitance : result.exitance)
        outcome.check(
            exitance.value >= 0 && std::isfinite(exitance.value) && std::isfinite(exitance.standardError),
            fmt::format("exitance {} +- {}", exitance.value, exitance.standardError));
}

void checkPicture(const image::Image& picture, const std::string& name, Outcome& outcome) {
    std::size_t wrong = 0;
    for (const float value : picture.pixels) wrong += std::isfinite(value) && value >= 0 ? 0 : 1;
    outcome.check(wrong == 0, fmt::format("{}: {} of {} values are negative or not finite", name, wrong,
                                          picture.pixels.size()));
}

void checkProfiles(const Medium& medium, Outcome& outcome) {
    checkProfile(Dipole(medium, InternalReflection::exact), "dipole", 1, outcome);
    checkProfile(Dipole(medium, InternalReflection::fitted), "dipole with the fit", 1, outcome);
    checkProfile(BetterDipole(medium), "better dipole", 1, outcome);
    checkProfile(fittedGaussians(medium), "sum of Gaussians", 1, outcome);
    // Diffusion plus exact single scattering does not keep power where scattering is far from isotropic.
    checkProfile(PhotonBeamDiffusion(medium, 8), "photon beam diffusion", 2, outcome);
}

void checkBurley(const Medium& medium, Outcome& outcome) {
    checkProfile(Burley(medium), "Burley", 1, outcome);
}

void checkPhotons(const LayerStack& stack, Outcome& outcome) {
    constexpr std::array radii{0.0, 1e-3, 1.0};
    const MonteCarloResult result = simulate(stack, radii, {.photons = 2000, .seed = 1, .work = {}});
    checkPowers(result, outcome);
}

void checkReferences(const SceneValues& values, const Place& place, Outcome& outcome) {
    const scene::Scene scene =
        runtime::loadScene(write(values, place.folder), 0, runtime::DataFolders::find());
    for (const ReferenceMode& mode : referenceModes) checkReference(scene, mode, outcome);
}

}  // namespace nephrite::stress
