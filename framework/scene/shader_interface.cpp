// The GLSL text of descriptor set 0 and of the raster vertex stage.
#include "scene/shader_interface.h"

#include <cstddef>

namespace nephrite::scene {
namespace {

// The offsets GLSL gives the members below (std140 and std430 agree on these structs).
static_assert(offsetof(View, inverseViewProjection) == 64 && offsetof(View, position) == 128);
static_assert(offsetof(View, near) == 140 && offsetof(View, forward) == 144 && offsetof(View, far) == 156);
static_assert(offsetof(View, right) == 160 && offsetof(View, tanHalfFovX) == 172 &&
              offsetof(View, up) == 176);
static_assert(offsetof(View, tanHalfFovY) == 188 && offsetof(View, light) == 192);
static_assert(offsetof(GpuFrame, lightCount) == 208 && offsetof(GpuFrame, time) == 220);
static_assert(offsetof(GpuFrame, environmentCoefficients) == 224);
static_assert(offsetof(GpuLight, firstView) == 12 && offsetof(GpuLight, intensity) == 16 &&
              offsetof(GpuLight, viewCount) == 28);
static_assert(offsetof(GpuMaterial, roughness) == 12 && offsetof(GpuMaterial, g) == 16 &&
              offsetof(GpuMaterial, eta) == 20 && offsetof(GpuMaterial, firstLayer) == 24 &&
              offsetof(GpuMaterial, layerCount) == 28 && offsetof(GpuMaterial, specular) == 32);
static_assert(offsetof(GpuLayer, thickness) == 12 && offsetof(GpuLayer, scattering) == 16 &&
              offsetof(GpuLayer, absorptionTexture) == 32 && offsetof(GpuLayer, scatteringTexture) == 48 &&
              offsetof(GpuLayer, thicknessTexture) == 64);
static_assert(offsetof(GpuObject, normalMatrix) == 64 && offsetof(GpuObject, material) == 128);

constexpr const char* declarations = R"glsl(
struct View {
    mat4 viewProjection; mat4 inverseViewProjection;
    vec3 position; float near; vec3 forward; float far; vec3 right; float tanHalfFovX; vec3 up; float tanHalfFovY;
    uint light; uint padding0; uint padding1; uint padding2;
};
struct Light { vec3 position; uint firstView; vec3 intensity; uint viewCount; };
struct Material {
    vec3 diffuse; float roughness; float g; float eta; uint firstLayer; uint layerCount;
    uint specular; uint padding0; uint padding1; uint padding2;
};
struct scene_Layer {
    vec3 absorption; float thickness; vec3 scattering; float padding0;
    uvec4 absorptionTexture; uvec4 scatteringTexture; uvec4 thicknessTexture;  // offset, width, height, channels
};
struct scene_Object { mat4 world; mat4 normalMatrix; uint material; uint padding0; uint padding1; uint padding2; };
struct LayerCoefficients { float thickness; vec3 absorption; vec3 scattering; };
struct LightTexel { bool inside; uint view; vec2 uv; };

layout(set = 0, binding = 0, std140) uniform scene_Frame {
    View camera;
    uint lightCount; uint lightViewCount; uint materialCount; float time;
    vec4 scene_environmentCoefficients[9];
};
layout(set = 0, binding = 1, std430) readonly buffer scene_Lights { Light lights[]; };
layout(set = 0, binding = 2, std430) readonly buffer scene_LightViews { View lightViews[]; };
layout(set = 0, binding = 3, std430) readonly buffer scene_Materials { Material materials[]; };
layout(set = 0, binding = 4, std430) readonly buffer scene_Layers { scene_Layer scene_layers[]; };
layout(set = 0, binding = 5, std430) readonly buffer scene_LayerTexels { float scene_layerTexels[]; };
layout(set = 0, binding = 6) uniform sampler2D scene_environmentMap;
layout(set = 0, binding = 7, std430) readonly buffer scene_Objects { scene_Object scene_objects[]; };
)glsl";

constexpr const char* views = R"glsl(
// Unit world direction through uv (0..1, y down).
vec3 viewRay(View view, vec2 uv) {
    vec2 p = (2.0 * uv - 1.0) * vec2(view.tanHalfFovX, view.tanHalfFovY);
    return normalize(view.forward + p.x * view.right - p.y * view.up);
}

// The cube face that sees a direction: +x, -x, +y, -y, +z, -z.
uint scene_cubeFace(vec3 d) {
    vec3 a = abs(d);
    if (a.x >= a.y && a.x >= a.z) return d.x >= 0.0 ? 0u : 1u;
    if (a.y >= a.z) return d.y >= 0.0 ? 2u : 3u;
    return d.z >= 0.0 ? 4u : 5u;
}

// Which view of a light sees a world position, as an index of lightViews, and where in it (0..1, y down).
LightTexel lightTexelOf(uint light, vec3 worldPosition) {
    vec3 d = worldPosition - lights[light].position;
    bool cube = lights[light].viewCount == 6u;
    uint index = lights[light].firstView + (cube ? scene_cubeFace(d) : 0u);
    // By the matrix, whose last column is rounded once: of a light far away worldPosition - position would lose what a
    // texel is wide.
    vec4 clip = lightViews[index].viewProjection * vec4(worldPosition, 1.0);
    if (!(clip.w > 0.0)) return LightTexel(false, index, vec2(0.5));
    vec2 uv = 0.5 + 0.5 * clip.xy / clip.w;
    if (cube) return LightTexel(true, index, clamp(uv, 0.0, 1.0));
    return LightTexel(all(greaterThanEqual(uv, vec2(0.0))) && all(lessThanEqual(uv, vec2(1.0))), index, uv);
}
)glsl";

