// FLIP: how different two pictures look to somebody who flips between them.
#pragma once

#include <cstdint>

namespace nephrite::image {

/// HDR-FLIP (Andersson et al. 2021) of two pictures.
struct FlipError {
    double mean = 0;              ///< mean over pixels, 0 (equal) to 1
    double startExposure = 0;     ///< exposures tried are from 2^start ...
    double stopExposure = 0;      ///< ... to 2^stop, evenly spaced in the exponent
    std::uint32_t exposures = 0;  ///< how many
};

}  // namespace nephrite::image
