// A mesh at a time: rest or clip, then deformation.
#include "scene/mesh/animated_mesh.h"

#include <utility>

#include "scene/mesh/prepare.h"

namespace nephrite::scene {

AnimatedMesh::AnimatedMesh(Mesh rest) : rest_(std::move(rest)), restBox_(boundingBox(rest_.positions)) {}

AnimatedMesh::AnimatedMesh(Mesh rest, Rig rig)
    : rest_(std::move(rest)), restBox_(boundingBox(rest_.positions)), rig_(std::move(rig)) {
    if (rig_.smoothNormals) smoothingGroups_ = equalPositions(rest_.positions);
}

std::vector<std::string> AnimatedMesh::clipNames() const {
    std::vector<std::string> names;
    for (const Clip& clip : rig_.clips) names.push_back(clip.name);
    return names;
}

bool AnimatedMesh::play(std::string_view clip) {
    for (std::size_t i = 0; i < rig_.clips.size(); ++i) {
        if (rig_.clips[i].name != clip) continue;
        clip_ = i;
        return true;
    }
    return false;
}

Pose AnimatedMesh::at(double seconds) const {
    Pose pose;
    if (clip_) {
        pose = evaluate(rig_, &rig_.clips[*clip_], seconds);
        if (rig_.smoothNormals) pose.normals = smoothNormals(pose.positions, rest_.indices, smoothingGroups_);
        for (std::size_t i = 0; i < pose.normals.size(); ++i) {
            if (pose.normals[i] == glm::vec3(0.0f)) pose.normals[i] = rest_.normals[i];
        }
    } else {
        pose = {rest_.positions, rest_.normals};
    }
    if (deformation_) scene::deform(*deformation_, restBox_, seconds, pose);
    return pose;
}

}  // namespace nephrite::scene
