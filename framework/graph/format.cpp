// The table of pixel formats and of buffer elements.
#include "graph/format.h"

namespace nephrite::graph {
namespace {

constexpr std::array<FormatInfo, 21> table{{
    {Format::r8, "r8", "r8", 1, 1, false, false},
    {Format::rg8, "rg8", "rg8", 2, 2, false, false},
    {Format::rgba8, "rgba8", "rgba8", 4, 4, false, false},
    {Format::r8snorm, "r8snorm", "r8_snorm", 1, 1, false, false},
    {Format::rg8snorm, "rg8snorm", "rg8_snorm", 2, 2, false, false},
    {Format::rgba8snorm, "rgba8snorm", "rgba8_snorm", 4, 4, false, false},
    {Format::r16unorm, "r16unorm", "r16", 1, 2, false, false},
    {Format::rg16unorm, "rg16unorm", "rg16", 2, 4, false, false},
    {Format::rgba16unorm, "rgba16unorm", "rgba16", 4, 8, false, false},
    {Format::r16snorm, "r16snorm", "r16_snorm", 1, 2, false, false},
    {Format::rg16snorm, "rg16snorm", "rg16_snorm", 2, 4, false, false},
    {Format::rgba16snorm, "rgba16snorm", "rgba16_snorm", 4, 8, false, false},
    {Format::r16f, "r16f", "r16f", 1, 2, false, false},
    {Format::rg16f, "rg16f", "rg16f", 2, 4, false, false},
    {Format::rgba16f, "rgba16f", "rgba16f", 4, 8, false, false},
    {Format::r32f, "r32f", "r32f", 1, 4, false, false},
    {Format::rg32f, "rg32f", "rg32f", 2, 8, false, false},
    {Format::rgba32f, "rgba32f", "rgba32f", 4, 16, false, false},
    {Format::r32u, "r32u", "r32ui", 1, 4, true, false},
    {Format::r11g11b10f, "r11g11b10f", "r11f_g11f_b10f", 3, 4, false, false},
    {Format::d32f, "d32f", "", 1, 4, false, true},
}};

/// Names that mean the same as another.
struct Alias {
    std::string_view name;
    Format format;
};
constexpr std::array<Alias, 3> aliases{
    {{"r8unorm", Format::r8}, {"rg8unorm", Format::rg8}, {"rgba8unorm", Format::rgba8}}};

constexpr std::array<std::string_view, 12> elements{"float", "vec2",  "vec3", "vec4",  "int",   "ivec2",
                                                    "ivec3", "ivec4", "uint", "uvec2", "uvec3", "uvec4"};

}  // namespace

std::span<const FormatInfo> allFormats() {
    return table;
}

const FormatInfo& info(Format format) {
    return table[static_cast<std::size_t>(format)];
}

std::vector<std::string_view> formatNames() {
    std::vector<std::string_view> names;
    for (const FormatInfo& row : table) names.push_back(row.name);
    for (const Alias& alias : aliases) names.push_back(alias.name);
    return names;
}

std::optional<Format> formatNamed(std::string_view name) {
    for (const FormatInfo& row : table) {
        if (row.name == name) return row.format;
    }
    for (const Alias& alias : aliases) {
        if (alias.name == name) return alias.format;
    }
    return std::nullopt;
}

std::span<const std::string_view> bufferElements() {
    return elements;
}

std::optional<std::uint32_t> bufferElementBytes(std::string_view element) {
    for (const std::string_view known : elements) {
        if (known != element) continue;
        const char last = element.back();
        if (last == '2') return 8;
        return last == '3' || last == '4' ? 16 : 4;  // std430 strides a vec3 like a vec4
    }
    return std::nullopt;
}

}  // namespace nephrite::graph
