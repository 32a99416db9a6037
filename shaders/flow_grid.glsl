// Completes the coarse grid of the diffuse flow for interpolation: says how far that may be off, and continues the surface by
// one point beyond its outline, so that pixels up to there have four points around them.
#include "coarse_grid.glsl"
#include "diffuse_flow.glsl"

/// A point of the grid.
struct GridPoint {
    float material;  // plus 1; 0 where nothing scatters
    vec3 position;   // mm
    DiffuseFlow flow;
};

const GridPoint emptyPoint = GridPoint(0.0, vec3(0.0), noFlow);

GridPoint gridPointAt(ivec2 p) {
    ivec2 coarse = extent(flowRed);
    ivec2 fine = extent(position);
    bool isInside = all(greaterThanEqual(p, ivec2(0))) && all(lessThan(p, coarse));
    vec4 red = load(flowRed, p);
    vec3 place = load(position, pixelAtGrid(p, gridStride(fine, coarse), fine)).xyz;
    return GridPoint(isInside ? red.w : 0.0, place, DiffuseFlow(red.xyz, load(flowGreen, p).xyz, load(flowBlue, p).xyz));
}

/// |second difference| along one direction, each channel. Where the surface ends there is only the first difference.
vec3 bend(GridPoint here, GridPoint before, GridPoint after) {
    DiffuseFlow first = before.material == here.material ? before.flow : here.flow;
    DiffuseFlow last = after.material == here.material ? after.flow : here.flow;
    DiffuseFlow middle = plus(plus(noFlow, first, vec3(0.5)), last, vec3(0.5));
    return 2.0 * sqrt(squaredDifference(middle, here.flow));
}

/// How far bilinear interpolation around a point may be off, relative to the flow: |second difference|/8 each way, the worst
/// channel.
float interpolationError(ivec2 p, GridPoint here) {
    vec3 strength = sqrt(squaredDifference(here.flow, noFlow));
    // A channel far darker than the others is seen only through them.
    const float visible = 0.02;
    vec3 scale = strength + visible * max(strength.r, max(strength.g, strength.b));
    vec3 off = bend(here, gridPointAt(p - ivec2(1, 0)), gridPointAt(p + ivec2(1, 0))) +
               bend(here, gridPointAt(p - ivec2(0, 1)), gridPointAt(p + ivec2(0, 1)));
    off /= 8.0 * max(scale, vec3(1e-30));
    return max(off.r, max(off.g, off.b));
}

/// The mean of what the surface's last two points in each direction extrapolate to; of the first direction's material.
GridPoint continuedAt(ivec2 p) {
    GridPoint sum = emptyPoint;
    float count = 0.0;
    for (int i = 0; i < 8; ++i) {
        int k = i < 4 ? i : i + 1;  // of 3 x 3 all but the middle
        ivec2 step = ivec2(k % 3, k / 3) - 1;
        GridPoint last = gridPointAt(p + step);
        GridPoint before = gridPointAt(p + 2 * step);
        bool continues = last.material != 0.0 && before.material == last.material &&
                         (count == 0.0 || last.material == sum.material);
        if (!continues) continue;
        sum.material = last.material;
        sum.position += 2.0 * last.position - before.position;
        sum.flow = plus(plus(sum.flow, last.flow, vec3(2.0)), before.flow, vec3(-1.0));
        count += 1.0;
    }
    float share = 1.0 / max(count, 1.0);
    return GridPoint(sum.material, share * sum.position, plus(noFlow, sum.flow, vec3(share)));
}

void pixel(ivec2 p) {
    GridPoint here = gridPointAt(p);
    float off = 0.0;
    if (here.material != 0.0) {
        off = interpolationError(p, here);
    } else {
        here = continuedAt(p);
    }
    store(gridRed, p, vec4(here.flow.red, here.material));
    store(gridGreen, p, vec4(here.flow.green, here.material));
    store(gridBlue, p, vec4(here.flow.blue, here.material));
    store(gridPlace, p, vec4(here.position, off));
}
