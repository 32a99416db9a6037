// What the formulas need of a scene file: camera, lights and their views, materials, environment.
#pragma once

#include <filesystem>
#include <vector>

#include "reference/literal/environment.h"
#include "reference/literal/material.h"
#include "reference/literal/point_light.h"
#include "reference/literal/texels.h"
#include "scene/scene_description.h"

namespace nephrite::reference {

/// A quantity of a layer: a constant, or a texture.
struct LayerQuantity {
    glm::dvec3 constant{0};
    Texels texture;  ///< empty: the constant counts
    double scale = 1;

    /// Bilinear, repeating; u to the right, v down the texture's rows, texel centres at half-integers.
    glm::dvec3 at(glm::dvec2 uv) const;
};

struct MaterialLayer {
    LayerQuantity thickness;  ///< mm, in x
    LayerQuantity absorption;
    LayerQuantity scattering;  ///< not reduced
};

struct SceneData {
    View camera;
    std::vector<PointLight> lights;  ///< their views without images
    std::vector<Material> materials;
    std::vector<std::vector<MaterialLayer>> layers;  ///< of each material
    HarmonicRadiance environment{};
    Radiance environmentRadiance;
    std::size_t maxLayers = 0;

    LayerStack layersAt(std::size_t material, glm::dvec2 uv) const;
};

/// Reads a scene file for a picture of the given size.
SceneData readSceneData(const std::filesystem::path& file, std::uint32_t width, std::uint32_t height);

/// The view of a camera, from its definition: rays through a picture of square pixels, fovY its whole
/// vertical angle.
View pinholeView(const scene::CameraDescription& camera, std::uint32_t width, std::uint32_t height);

}  // namespace nephrite::reference
