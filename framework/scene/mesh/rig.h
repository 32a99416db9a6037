// A glTF file's moving parts, evaluated on the CPU: a tree of nodes, skins (linear blend skinning), morph
// targets, and the clips that drive them.
//
// Every vertex follows up to four joints. A mesh without a skin is one joint: its node, with weight 1.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <span>
#include <string>
#include <vector>

#include "scene/mesh/deformation.h"
#include "scene/mesh/mesh.h"

namespace nephrite::scene {

inline constexpr std::uint32_t noParent = 0xffffffffu;

/// A node's place in its parent; parents come before their children.
struct RigNode {
    std::uint32_t parent = noParent;
    glm::mat4 local{1.0f};
    std::vector<float> morphWeights;  ///< of its mesh's morph targets at rest
};

/// A matrix of the skinning palette: global(node) * inverseBind.
struct RigJoint {
    std::uint32_t node = 0;
    glm::mat4 inverseBind{1.0f};
};

/// The joints (indices into Rig::joints) a vertex follows; the weights sum to 1.
struct JointWeights {
    std::array<std::uint32_t, 4> joints{};
    std::array<float, 4> weights{1.0f, 0.0f, 0.0f, 0.0f};
};

/// How far a morph target moves one vertex.
struct MorphOffset {
    std::uint32_t vertex = 0;
    glm::vec3 position{0.0f};
    glm::vec3 normal{0.0f};
};

/// Displacements that one of a node's morph weights scales; vertices it leaves alone are not listed.
struct MorphTarget {
    std::uint32_t node = 0;
    std::uint32_t weight = 0;  ///< which of the node's morph weights
    std::vector<MorphOffset> offsets;
};

template<typename T>
struct Key {
    double seconds = 0.0;
    T value;
};

/// What a clip does to one node: moves it (then translations, rotations and scales have a key or more each),
/// changes its morph weights, or both. Values between keys are interpolated linearly, rotations along the
/// shorter arc.
struct NodeTrack {
    std::uint32_t node = 0;
    std::vector<Key<glm::vec3>> translations;
    std::vector<Key<glm::quat>> rotations;
    std::vector<Key<glm::vec3>> scales;
    std::vector<Key<std::vector<float>>> morphWeights;
};

/// A named animation; it repeats after `duration` seconds.
struct Clip {
    std::string name;
    double duration = 0.0;
    std::vector<NodeTrack> tracks;
};

struct Rig {
    std::vector<RigNode> nodes;
    std::vector<RigJoint> joints;
    std::vector<glm::vec3> positions;  ///< before morphing and skinning, one for each vertex of the mesh
    std::vector<glm::vec3> normals;
    std::vector<JointWeights> weights;
    std::vector<MorphTarget> morphTargets;
    std::vector<Clip> clips;
    bool smoothNormals =
        false;  ///< the file lacks normals for some pose: compute them from the moved triangles
};

/// The vertices while `clip` plays (it repeats), or at rest if it is null. Normals follow the cofactor matrix
/// of the blended transform and are unit, or of length zero where the rig has none.
Pose evaluate(const Rig& rig, const Clip* clip, double seconds);

/// The rig for a mesh whose vertex i is this rig's vertex source[i].
Rig reordered(const Rig& rig, std::span<const std::uint32_t> source);

/// Equal numbers for vertices that move alike: same place, joints, weights and morph offsets.
std::vector<std::uint32_t> movementKinds(const Rig& rig);

}  // namespace nephrite::scene
