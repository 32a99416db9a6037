// From texels to pixels of the window and back.
#include "view/picture_placement.h"

#include <algorithm>
#include <cmath>

namespace nephrite::view {
namespace {

constexpr double factorPerStep = 1.25;
constexpr double greatestFactor = 512;

/// The texels from `first` to `last` of one direction that are seen, and the pixels they cover.
struct Span {
    std::int32_t source0 = 0, source1 = 0;
    std::int32_t destination0 = 0, destination1 = 0;
    bool empty() const { return source0 >= source1 || destination0 >= destination1; }
};

Span seenSpan(double origin, double scale, double areaStart, double areaEnd, std::int32_t texels,
              std::int32_t pixels) {
    const auto pixelOf = [&](std::int32_t texel) {
        return static_cast<std::int32_t>(std::lround(origin + texel * scale));
    };
    Span span;
    span.source0 = std::clamp(static_cast<std::int32_t>(std::floor((areaStart - origin) / scale)), 0, texels);
    span.source1 = std::clamp(static_cast<std::int32_t>(std::ceil((areaEnd - origin) / scale)), 0, texels);
    while (span.source0 < span.source1 && pixelOf(span.source0) < 0) ++span.source0;
    while (span.source0 < span.source1 && pixelOf(span.source1) > pixels) --span.source1;
    span.destination0 = pixelOf(span.source0);
    span.destination1 = pixelOf(span.source1);
    return span;
}

}  // namespace

void PicturePlacement::magnify(double magnification, Point center) {
    magnification_ = magnification;
    center_ = center;
}

double PicturePlacement::scale() const {
    if (width_ == 0 || height_ == 0) return 1;
    const double fitted = std::min(area_.width / width_, area_.height / height_);
    return std::max(fitted * magnification_, 1e-6);
}

Point PicturePlacement::toWindow(Point texel) const {
    return {area_.x + area_.width / 2 + (texel.x - center_.x * width_) * scale(),
            area_.y + area_.height / 2 + (texel.y - center_.y * height_) * scale()};
}

Point PicturePlacement::toPicture(Point window) const {
    return {(window.x - area_.x - area_.width / 2) / scale() + center_.x * width_,
            (window.y - area_.y - area_.height / 2) / scale() + center_.y * height_};
}

Point PicturePlacement::fraction(Point texel) const {
    const auto part = [](double value, std::uint32_t whole) {
        return whole == 0 ? 0.5 : std::clamp(value / whole, 0.0, 1.0);
    };
    return {part(texel.x, width_), part(texel.y, height_)};
}

std::optional<Texel> PicturePlacement::texelAt(Point window) const {
    if (!area_.contains(window)) return std::nullopt;
    const Point place = toPicture(window);
    if (place.x < 0 || place.y < 0 || place.x >= width_ || place.y >= height_) return std::nullopt;
    return Texel{static_cast<std::uint32_t>(place.x), static_cast<std::uint32_t>(place.y)};
}

std::optional<Blit> PicturePlacement::blit(std::int32_t windowWidth, std::int32_t windowHeight) const {
    const Point origin = toWindow({0, 0});
    const Span x = seenSpan(origin.x, scale(), area_.x, area_.x + area_.width,
                            static_cast<std::int32_t>(width_), windowWidth);
    const Span y = seenSpan(origin.y, scale(), area_.y, area_.y + area_.height,
                            static_cast<std::int32_t>(height_), windowHeight);
    if (x.empty() || y.empty()) return std::nullopt;
    return Blit{{x.source0, y.source0, x.source1, y.source1},
                {x.destination0, y.destination0, x.destination1, y.destination1}};
}

Magnification magnifiedAt(const PicturePlacement& placement, const Magnification& before, Point window,
                          double steps) {
    const Point place = placement.toPicture(window);
    const double factor = std::clamp(before.factor * std::pow(factorPerStep, steps), 1.0, greatestFactor);
    if (factor == 1) return {};
    const double scale = placement.scale() * factor / before.factor;
    const Area& area = placement.area();
    const Point middle{place.x - (window.x - area.x - area.width / 2) / scale,
                       place.y - (window.y - area.y - area.height / 2) / scale};
    return {factor, placement.fraction(middle)};
}

Magnification dragged(const PicturePlacement& placement, const Magnification& before, double x, double y) {
    const Area& area = placement.area();
    return {
        before.factor,
        placement.fraction(placement.toPicture({area.x + area.width / 2 - x, area.y + area.height / 2 - y}))};
}

}  // namespace nephrite::view
