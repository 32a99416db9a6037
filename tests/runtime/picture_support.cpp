// Small scenes, the pictures the renderer makes of them, and the rays of their pixels.
#include "picture_support.h"

#include <fmt/format.h>

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>

#include "scratch_folder.h"

namespace nephrite::pictures {
namespace {

std::string toJson(const glm::dvec3& v) {
    return fmt::format("[{}, {}, {}]", v.x, v.y, v.z);
}

}  // namespace

double Camera::pixelWidth(int size) const {
    return 2 * std::tan(fovY * std::numbers::pi / 360) / size;
}

glm::dvec3 Camera::ray(glm::dvec2 pixel, int size) const {
    const glm::dvec3 forward = glm::normalize(target - position);
    const glm::dvec3 right = glm::normalize(glm::cross(forward, glm::dvec3(0, 1, 0)));
    const glm::dvec3 up = glm::cross(right, forward);
    const glm::dvec2 offset = (pixel - glm::dvec2(size) / 2.0) * pixelWidth(size);
    return glm::normalize(forward + offset.x * right - offset.y * up);
}

std::string SceneText::json() const {
    return fmt::format(R"({{ "millimetersPerUnit": 1,
  "camera": {{"position": {}, "target": {}, "up": [0, 1, 0], "fovY": {}, "near": 1, "far": 1000}},
  "lights": [{}],
  "environment": {{"radiance": {}}},
  "materials": {{"stuff": {}}},
  "objects": [{{"mesh": {}, "material": "stuff", "transform": {{"translate": {}}}}}] }})",
                       toJson(camera.position), toJson(camera.target), camera.fovY, light, environment,
                       material, mesh, translate);
}

runtime::Session render(const SceneText& scene, int size, const std::vector<std::string>& dumps) {
    runtime::SessionOptions options;
    options.graph = std::filesystem::path(NEPHRITE_SOURCE_DIR) / "graphs" / "paper.json";
    options.scene = sharedScratchFolder().write("scene.json", scene.json());
    options.size = {static_cast<std::uint32_t>(size), static_cast<std::uint32_t>(size)};
    options.dumps = dumps;
    runtime::Session session(options);
    session.renderFrame(0);
    return session;
}

std::optional<double> hitSphere(const glm::dvec3& origin, const glm::dvec3& direction, double radius) {
    const double along = -glm::dot(origin, direction);
    const double squared = along * along - glm::dot(origin, origin) + radius * radius;
    if (squared < 0) return std::nullopt;
    return along - std::sqrt(squared);
}

bool hitsBox(const glm::dvec3& origin, const glm::dvec3& direction, const glm::dvec3& size) {
    const glm::dvec3 a = (-size / 2.0 - origin) / direction;
    const glm::dvec3 b = (size / 2.0 - origin) / direction;
    const glm::dvec3 enter = glm::min(a, b);
    const glm::dvec3 leave = glm::max(a, b);
    return std::max({enter.x, enter.y, enter.z}) <= std::min({leave.x, leave.y, leave.z});
}

int farFromOutline(const image::Image& position, const Camera& camera,
                   const std::function<bool(const glm::dvec3&)>& hits) {
    constexpr int directions = 32;
    const int size = static_cast<int>(position.width);
    int wrong = 0;
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            const bool covered =
                position.at(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y), 3) != 0;
            const glm::dvec2 centre(x + 0.5, y + 0.5);
            bool near = hits(camera.ray(centre, size)) == covered;
            for (int i = 0; i < directions && !near; ++i) {
                const double angle = 2 * std::numbers::pi * i / directions;
                near =
                    hits(camera.ray(centre + glm::dvec2(std::cos(angle), std::sin(angle)), size)) == covered;
            }
            wrong += near ? 0 : 1;
        }
    }
    return wrong;
}

double brightness(const image::Image& image, glm::ivec2 topLeft, glm::ivec2 bottomRight) {
    double sum = 0;
    for (int y = topLeft.y; y < bottomRight.y; ++y) {
        for (int x = topLeft.x; x < bottomRight.x; ++x) {
            for (std::uint32_t channel = 0; channel < 3; ++channel)
                sum += image.at(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y), channel);
        }
    }
    return sum;
}

}  // namespace nephrite::pictures
