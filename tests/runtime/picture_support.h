// Small scenes, the pictures the renderer makes of them, and the rays of their pixels.
#pragma once

#include <functional>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "runtime/session.h"

namespace nephrite::pictures {

/// A camera as a scene file has it; up is +y.
struct Camera {
    glm::dvec3 position{0, 0, 40};
    glm::dvec3 target{0, 0, 0};
    double fovY = 36;  ///< degrees

    /// Unit direction through a place of a square picture, in pixels from its top left corner.
    glm::dvec3 ray(glm::dvec2 pixel, int size) const;
    /// Width of a pixel at a distance of 1 along the middle ray.
    double pixelWidth(int size) const;
};

/// A scene of one light and one object; each text is the JSON of a member.
struct SceneText {
    Camera camera;
    std::string light = R"({"type": "point", "position": [30, 30, 10], "intensity": [5000, 5000, 5000]})";
    std::string mesh = R"({"procedural": "sphere", "radius": 10})";
    std::string translate = "[0, 0, 0]";
    std::string environment = "[0, 0, 0]";
    std::string material =
        R"({"layers": [{"absorption": [0.003, 0.0034, 0.046], "scattering": [2.29, 2.39, 1.97], "reduced": true}],
            "g": 0, "eta": 1.3, "diffuse": [0.8, 0.7, 0.6], "roughness": 0.4, "specular": true})";

    std::string json() const;
};

/// Renders graphs/paper.json (one frame at time 0) and keeps the session, so that its images can be read.
runtime::Session render(const SceneText& scene, int size, const std::vector<std::string>& dumps);

/// Distance along a ray from `origin` to the first point of a sphere about the origin, or nothing.
std::optional<double> hitSphere(const glm::dvec3& origin, const glm::dvec3& direction, double radius);
/// True if the ray meets the box about the origin with sides `size`.
bool hitsBox(const glm::dvec3& origin, const glm::dvec3& direction, const glm::dvec3& size);

/// Pixels on the wrong side of an outline by more than one pixel: covered, but no ray within a pixel hits; or
/// not covered, but no ray within a pixel misses.
int farFromOutline(const image::Image& position, const Camera& camera,
                   const std::function<bool(const glm::dvec3&)>& hits);

/// Sum of R, G and B over the pixels of columns [left, right) and rows [top, bottom).
double brightness(const image::Image& image, glm::ivec2 topLeft, glm::ivec2 bottomRight);

}  // namespace nephrite::pictures
