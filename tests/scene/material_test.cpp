// Presets against Jensen's table, overrides, and packing for the GPU with textures.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "image/exr.h"
#include "scene/layer_textures.h"
#include "scene/material_reader.h"
#include "scene/scene_support.h"

namespace nephrite::scene {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// A row of Jensen, Marschner, Levoy, Hanrahan 2001, Figure 5: reduced scattering, absorption (1/mm),
/// reflectance.
struct Measured {
    const char* name;
    glm::dvec3 scattering;
    glm::dvec3 absorption;
    glm::dvec3 reflectance;
    double eta = 1.3;
};
const Measured table[] = {
    {"apple", {2.29, 2.39, 1.97}, {0.0030, 0.0034, 0.046}, {0.85, 0.84, 0.53}},
    {"chicken1", {0.15, 0.21, 0.38}, {0.015, 0.077, 0.19}, {0.31, 0.15, 0.10}},
    {"chicken2", {0.19, 0.25, 0.32}, {0.018, 0.088, 0.20}, {0.32, 0.16, 0.10}},
    {"cream", {7.38, 5.47, 3.15}, {0.0002, 0.0028, 0.0163}, {0.98, 0.90, 0.73}},
    {"ketchup", {0.18, 0.07, 0.03}, {0.061, 0.97, 1.45}, {0.16, 0.01, 0.00}},
    {"marble", {2.19, 2.62, 3.00}, {0.0021, 0.0041, 0.0071}, {0.83, 0.79, 0.75}, 1.5},
    {"potato", {0.68, 0.70, 0.55}, {0.0024, 0.0090, 0.12}, {0.77, 0.62, 0.21}},
    {"skimmilk", {0.70, 1.22, 1.90}, {0.0014, 0.0025, 0.0142}, {0.81, 0.81, 0.69}},
    {"skin1", {0.74, 0.88, 1.01}, {0.032, 0.17, 0.48}, {0.44, 0.22, 0.13}},
    {"skin1-table1", {0.74, 0.88, 1.01}, {0.032, 0.17, 0.18}, {0.44, 0.22, 0.13}},
    {"skin2", {1.09, 1.59, 1.79}, {0.013, 0.070, 0.145}, {0.63, 0.44, 0.34}},
    {"spectralon", {11.6, 20.4, 14.9}, {0, 0, 0}, {1, 1, 1}},
    {"wholemilk", {2.55, 3.21, 3.77}, {0.0011, 0.0024, 0.014}, {0.91, 0.88, 0.76}},
};

MaterialDescription preset(const std::string& name) {
    Diagnostics faults;
    const PresetFolder presets(test::presetFolder);
    EXPECT_TRUE(presets.has(name)) << name;
    MaterialDescription material = readPreset(name, presets, faults);
    EXPECT_THAT(test::errorLines(faults), IsEmpty());
    return material;
}

TEST(Preset, HasTheMeasuredNumbers) {
    for (const Measured& row : table) {
        const MaterialDescription material = preset(row.name);
        ASSERT_EQ(material.layers.size(), 1U) << row.name;
        EXPECT_EQ(material.layers[0].scattering, row.scattering) << row.name;
        EXPECT_EQ(material.layers[0].absorption, row.absorption) << row.name;
        EXPECT_TRUE(material.layers[0].reduced) << row.name;
        EXPECT_TRUE(std::isinf(material.layers[0].thickness)) << row.name;
        EXPECT_EQ(material.diffuse, row.reflectance) << row.name;
        EXPECT_EQ(material.eta, row.eta) << row.name;
        EXPECT_TRUE(material.specular) << row.name;
        EXPECT_EQ(material.roughness, 0.3) << row.name;
    }
}

TEST(Preset, LayeredReadingHasThreeGreyLayers) {
    for (const char* name : {"apple", "skin1-table1", "chicken1", "skin2", "skimmilk"}) {
        const auto row = std::find_if(std::begin(table), std::end(table),
                                      [&](const Measured& entry) { return std::string(entry.name) == name; });
        const MaterialDescription material = preset(std::string(name) + "-layers");
        ASSERT_EQ(material.layers.size(), 3U) << name;
        for (int k = 0; k < 3; ++k) {
            const LayerDescription& layer = material.layers[static_cast<std::size_t>(k)];
            EXPECT_EQ(layer.scattering, glm::dvec3(row->scattering[k])) << name;
            EXPECT_EQ(layer.absorption, glm::dvec3(row->absorption[k])) << name;
            EXPECT_TRUE(layer.reduced) << name;
        }
        EXPECT_EQ(material.layers[0].thickness, 0.5);
        EXPECT_EQ(material.layers[1].thickness, 1);
        EXPECT_TRUE(std::isinf(material.layers[2].thickness));
    }
}

TEST(Preset, EveryFileIsAMaterialWithLayers) {
    const PresetFolder presets(test::presetFolder);
    EXPECT_EQ(presets.names().size(), std::size(table) + 5);
    for (const std::string& name : presets.names()) EXPECT_FALSE(preset(name).layers.empty()) << name;
}

TEST(Material, OverridesReplaceAPresetsValues) {
    const SceneDescription scene = test::readGood("{" + test::anyCamera + R"(, "objects": [
        {"mesh": {"procedural": "sphere"}, "material": {"preset": "marble", "roughness": 0.1, "specular": false}}]})");
    ASSERT_EQ(scene.materials.size(), 1U);
    const MaterialDescription& material = scene.materials[0];
    EXPECT_EQ(material.roughness, 0.1);
    EXPECT_FALSE(material.specular);
    EXPECT_EQ(material.eta, 1.5);
    EXPECT_EQ(material.layers.size(), 1U);
    EXPECT_EQ(material.presetFile, test::presetFolder / "marble.json");
}

