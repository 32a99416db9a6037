// A coarse grid over the picture: slowly varying light is computed at every `stride`-th pixel each way and interpolated
// between them where that is safe.
#ifndef COARSE_GRID_GLSL
#define COARSE_GRID_GLSL

/// Pixels from one point of the grid to the next.
int gridStride(ivec2 fine, ivec2 coarse) {
    ivec2 stride = (fine + coarse - 1) / coarse;
    return max(max(stride.x, stride.y), 1);
}

/// The pixel at which a point of the grid lies.
ivec2 pixelAtGrid(ivec2 point, int stride, ivec2 fine) {
    return min(point * stride + stride / 2, fine - 1);
}

/// The four points of the grid around a pixel.
struct GridCell {
    bool isWhole;   // false at the picture's edge, where there are not four
    ivec2 first;    // the upper left point
    vec4 weights;   // bilinear, of first + (0,0), (1,0), (0,1), (1,1)
};

GridCell gridCellOf(ivec2 pixelAt, int stride, ivec2 coarse) {
    vec2 place = vec2(pixelAt - stride / 2) / float(stride);
    ivec2 first = ivec2(floor(place));
    bool isWhole = all(greaterThanEqual(first, ivec2(0))) && all(lessThan(first + 1, coarse));
    vec2 f = place - vec2(first);
    vec4 weights = vec4((1.0 - f.x) * (1.0 - f.y), f.x * (1.0 - f.y), (1.0 - f.x) * f.y, f.x * f.y);
    return GridCell(isWhole, first, weights);
}

ivec2 cornerOf(GridCell cell, int corner) {
    return cell.first + ivec2(corner & 1, corner >> 1);
}

#endif
