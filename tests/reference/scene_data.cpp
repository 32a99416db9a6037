// What the formulas need of a scene file.
#include "reference/scene_data.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <memory>
#include <numbers>
#include <stdexcept>

#include "image/exr.h"
#include "runtime/loading/data_folders.h"
#include "runtime/loading/graph_loading.h"
#include "scene/environment.h"
#include "scene/scene.h"
#include "scene/view.h"

namespace nephrite::reference {
namespace {

constexpr double infiniteThickness = 1e30;

std::size_t channelNamed(const image::Image& image, const std::string& name) {
    for (std::size_t i = 0; i < image.channels.size(); ++i) {
        if (image.channels[i] == name) return i;
    }
    throw std::runtime_error("a texture has no channel " + name);
}

/// The texture's three channels, or one of them three times. A thickness without a channel takes the first.
Texels readTexture(const scene::TextureReference& reference, bool colour) {
    const image::Image image = image::readExr(reference.file).image;
    std::array<std::size_t, 3> channel{};
    for (std::size_t i = 0; i < 3; ++i) {
        const bool own = reference.channel.empty() && colour;
        channel[i] = own ? channelNamed(image, std::string(1, "RGB"[i]))
                         : (reference.channel.empty() ? 0 : channelNamed(image, reference.channel));
    }
    std::vector<glm::dvec4> texels;
    for (std::size_t pixel = 0; pixel < std::size_t{image.width} * image.height; ++pixel) {
        const float* values = &image.pixels[pixel * image.channels.size()];
        texels.emplace_back(values[channel[0]], values[channel[1]], values[channel[2]], 1);
    }
    return {static_cast<int>(image.width), static_cast<int>(image.height), std::move(texels)};
}

LayerQuantity quantity(const glm::dvec3& constant, const std::optional<scene::TextureReference>& texture,
                       bool colour, double factor) {
    LayerQuantity result;
    result.constant = constant * factor;
    if (texture) {
        result.texture = readTexture(*texture, colour);
        result.scale = texture->scale * factor;
    }
    return result;
}

std::vector<MaterialLayer> layersOf(const scene::MaterialDescription& material) {
    std::vector<MaterialLayer> layers;
    for (const scene::LayerDescription& layer : material.layers) {
        const double thickness = std::isinf(layer.thickness) ? infiniteThickness : layer.thickness;
        const double unreduced = layer.reduced ? 1 / (1 - material.g) : 1;
        layers.push_back({quantity(glm::dvec3(thickness), layer.thicknessTexture, false, 1),
                          quantity(layer.absorption, layer.absorptionTexture, true, 1),
                          quantity(layer.scattering, layer.scatteringTexture, true, unreduced)});
    }
    return layers;
}

Material materialOf(const scene::MaterialDescription& material) {
    return {material.diffuse, material.roughness, material.g,
            material.eta,     material.specular,  material.layers.size()};
}

View viewOf(const scene::View& view) {
    return {view.position, view.forward, view.right, view.up, view.tanHalfFovX, view.tanHalfFovY};
}

PointLight lightOf(const scene::Scene& scene, std::size_t index) {
    const scene::LightDescription& description = scene.description().lights[index];
    PointLight light{description.position, description.intensity, {}};
    const std::uint32_t count = scene.lightViewCounts()[index];
    for (const scene::View& view : scene::lightViews(description.position, static_cast<std::uint32_t>(index),
                                                     scene.boundingSphere(0), count))
        light.views.push_back({viewOf(view), {}, {}, {}, {}, {}, {}});
    return light;
}

/// The environment as an image whose columns repeat and whose rows end at the poles.
struct LatLongImage {
    Texels texels;