constexpr const char* layerLookup = R"glsl(
vec3 scene_layerTexel(uvec4 image, uint x, uint y) {
    uint at = image.x + (y * image.y + x) * image.w;
    if (image.w == 1u) return vec3(scene_layerTexels[at]);
    return vec3(scene_layerTexels[at], scene_layerTexels[at + 1u], scene_layerTexels[at + 2u]);
}

// Bilinear, repeating in both directions; row 0 at v = 0.
vec3 scene_layerSample(uvec4 image, vec2 uv) {
    vec2 size = vec2(image.yz);
    vec2 t = (uv - floor(uv)) * size - 0.5;
    vec2 low = floor(t);
    vec2 f = t - low;
    uint x0 = (uint(int(low.x) + int(image.y))) % image.y, x1 = (x0 + 1u) % image.y;
    uint y0 = (uint(int(low.y) + int(image.z))) % image.z, y1 = (y0 + 1u) % image.z;
    return mix(mix(scene_layerTexel(image, x0, y0), scene_layerTexel(image, x1, y0), f.x),
               mix(scene_layerTexel(image, x0, y1), scene_layerTexel(image, x1, y1), f.x), f.y);
}

// A layer of a material, 0 at the surface; all zero beyond its last. Thickness in mm (1e30: infinite), the others in
// 1/mm, scattering not reduced.
LayerCoefficients layerAt(uint material, uint layer, vec2 uv) {
    if (layer >= materials[material].layerCount) return LayerCoefficients(0.0, vec3(0.0), vec3(0.0));
    uint index = materials[material].firstLayer + layer;
    LayerCoefficients result =
        LayerCoefficients(scene_layers[index].thickness, scene_layers[index].absorption, scene_layers[index].scattering);
    uvec4 image = scene_layers[index].thicknessTexture;
    if (image.w != 0u) result.thickness *= scene_layerSample(image, uv).x;
    image = scene_layers[index].absorptionTexture;
    if (image.w != 0u) result.absorption *= scene_layerSample(image, uv);
    image = scene_layers[index].scatteringTexture;
    if (image.w != 0u) result.scattering *= scene_layerSample(image, uv);
    return result;
}
)glsl";

