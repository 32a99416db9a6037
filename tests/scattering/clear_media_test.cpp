// Media of next to no extinction, where products of coefficients underflow.
#include <gtest/gtest.h>

#include "scattering/better_dipole.h"
#include "scattering/burley.h"
#include "scattering/dipole.h"
#include "scattering/gaussian_sum.h"
#include "scattering/photon_beam_diffusion.h"

namespace nephrite::scattering {
namespace {

/// Every model's total, and its exitance at 1 mm.
template<class Profile>
void expectProfile(const Profile& profile, double total, double exitance) {
    EXPECT_NEAR(profile.total(), total, 1e-9);
    EXPECT_EQ(profile.exitance(1), exitance);
}

TEST(Profiles, OfNextToNoExtinctionAreThoseOfAClearMedium) {
    for (const double coefficient : {5e-324, 1e-320, 1e-305, 1e-200, 1e-120}) {
        const Medium medium{coefficient, coefficient, 0.5, 1.3};
        expectProfile(Dipole(medium, InternalReflection::exact), 0, 0);
        expectProfile(BetterDipole(medium), 0, 0);
        expectProfile(PhotonBeamDiffusion(medium), 0, 0);
        expectProfile(Burley(medium), 0, 0);
        expectProfile(fittedGaussians(medium), 0, 0);
    }
    // Above that only the ratio of the coefficients counts.
    const Medium usual{1, 1, 0.5, 1.3};
    const Medium faint{1e-99, 1e-99, 0.5, 1.3};
    EXPECT_NEAR(Dipole(faint, InternalReflection::exact).total(),
                Dipole(usual, InternalReflection::exact).total(), 1e-12);
    EXPECT_NEAR(BetterDipole(faint).total(), BetterDipole(usual).total(), 1e-12);
    EXPECT_NEAR(PhotonBeamDiffusion(faint).total(), PhotonBeamDiffusion(usual).total(), 1e-9);
    EXPECT_NEAR(fittedGaussians(faint).total(), fittedGaussians(usual).total(), 1e-9);
}

}  // namespace
}  // namespace nephrite::scattering