TEST(Material, WithoutLayersIsOpaque) {
    const SceneDescription scene = test::readGood("{" + test::anyCamera + R"(, "objects": [
        {"mesh": {"procedural": "sphere"}, "material": {"diffuse": [0.1, 0.2, 0.3], "roughness": 0.7}}]})");
    EXPECT_TRUE(scene.materials[0].layers.empty());
    EXPECT_FALSE(scene.materials[0].specular);
    EXPECT_EQ(scene.materials[0].diffuse, glm::dvec3(0.1, 0.2, 0.3));
}

TEST(PackedMaterials, UndoTheReductionAndWriteInfinityAsALargeNumber) {
    MaterialDescription opaque, layered;
    layered.g = 0.5;
    layered.eta = 1.4;
    layered.specular = true;
    layered.layers.resize(2);
    layered.layers[0].thickness = 0.25;
    layered.layers[0].scattering = {1, 2, 3};
    layered.layers[0].reduced = true;
    layered.layers[1].scattering = {1, 2, 3};
    layered.layers[1].absorption = {0.5, 0.25, 0.125};
    Diagnostics faults;
    const PackedMaterials packed = packMaterials(std::vector{opaque, layered}, faults);
    ASSERT_EQ(packed.materials.size(), 2U);
    EXPECT_EQ(packed.materials[0].layerCount, 0U);
    EXPECT_EQ(packed.materials[1].firstLayer, 0U);
    EXPECT_EQ(packed.materials[1].layerCount, 2U);
    EXPECT_EQ(packed.materials[1].specular, 1U);
    EXPECT_EQ(packed.layers[0].scattering, glm::vec3(2, 4, 6));
    EXPECT_EQ(packed.layers[0].thickness, 0.25F);
    EXPECT_EQ(packed.layers[1].scattering, glm::vec3(1, 2, 3));
    EXPECT_EQ(packed.layers[1].thickness, 1e30F);
    EXPECT_EQ(packed.layers[1].absorption, glm::vec3(0.5, 0.25, 0.125));
    EXPECT_EQ(packed.textures, 0U);
}

