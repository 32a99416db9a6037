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
    ivec2 regions = regionsOf(extent(position));
    ivec2 groups = (extent(gathered) + 7) / 8;
    // Several groups of 8 x 8 share a region, where there are enough of them; what is left over of them has nothing to do.
    int sharers = clamp(groups.x * groups.y / (regions.x * regions.y), 1, 16);
    int teams = groups.x * groups.y / sharers;
    int group = int(id.y >> 3u) * groups.x + int(id.x >> 3u);
    int team = group / sharers;
    int member = int((id.y & 7u) * 8u + (id.x & 7u)) + 64 * (group % sharers);
    int count = 0;
    for (int i = team < teams ? team : regions.x * regions.y; i < regions.x * regions.y; i += teams) {
        ivec2 region = ivec2(i % regions.x, i / regions.x);
        int marked = markedInRegion(region);
        for (int k = member; k < marked; k += 64 * sharers) {
            gather(markedPixel(region, k));
            ++count;
        }
    }
    if (all(lessThan(ivec2(id.xy), extent(gathered)))) store(gathered, ivec2(id.xy), uvec4(count));
}
