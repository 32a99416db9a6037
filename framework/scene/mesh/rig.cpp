// Evaluating a rig: clip -> nodes -> joints -> vertices.
#include "scene/mesh/rig.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <unordered_map>

namespace nephrite::scene {
namespace {

glm::vec3 between(const glm::vec3& a, const glm::vec3& b, float share) {
    return glm::mix(a, b, share);
}
glm::quat between(const glm::quat& a, const glm::quat& b, float share) {
    return glm::slerp(a, b, share);
}
std::vector<float> between(const std::vector<float>& a, const std::vector<float>& b, float share) {
    std::vector<float> mixed(std::min(a.size(), b.size()));
    for (std::size_t i = 0; i < mixed.size(); ++i) mixed[i] = glm::mix(a[i], b[i], share);
    return mixed;
}

/// The value at a time; the first and last keys hold beyond them. There is at least one key.
template<typename T>
T valueAt(const std::vector<Key<T>>& keys, double seconds) {
    const auto after = std::upper_bound(keys.begin(), keys.end(), seconds,
                                        [](double time, const Key<T>& key) { return time < key.seconds; });
    if (after == keys.begin()) return keys.front().value;
    if (after == keys.end()) return keys.back().value;
    const Key<T>& before = *(after - 1);
    const double share = (seconds - before.seconds) / (after->seconds - before.seconds);
    return between(before.value, after->value, static_cast<float>(share));
}

double repeated(double seconds, double duration) {
    if (!(duration > 0.0)) return 0.0;
    const double rest = std::fmod(seconds, duration);
    return rest < 0.0 ? rest + duration : rest;
}

/// Nodes as the clip has them at a time.
std::vector<RigNode> posedNodes(const Rig& rig, const Clip* clip, double seconds) {
    std::vector<RigNode> nodes = rig.nodes;
    if (!clip) return nodes;
    const double time = repeated(seconds, clip->duration);
    for (const NodeTrack& track : clip->tracks) {
        RigNode& node = nodes[track.node];
        if (!track.translations.empty()) {
            const glm::mat4 moved = glm::translate(glm::mat4(1.0f), valueAt(track.translations, time));
            const glm::mat4 turned = glm::mat4_cast(valueAt(track.rotations, time));
            node.local = glm::scale(moved * turned, valueAt(track.scales, time));
        }
        if (!track.morphWeights.empty()) node.morphWeights = valueAt(track.morphWeights, time);
    }
    return nodes;
}

std::vector<glm::mat4> palette(const Rig& rig, const std::vector<RigNode>& nodes) {
    std::vector<glm::mat4> global(nodes.size());
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const RigNode& node = nodes[i];
        global[i] = node.parent == noParent ? node.local : global[node.parent] * node.local;
    }
    std::vector<glm::mat4> joints(rig.joints.size());
    for (std::size_t i = 0; i < joints.size(); ++i)
        joints[i] = global[rig.joints[i].node] * rig.joints[i].inverseBind;
    return joints;
}

Pose morphed(const Rig& rig, const std::vector<RigNode>& nodes) {
    Pose pose{rig.positions, rig.normals};
    for (const MorphTarget& target : rig.morphTargets) {
        const std::vector<float>& weights = nodes[target.node].morphWeights;
        const float weight = target.weight < weights.size() ? weights[target.weight] : 0.0f;
        if (weight == 0.0f) continue;
        for (const MorphOffset& offset : target.offsets) {
            pose.positions[offset.vertex] += weight * offset.position;
            pose.normals[offset.vertex] += weight * offset.normal;
        }
    }
    return pose;
}

/// Transforms a normal by the inverse transpose (up to a positive factor), made from cross products: it
/// exists for singular matrices too.
glm::vec3 transformedNormal(const glm::mat4& transform, const glm::vec3& normal) {
    const glm::dvec3 x(transform[0]);
    const glm::dvec3 y(transform[1]);
    const glm::dvec3 z(transform[2]);
    const glm::dmat3 cofactors(glm::cross(y, z), glm::cross(z, x), glm::cross(x, y));
    const double orientation = glm::dot(x, cofactors[0]) < 0.0 ? -1.0 : 1.0;
    const glm::dvec3 moved = orientation * (cofactors * glm::dvec3(normal));
    const double length = glm::length(moved);
    return length > 0.0 ? glm::vec3(moved / length) : glm::vec3(0.0f);
}

void append(std::string& key, const void* data, std::size_t bytes) {
    key.append(static_cast<const char*>(data), bytes);
}

}  // namespace

Pose evaluate(const Rig& rig, const Clip* clip, double seconds) {
    const std::vector<RigNode> nodes = posedNodes(rig, clip, seconds);
    const std::vector<glm::mat4> joints = palette(rig, nodes);
    Pose pose = morphed(rig, nodes);
    for (std::size_t i = 0; i < pose.positions.size(); ++i) {
        const JointWeights& follows = rig.weights[i];
        glm::mat4 transform(0.0f);
        for (std::size_t k = 0; k < 4; ++k) transform += follows.weights[k] * joints[follows.joints[k]];
        pose.positions[i] = glm::vec3(transform * glm::vec4(pose.positions[i], 1.0f));
        pose.normals[i] = transformedNormal(transform, pose.normals[i]);
    }
    return pose;
}

Rig reordered(const Rig& rig, std::span<const std::uint32_t> source) {
    Rig result;
    result.nodes = rig.nodes;
    result.joints = rig.joints;
    result.clips = rig.clips;
    result.smoothNormals = rig.smoothNormals;
    for (const std::uint32_t old : source) {
        result.positions.push_back(rig.positions[old]);
        result.normals.push_back(rig.normals[old]);
        result.weights.push_back(rig.weights[old]);
    }
    for (const MorphTarget& target : rig.morphTargets) {
        std::vector<const MorphOffset*> offsetOf(rig.positions.size(), nullptr);
        for (const MorphOffset& offset : target.offsets) offsetOf[offset.vertex] = &offset;
        MorphTarget& moved = result.morphTargets.emplace_back(MorphTarget{target.node, target.weight, {}});
        for (std::uint32_t i = 0; i < source.size(); ++i) {
            const MorphOffset* offset = offsetOf[source[i]];
            if (offset) moved.offsets.push_back({i, offset->position, offset->normal});
        }
    }
    return result;
}

std::vector<std::uint32_t> movementKinds(const Rig& rig) {
    std::vector<std::string> keys(rig.positions.size());
    for (std::size_t i = 0; i < keys.size(); ++i) {
        append(keys[i], &rig.positions[i], sizeof(glm::vec3));
        append(keys[i], &rig.weights[i], sizeof(JointWeights));
    }
    for (std::uint32_t t = 0; t < rig.morphTargets.size(); ++t) {
        for (const MorphOffset& offset : rig.morphTargets[t].offsets) {
            append(keys[offset.vertex], &t, sizeof t);
            append(keys[offset.vertex], &offset.position, sizeof offset.position);
            append(keys[offset.vertex], &offset.normal, sizeof offset.normal);
        }
    }
    std::unordered_map<std::string, std::uint32_t> kinds;
    std::vector<std::uint32_t> kindOf(keys.size());
    for (std::size_t i = 0; i < keys.size(); ++i) {
        kindOf[i] = kinds.emplace(std::move(keys[i]), static_cast<std::uint32_t>(kinds.size())).first->second;
    }
    return kindOf;
}

}  // namespace nephrite::scene
