// Colours for numbers.
#pragma once

#include <array>
#include <cstdint>

namespace nephrite::image {

/// sRGB bytes of the colour map viridis (S. van der Walt and N. Smith, for Matplotlib, 2015; CC0) at 0 (dark
/// violet) to 1 (yellow); beyond, the colour of the end. Equal steps look equally large, lightness rises
/// throughout, and it reads the same with red-green blindness and in grey.
std::array<std::uint8_t, 3> viridis(double value);

}  // namespace nephrite::image
