// See scene_values.h.
#include "stress/scene_values.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "image/output_file.h"
#include "stress/shapes.h"

namespace nephrite::stress {
namespace {

constexpr double mostOfAFile = 1e15;  ///< the greatest number a scene file may hold

std::string triple(const Triple& values, double factor = 1) {
    return fmt::format("[{}, {}, {}]", values[0] * factor, values[1] * factor, values[2] * factor);
}

std::string layerText(const LayerValues& layer, double scale) {
    const std::string thickness =
        std::isinf(layer.thickness) ? "null" : fmt::format("{}", layer.thickness * scale);
    return fmt::format(R"({{"absorption": {}, "scattering": {}, "thickness": {}}})",
                       triple(layer.absorption, 1 / scale), triple(layer.scattering, 1 / scale), thickness);
}

std::string materialText(const MaterialValues& material, double scale) {
    std::vector<std::string> layers;
    for (const LayerValues& layer : material.layers) layers.push_back(layerText(layer, scale));
    return fmt::format(R"({{"layers": [{}], "g": {}, "eta": {}, "specular": {}, "roughness": 0.3}})",
                       fmt::join(layers, ", "), material.g, material.eta, material.specular);
}

std::string meshText(Shape shape, double scale, const std::filesystem::path& folder) {
    const double radius = objectRadius * scale;
    if (shape == Shape::sphere) return fmt::format(R"({{"procedural": "sphere", "radius": {}}})", radius);
    if (shape == Shape::slab)
        return fmt::format(R"({{"procedural": "slab", "size": {}}})", triple({1.2, 1.2, 0.4}, radius));
    const std::string file = fmt::format("shape-{}.obj", static_cast<int>(shape));
    image::writeFile(folder / file, objText(shape, scale).value());
    return fmt::format("\"{}\"", file);
}

}  // namespace

std::filesystem::path write(const SceneValues& scene, const std::filesystem::path& folder) {
    const double k = scene.scale;
    std::vector<std::string> lights;
    for (const LightValues& light : scene.lights) {
        const double intensity = std::min(light.intensity * k * k, mostOfAFile);
        lights.push_back(fmt::format(R"({{"type": "point", "position": {}, "intensity": {}}})",
                                     triple(light.position, k), triple({intensity, intensity, intensity})));
    }
    std::vector<std::string> materials;
    for (std::size_t i = 0; i < scene.materials.size(); ++i)
        materials.push_back(fmt::format("\"m{}\": {}", i, materialText(scene.materials[i], k)));
    std::vector<std::string> objects;
    for (const ObjectValues& object : scene.objects)
        objects.push_back(
            fmt::format(R"({{"mesh": {}, "material": "m{}", "transform": {{"translate": {}}}}})",
                        meshText(object.shape, k, folder), object.material, triple(object.place, k)));
    const std::string environment =
        scene.environment == 0
            ? ""
            : fmt::format(R"("environment": {{"radiance": {}}}, )",
                          triple({scene.environment, scene.environment, scene.environment}));
    const std::filesystem::path file = folder / "scene.json";
    image::writeFile(
        file,
        fmt::format(
            R"({{ "camera": {{"position": {}, "target": {}, "up": {}, "fovY": {}, "near": {}, "far": {}}},
  {}"lights": [{}],
  "materials": {{{}}},
  "objects": [{}] }}
)",
            triple(scene.camera, k), triple(scene.target, k), triple(scene.up), scene.fovY, scene.near * k,
            scene.far * k, environment, fmt::join(lights, ", "), fmt::join(materials, ", "),
            fmt::join(objects, ", ")));
    return file;
}

}  // namespace nephrite::stress
