// Dividing the window.
#include "view/layout.h"

#include <algorithm>

namespace nephrite::view {
namespace {

constexpr double columnWidth = 290;
constexpr double belowHeight = 210;
/// Columns and what is below leave the picture at least this part of the window.
constexpr double pictureShare = 0.4;

}  // namespace

Layout layOut(double width, double height, double barHeight, double scale, bool below) {
    const double column = std::min(columnWidth * scale, width * (1 - pictureShare) / 2);
    const double lower = below ? std::min(belowHeight * scale, (height - barHeight) * (1 - pictureShare)) : 0;
    const double middle = std::max(height - barHeight - lower, 0.0);
    Layout layout;
    layout.bar = {0, 0, width, barHeight};
    layout.controls = {0, barHeight, column, middle};
    layout.picture = {column, barHeight, width - 2 * column, middle};
    layout.inspector = {width - column, barHeight, column, middle};
    layout.timings = {0, barHeight + middle, width, lower};
    return layout;
}

Halves halvesOf(const Area& area, double gap) {
    const double width = std::max((area.width - gap) / 2, 1.0);
    return {{area.x, area.y, width, area.height}, {area.x + area.width - width, area.y, width, area.height}};
}

}  // namespace nephrite::view
