// A mesh whose vertices may move with time while its triangles and texture coordinates stay: a glTF clip,
// then a procedural deformation.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/mesh/deformation.h"
#include "scene/mesh/mesh.h"
#include "scene/mesh/rig.h"

namespace nephrite::scene {

class AnimatedMesh {
  public:
    AnimatedMesh() = default;
    /// A mesh that stays as it is unless deformed. `rest` is finished (see prepare.h).
    explicit AnimatedMesh(Mesh rest);
    /// A mesh moved by a rig; the rig has one vertex for each of `rest`, which is its pose without a clip.
    AnimatedMesh(Mesh rest, Rig rig);

    /// The mesh without any animation: also the one whose bounding box `"fit"` uses.
    const Mesh& rest() const { return rest_; }
    const Box& restBox() const { return restBox_; }

    /// The clips the file has, in its order.
    std::vector<std::string> clipNames() const;
    /// From now on `at` plays this clip. Returns false if there is no such clip; clipNames() has the right
    /// ones.
    bool play(std::string_view clip);
    /// From now on `at` applies this deformation (after the clip).
    void deform(const Deformation& deformation) { deformation_ = deformation; }

    /// True if `at` depends on the time.
    bool animated() const { return clip_.has_value() || deformation_.has_value(); }
    /// Vertices at a time; index for index those of rest(). Times before 0 and after the end repeat the clip.
    Pose at(double seconds) const;

  private:
    Mesh rest_;
    Box restBox_;
    Rig rig_;
    std::vector<std::uint32_t> smoothingGroups_;
    std::optional<std::size_t> clip_;
    std::optional<Deformation> deformation_;
};

}  // namespace nephrite::scene