    glm::dvec3 at(double x, double y) const {
        const double width = texels.width();
        const double left = std::floor(x - 0.5);
        const double s = x - 0.5 - left;
        const auto column = [&](double c) { return static_cast<int>(c - width * std::floor(c / width)); };
        const auto mixed = [&](int row) {
            return (1 - s) * texels.at(column(left), row) + s * texels.at(column(left + 1), row);
        };
        const int top = static_cast<int>(std::floor(y - 0.5));
        const double t = y - 0.5 - top;
        return glm::dvec3((1 - t) * mixed(top) + t * mixed(top + 1));
    }
    glm::dvec3 radiance(const glm::dvec3& direction) const {
        const double u = 0.5 + std::atan2(direction.x, -direction.z) / (2 * std::numbers::pi);
        const double v = std::acos(std::clamp(direction.y, -1.0, 1.0)) / std::numbers::pi;
        return at(u * texels.width(), v * texels.height());
    }
};

LatLongImage environmentOf(const scene::EnvironmentDescription& description) {
    Diagnostics faults;
    const scene::Environment environment = scene::loadEnvironment(description, faults);
    faults.throwIfErrors();
    std::vector<glm::dvec4> texels;
    for (const glm::vec3& texel : environment.texels) texels.emplace_back(texel, 1);
    return {
        Texels(static_cast<int>(environment.width), static_cast<int>(environment.height), std::move(texels))};
}

/// L_lm of the image, each texel one cell; a single texel is a constant, which needs no sum.
HarmonicRadiance harmonicsOf(const LatLongImage& image) {
    if (image.texels.width() == 1 && image.texels.height() == 1) {
        HarmonicRadiance constant{};
        constant[0] = glm::dvec3(image.texels.at(0, 0)) * std::sqrt(4 * std::numbers::pi);
        return constant;
    }
    return projectRadiance([&](const glm::dvec3& direction) { return image.radiance(direction); },
                           image.texels.width(), image.texels.height());
}

}  // namespace

glm::dvec3 LayerQuantity::at(glm::dvec2 uv) const {
    if (texture.width() == 0) return constant;
    const glm::dvec2 size(texture.width(), texture.height());
    const glm::dvec2 place = uv * size - 0.5;
    const glm::dvec2 corner = glm::floor(place);
    const glm::dvec2 weight = place - corner;
    const auto texel = [&](double x, double y) {
        return glm::dvec3(texture.at(static_cast<int>(x - size.x * std::floor(x / size.x)),
                                     static_cast<int>(y - size.y * std::floor(y / size.y))));
    };
    const glm::dvec3 upper = glm::mix(texel(corner.x, corner.y), texel(corner.x + 1, corner.y), weight.x);
    const glm::dvec3 lower =
        glm::mix(texel(corner.x, corner.y + 1), texel(corner.x + 1, corner.y + 1), weight.x);
    return scale * glm::mix(upper, lower, weight.y);
}

LayerStack SceneData::layersAt(std::size_t material, glm::dvec2 uv) const {
    LayerStack stack;
    for (const MaterialLayer& layer : layers[material]) {
        stack.thickness.push_back(layer.thickness.at(uv).x);
        stack.absorption.push_back(layer.absorption.at(uv));
        stack.scattering.push_back(layer.scattering.at(uv));
    }
    return stack;
}

View pinholeView(const scene::CameraDescription& camera, std::uint32_t width, std::uint32_t height) {
    View view;
    view.position = camera.position;
    view.forward = glm::normalize(camera.target - camera.position);
    view.right = glm::normalize(glm::cross(view.forward, camera.up));
    view.up = glm::cross(view.right, view.forward);
    view.tanHalfFovY = std::tan(camera.fovY * std::numbers::pi / 360);
    view.tanHalfFovX = view.tanHalfFovY * width / height;
    return view;
}

SceneData readSceneData(const std::filesystem::path& file, std::uint32_t width, std::uint32_t height) {
    const scene::Scene scene = runtime::loadScene(file, 0, runtime::DataFolders::find());
    const scene::SceneDescription& description = scene.description();
    SceneData data;
    data.camera = pinholeView(description.camera, width, height);
    for (std::size_t light = 0; light < description.lights.size(); ++light)
        data.lights.push_back(lightOf(scene, light));
    for (const scene::MaterialDescription& material : description.materials) {
        data.materials.push_back(materialOf(material));
        data.layers.push_back(layersOf(material));
        data.maxLayers = std::max(data.maxLayers, material.layers.size());
    }
    const auto environment = std::make_shared<const LatLongImage>(environmentOf(description.environment));
    data.environment = harmonicsOf(*environment);
    data.environmentRadiance = [environment](const glm::dvec3& direction) {
        return environment->radiance(direction);
    };
    return data;
}

}  // namespace nephrite::reference
