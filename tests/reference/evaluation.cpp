// Each shader's output beside the double-precision value of its formula.
#include "reference/evaluation.h"

#include <fmt/format.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "reference/literal/ambient_occlusion.h"
#include "reference/literal/composite.h"
#include "reference/literal/dipole.h"
#include "reference/literal/refraction.h"
#include "reference/literal/single_scatter.h"
#include "reference/literal/specular.h"

namespace nephrite::reference {
namespace {

/// Halves below this are denormal: their steps of 2^-24 are no longer small beside them.
constexpr double smallestNormalHalf = 1.0 / 16384;

std::vector<Texels> arrayLayers(const DumpedFrame& frame, const std::string& port, std::size_t first,
                                std::size_t count) {
    std::vector<Texels> layers;
    for (std::size_t layer = 0; layer < count; ++layer)
        layers.push_back(frame.texels(port, static_cast<std::uint32_t>(first + layer)));
    return layers;
}

/// The layers of a texel: `count` of them out of images as the pass `layers` writes them.
LayerStack stackAt(const std::vector<Texels>& thickness, const std::vector<Texels>& absorption,
                   const std::vector<Texels>& scattering, std::size_t count, glm::ivec2 pixel) {
    LayerStack stack;
    for (std::size_t layer = 0; layer < count; ++layer) {
        stack.thickness.push_back(thickness[layer / 4].at(pixel.x, pixel.y)[static_cast<int>(layer % 4)]);
        stack.absorption.emplace_back(absorption[layer].at(pixel.x, pixel.y));
        stack.scattering.emplace_back(scattering[layer].at(pixel.x, pixel.y));
    }
    return stack;
}

std::size_t materialIndex(const glm::dvec4& surface) {
    return static_cast<std::size_t>(std::lround(surface.z)) - 1;
}

std::size_t single(double parameter) {
    return static_cast<std::size_t>(std::lround(parameter));
}

}  // namespace

Evaluation::Evaluation(const DumpedFrame& frame, const SceneData& scene)
    : frame_(frame),
      scene_(scene),
      lights_(scene.lights),
      position_(frame.texels("gbuffer.position")),
      normal_(frame.texels("gbuffer.normal")),
      surface_(frame.texels("gbuffer.surface")) {
    thickness_ = arrayLayers(frame, "layers.thickness", 0, (scene.maxLayers + 3) / 4);
    absorption_ = arrayLayers(frame, "layers.absorption", 0, scene.maxLayers);
    scattering_ = arrayLayers(frame, "layers.scattering", 0, scene.maxLayers);
    attachLightImages();
}

void Evaluation::attachLightImages() {
    const std::size_t thicknessLayers = (scene_.maxLayers + 3) / 4;
    std::size_t index = 0;
    for (PointLight& light : lights_) {
        for (LightView& view : light.views) {
            const auto layer = static_cast<std::uint32_t>(index);
            view.position = frame_.texels("light.position", layer);
            view.normal = frame_.texels("light.normal", layer);
            view.surface = frame_.texels("light.surface", layer);
            view.irradiance = frame_.texels("light-irradiance.irradiance", layer);
            view.thickness =
                arrayLayers(frame_, "light-layers.thickness", index * thicknessLayers, thicknessLayers);
            view.scattering =
                arrayLayers(frame_, "light-layers.scattering", index * scene_.maxLayers, scene_.maxLayers);
            ++index;
        }
    }
}

std::vector<glm::ivec2> Evaluation::coveredPixels() const {
    std::vector<glm::ivec2> pixels;
    for (int y = 0; y < position_.height(); ++y) {
        for (int x = 0; x < position_.width(); ++x) {
            if (covered({x, y})) pixels.emplace_back(x, y);
        }
    }
    return pixels;
}

std::size_t Evaluation::materialAt(glm::ivec2 pixel) const {
    return materialIndex(surface_.at(pixel.x, pixel.y));
}

SurfacePoint Evaluation::pointAt(glm::ivec2 pixel) const {
    const glm::dvec3 position(position_.at(pixel.x, pixel.y));
    return {position, glm::normalize(glm::dvec3(normal_.at(pixel.x, pixel.y))),
            glm::normalize(scene_.camera.position - position)};
}

LayerStack Evaluation::layersAt(glm::ivec2 pixel) const {
    const std::size_t count = scene_.materials[materialAt(pixel)].layerCount;
    return stackAt(thickness_, absorption_, scattering_, count, pixel);
}

Comparison Evaluation::comparisonOf(const std::string& port) const {
    const bool half = frame_.format(port) == graph::Format::rgba16f;
    return {port, Agreement(1e-3, half ? smallestNormalHalf : 0), half ? 2e-3 : 1e-3};
}

template<class Expected>
Comparison Evaluation::compare(const std::string& port, Expected expected) const {
    Comparison comparison = comparisonOf(port);
    const Texels rendered = frame_.texels(port);
    for (const glm::ivec2 pixel : coveredPixels())
        comparison.agreement.add(pixel, glm::dvec3(rendered.at(pixel.x, pixel.y)), expected(pixel));
    return comparison;
}

Comparison Evaluation::lightViews() const {
    // The error is in texels: how far from its texel's centre a position projects.
    Comparison comparison{"light.position", Agreement(0, 1), 1e-2};
    for (const PointLight& light : lights_) {
        for (const LightView& view : light.views) {
            for (int y = 0; y < view.position.height(); ++y) {
                for (int x = 0; x < view.position.width(); ++x) {
                    if (view.position.at(x, y).w == 0) continue;
                    const auto uv = project(view.view, glm::dvec3(view.position.at(x, y)));
                    const glm::dvec2 size(view.position.width(), view.position.height());
                    const glm::dvec2 offset =
                        uv ? *uv * size - glm::dvec2(x + 0.5, y + 0.5) : glm::dvec2(1e9);
                    comparison.agreement.add({x, y}, glm::dvec3(offset, 0), glm::dvec3(0));
                }
            }
        }
    }
    return comparison;
}

std::vector<Comparison> Evaluation::layerImages(const std::string& node,
                                                const std::vector<Texels>& surfaces) const {
    // Layers differ by any factor and infinite is 1e30, so there is no common floor: what is 0 must be 0.
    Comparison thickness{node + ".thickness", Agreement(0), 1e-3};
    Comparison absorption{node + ".absorption", Agreement(0), 1e-3};
    Comparison scattering{node + ".scattering", Agreement(0), 1e-3};
    const std::size_t perView = scene_.maxLayers;
    const std::size_t thicknessPerView = (perView + 3) / 4;
    for (std::size_t view = 0; view < surfaces.size(); ++view) {
        const Texels& surface = surfaces[view];
        const auto depths = arrayLayers(frame_, thickness.what, view * thicknessPerView, thicknessPerView);
        const auto absorbing = arrayLayers(frame_, absorption.what, view * perView, perView);
        const auto scatteringLayers = arrayLayers(frame_, scattering.what, view * perView, perView);
        for (int y = 0; y < surface.height(); ++y) {
            for (int x = 0; x < surface.width(); ++x) {
                const glm::dvec4& texel = surface.at(x, y);
                const LayerStack expected =
                    texel.z == 0 ? LayerStack{} : scene_.layersAt(materialIndex(texel), {texel.x, texel.y});
                const LayerStack rendered = stackAt(depths, absorbing, scatteringLayers, perView, {x, y});
                for (std::size_t k = 0; k < perView; ++k) {
                    const bool exists = k < expected.count();
                    thickness.agreement.add({x, y}, glm::dvec3(rendered.thickness[k]),
                                            glm::dvec3(exists ? expected.thickness[k] : 0));
                    absorption.agreement.add({x, y}, rendered.absorption[k],
                                             exists ? expected.absorption[k] : glm::dvec3(0));
                    scattering.agreement.add({x, y}, rendered.scattering[k],
                                             exists ? expected.scattering[k] : glm::dvec3(0));
                }
            }
        }
    }
    return {thickness, absorption, scattering};
}

std::vector<Comparison> Evaluation::layers() const {
    std::vector<Comparison> all = layerImages("layers", {surface_});
    std::vector<Texels> lightSurfaces;
    for (const PointLight& light : lights_) {
        for (const LightView& view : light.views) lightSurfaces.push_back(view.surface);
    }
    for (Comparison& comparison : layerImages("light-layers", lightSurfaces))
        all.push_back(std::move(comparison));
    return all;
}

Comparison Evaluation::lightIrradiance() const {
    Comparison comparison = comparisonOf("light-irradiance.irradiance");
    for (const PointLight& light : lights_) {
        for (const LightView& view : light.views) {
            for (int y = 0; y < view.position.height(); ++y) {
                for (int x = 0; x < view.position.width(); ++x) {
                    const glm::dvec4& position = view.position.at(x, y);
                    if (position.w == 0) continue;
                    const glm::dvec3 normal = glm::normalize(glm::dvec3(view.normal.at(x, y)));
                    comparison.agreement.add({x, y}, glm::dvec3(view.irradiance.at(x, y)),
                                             unshadowedIrradiance(light, glm::dvec3(position), normal));
                }
            }
        }
    }
    return comparison;
}

Comparison Evaluation::direct() const {
    const double bias = frame_.parameter("direct", "shadowBias")[0];
    return compare("direct.irradiance", [&](glm::ivec2 pixel) {
        const SurfacePoint point = pointAt(pixel);
        return directIrradiance(lights_, scene_.environment, point.position, point.normal, bias);
    });
}

Comparison Evaluation::singleScatter() const {
    SingleScatterSettings settings;
    settings.maximumDepth = frame_.parameter("single-scatter", "maximumDepth")[0];
    settings.steps = static_cast<int>(frame_.parameter("single-scatter", "steps")[0]);
    return compare("single-scatter.radiance", [&](glm::ivec2 pixel) {
        return reference::singleScatter(pointAt(pixel), scene_.materials[materialAt(pixel)], layersAt(pixel),
                                        lights_, scene_.materials, settings);
    });
}

Comparison Evaluation::dipole() const {
    const auto offsets = nearestOffsets(single(frame_.parameter("dipole", "taps")[0]));
    const Texels irradiance = frame_.texels("direct.irradiance");
    return compare("dipole.radiance", [&](glm::ivec2 pixel) {
        const Material& material = scene_.materials[materialAt(pixel)];
        if (material.layerCount == 0) return glm::dvec3(0);
        const LayerStack layers = layersAt(pixel);
        std::array<Medium, 3> medium;
        for (int channel = 0; channel < 3; ++channel) {
            medium[static_cast<std::size_t>(channel)] = {
                layers.absorption[0][channel], layers.scattering[0][channel], material.g, material.eta};
        }
        return gatherDipole(position_, irradiance, pixel, medium, offsets);
    });
}

Comparison Evaluation::ambientOcclusion() const {
    const auto parameter = [&](const char* name) { return frame_.parameter("ssao", name)[0]; };
    const OcclusionSettings settings{static_cast<int>(parameter("samples")), parameter("radius"),
                                     parameter("turns"), parameter("bias"), parameter("intensity")};
    const Texels irradiance = frame_.texels("direct.irradiance");
    std::vector<glm::dvec4> unit;
    for (int y = 0; y < normal_.height(); ++y) {
        for (int x = 0; x < normal_.width(); ++x)
            unit.emplace_back(covered({x, y}) ? pointAt({x, y}).normal : glm::dvec3(0), 0);
    }
    const Texels normal(normal_.width(), normal_.height(), std::move(unit));
    return compare("ssao.radiance", [&](glm::ivec2 pixel) {
        const double visible = ambientVisibility(position_, normal, pixel, scene_.camera, settings);
        return diffuseRadiance(scene_.materials[materialAt(pixel)].diffuse,
                               glm::dvec3(irradiance.at(pixel.x, pixel.y)), visible);
    });
}

Comparison Evaluation::specular() const {
    const double bias = frame_.parameter("specular", "shadowBias")[0];
    return compare("specular.radiance", [&](glm::ivec2 pixel) {
        return specularRadiance(pointAt(pixel), scene_.materials[materialAt(pixel)], lights_, bias);
    });
}

Comparison Evaluation::refraction() const {
    const Texels farthest = frame_.texels("farthest.position");
    return compare("refraction.radiance", [&](glm::ivec2 pixel) {
        return refractedRadiance(pointAt(pixel), scene_.materials[materialAt(pixel)], layersAt(pixel),
                                 glm::dvec3(farthest.at(pixel.x, pixel.y)), scene_.environmentRadiance);
    });
}

Comparison Evaluation::composite() const {
    const std::array<Texels, 5> terms{frame_.texels("ssao.radiance"), frame_.texels("specular.radiance"),
                                      frame_.texels("refraction.radiance"),
                                      frame_.texels("single-scatter.radiance"),
                                      frame_.texels("dipole.radiance")};
    const std::vector<double> parameter = frame_.parameter("composite", "weights");
    std::array<double, 5> weights{};
    std::copy(parameter.begin(), parameter.end(), weights.begin());
    const Texels color = frame_.texels("color");
    Comparison comparison{"composite.color", Agreement(1e-3), 1e-5};
    for (int y = 0; y < color.height(); ++y) {
        for (int x = 0; x < color.width(); ++x) {
            comparison.agreement.add(
                {x, y}, glm::dvec3(color.at(x, y)),
                reference::composite(terms, weights, color.width(), color.height(), x, y));
        }
    }
    return comparison;
}

}  // namespace nephrite::reference
