// World matrices: fit, scale, rotation, translation, turning and paths.
#include "scene/object_motion.h"

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

namespace nephrite::scene {
namespace {

/// Nobody can ask the mesh how long a clip is; long enough to see one of usual length go through its poses.
constexpr double usualClipSeconds = 4;

glm::dmat4 rotation(const glm::dvec3& degrees) {
    glm::dmat4 matrix(1);
    matrix = glm::rotate(matrix, glm::radians(degrees.z), {0, 0, 1});
    matrix = glm::rotate(matrix, glm::radians(degrees.y), {0, 1, 0});
    return glm::rotate(matrix, glm::radians(degrees.x), {1, 0, 0});
}

/// Mesh coordinates to mm.
glm::dmat4 unitMatrix(const TransformDescription& transform, const Box& restBox, double millimetersPerUnit) {
    if (!transform.fit) return glm::scale(glm::dmat4(1), glm::dvec3(millimetersPerUnit));
    const double side = restBox.longestSide();
    const double factor = side > 0 ? *transform.fit / side : 1;
    return glm::translate(glm::scale(glm::dmat4(1), glm::dvec3(factor)), -glm::dvec3(restBox.center()));
}

}  // namespace

glm::dvec3 pointOnPath(const AnimationDescription& path, double loops) {
    const auto count = static_cast<std::ptrdiff_t>(path.points.size());
    const double along = (loops - std::floor(loops)) * static_cast<double>(count);
    const auto segment = static_cast<std::ptrdiff_t>(along);
    const double t = along - static_cast<double>(segment);
    const auto point = [&](std::ptrdiff_t offset) {
        return path.points[static_cast<std::size_t>((segment + offset + count) % count)];
    };
    if (!path.smooth) return glm::mix(point(0), point(1), t);
    const glm::dvec3 before = point(-1), from = point(0), to = point(1), after = point(2);
    return from + 0.5 * t *
                      (to - before +
                       t * (2.0 * before - 5.0 * from + 4.0 * to - after +
                            t * (3.0 * (from - to) + after - before)));
}

glm::dmat4 worldMatrix(const ObjectDescription& object, const Box& restBox, double millimetersPerUnit,
                       double seconds) {
    glm::dvec3 place = object.transform.translate;
    glm::dmat4 spin(1);
    for (const AnimationDescription& animation : object.animations) {
        if (animation.type == AnimationType::Path)
            place += pointOnPath(animation, seconds / animation.secondsPerLoop);
        if (animation.type == AnimationType::Rotate) {
            const double degrees = std::fmod(animation.degreesPerSecond * seconds, 360.0);
            spin = glm::rotate(glm::dmat4(1), glm::radians(degrees), animation.axis) * spin;
        }
    }
    const glm::dmat4 oriented = spin * rotation(object.transform.rotate);
    const glm::dmat4 placed = glm::translate(glm::dmat4(1), place) * oriented;
    return glm::scale(placed, object.transform.scale) *
           unitMatrix(object.transform, restBox, millimetersPerUnit);
}

double periodOf(const AnimationDescription& animation) {
    switch (animation.type) {
        case AnimationType::Clip:
            return usualClipSeconds;
        case AnimationType::Rotate:
            return animation.degreesPerSecond == 0 ? 0 : 360 / std::abs(animation.degreesPerSecond);
        case AnimationType::Path:
            return animation.secondsPerLoop;
        case AnimationType::Deformation:
            return animation.deformation.period;
    }
    return 0;
}

}  // namespace nephrite::scene
