// Where the labels of a plot's points go, so that they cover each other and the points as little as may be.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace nephrite::pareto {

/// A point and the width of its label, in pixels; y grows upwards.
struct LabelledPoint {
    double x = 0;
    double y = 0;
    double width = 0;
};

/// The side of its point on which a label stands.
enum class LabelPlace : std::uint8_t { RightAbove, RightBelow, LeftAbove, LeftBelow };

/// The space labels may use, from (0, 0), and the height of a line of text. All in pixels.
struct LabelSpace {
    double width = 0;
    double height = 0;
    double lineHeight = 0;
};

/// Chooses for one label after the other the place that covers least: labels before it, points, what lies
/// outside.
std::vector<LabelPlace> placeLabels(std::span<const LabelledPoint> points, const LabelSpace& space);

}  // namespace nephrite::pareto
