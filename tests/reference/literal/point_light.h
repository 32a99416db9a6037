// A point light together with the G-buffers drawn from it.
#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "reference/literal/layer_path.h"
#include "reference/literal/texels.h"
#include "reference/literal/view.h"

namespace nephrite::reference {

/// One view of a light and what it sees. Images that an evaluated formula does not read may be empty.
struct LightView {
    View view;
    Texels position;  ///< xyz, w = 1 where covered
    Texels normal;
    Texels surface;                  ///< u, v, material + 1
    Texels irradiance;               ///< E'
    std::vector<Texels> thickness;   ///< four layers a texel
    std::vector<Texels> scattering;  ///< one image a layer
};

struct PointLight {
    glm::dvec3 position{0};
    glm::dvec3 intensity{0};       ///< W/sr
    std::vector<LightView> views;  ///< 1, or 6 cube faces
};

/// A view of a light and picture coordinates in it.
struct LightProjection {
    const LightView* view = nullptr;
    glm::dvec2 uv{0};
};

/// The view of the light that contains a point's projection, and where; nothing if none does.
std::optional<LightProjection> projectIntoLight(const PointLight& light, const glm::dvec3& point);

}  // namespace nephrite::reference
