// Multiple scattering, Eqs. 12 and 13 as printed: the dipole's R_d times the irradiance of the nearest pixels, each taken
// as a point light on the surface. As in the paper, no pixel has an area and a pixel does not light itself, so that the
// brightness depends on the resolution.
#include "bssrdf.glsl"
#include "nearest_offsets.glsl"
#include "surface.glsl"

/// L_ims (Eq. 13) of a translucent surface point.
vec3 multipleScattering(ivec2 p, vec3 surfacePoint, Dipole dipole) {
    vec3 sum = vec3(0.0);
    ivec2 size = extent(position);
    for (uint i = 0u; i < params.taps; ++i) {
        ivec2 q = p + nearestOffsets[i];
        bool inImage = all(greaterThanEqual(q, ivec2(0))) && all(lessThan(q, size));
        vec4 neighbour = load(position, q);
        if (!inImage || neighbour.w == 0.0) continue;
        vec3 along = neighbour.xyz - surfacePoint;
        sum += diffuseReflectance(dipole, dot(along, along)) * load(irradiance, q).rgb;
    }
    return sum;
}

void pixel(ivec2 p) {
    vec4 point = load(position, p);
    vec3 sum = vec3(0.0);
    if (point.w > 0.0) {
        uint material = materialOf(load(surface, p));
        if (materials[material].layerCount > 0u) {
            Dipole dipole = dipoleOf(loadLayer(absorption, p, 0).rgb, loadLayer(scattering, p, 0).rgb,
                                     materials[material].g, materials[material].eta);
            sum = multipleScattering(p, point.xyz, dipole);
        }
    }
    store(radiance, p, vec4(sum, point.w));
}