constexpr const char* environmentLookup = R"glsl(
// Radiance from a direction, W/mm^2/sr. Lat-long, +y up, the image's middle at -z; bilinear.
vec3 environmentRadiance(vec3 direction) {
    const float pi = 3.14159265358979;
    ivec2 size = textureSize(scene_environmentMap, 0);
    vec3 d = normalize(direction);
    float azimuth = d.x == 0.0 && d.z == 0.0 ? 0.0 : atan(d.x, -d.z);
    float polar = atan(length(d.xz), d.y);  // some drivers' acos is good to 1e-4 only
    vec2 t = vec2(0.5 + azimuth / (2.0 * pi), polar / pi) * vec2(size) - 0.5;
    vec2 low = floor(t);
    vec2 f = t - low;
    int x0 = (int(low.x) + size.x) % size.x, x1 = (x0 + 1) % size.x;
    int y0 = clamp(int(low.y), 0, size.y - 1), y1 = clamp(int(low.y) + 1, 0, size.y - 1);
    return mix(mix(texelFetch(scene_environmentMap, ivec2(x0, y0), 0).rgb, texelFetch(scene_environmentMap, ivec2(x1, y0), 0).rgb, f.x),
               mix(texelFetch(scene_environmentMap, ivec2(x0, y1), 0).rgb, texelFetch(scene_environmentMap, ivec2(x1, y1), 0).rgb, f.x), f.y);
}

// Irradiance on a plane of unit normal from the environment's first nine spherical harmonics, W/mm^2
// (Ramamoorthi and Hanrahan 2001).
vec3 environmentIrradiance(vec3 n) {
    const float pi = 3.14159265358979;
    vec3 l0 = scene_environmentCoefficients[0].xyz * 0.28209479177387814;
    vec3 l1 = (scene_environmentCoefficients[1].xyz * n.y + scene_environmentCoefficients[2].xyz * n.z +
               scene_environmentCoefficients[3].xyz * n.x) * 0.4886025119029199;
    vec3 l2 = (scene_environmentCoefficients[4].xyz * (n.x * n.y) + scene_environmentCoefficients[5].xyz * (n.y * n.z) +
               scene_environmentCoefficients[7].xyz * (n.x * n.z)) * 1.0925484305920792 +
              scene_environmentCoefficients[6].xyz * (0.31539156525252005 * (3.0 * n.z * n.z - 1.0)) +
              scene_environmentCoefficients[8].xyz * (0.5462742152960396 * (n.x * n.x - n.y * n.y));
    return max(pi * l0 + (2.0 * pi / 3.0) * l1 + (pi / 4.0) * l2, vec3(0.0));
}
)glsl";

constexpr const char* vertexDeclarations = R"glsl(
layout(push_constant) uniform scene_Push { uint scene_iteration; };
layout(location = 0) in vec3 scene_position;
layout(location = 1) in vec3 scene_normal;
layout(location = 2) in vec2 scene_uv;
layout(location = 0) out vec3 scene_outPosition;
layout(location = 1) out vec3 scene_outNormal;
layout(location = 2) out vec2 scene_outUv;
layout(location = 3) flat out uint scene_outMaterial;
invariant gl_Position;
void main() {
    vec4 world = scene_objects[gl_InstanceIndex].world * vec4(scene_position, 1.0);
    scene_outPosition = world.xyz;
    scene_outNormal = mat3(scene_objects[gl_InstanceIndex].normalMatrix) * scene_normal;
    scene_outUv = scene_uv;
    scene_outMaterial = scene_objects[gl_InstanceIndex].material;
    gl_Position = VIEW.viewProjection * world;
}
)glsl";

}  // namespace

std::string shaderInterface() {
    return std::string(declarations) + views + layerLookup + environmentLookup;
}

std::string vertexStage(RasterView view) {
    std::string text = vertexDeclarations;
    const std::string placeholder = "VIEW";
    text.replace(text.find(placeholder), placeholder.size(),
                 view == RasterView::Camera ? "camera" : "lightViews[scene_iteration]");
    return text;
}

}  // namespace nephrite::scene
