// The CPU's models and references under stress: profiles, Monte Carlo of plane layers, pictures.
#pragma once

#include <string>
#include <vector>

#include "image/image.h"
#include "scattering/layer_stack.h"
#include "scattering/medium.h"
#include "scattering/montecarlo.h"
#include "stress/device.h"
#include "stress/outcome.h"
#include "stress/scene_values.h"

namespace nephrite::stress {

/// What a profile says, and the greatest total that it may have.
struct ProfileFigures {
    std::string name;
    std::vector<double> exitances;
    double total = 0;
    double mostTotal = 1;
};

// The checks themselves, apart from what makes the figures.
void checkFigures(const ProfileFigures& figures, Outcome& outcome);
void checkPowers(const scattering::MonteCarloResult& result, Outcome& outcome);
void checkPicture(const image::Image& picture, const std::string& name, Outcome& outcome);

/// Dipole, better dipole, photon beam diffusion and sums of Gaussians: exitance finite and not negative from
/// the axis to a kilometre, totals within [0, 1] where the model keeps power.
void checkProfiles(const scattering::Medium& medium, Outcome& outcome);
/// The same of Burley's profile, which takes a tenth of a second a medium.
void checkBurley(const scattering::Medium& medium, Outcome& outcome);

/// Two thousand photons: what is reflected, let through, absorbed and lost is 1 together; all finite.
void checkPhotons(const scattering::LayerStack& stack, Outcome& outcome);

/// The references volume, single and dipole of the scene: every value finite and not negative.
void checkReferences(const SceneValues& scene, const Place& place, Outcome& outcome);

}  // namespace nephrite::stress
