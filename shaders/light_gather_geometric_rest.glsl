// Gathers the light of the pixels that light_gather_geometric.glsl could not interpolate.
#include "flow_radiance.glsl"
#include "geometric_source.glsl"
#include "packed_pixels.glsl"

void gather(ivec2 p) {
    vec4 positionTexel = load(position, p);
    ShadedPoint point = shadedPointOf(positionTexel, load(normal, p), load(surface, p));
    GeometricMedium medium = geometricMediumOf(point);
    vec3 scattered = scatteredRadiance(diffuseFlow(point, medium), point, medium);
    store(radiance, p, vec4(scattered, positionTexel.w));
}

void compute(uvec3 id) {
    ivec2 groups = (extent(gathered) + 7) / 8;
    ivec2 group = ivec2(id.xy >> 3u);
    int member = int((id.y & 7u) * 8u + (id.x & 7u));
    ivec2 regions = regionsOf(extent(position));
    int count = 0;
    for (int i = group.y * groups.x + group.x; i < regions.x * regions.y; i += groups.x * groups.y) {
        ivec2 region = ivec2(i % regions.x, i / regions.x);
        int marked = markedInRegion(region);
        for (int k = member; k < marked; k += 64) {
            gather(markedPixel(region, k));
            ++count;
        }
    }
    if (all(lessThan(ivec2(id.xy), extent(gathered)))) store(gathered, ivec2(id.xy), uvec4(count));
}
