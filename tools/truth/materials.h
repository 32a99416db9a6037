// What light meets inside the scene's materials: coefficients by depth below the surface and colour channel.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "scattering/medium.h"
#include "scene/scene.h"

namespace nephrite::truth {

/// A layer quantity: a constant, or a constant times a texture (bilinear, repeating, row 0 at v = 0).
struct LayerQuantity {
    glm::dvec3 value{0, 0, 0};
    std::uint32_t width = 0;   ///< 0: not textured
    std::uint32_t height = 0;  ///< texels
    std::uint32_t channels = 0;
    std::span<const float> texels;

    glm::dvec3 at(const glm::dvec2& textureCoordinates) const;
    glm::dvec3 greatest() const;
};

struct MaterialLayer {
    LayerQuantity thickness;   ///< mm, channel 0; may be infinite
    LayerQuantity absorption;  ///< 1/mm
    LayerQuantity scattering;  ///< 1/mm, not reduced
};

/// A surface and what lies under it. Without layers it is opaque.
struct Material {
    double g = 0;
    double eta = 1;
    std::vector<MaterialLayer> layers;
    /// No depth within the layers that end, the last left out, is greater (mm).
    double layeredDepth = 0;
    /// Bounds sigma_t of every layer, 1/mm, by channel.
    glm::dvec3 greatestExtinction{0, 0, 0};
    /// One endless layer without textures: the same medium everywhere.
    bool homogeneous = false;

    bool translucent() const { return !layers.empty(); }
    /// The medium at a depth (mm) below the point of the surface with these texture coordinates. Below a last
    /// layer that ends there is a void.
    scattering::Medium at(double depth, const glm::dvec2& textureCoordinates, int channel) const;
};

/// The materials of a scene, which must outlive them.
std::vector<Material> materialsOf(const scene::Scene& scene);

}  // namespace nephrite::truth
