// Colour transforms as Andersson et al. 2020 give them.
#include "image/metrics/flip_color.h"

#include <cmath>
#include <cstddef>

namespace nephrite::image::flip {
namespace {

using Row = std::array<double, 3>;
using Matrix = std::array<Row, 3>;

constexpr Row cross(const Row& a, const Row& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

constexpr Matrix inverseOf(const Matrix& m) {
    const Matrix columns{cross(m[1], m[2]), cross(m[2], m[0]), cross(m[0], m[1])};
    const double determinant = m[0][0] * columns[0][0] + m[0][1] * columns[0][1] + m[0][2] * columns[0][2];
    Matrix result{};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) result[i][j] = columns[j][i] / determinant;
    return result;
}

constexpr std::array<Color, 3> rounded(const Matrix& m) {
    std::array<Color, 3> result{};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) result[i][j] = static_cast<float>(m[i][j]);
    return result;
}

/// XYZ over that of white, of Rec. 709 primaries under D65: the papers' matrix, its rows scaled so that (1,
/// 1, 1) gives 1.
constexpr Matrix relativeXyz = [] {
    Matrix xyz{{{10135552.0 / 24577794, 8788810.0 / 24577794, 4435075.0 / 24577794},
                {2613072.0 / 12288897, 8788810.0 / 12288897, 887015.0 / 12288897},
                {1425312.0 / 73733382, 8788810.0 / 73733382, 70074185.0 / 73733382}}};
    for (Row& row : xyz) {
        const double white = row[0] + row[1] + row[2];
        for (double& value : row) value /= white;
    }
    return xyz;
}();

constexpr std::array<Color, 3> toRelativeXyz = rounded(relativeXyz);
constexpr std::array<Color, 3> toLinear = rounded(inverseOf(relativeXyz));

Color times(const std::array<Color, 3>& m, const Color& v) {
    return {m[0][0] * v[0] + m[0][1] * v[1] + m[0][2] * v[2],
            m[1][0] * v[0] + m[1][1] * v[1] + m[1][2] * v[2],
            m[2][0] * v[0] + m[2][1] * v[1] + m[2][2] * v[2]};
}

/// L*, a*, b* of compressed values, and Y, Cx, Cz of linear ones.
Color opponentFrom(const Color& xyz) {
    return {116 * xyz[1] - 16, 500 * (xyz[0] - xyz[1]), 200 * (xyz[1] - xyz[2])};
}

/// CIE's cube root with a straight piece near black.
float compressed(float value) {
    constexpr float edge = 6.0F / 29;
    return value > edge * edge * edge ? std::cbrt(value) : value / (3 * edge * edge) + 4.0F / 29;
}

float powered(float hyab) {
    return std::pow(hyab, 0.7F);
}

}  // namespace

Color opponentOf(const Color& linear) {
    return opponentFrom(times(toRelativeXyz, linear));
}

Color linearOf(const Color& opponent) {
    const float y = (opponent[0] + 16) / 116;
    return times(toLinear, {y + opponent[1] / 500, y, y - opponent[2] / 200});
}

Color huntLabOf(const Color& linear) {
    const Color xyz = times(toRelativeXyz, linear);
    Color lab = opponentFrom({compressed(xyz[0]), compressed(xyz[1]), compressed(xyz[2])});
    lab[1] *= 0.01F * lab[0];
    lab[2] *= 0.01F * lab[0];
    return lab;
}

float hyabDistance(const Color& a, const Color& b) {
    const float da = a[1] - b[1];
    const float db = a[2] - b[2];
    return std::abs(a[0] - b[0]) + std::sqrt(da * da + db * db);
}

float redistributed(float hyab) {
    constexpr float kneeOfRange = 0.4F;
    constexpr float kneeOfResult = 0.95F;
    static const float most = powered(hyabDistance(huntLabOf({0, 1, 0}), huntLabOf({0, 0, 1})));
    const float share = powered(hyab) / most;
    return share < kneeOfRange
               ? share * (kneeOfResult / kneeOfRange)
               : kneeOfResult + (share - kneeOfRange) / (1 - kneeOfRange) * (1 - kneeOfResult);
}

}  // namespace nephrite::image::flip
