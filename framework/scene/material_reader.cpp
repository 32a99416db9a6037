// Materials, their layers, textures and presets.
#include "scene/material_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scene/scene_keys.h"
#include "scene/value_rules.h"

namespace nephrite::scene {
namespace {

using json::ObjectReader;
using json::Value;

/// A material as it is read; overrides replace what a preset said.
class MaterialReader {
  public:
    MaterialReader(const std::filesystem::path& folder, Diagnostics& diagnostics)
        : folder_(folder), diagnostics_(diagnostics) {}

    void read(ObjectReader& object, MaterialDescription& material) {
        if (const auto doc = object.optional("doc")) doc->string(diagnostics_, "a string");
        readVector(object, "diffuse", unitInterval, material.diffuse);
        readNumber(object, "roughness", unitInterval, material.roughness);
        readNumber(object, "g", anisotropy, material.g);
        readNumber(object, "eta", positive, material.eta);
        readBool(object, "specular", material.specular);
        if (const auto layers = object.optional("layers")) readLayers(*layers, material);
        object.finish();
        for (const LayerDescription& layer : material.layers)
            if (layer.reduced && material.g == 1)
                diagnostics_.error(layer.where,
                                   "a layer with \"reduced\" scattering needs g less than 1, found g 1");
    }

  private:
    void readLayers(const Value& value, MaterialDescription& material) {
        material.layers.clear();
        if (!value.isArray())
            return diagnostics_.error(value.where(),
                                      fmt::format("expected an array of layers, found {}", value.describe()));
        for (std::size_t i = 0; i < value.size(); ++i) material.layers.push_back(readLayer(value.at(i)));
        for (std::size_t i = 0; i + 1 < material.layers.size(); ++i)
            if (std::isinf(material.layers[i].thickness))
                diagnostics_.warning(material.layers[i].where,
                                     "the layers below this infinitely thick one are never reached");
    }

    LayerDescription readLayer(const Value& value) {
        ObjectReader object(value, "a layer", keys::layer(), diagnostics_);
        LayerDescription layer;
        layer.where = value.where();
        if (const auto thickness = object.optional("thickness")) readThickness(*thickness, layer);
        if (const auto color = object.optional("absorption"))
            readColor(*color, layer.absorption, layer.absorptionTexture);
        if (const auto color = object.optional("scattering"))
            readColor(*color, layer.scattering, layer.scatteringTexture);
        readBool(object, "reduced", layer.reduced);
        object.finish();
        return layer;
    }

    void readThickness(const Value& value, LayerDescription& layer) {
        if (value.isNull()) return;
        if (value.isObject()) {
            layer.thicknessTexture = readTexture(value);
            layer.thickness = 0;
        } else {
            readNumber(value, notNegative, layer.thickness, diagnostics_);
        }
    }

    void readColor(const Value& value, glm::dvec3& color, std::optional<TextureReference>& texture) {
        if (value.isObject())
            texture = readTexture(value);
        else
            readVector(value, notNegative, color, diagnostics_);
    }

    std::optional<TextureReference> readTexture(const Value& value) {
        ObjectReader object(value, "a texture", keys::texture(), diagnostics_);
        TextureReference texture;
        texture.where = value.where();
        if (const auto file = object.optional("texture"))
            if (const auto path = file->string(diagnostics_, "the name of an EXR file"))
                texture.file = resolvePath(*path, folder_);
        if (const auto channel = object.optional("channel"))
            if (const auto name = channel->string(diagnostics_, "a channel's name")) texture.channel = *name;
        readNumber(object, "scale", notNegative, texture.scale);
        object.finish();
        if (texture.file.empty()) return std::nullopt;
        return texture;
    }

    std::filesystem::path folder_;
    Diagnostics& diagnostics_;
};

/// Starts from the preset that "preset" names, if it names one.
void applyPreset(ObjectReader& object, const PresetFolder& presets, MaterialDescription& material,
                 Diagnostics& diagnostics) {
    const auto preset = object.optional("preset");
    if (!preset) return;
    const std::vector<std::string_view> known(presets.names().begin(), presets.names().end());
    const auto name = preset->string(diagnostics, "a preset's name");
    if (!name) return;
    if (presets.has(*name))
        material = readPreset(*name, presets, diagnostics);
    else
        diagnostics.error(preset->where(),
                          fmt::format("no preset is called \"{}\"{}", *name, suggestion(*name, known)));
}

}  // namespace

PresetFolder::PresetFolder(std::filesystem::path folder) : folder_(std::move(folder)) {
    std::error_code
        ignored;  // a folder that cannot be listed has no presets, and every name in it is then unknown
    for (const auto& entry : std::filesystem::directory_iterator(folder_, ignored))
        if (entry.path().extension() == ".json") names_.push_back(entry.path().stem().string());
    std::sort(names_.begin(), names_.end());
}

bool PresetFolder::has(std::string_view name) const {
    return std::binary_search(names_.begin(), names_.end(), name);
}

std::filesystem::path PresetFolder::fileOf(std::string_view name) const {
    return folder_ / (std::string(name) + ".json");
}

std::filesystem::path resolvePath(const std::string& path, const std::filesystem::path& folder) {
    return (folder / path).lexically_normal();
}

MaterialDescription readMaterial(const Value& value, std::string name, const std::filesystem::path& folder,
                                 const PresetFolder& presets, Diagnostics& diagnostics) {
    MaterialDescription material;
    ObjectReader object(value, "a material", keys::material(), diagnostics);
    applyPreset(object, presets, material, diagnostics);
    MaterialReader(folder, diagnostics).read(object, material);
    material.name = std::move(name);
    material.where = value.where();
    return material;
}

MaterialDescription readPreset(const std::string& name, const PresetFolder& presets,
                               Diagnostics& diagnostics) {
    MaterialDescription material;
    material.name = name;
    material.presetFile = presets.fileOf(name);
    material.specular = true;
    material.roughness = 0.3;
    try {
        const Value value = json::parseFile(presets.fileOf(name));
        material.where = value.where();
        ObjectReader object(value, "a preset", keys::preset(), diagnostics);
        MaterialReader(presets.fileOf(name).parent_path(), diagnostics).read(object, material);
    } catch (const InputError& error) {
        for (const Diagnostic& fault : error.faults()) diagnostics.error(fault.where, fault.message);
    }
    return material;
}

}  // namespace nephrite::scene
