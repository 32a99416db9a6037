// Dividing the window.
#include "view/layout.h"

#include <algorithm>

namespace nephrite::view {
namespace {

constexpr double columnWidth = 290;
constexpr double lowHeight = 210;
constexpr double highShare = 0.55;  ///< of the window, below the bar
/// Columns and what is below leave the picture at least this part of the window.
constexpr double pictureShare = 0.4;

double heightOf(LowerPart lower, double height, double scale) {
    switch (lower) {
        case LowerPart::Hidden:
            return 0;
        case LowerPart::Low:
            return std::min(lowHeight * scale, height * (1 - pictureShare));
        case LowerPart::High:
            return height * highShare;
    }
    return 0;
}

}  // namespace

Layout layOut(double width, double height, double barHeight, double scale, LowerPart part) {
    const double column = std::min(columnWidth * scale, width * (1 - pictureShare) / 2);
    const double lower = heightOf(part, height - barHeight, scale);
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
