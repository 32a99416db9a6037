// Media and radii where formulas break: every extreme of anisotropy, index and coefficients, alone and
// together.
#pragma once

#include <vector>

#include "scattering/medium.h"

namespace nephrite::scattering {

/// 9 pairs of coefficients x 7 anisotropies x 7 indices.
inline std::vector<Medium> stressMedia() {
    struct Coefficients {
        double absorption;
        double scattering;
    };
    std::vector<Medium> media;
    for (const Coefficients c : {Coefficients{0, 1},
                                 {1, 0},
                                 {0, 0},
                                 {1e4, 1e4},
                                 {1e-6, 1e-6},
                                 {1e-6, 1e4},
                                 {1e4, 1e-6},
                                 {0.003, 2.29},
                                 {0.19, 0.38}})
        for (const double g : {-1.0, -0.999, 0.0, 0.75, 0.999, 1 - 1e-9, 1.0})
            for (const double eta : {0.5, 0.8, 1.0, 1.000001, 1.3, 2.0, 4.0})
                media.push_back({c.absorption, c.scattering, g, eta});
    return media;
}

/// Radii where profiles break, mm: the centre, radii far apart in mm and in mean free paths, and, where light
/// is absorbed, some at which little and next to nothing is left of it.
inline std::vector<double> stressRadii(const Medium& medium) {
    std::vector<double> radii{0, 1e-6, 1e-3, 0.1, 1, 30, 1e4, 1e9, 1e18};
    const double extinction = reducedExtinction(medium);
    if (extinction > 0)
        for (const double freePaths : {1e-4, 1.0, 10.0, 100.0}) radii.push_back(freePaths / extinction);
    const double decay = transportCoefficient(medium);
    if (decay > 0)
        for (const double decays : {1.0, 10.0, 30.0, 60.0, 600.0}) radii.push_back(decays / decay);
    return radii;
}

}  // namespace nephrite::scattering
