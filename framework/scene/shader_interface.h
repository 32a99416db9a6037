// How shaders see the scene: the C++ structs of descriptor set 0 and the GLSL text that declares the same.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstdint>
#include <string>

#include "scene/view.h"

namespace nephrite::scene {

/// Bindings of descriptor set 0.
enum class SceneBinding : std::uint32_t {
    Frame = 0,   ///< uniform buffer
    Lights = 1,  ///< storage buffers up to LayerTexels
    LightViews = 2,
    Materials = 3,
    Layers = 4,
    LayerTexels = 5,
    EnvironmentMap = 6,  ///< combined image sampler
    Objects = 7,         ///< storage buffer
};

/// Binding 0, std140: what changes with the frame.
struct GpuFrame {
    View camera;
    std::uint32_t lightCount = 0;
    std::uint32_t lightViewCount = 0;
    std::uint32_t materialCount = 0;
    float time = 0;                          ///< seconds
    glm::vec4 environmentCoefficients[9]{};  ///< xyz: radiance L_lm in W/mm^2/sr, ordered (0,0) (1,-1) (1,0)
                                             ///< (1,1) (2,-2) .. (2,2)
};
static_assert(sizeof(GpuFrame) == 208 + 16 + 9 * 16);

/// Binding 1, std430.
struct GpuLight {
    glm::vec3 position{0};        ///< mm
    std::uint32_t firstView = 0;  ///< in lightViews
    glm::vec3 intensity{0};       ///< W/sr
    std::uint32_t viewCount = 0;  ///< 1 or 6
};
static_assert(sizeof(GpuLight) == 32);

/// Binding 3, std430.
struct GpuMaterial {
    glm::vec3 diffuse{0};
    float roughness = 0;
    float g = 0;
    float eta = 1;
    std::uint32_t firstLayer = 0;  ///< in the layers
    std::uint32_t layerCount = 0;  ///< 0: opaque
    std::uint32_t specular = 0;
    std::uint32_t padding[3] = {0, 0, 0};
};
static_assert(sizeof(GpuMaterial) == 48);

/// A texture in the layer texels: `width` x `height` x `channels` floats from `offset`; no channels: not
/// textured.
struct GpuLayerTexture {
    std::uint32_t offset = 0;
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::uint32_t channels = 0;
};

/// Binding 4, std430. A textured quantity is its texel times the value here.
struct GpuLayer {
    glm::vec3 absorption{0};  ///< 1/mm
    float thickness = 0;      ///< mm, 1e30 for infinite
    glm::vec3 scattering{0};  ///< 1/mm, not reduced
    float padding = 0;
    GpuLayerTexture absorptionTexture;
    GpuLayerTexture scatteringTexture;
    GpuLayerTexture thicknessTexture;
};
static_assert(sizeof(GpuLayer) == 80);

/// Binding 7, std430.
struct GpuObject {
    glm::mat4 world{1};         ///< mesh to world, mm
    glm::mat4 normalMatrix{1};  ///< upper 3x3: inverse transpose of world's
    std::uint32_t material = 0;
    std::uint32_t padding[3] = {0, 0, 0};
};
static_assert(sizeof(GpuObject) == 144);

/// What an infinite thickness is in shaders and images, mm.
inline constexpr float infiniteThickness = 1e30F;

/// GLSL for every stage, to stand after #version: structs, the bindings of set 0, camera, lights, lightViews,
/// lightCount, lightViewCount, materials, materialCount, time, viewRay, lightTexelOf, layerAt,
/// environmentRadiance, environmentIrradiance. Names that begin with `scene_` are its own.
std::string shaderInterface();

/// Whose eyes a raster pass draws with.
enum class RasterView : std::uint8_t { Camera, Light };

/// A whole vertex stage after #version and shaderInterface(): push constants `uint iteration` (offset 0 of 16
/// bytes), inputs as GpuScene's vertex attributes, and outputs location 0 vec3 world position (mm), 1 vec3
/// normal (not unit, outward as the mesh has it), 2 vec2 texture coordinates, 3 flat uint material. Light:
/// draws lightViews[iteration].
std::string vertexStage(RasterView view);

}  // namespace nephrite::scene
