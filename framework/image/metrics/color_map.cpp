// Every fifth of viridis' 256 colours; between them it is straight to within a step of a byte.
#include "image/metrics/color_map.h"

#include <algorithm>
#include <cmath>

namespace nephrite::image {
namespace {

constexpr std::array<std::array<std::uint8_t, 3>, 52> colors{{
    {68, 1, 84},    {70, 8, 92},    {71, 16, 99},   {72, 23, 105},  {72, 29, 111},  {72, 36, 117},
    {71, 42, 122},  {70, 48, 126},  {69, 55, 129},  {67, 61, 132},  {65, 66, 135},  {63, 72, 137},
    {61, 78, 138},  {58, 83, 139},  {56, 89, 140},  {53, 94, 141},  {51, 99, 141},  {49, 104, 142},
    {46, 109, 142}, {44, 113, 142}, {42, 118, 142}, {41, 123, 142}, {39, 128, 142}, {37, 132, 142},
    {35, 137, 142}, {33, 142, 141}, {32, 146, 140}, {31, 151, 139}, {30, 156, 137}, {31, 161, 136},
    {33, 165, 133}, {36, 170, 131}, {40, 174, 128}, {46, 179, 124}, {53, 183, 121}, {61, 188, 116},
    {70, 192, 111}, {80, 196, 106}, {90, 200, 100}, {101, 203, 94}, {112, 207, 87}, {124, 210, 80},
    {137, 213, 72}, {149, 216, 64}, {162, 218, 55}, {176, 221, 47}, {189, 223, 38}, {202, 225, 31},
    {216, 226, 25}, {229, 228, 25}, {241, 229, 29}, {253, 231, 37},
}};

}  // namespace

std::array<std::uint8_t, 3> viridis(double value) {
    const double place = std::clamp(value, 0.0, 1.0) * (colors.size() - 1);
    const auto below = std::min(static_cast<std::size_t>(place), colors.size() - 2);
    const double share = place - static_cast<double>(below);
    std::array<std::uint8_t, 3> color{};
    for (std::size_t c = 0; c < color.size(); ++c)
        color[c] = static_cast<std::uint8_t>(
            std::lround((1 - share) * colors[below][c] + share * colors[below + 1][c]));
    return color;
}

}  // namespace nephrite::image
