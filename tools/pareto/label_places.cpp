// Greedy placement.
#include "pareto/label_places.h"

#include <algorithm>
#include <array>

namespace nephrite::pareto {
namespace {

constexpr std::array places{LabelPlace::RightAbove, LabelPlace::RightBelow, LabelPlace::LeftAbove,
                            LabelPlace::LeftBelow};
constexpr double pointSize = 8;
constexpr double gap = 3;

struct Box {
    double left = 0, right = 0, bottom = 0, top = 0;

    double area() const { return (right - left) * (top - bottom); }
};

double overlap(const Box& a, const Box& b) {
    const double width = std::min(a.right, b.right) - std::max(a.left, b.left);
    const double height = std::min(a.top, b.top) - std::max(a.bottom, b.bottom);
    return width > 0 && height > 0 ? width * height : 0;
}

Box boxOf(const LabelledPoint& point, LabelPlace place, double lineHeight) {
    const bool isRight = place == LabelPlace::RightAbove || place == LabelPlace::RightBelow;
    const bool isAbove = place == LabelPlace::RightAbove || place == LabelPlace::LeftAbove;
    const double left = isRight ? point.x + gap : point.x - gap - point.width;
    const double bottom = isAbove ? point.y : point.y - lineHeight;
    return {left, left + point.width, bottom, bottom + lineHeight};
}

}  // namespace

std::vector<LabelPlace> placeLabels(std::span<const LabelledPoint> points, const LabelSpace& space) {
    const Box inside{0, space.width, 0, space.height};
    std::vector<Box> taken;
    for (const LabelledPoint& point : points)
        taken.push_back({point.x - pointSize / 2, point.x + pointSize / 2, point.y - pointSize / 2,
                         point.y + pointSize / 2});
    std::vector<LabelPlace> chosen;
    for (const LabelledPoint& point : points) {
        const auto covered = [&](LabelPlace place) {
            const Box box = boxOf(point, place, space.lineHeight);
            double sum = box.area() - overlap(box, inside);
            for (const Box& other : taken) sum += overlap(box, other);
            return sum;
        };
        chosen.push_back(*std::min_element(places.begin(), places.end(), [&](LabelPlace a, LabelPlace b) {
            return covered(a) < covered(b);
        }));
        taken.push_back(boxOf(point, chosen.back(), space.lineHeight));
    }
    return chosen;
}

}  // namespace nephrite::pareto
