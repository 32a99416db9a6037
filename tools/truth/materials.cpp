// From the scene's packed materials to coefficients in double precision.
#include "truth/materials.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <limits>

#include "scene/scene_state.h"

namespace nephrite::truth {
namespace {

/// A texture lookup's two neighbours along one side, and how far it is towards the second.
struct Neighbours {
    std::uint32_t first;
    std::uint32_t second;
    double fraction;
};

Neighbours neighbours(double coordinate, std::uint32_t size) {
    const double place = (coordinate - std::floor(coordinate)) * size - 0.5;
    const double low = std::floor(place);
    const auto first = (static_cast<std::uint32_t>(static_cast<std::int64_t>(low) + size)) % size;
    return {first, (first + 1) % size, place - low};
}

LayerQuantity quantity(const glm::dvec3& value, const scene::GpuLayerTexture& texture, double factor,
                       std::span<const float> texels) {
    LayerQuantity result;
    const bool textured = texture.channels > 0;
    result.value = textured ? glm::dvec3(factor) : value * factor;
    if (!textured) return result;
    result.width = texture.width;
    result.height = texture.height;
    result.channels = texture.channels;
    result.texels =
        texels.subspan(texture.offset, std::size_t{texture.width} * texture.height * texture.channels);
    return result;
}

Material material(const scene::MaterialDescription& description, const scene::GpuMaterial& packed,
                  const scene::PackedMaterials& all) {
    Material result;
    result.g = description.g;
    result.eta = description.eta;
    for (std::size_t i = 0; i < description.layers.size(); ++i) {
        const scene::LayerDescription& layer = description.layers[i];
        const scene::GpuLayer& gpu = all.layers[packed.firstLayer + i];
        const double factor = layer.reduced ? 1 / (1 - description.g) : 1;
        result.layers.push_back({quantity(glm::dvec3(layer.thickness), gpu.thicknessTexture, 1, all.texels),
                                 quantity(layer.absorption, gpu.absorptionTexture, 1, all.texels),
                                 quantity(layer.scattering, gpu.scatteringTexture, factor, all.texels)});
        const MaterialLayer& added = result.layers.back();
        result.greatestExtinction =
            glm::max(result.greatestExtinction, added.absorption.greatest() + added.scattering.greatest());
        if (i + 1 < description.layers.size()) result.layeredDepth += added.thickness.greatest().x;
    }
    if (result.layers.empty()) return result;
    const MaterialLayer& last = result.layers.back();
    const bool endless = std::isinf(last.thickness.value.x) && last.thickness.width == 0;
    if (!endless) result.layeredDepth += last.thickness.greatest().x;
    result.homogeneous =
        result.layers.size() == 1 && endless && last.absorption.width == 0 && last.scattering.width == 0;
    return result;
}

}  // namespace

glm::dvec3 LayerQuantity::at(const glm::dvec2& textureCoordinates) const {
    if (width == 0) return value;
    const Neighbours x = neighbours(textureCoordinates.x, width);
    const Neighbours y = neighbours(textureCoordinates.y, height);
    const auto texel = [&](std::uint32_t column, std::uint32_t row) {
        const std::size_t first = (std::size_t{row} * width + column) * channels;
        if (channels == 1) return glm::dvec3(texels[first]);
        return glm::dvec3(texels[first], texels[first + 1], texels[first + 2]);
    };
    const glm::dvec3 above = glm::mix(texel(x.first, y.first), texel(x.second, y.first), x.fraction);
    const glm::dvec3 below = glm::mix(texel(x.first, y.second), texel(x.second, y.second), x.fraction);
    return value * glm::mix(above, below, y.fraction);
}

glm::dvec3 LayerQuantity::greatest() const {
    if (width == 0) return value;
    glm::dvec3 greatest(0);
    for (std::size_t i = 0; i < texels.size(); ++i)
        for (int c = 0; c < 3; ++c)
            if (channels == 1 || static_cast<std::size_t>(c) == i % channels)
                greatest[c] = std::max(greatest[c], double{texels[i]});
    return value * greatest;
}

scattering::Medium Material::at(double depth, const glm::dvec2& textureCoordinates, int channel) const {
    const MaterialLayer* found = nullptr;
    for (const MaterialLayer& layer : layers) {
        found = &layer;
        const double thickness = layer.thickness.at(textureCoordinates).x;
        if (depth < thickness) break;
        depth -= thickness;
        found = nullptr;
    }
    if (found == nullptr) return {0, 0, g, eta};
    return {found->absorption.at(textureCoordinates)[channel],
            found->scattering.at(textureCoordinates)[channel], g, eta};
}

std::vector<Material> materialsOf(const scene::Scene& scene) {
    const scene::Scene::State& state = scene.state();
    std::vector<Material> materials;
    for (std::size_t i = 0; i < state.description.materials.size(); ++i)
        materials.push_back(
            material(state.description.materials[i], state.materials.materials[i], state.materials));
    return materials;
}

}  // namespace nephrite::truth
