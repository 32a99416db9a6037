// FLIP as its papers define it, in double precision and with nothing made faster: the truth for the code.
#pragma once

#include <cstdint>
#include <vector>

#include "image/metrics/color_planes.h"

namespace nephrite::image::direct {

/// LDR-FLIP of each pixel (Andersson et al. 2020), values linear.
std::vector<double> ldrFlip(const ColorPlanes& picture, const ColorPlanes& reference);

/// The greatest LDR-FLIP over `count` exposures from 2^start to 2^stop (Andersson et al. 2021).
std::vector<double> hdrFlip(const ColorPlanes& picture, const ColorPlanes& reference, double start,
                            double stop, int count);

}  // namespace nephrite::image::direct
