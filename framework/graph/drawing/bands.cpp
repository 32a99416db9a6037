// Breaking a long drawing into bands, so that it has the shape of the pane it is shown in.
#include <algorithm>
#include <cmath>

#include "graph/drawing/arrangement.h"

namespace nephrite::graph {
namespace {

/// A break makes wires longer; it has to gain this much.
constexpr float gainOfABreak = 1.4F;

float columnPitch(const DrawingStyle& style) {
    return style.nodeWidth + style.columnGap;
}

Index layersPerBand(Index layers, Index bands) {
    return (layers + bands - 1) / bands;
}

/// Space above a band for the wires that come from the one before.
float roomForWires(std::size_t wires, const DrawingStyle& style) {
    return wireHeight * static_cast<float>(wires) + 2 * style.nodeGap;
}

/// Room left and right of the bands, where wires run from one to the next.
float sideRoom(const Arrangement& arrangement, const DrawingStyle& style) {
    std::size_t most = 0;
    for (std::size_t i = 1; i < arrangement.bands.size(); ++i)
        most = std::max(most, wiresInto(arrangement, arrangement.bands[i].first).size());
    return most == 0 ? 0 : wireHeight * static_cast<float>(most) + style.nodeGap;
}

}  // namespace

void breakIntoBands(Arrangement& arrangement, Index count, const DrawingStyle& style) {
    const auto layers = static_cast<Index>(arrangement.layers.size());
    const Index perBand = layersPerBand(layers, count);
    arrangement.bands.clear();
    float top = 0;
    for (Index first = 0; first < layers; first += perBand) {
        Band band{first, std::min(perBand, layers - first), 0, 0};
        if (first > 0) top += roomForWires(wiresInto(arrangement, first).size(), style);
        band.top = top;
        for (Index layer = first; layer < first + band.count; ++layer)
            band.height = std::max(band.height, packedHeight(arrangement, layer, style));
        top += band.height;
        arrangement.bands.push_back(band);
    }
}

Point extentOf(const Arrangement& arrangement, const DrawingStyle& style) {
    if (arrangement.bands.empty()) return {};
    const Band& last = arrangement.bands.back();
    const auto columns = static_cast<float>(arrangement.bands.front().count);
    return {columns * columnPitch(style) - style.columnGap + 2 * sideRoom(arrangement, style),
            last.top + last.height};
}

float scaleOf(const Arrangement& arrangement, const DrawingStyle& style) {
    const Point extent = extentOf(arrangement, style);
    return std::min({style.paneWidth / extent.x, style.paneHeight / extent.y, 1.0F});
}

Index bestBandCount(const Arrangement& arrangement, const DrawingStyle& style) {
    const auto layers = static_cast<Index>(arrangement.layers.size());
    const auto most = static_cast<Index>(std::sqrt(static_cast<float>(layers)) * 2);
    Index best = 1;
    float bestScale = 0;
    Arrangement tried = arrangement;
    for (Index count = 1; count <= std::max<Index>(most, 1); ++count) {
        breakIntoBands(tried, count, style);
        const float scale = scaleOf(tried, style) / (count == 1 ? 1 : gainOfABreak);
        if (scale <= bestScale) continue;
        best = count;
        bestScale = scale;
    }
    return best;
}

float leftOf(const Arrangement& arrangement, Index layer, const DrawingStyle& style) {
    const Index inBand = layer % arrangement.bands.front().count;
    return sideRoom(arrangement, style) + static_cast<float>(inBand) * columnPitch(style);
}

}  // namespace nephrite::graph
