// Packs materials, layers and layer textures for the GPU.
#include "scene/layer_textures.h"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

#include "scene/texture_channels.h"

namespace nephrite::scene {
namespace {

/// Packs one material after the other; an image used twice is stored once.
class Packer {
  public:
    Packer(PackedMaterials& packed, Diagnostics& diagnostics, std::size_t maximumBytes)
        : packed_(packed), diagnostics_(diagnostics), maximumBytes_(maximumBytes) {}

    void add(const MaterialDescription& material) {
        GpuMaterial gpu;
        gpu.diffuse = material.diffuse;
        gpu.roughness = static_cast<float>(material.roughness);
        gpu.g = static_cast<float>(material.g);
        gpu.eta = static_cast<float>(material.eta);
        gpu.firstLayer = static_cast<std::uint32_t>(packed_.layers.size());
        gpu.layerCount = static_cast<std::uint32_t>(material.layers.size());
        gpu.specular = material.specular ? 1 : 0;
        packed_.materials.push_back(gpu);
        for (const LayerDescription& layer : material.layers)
            packed_.layers.push_back(pack(layer, material.g));
    }

  private:
    GpuLayer pack(const LayerDescription& layer, double g) {
        const double unreduced = layer.reduced ? 1 / (1 - g) : 1;
        GpuLayer gpu;
        gpu.thickness = std::isinf(layer.thickness) ? infiniteThickness : static_cast<float>(layer.thickness);
        gpu.absorption = layer.absorption;
        gpu.scattering = layer.scattering * unreduced;
        if (layer.thicknessTexture) {
            gpu.thicknessTexture = texture(*layer.thicknessTexture, 1);
            gpu.thickness = 1;
        }
        if (layer.absorptionTexture) {
            gpu.absorptionTexture = texture(*layer.absorptionTexture, 3);
            gpu.absorption = glm::vec3(1);
        }
        if (layer.scatteringTexture) {
            gpu.scatteringTexture = texture(*layer.scatteringTexture, 3);
            gpu.scattering = glm::vec3(static_cast<float>(unreduced));
        }
        return gpu;
    }

    GpuLayerTexture texture(const TextureReference& reference, std::uint32_t channels) {
        ++packed_.textures;
        const Key key{reference.file, reference.channel, reference.scale, channels};
        if (const auto known = images_.find(key); known != images_.end()) return known->second;
        GpuLayerTexture image;
        if (const auto texels = readTexels(reference, channels, diagnostics_))
            image = append(*texels, reference);
        packed_.files.push_back(reference.file);
        images_.emplace(key, image);
        return image;
    }

    GpuLayerTexture append(const Texels& texels, const TextureReference& reference) {
        const std::size_t offset = packed_.texels.size();
        const std::size_t bytes = (offset + texels.values.size()) * sizeof(float);
        if (bytes > maximumBytes_) {
            diagnostics_.error(
                reference.where,
                fmt::format("with {} the scene's layer textures take {} bytes, more than the {} a device "
                            "must be able to bind",
                            reference.file.string(), bytes, maximumBytes_));
            return {};
        }
        packed_.texels.insert(packed_.texels.end(), texels.values.begin(), texels.values.end());
        return {static_cast<std::uint32_t>(offset), texels.width, texels.height, texels.channels};
    }

    using Key = std::tuple<std::filesystem::path, std::string, double, std::uint32_t>;
    PackedMaterials& packed_;
    Diagnostics& diagnostics_;
    std::size_t maximumBytes_;
    std::map<Key, GpuLayerTexture> images_;
};

}  // namespace

PackedMaterials packMaterials(std::span<const MaterialDescription> materials, Diagnostics& diagnostics,
                              std::size_t maximumBytes) {
    PackedMaterials packed;
    Packer packer(packed, diagnostics, maximumBytes);
    for (const MaterialDescription& material : materials) packer.add(material);
    return packed;
}

}  // namespace nephrite::scene
