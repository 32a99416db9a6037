// Which part of the window is for what.
#pragma once

#include <cstdint>

#include "view/picture_placement.h"

namespace nephrite::view {

struct Layout {
    Area bar;        ///< commands, above everything
    Area controls;   ///< left: nodes and parameters
    Area picture;    ///< between the columns
    Area inspector;  ///< right: what is looked at
    Area timings;    ///< below everything
};

/// What is below the picture: lists are content with little, a graph is not.
enum class LowerPart : std::uint8_t { Hidden, Low, High };

/// Areas for a window of that size, pixels, that touch but do not overlap. `barHeight` is what the letters
/// need; `scale` is how much larger than usual they are.
Layout layOut(double width, double height, double barHeight, double scale, LowerPart lower);

/// The left and right half of an area, with a gap.
struct Halves {
    Area left;
    Area right;
};
Halves halvesOf(const Area& area, double gap);

}  // namespace nephrite::view
