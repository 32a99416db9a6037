// See shapes.h.
#include "stress/shapes.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace nephrite::stress {
namespace {

constexpr int columns = 16;
constexpr int rows = 8;

enum class Normals { none, outward, inward };

/// A sphere of latitudes and longitudes about the z axis, as text that more triangles can be added to.
class SphereText {
  public:
    SphereText(double scale, Normals normals, bool flipped, int lastRow) : flipped_(flipped) {
        for (int row = 0; row <= rows; ++row) {
            for (int column = 0; column < columns; ++column) writePoint(row, column, scale, normals);
        }
        for (int row = 0; row < lastRow; ++row) {
            for (int column = 0; column < columns; ++column) {
                const int next = (column + 1) % columns;
                if (row > 0) face(index(row, column), index(row + 1, column), index(row, next));
                if (row + 1 < rows) face(index(row, next), index(row + 1, column), index(row + 1, next));
            }
        }
    }

    void face(int a, int b, int c) {
        if (flipped_) std::swap(b, c);
        if (normals_)
            text_ += fmt::format("f {}//{} {}//{} {}//{}\n", a, a, b, b, c, c);
        else
            text_ += fmt::format("f {} {} {}\n", a, b, c);
    }
    static int index(int row, int column) { return 1 + row * columns + column; }
    std::string& text() { return text_; }

  private:
    void writePoint(int row, int column, double scale, Normals normals) {
        const double polar = std::numbers::pi * row / rows;
        const double turn = 2 * std::numbers::pi * column / columns;
        const double x = std::sin(polar) * std::cos(turn);
        const double y = std::sin(polar) * std::sin(turn);
        const double z = std::cos(polar);
        const double radius = objectRadius * scale;
        text_ += fmt::format("v {} {} {}\n", x * radius, y * radius, z * radius);
        normals_ = normals != Normals::none;
        const double sign = normals == Normals::inward ? -1 : 1;
        if (normals_) text_ += fmt::format("vn {} {} {}\n", sign * x, sign * y, sign * z);
    }

    bool flipped_;
    bool normals_ = false;
    std::string text_;
};

SphereText plainSphere(double scale) {
    return {scale, Normals::none, false, rows};
}

std::string slivers(double scale) {
    SphereText sphere = plainSphere(scale);
    const double radius = objectRadius * scale;
    std::string& text = sphere.text();
    for (int i = 0; i < 8; ++i) {
        const double height = radius * (0.1 * i - 0.35);
        const double inside = 0.9 * radius;
        text += fmt::format("v {} {} {}\nv {} {} {}\nv {} {} {}\nf -3 -2 -1\n", -inside / 4, height, inside,
                            inside / 4, height, inside, 0.0, height + 1e-6 * radius, inside);
    }
    return text;
}

std::string zeroArea(double scale) {
    SphereText sphere = plainSphere(scale);
    for (int column = 0; column + 2 < columns; ++column) {
        const int at = SphereText::index(rows / 2, column);
        sphere.face(at, at, at + 1);
        sphere.face(at, at, at);
    }
    const double radius = objectRadius * scale;
    sphere.text() += fmt::format("v 0 0 {0}\nv 0 {1} {0}\nv 0 {2} {0}\nf -3 -2 -1\n", 0.9 * radius,
                                 0.1 * radius, 0.2 * radius);
    return sphere.text();
}

std::string coincident(double scale) {
    SphereText sphere = plainSphere(scale);
    const std::string text = sphere.text();
    return text + text.substr(text.find("\nf ") + 1);
}

}  // namespace

std::optional<std::string> objText(Shape shape, double scale) {
    switch (shape) {
        case Shape::missingNormals:
            return plainSphere(scale).text();
        case Shape::inwardNormals:
            return SphereText(scale, Normals::inward, false, rows).text();
        case Shape::flippedWinding:
            return SphereText(scale, Normals::none, true, rows).text();
        case Shape::open:
            return SphereText(scale, Normals::outward, false, rows / 2).text();
        case Shape::slivers:
            return slivers(scale);
        case Shape::zeroArea:
            return zeroArea(scale);
        case Shape::coincident:
            return coincident(scale);
        case Shape::notANumber:
            return plainSphere(scale).text() + "v nan 0 0\nf 1 2 -1\n";
        case Shape::sphere:
        case Shape::slab:
            break;
    }
    return std::nullopt;
}

}  // namespace nephrite::stress
