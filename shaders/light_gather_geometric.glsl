// Single and multiple scattering by sources placed by geometry, interpolated from the coarse grid where the light varies
// slowly. The other pixels are marked for light_gather_geometric_rest.glsl.
#include "coarse_grid.glsl"
#include "flow_radiance.glsl"

/// Flow interpolated from the coarse grid.
struct InterpolatedFlow {
    bool isSafe;
    DiffuseFlow flow;
};

/// Safe where four points of the same material surround the pixel in the plane of their positions, up to a part of a mean
/// free path, and interpolating between them is off by `interpolationTolerance` at most.
InterpolatedFlow interpolatedFlow(ivec2 p, ShadedPoint point, GeometricMedium medium) {
    ivec2 coarse = extent(gridRed);
    GridCell cell = gridCellOf(p, gridStride(extent(position), coarse), coarse);
    vec3 meanPosition = vec3(0.0);
    DiffuseFlow flow = noFlow;
    bool isSafe = cell.isWhole;
    for (int i = 0; i < 4; ++i) {
        ivec2 corner = cornerOf(cell, i);
        vec4 red = load(gridRed, corner);
        vec4 place = load(gridPlace, corner);
        isSafe = isSafe && red.w == float(point.material + 1u) && place.w <= params.interpolationTolerance;
        meanPosition += cell.weights[i] * place.xyz;
        flow = plus(flow, DiffuseFlow(red.xyz, load(gridGreen, corner).xyz, load(gridBlue, corner).xyz), vec3(cell.weights[i]));
    }
    const float near = 0.3;
    vec3 away = point.position - meanPosition;
    float reach = near * min(medium.freePath.x, min(medium.freePath.y, medium.freePath.z));
    return InterpolatedFlow(isSafe && dot(away, away) <= reach * reach, flow);
}

void pixel(ivec2 p) {
    vec4 positionTexel = load(position, p);
    vec4 surfaceTexel = load(surface, p);
    vec3 scattered = vec3(0.0);
    float mark = 0.0;
    if (positionTexel.w > 0.0 && materials[materialOf(surfaceTexel)].layerCount > 0u) {
        ShadedPoint point = shadedPointOf(positionTexel, load(normal, p), surfaceTexel);
        GeometricMedium medium = geometricMediumOf(point);
        // Without a grid there is no light to gather, only the environment's.
        InterpolatedFlow interpolated = InterpolatedFlow(true, noFlow);
        if (connected(gridRed)) interpolated = interpolatedFlow(p, point, medium);
        if (interpolated.isSafe) scattered = scatteredRadiance(interpolated.flow, point, medium);
        mark = interpolated.isSafe ? 0.0 : 1.0;
    }
    store(radiance, p, vec4(scattered, positionTexel.w));
    store(rest, p, vec4(mark));
}
