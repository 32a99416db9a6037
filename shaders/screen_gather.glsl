// Multiple scattering in the picture: points around the pixel are drawn from the dipole's own radial distribution in the
// tangent plane, looked up in the picture, weighted by R_d at their true distance and by their true area.
#include "bssrdf.glsl"
#include "exitance.glsl"

/// One medium that stands for the three channels when points are drawn: the channel that reaches farthest bounds the weights.
struct Sampler {
    vec2 depth;       // real and virtual source, mm
    float transport;  // 1/mm
    float realShare;  // of the samples
};

Sampler samplerOf(Dipole dipole) {
    const vec3 mean = vec3(1.0 / 3.0);
    vec2 depth = vec2(dot(dipole.realDepth, mean), dot(dipole.virtualDepth, mean));
    float transport = min(dipole.transport.x, min(dipole.transport.y, dipole.transport.z));
    return Sampler(depth, transport, 1.0 / (1.0 + exp(transport * (depth.x - depth.y))));
}

/// The distance d from a source at depth z within which the part xi of its light leaves: 1 - z/d e^(sigma_tr (z - d)) = xi.
/// With w = sigma_tr d that is w + ln w = known, solved by Newton's method.
float quantileDistance(float xi, float z, float transport) {
    float s = transport * z;
    if (s < 1e-6) return z / (1.0 - xi);
    float known = s + log(s) - log(1.0 - xi);
    float w = max(known > 1.0 ? known - log(known) : exp(known - 1.0), s);
    for (int i = 0; i < 4; ++i) w = w * (1.0 + known - log(w)) / (1.0 + w);
    return max(w / transport, z);
}

/// Density of the drawn points in the tangent plane, 1/mm^2.
float densityAt(Sampler from, float squaredRadius) {
    const float inverseTwoPi = 0.159154943091895;
    vec2 distances = sqrt(squaredRadius + from.depth * from.depth);
    vec2 s = from.transport * distances;
    vec2 perSource = from.depth * (1.0 + s) * exp(from.transport * from.depth - s) / (distances * distances * distances);
    return inverseTwoPi * dot(vec2(from.realShare, 1.0 - from.realShare), perSource);
}

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
        bool isReal = u < from.realShare;
        float z = isReal ? from.depth.x : from.depth.y;
        float d = quantileDistance(isReal ? u / from.realShare : (u - from.realShare) / (1.0 - from.realShare), z, from.transport);
        float squaredRadius = max(d * d - z * z, 0.0);
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
