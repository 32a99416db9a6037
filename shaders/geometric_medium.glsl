// What sources placed by geometry need to know of a medium, and how strong they are.
#ifndef GEOMETRIC_MEDIUM_GLSL
#define GEOMETRIC_MEDIUM_GLSL

#include "bssrdf.glsl"
#include "exitance.glsl"
#include "half_space_reflectance.glsl"

/// What the kernel needs of the medium, each channel apart.
struct GeometricMedium {
    vec3 transport;      // sigma_tr, 1/mm
    vec3 freePath;       // 1/sigma_t', mm
    vec3 extrapolation;  // 2 z_b, mm
    vec3 absorbed;       // sqrt(1 - alpha')
    vec3 reflectance;    // total, of a half space lit perpendicularly
    vec3 single;         // the part of it that is scattered once
    vec3 apart;          // which part of that the sources leave out
    vec3 fluenceShare;   // which part of the exitance follows the fluence, the rest the flow
    vec3 planeShare;     // what a plane's sources need for a total of 1
    vec3 slabDepth;      // (z_r + z_b) e^(-sigma_tr z_b) (1 - e^-2x)/x, x = sigma_tr (z_r + z_b), mm: see shareOfSlab
};

/// Which part of single scattering the sources leave out, by sqrt(1 - alpha'). Where absorption is low their total carries
/// far, and without that part it would carry too little; where it is high light leaves by its first scattering more often
/// than it goes on. Measured on spheres, see docs/model.md.
vec3 partApart(vec3 absorbed) {
    return smoothstep(0.15, 0.4, absorbed);
}

/// Which part of the exitance follows the fluence. In diffusion what leaves is part fluence, part flow (d'Eon and Irving 2011);
/// on curved surfaces the fluence of a source and its mirror image reaches too far where little is absorbed. Measured on
/// spheres, see docs/model.md.
vec3 partOfFluence(vec3 absorbed) {
    return min(0.8 * absorbed, vec3(0.12));
}

/// (1 - e^-2x)/x.
vec3 fallOver(vec3 x) {
    return mix((1.0 - exp(-2.0 * x)) / max(x, vec3(1e-3)), 2.0 - 2.0 * x, lessThan(x, vec3(1e-3)));
}

/// 1 over what a plane of unit sources and their mirror images sends through the surface, x = sigma_tr z_b: the flow
/// 2 pi (1 + e^-2x), the fluence times D/z_b 2 pi (1 - e^-2x)/x.
vec3 planeShareOf(vec3 x, vec3 fluenceShare) {
    const float inverseTwoPi = 0.159154943091895;
    return inverseTwoPi / mix(1.0 + exp(-2.0 * x), fallOver(x), fluenceShare);
}

/// What a slab `thick` mm deep lets through in diffusion, sinh(sigma_tr (z_r + z_b))/sinh(sigma_tr (thick + 2 z_b)), over what
/// the source alone sends through its back, e^(-sigma_tr (thick - z_r))/2: at most 1. y + y coth y is taken as
/// y + sqrt(1 + y^2), y = sigma_tr (thick + 2 z_b).
vec3 shareOfSlab(GeometricMedium medium, float thick) {
    vec3 whole = thick + medium.extrapolation;
    vec3 y = medium.transport * whole;
    return min(medium.slabDepth / whole * (y + sqrt(1.0 + y * y)), vec3(1.0));
}

GeometricMedium geometricMediumOf(ShadedPoint point) {
    float boundary = boundaryMismatch(point.eta);
    Dipole dipole = dipoleUnder(boundary, point.absorption, point.scattering, point.g);
    vec3 extinction = max(point.absorption + point.scattering, vec3(1e-30));
    vec3 absorbed = sqrt(clamp(point.absorption * dipole.realDepth, 0.0, 1.0));
    vec3 single = singleReflectanceOverAlbedo(point.g, point.eta) * point.scattering / extinction;
    // The boundary at which diffuse light vanishes lies 0.7104 A free paths outside (Milne's problem; diffusion: 2/3).
    const float twiceMilne = 1.4209;
    vec3 extrapolation = twiceMilne * boundary * dipole.realDepth;
    vec3 share = partOfFluence(absorbed);
    vec3 toBoundary = 0.5 * dipole.transport * extrapolation;
    vec3 deep = dipole.realDepth + 0.5 * extrapolation;
    vec3 slabDepth = deep * exp(-toBoundary) * fallOver(dipole.transport * deep);
    return GeometricMedium(dipole.transport, dipole.realDepth, extrapolation, absorbed,
                           halfSpaceReflectance(dipole, point.absorption, point.eta), single, partApart(absorbed),
                           share, planeShareOf(toBoundary, share), slabDepth);
}

/// Strength of the sources of light that entered at `cosine`, per 4 pi: what a half space reflects of it, over what the
/// two sources send through a plane. Oblique light stays shallower: reflectance falls with the cosine as 1/(1 + 2 c s)
/// (Hapke 1981). sigma_tr/sigma_t' is sqrt(3 (1 - alpha')), also where nothing scatters and both are made up.
vec3 strengthOf(GeometricMedium medium, float cosine) {
    vec3 total = medium.reflectance * (1.0 + 2.0 * medium.absorbed) / (1.0 + 2.0 * cosine * medium.absorbed);
    vec3 scatteredMore = max(total - medium.apart * medium.single * singleObliquity(cosine), vec3(0.0));
    const float squareRootOfThree = 1.73205080756888;
    return medium.planeShare * scatteredMore * exp(squareRootOfThree * cosine * medium.absorbed);
}

#endif
