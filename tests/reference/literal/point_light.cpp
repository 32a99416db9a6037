// Which view of a light sees a point.
#include "reference/literal/point_light.h"

namespace nephrite::reference {

std::optional<LightProjection> projectIntoLight(const PointLight& light, const glm::dvec3& point) {
    for (const LightView& view : light.views) {
        if (const auto uv = project(view.view, point)) return LightProjection{&view, *uv};
    }
    return std::nullopt;
}

}  // namespace nephrite::reference
