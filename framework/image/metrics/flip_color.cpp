// Colour transforms as Andersson et al. 2020 give them.
#include "image/metrics/flip_color.h"

#include <cmath>

namespace nephrite::image::flip {
namespace {

using Matrix = std::array<Color, 3>;

/// XYZ over that of white: XYZ of Rec. 709 primaries and D65 (IEC 61966-2-1), the rows scaled so that (1, 1,
/// 1) gives 1. The fractions are exact for the primaries' and the white's chromaticities.
constexpr Matrix toRelativeXyz = [] {
    constexpr std::array<std::array<double, 3>, 3> xyz{
        {{10135552.0 / 24577794, 8788810.0 / 24577794, 4435075.0 / 24577794},
         {2613072.0 / 12288897, 8788810.0 / 12288897, 887015.0 / 12288897},
         {1425312.0 / 73733382, 8788810.0 / 73733382, 70074185.0 / 73733382}}};
    Matrix result{};
    for (std::size_t row = 0; row < 3; ++row) {
        const double white = xyz[row][0] + xyz[row][1] + xyz[row][2];
        for (std::size_t column = 0; column < 3; ++column)
            result[row][column] = static_cast<float>(xyz[row][column] / white);
    }
    return result;
}();

constexpr Matrix inverseOf(const Matrix& m) {
    Matrix result{};
    double determinant = 0;
    for (std::size_t i = 0; i < 3; ++i)
        determinant +=
            static_cast<double>(m[0][i]) * (static_cast<double>(m[1][(i + 1) % 3]) * m[2][(i + 2) % 3] -
                                            static_cast<double>(m[1][(i + 2) % 3]) * m[2][(i + 1) % 3]);
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) {
            const std::size_t a = (j + 1) % 3, b = (j + 2) % 3, c = (i + 1) % 3, d = (i + 2) % 3;
            const double cofactor =
                static_cast<double>(m[a][c]) * m[b][d] - static_cast<double>(m[a][d]) * m[b][c];
            result[i][j] = static_cast<float>(cofactor / determinant);
        }
    return result;
}

constexpr Matrix toLinear = inverseOf(toRelativeXyz);

Color times(const Matrix& m, const Color& v) {
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
