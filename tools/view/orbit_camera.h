// A camera that is moved by hand: around its target, along the picture, towards it.
#pragma once

#include "scene/bounds.h"
#include "scene/scene_description.h"

namespace nephrite::view {

/// Distances on the picture are in heights of the picture, x to the right and y down.
class OrbitCamera {
  public:
    explicit OrbitCamera(const scene::CameraDescription& camera);

    const scene::CameraDescription& description() const { return camera_; }

    /// Turns around the target as if the scene were grabbed and drawn over the picture: a whole height is
    /// half a turn. Stops short of looking along the up direction.
    void orbit(double x, double y);
    /// Moves along the picture plane, so that what is at the target's distance follows the hand. A step that
    /// would end farther away than approach() goes is not made.
    void pan(double x, double y);
    /// Goes nearer by a tenth of the distance to the target for each step; away for negative steps. Stops at
    /// a millionth and at a million times the distance there was at first.
    void approach(double steps);
    /// Moves so that the sphere just fits into a picture of `width` x `height`, seen from the same direction.
    /// Nothing happens with an empty sphere.
    void frame(const scene::EnclosingSphere& sphere, double width, double height);

  private:
    glm::dvec3 upwards() const;
    glm::dvec3 rightwards() const;
    void keepInDepth();

    double limited(double distance) const;

    scene::CameraDescription camera_;
    glm::dvec3 firstTarget_;  ///< mm
    double firstDistance_;    ///< mm
    double firstNear_;        ///< mm
    double firstFar_;         ///< mm
};

}  // namespace nephrite::view