class LayerTexture : public test::InFolder {
  protected:
    MaterialDescription textured(const TextureReference& absorption) const {
        MaterialDescription material;
        material.layers.resize(1);
        material.layers[0].absorptionTexture = absorption;
        return material;
    }
};

TEST_F(LayerTexture, TakesTheNamedChannelTimesTheScale) {
    image::writeExr(in("t.exr"), {2, 1, {"R", "G", "B"}, {1, 2, 3, 4, 5, 6}});
    Diagnostics faults;
    const PackedMaterials packed = packMaterials(std::vector{textured({in("t.exr"), "G", 10, {}})}, faults);
    EXPECT_THAT(test::errorLines(faults), IsEmpty());
    EXPECT_THAT(packed.texels, ElementsAre(20, 50));
    const GpuLayerTexture& header = packed.layers[0].absorptionTexture;
    EXPECT_THAT((std::vector{header.offset, header.width, header.height, header.channels}),
                ElementsAre(0U, 2U, 1U, 1U));
    EXPECT_EQ(packed.layers[0].absorption, glm::vec3(1));
    EXPECT_EQ(packed.textures, 1U);
}

TEST_F(LayerTexture, WithoutAChannelIsRgbAndIsStoredOnce) {
    image::writeExr(in("t.exr"), {1, 2, {"R", "G", "B"}, {1, 2, 3, 4, 5, 6}});
    MaterialDescription material = textured({in("t.exr"), "", 1, {}});
    material.layers[0].scatteringTexture = TextureReference{in("t.exr"), "", 1, {}};
    material.layers[0].thicknessTexture = TextureReference{in("t.exr"), "", 1, {}};
    Diagnostics faults;
    const PackedMaterials packed = packMaterials(std::vector{material}, faults);
    EXPECT_THAT(packed.texels, ElementsAre(1, 4, 1, 2, 3, 4, 5, 6));
    EXPECT_EQ(packed.layers[0].absorptionTexture.offset, 2U);
    EXPECT_EQ(packed.layers[0].scatteringTexture.offset, 2U);
    EXPECT_EQ(packed.layers[0].thicknessTexture.offset, 0U);
    EXPECT_EQ(packed.layers[0].thicknessTexture.channels, 1U);
    EXPECT_EQ(packed.textures, 3U);
}

TEST_F(LayerTexture, FaultsNameFileChannelAndPlace) {
    image::writeExr(in("t.exr"), {1, 1, {"R", "G", "B"}, {1, -2, std::nanf("")}});
    const SourceLocation where{"s.json", 4, 7};
    for (const auto& [channel, text] : {std::pair{"A", "has no channel \"A\", its channels are R, G, B"},
                                        {"G", "pixel (0, 0) of channel \"G\" times 1 is -2"},
                                        {"B", "pixel (0, 0) of channel \"B\" times 1 is nan"}}) {
        Diagnostics faults;
        packMaterials(std::vector{textured({in("t.exr"), channel, 1, where})}, faults);
        ASSERT_EQ(faults.errors().size(), 1U) << channel;
        EXPECT_EQ(faults.errors()[0].where, where);
        EXPECT_THAT(faults.errors()[0].message, HasSubstr(text));
    }
}

TEST_F(LayerTexture, MoreThanADeviceCanBindIsRefused) {
    image::writeExr(in("t.exr"), {4, 2, {"Y"}, std::vector<float>(8, 1.0F)});
    std::vector<MaterialDescription> materials;
    for (const double scale : {1.0, 2.0, 3.0})
        materials.push_back(textured({in("t.exr"), "", scale, {"s.json", 1, 1}}));
    Diagnostics faults;
    const PackedMaterials packed = packMaterials(materials, faults, 2 * 8 * sizeof(float));
    ASSERT_EQ(faults.errors().size(), 1U);
    EXPECT_THAT(faults.errors()[0].message, HasSubstr("96 bytes, more than the 64"));
    EXPECT_EQ(packed.texels.size(), 16U);
}

}  // namespace
}  // namespace nephrite::scene
