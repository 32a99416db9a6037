// L_id: diffuse reflection darkened by screen-space ambient occlusion, L_id = rho/pi E AO.
// AO is the obscurance of McGuire, Osman, Bukowski and Hennessy, "The Alchemy screen-space ambient obscurance algorithm"
// (2011): each sample nearby counts by how steeply it rises over the tangent plane.
#include "sampling.glsl"
#include "surface.glsl"

/// How much the point at v mm from the shaded one obscures it, 1/mm. `lift` (mm) ignores what rises less than that.
float obscurance(vec3 v, vec3 surfaceNormal, float lift) {
    float squaredDistance = dot(v, v);
    float squaredRadius = params.radius * params.radius;
    if (squaredDistance > squaredRadius) return 0.0;
    return max(0.0, dot(v, surfaceNormal) - lift) / (squaredDistance + 1e-4 * squaredRadius);
}

/// AO, 0 (closed in) to 1 (open).
float ambientOcclusion(ivec2 p, vec3 surfacePoint, vec3 surfaceNormal) {
    vec2 lastTexel = vec2(extent(position) - 1);
    float viewDistance = distance(surfacePoint, camera.position);
    float radiusInPixels = params.radius * (lastTexel.y + 1.0) / max(2.0 * viewDistance * camera.tanHalfFovY, 1e-20);
    float firstAngle = pixelAngle(p);
    float sum = 0.0;
    for (uint i = 0u; i < params.samples; ++i) {
        vec2 offset = radiusInPixels * spiralPoint(i, params.samples, params.turns, firstAngle);
        ivec2 q = ivec2(clamp(vec2(p) + floor(offset + 0.5), vec2(0.0), lastTexel));
        vec4 neighbour = load(position, q);
        if (neighbour.w == 0.0) continue;
        sum += obscurance(neighbour.xyz - surfacePoint, surfaceNormal, params.bias * viewDistance);
    }
    return max(0.0, 1.0 - 2.0 * params.intensity / float(params.samples) * sum);
}

void pixel(ivec2 p) {
    const float inversePi = 0.318309886183791;
    vec4 point = load(position, p);
    vec3 reflected = vec3(0.0);
    if (point.w > 0.0) {
        vec3 n = unitOrZero(load(normal, p).xyz);
        vec3 albedo = materials[materialOf(load(surface, p))].diffuse;
        reflected = albedo * inversePi * load(irradiance, p).rgb * ambientOcclusion(p, point.xyz, n);
    }
    store(radiance, p, vec4(reflected, point.w));
}
