// Multiple scattering in the picture: points around the pixel are drawn from the dipole's own radial distribution in the
// tangent plane, looked up in the picture, weighted by R_d at their true distance and by their true area.
#include "dipole_sampling.glsl"
#include "exitance.glsl"

/// The pixel that shows the direction to a world point; `inside` false where there is none.
ivec2 pixelOf(vec3 worldPoint, out bool inside) {
    vec3 fromCamera = worldPoint - camera.position;
    float depth = dot(fromCamera, camera.forward);
    vec2 slope = vec2(dot(fromCamera, camera.right) / camera.tanHalfFovX, -dot(fromCamera, camera.up) / camera.tanHalfFovY);
    vec2 uv = 0.5 + 0.5 * slope / max(depth, 1e-30);
    inside = depth > 0.0 && all(greaterThanEqual(uv, vec2(0.0))) && all(lessThan(uv, vec2(1.0)));
    return inside ? ivec2(uv * vec2(extent(position))) : ivec2(0);
}

/// Area that a unit solid angle of the camera covers at a point, mm^2/sr.
float areaPerSolidAngle(vec3 worldPoint, vec3 normalThere) {
    vec3 toCamera = camera.position - worldPoint;
    return dot(toCamera, toCamera) / max(dot(unitOrZero(toCamera), normalThere), 0.05);
}

/// Samples for a kernel whose half lies within a disc of so many pixels.
uint tapsFor(ShadedPoint point, Sampler from) {
    const float pi = 3.14159265358979;
    float pixelWidth = 2.0 * distance(point.position, camera.position) * camera.tanHalfFovY / float(extent(position).y);
    float radius = quantileDistance(0.5, from.depth.x, from.transport) / max(pixelWidth, 1e-30);
    return uint(clamp(pi * radius * radius, float(params.leastTaps), float(max(params.mostTaps, params.leastTaps))));
}

/// Radiant exitance of a surface point, W/mm^2.
vec3 exitanceOf(ShadedPoint point, Dipole dipole, vec3 ownIrradiance) {
    const float goldenAngle = 2.39996322972865;
    Sampler from = samplerOf(dipole);
    uint taps = tapsFor(point, from);
    vec3 tangent = unitOrZero(cross(point.normal, abs(point.normal.x) < 0.7 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 1.0, 0.0)));
    vec3 bitangent = cross(point.normal, tangent);
    float planeArea = areaPerSolidAngle(point.position, point.normal);
    vec3 sum = vec3(0.0);
    vec3 weights = vec3(0.0);
    for (uint i = 0u; i < taps; ++i) {
        float u = (float(i) + 0.5) / float(taps);
        float squaredRadius = squaredRadiusAt(from, u);
        float angle = goldenAngle * float(i);
        vec3 aimed = point.position + sqrt(squaredRadius) * (cos(angle) * tangent + sin(angle) * bitangent);
        bool inside;
        ivec2 q = pixelOf(aimed, inside);
        vec4 entering = load(irradiance, q);
        if (!inside || entering.w != float(point.material + 1u)) continue;
        vec3 found = load(position, q).xyz;
        vec3 along = found - point.position;
        float area = areaPerSolidAngle(found, unitOrZero(load(normal, q).xyz)) / planeArea;
        vec3 weight = diffuseReflectance(dipole, dot(along, along)) * (area / densityAt(from, squaredRadius));
        sum += weight * entering.rgb;
        weights += weight;
    }
    vec3 mean = mix(sum / max(weights, vec3(1e-30)), ownIrradiance, lessThanEqual(weights, vec3(1e-30)));
    return totalReflectance(dipole) * mean;
}

void pixel(ivec2 p) {
    vec4 positionTexel = load(position, p);
    vec4 surfaceTexel = load(surface, p);
    vec3 scattered = vec3(0.0);
    if (positionTexel.w > 0.0 && materials[materialOf(surfaceTexel)].layerCount > 0u) {
        ShadedPoint point = shadedPointOf(positionTexel, load(normal, p), surfaceTexel);
        Dipole dipole = dipoleUnder(boundaryMismatch(point.eta), point.absorption, point.scattering, point.g);
        scattered = radianceOf(exitanceOf(point, dipole, load(irradiance, p).rgb), point);
    }
    store(radiance, p, vec4(scattered, positionTexel.w));
}
