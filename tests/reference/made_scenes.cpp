// Scenes made for the tests: textures, a sky, many layers, odd materials.
#include "reference/made_scenes.h"

#include <array>
#include <cmath>
#include <functional>
#include <numbers>

#include "image/exr.h"
#include "scratch_folder.h"

namespace nephrite::reference {
namespace {

constexpr const char* texturedScene = R"({ "millimetersPerUnit": 1,
  "camera": {"position": [4, 9, 38], "target": [0, 0, 0], "up": [0, 1, 0], "fovY": 36, "near": 1, "far": 300},
  "lights": [{"type": "point", "position": [25, 30, 15], "intensity": [5000, 4000, 3000]},
             {"type": "point", "position": [-30, 10, -25], "intensity": [1000, 2000, 4000]}],
  "environment": {"image": "sky.exr", "scale": 0.5},
  "materials": {
    "textured": {"g": 0.4, "eta": 1.4, "diffuse": [0.7, 0.5, 0.4], "roughness": 0.35, "specular": true, "layers": [
      {"thickness": {"texture": "pattern.exr", "channel": "G", "scale": 0.3}, "absorption": [0.02, 0.03, 0.04],
       "scattering": {"texture": "pattern.exr", "scale": 1.5}, "reduced": true},
      {"thickness": 0, "absorption": [9, 9, 9], "scattering": [9, 9, 9]},
      {"thickness": 0.2, "absorption": {"texture": "pattern.exr", "scale": 0.1}, "scattering": [0.4, 0.5, 0.6]},
      {"thickness": 0.5, "absorption": {"texture": "pattern.exr", "channel": "B", "scale": 0.2}, "scattering": [0, 0, 0]},
      {"absorption": [0.01, 0.01, 0.02], "scattering": [0.3, 0.2, 0.1], "reduced": true}]},
    "floor": {"diffuse": [0.6, 0.6, 0.5], "roughness": 0.6, "specular": true}},
  "objects": [
    {"mesh": {"procedural": "sphere", "radius": 7}, "material": "textured"},
    {"mesh": {"procedural": "slab", "size": [30, 2, 20]}, "material": "floor", "transform": {"translate": [0, -8, 0]}}] }
)";

constexpr const char* lowIndexScene = R"({ "millimetersPerUnit": 1,
  "camera": {"position": [0, 5, 40], "target": [0, 0, 0], "up": [0, 1, 0], "fovY": 36, "near": 1, "far": 300},
  "lights": [{"type": "point", "position": [10, 40, 30], "intensity": [5000, 5000, 5000]}],
  "environment": {"radiance": [0.5, 0.6, 0.7]},
  "materials": {
    "thin": {"g": 0.8, "eta": 0.8, "specular": true, "roughness": 0.2,
             "layers": [{"absorption": [0.01, 0.02, 0.03], "scattering": [0.5, 0.6, 0.7]}]},
    "same": {"g": -0.5, "eta": 1, "layers": [{"thickness": 1, "absorption": [0, 0, 0.1], "scattering": [0.1, 0, 0.2]}]}},
  "objects": [
    {"mesh": {"procedural": "sphere", "radius": 5}, "material": "thin", "transform": {"translate": [-6, 0, 0]}},
    {"mesh": {"procedural": "sphere", "radius": 5}, "material": "same", "transform": {"translate": [6, 0, 0]}}] }
)";

using Color = std::array<float, 3>;

/// An RGB image of `color(u, v)` at texel centres, v down.
void writeImage(const char* name, std::uint32_t width, std::uint32_t height,
                const std::function<Color(float, float)>& color) {
    image::Image image{width, height, {"R", "G", "B"}, {}};
    for (std::uint32_t y = 0; y < height; ++y) {
        for (std::uint32_t x = 0; x < width; ++x) {
            const Color value = color((static_cast<float>(x) + 0.5F) / static_cast<float>(width),
                                      (static_cast<float>(y) + 0.5F) / static_cast<float>(height));
            image.pixels.insert(image.pixels.end(), value.begin(), value.end());
        }
    }
    image::writeExr(sharedScratchFolder().path() / name, image);
}

float wave(float phase) {
    return 1 + 0.5F * std::sin(2 * std::numbers::pi_v<float> * phase);
}

}  // namespace

std::filesystem::path writeTexturedScene() {
    // Not symmetric in u or v, so that a flipped or transposed look-up shows.
    writeImage("pattern.exr", 24, 10, [](float u, float v) {
        return Color{wave(2 * u + v), wave(u - 2 * v), wave(u + 0.3F) * (0.5F + v)};
    });
    // Brightest towards +y, and to the right of the middle.
    writeImage("sky.exr", 128, 64, [](float u, float v) {
        return Color{1.5F - v, 1.2F - 0.8F * v,
                     0.5F + 0.4F * wave(u - 0.5F) * std::sin(std::numbers::pi_v<float> * v)};
    });
    return sharedScratchFolder().write("textured.json", texturedScene);
}

std::filesystem::path writeLowIndexScene() {
    return sharedScratchFolder().write("low-index.json", lowIndexScene);
}

}  // namespace nephrite::reference
