// Media where formulas break: every extreme of anisotropy, index and coefficients, alone and together.
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

}  // namespace nephrite::scattering
