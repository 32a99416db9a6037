// Where a picture's texels lie in the window: fitted into its place, or magnified around a point.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

namespace nephrite::view {

struct Point {
    double x = 0;
    double y = 0;
};

/// A part of the window, pixels.
struct Area {
    double x = 0;
    double y = 0;
    double width = 0;
    double height = 0;

    bool contains(Point point) const {
        return point.x >= x && point.y >= y && point.x < x + width && point.y < y + height;
    }
};

struct Texel {
    std::uint32_t x = 0;
    std::uint32_t y = 0;
    friend bool operator==(const Texel&, const Texel&) = default;
};

/// Whole texels of a picture and the whole pixels of the window that they cover.
struct Blit {
    std::array<std::int32_t, 4> source{};       ///< x0, y0, x1, y1, the last ones outside
    std::array<std::int32_t, 4> destination{};  ///< likewise
};

/// A picture of `width` x `height` texels in an area.
class PicturePlacement {
  public:
    PicturePlacement() = default;
    PicturePlacement(Area area, std::uint32_t width, std::uint32_t height)
        : area_(area), width_(width), height_(height) {}

    /// Magnification 1 fits the whole picture into the area; `center` is the place of the picture, 0..1, in
    /// the middle.
    void magnify(double magnification, Point center);

    const Area& area() const { return area_; }
    /// Pixels of the window for each texel.
    double scale() const;
    Point toWindow(Point texel) const;
    Point toPicture(Point window) const;
    /// A place of the picture, texels, as a part of its size: within 0..1.
    Point fraction(Point texel) const;
    /// The texel under a point of the window, if the picture is seen there.
    std::optional<Texel> texelAt(Point window) const;
    /// What is seen of the picture, in a window of `windowWidth` x `windowHeight`. Texels at the area's edge
    /// are drawn whole: they may reach over it, but not out of the window. Nothing if none is seen.
    std::optional<Blit> blit(std::int32_t windowWidth, std::int32_t windowHeight) const;

  private:
    Area area_;
    std::uint32_t width_ = 0;
    std::uint32_t height_ = 0;
    double magnification_ = 1;
    Point center_{0.5, 0.5};
};

/// The magnification and center after the wheel was turned by `steps` at a point of the window, which keeps
/// its texel.
struct Magnification {
    double factor = 1;
    Point center{0.5, 0.5};
};
Magnification magnifiedAt(const PicturePlacement& placement, const Magnification& before, Point window,
                          double steps);
/// The same after the picture was dragged by so many pixels.
Magnification dragged(const PicturePlacement& placement, const Magnification& before, double x, double y);

}  // namespace nephrite::view
