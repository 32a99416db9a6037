// From Assimp's scene to a mesh and its rig.
#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fmt/format.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <charconv>
#include <exception>
#include <glm/gtc/type_ptr.hpp>
#include <optional>

#include "scene/mesh/gltf.h"

namespace nephrite::scene {
namespace {

/// Assimp's glTF key times are milliseconds.
constexpr double secondsPerTick = 1e-3;

glm::vec3 toGlm(const aiVector3D& v) {
    return {v.x, v.y, v.z};
}
glm::quat toGlm(const aiQuaternion& q) {
    return {q.w, q.x, q.y, q.z};
}
/// Assimp's matrices are stored row by row.
glm::mat4 toGlm(const aiMatrix4x4& m) {
    return glm::transpose(glm::make_mat4(&m.a1));
}

class SceneReader {
  public:
    SceneReader(const aiScene& scene, const CheckedGltf& checked) : scene_(scene), checked_(checked) {}

    RiggedMesh read() {
        result_.rig.nodes.resize(checked_.nodeCount);
        result_.rig.smoothNormals = checked_.smoothNormals;
        std::vector<const aiNode*> pending{scene_.mRootNode};
        while (!pending.empty()) {
            const aiNode* node = pending.back();
            pending.pop_back();
            pending.insert(pending.end(), node->mChildren, node->mChildren + node->mNumChildren);
            readNode(*node);
        }
        for (unsigned i = 0; i < scene_.mNumAnimations; ++i)
            readClip(*scene_.mAnimations[i], checked_.clipNames.at(i));
        readRestPose();
        return std::move(result_);
    }

  private:
    /// Our nodes are named by their number; the root that Assimp adds above several is not ours.
    std::optional<std::uint32_t> numberOf(const aiString& name) const {
        std::uint32_t number = 0;
        const auto [end, fault] = std::from_chars(name.data, name.data + name.length, number);
        if (fault != std::errc() || end != name.data + name.length || number >= checked_.nodeCount)
            return std::nullopt;
        return number;
    }

    std::uint32_t knownNumber(const aiString& name) const {
        const std::optional<std::uint32_t> number = numberOf(name);
        if (!number) throw RunError(fmt::format("Assimp names an unknown node \"{}\"", name.C_Str()));
        return *number;
    }

    void readNode(const aiNode& node) {
        const std::optional<std::uint32_t> number = numberOf(node.mName);
        if (!number) return;
        RigNode& target = result_.rig.nodes[*number];
        target.local = toGlm(node.mTransformation);
        const std::optional<std::uint32_t> parent =
            node.mParent ? numberOf(node.mParent->mName) : std::nullopt;
        target.parent = parent.value_or(noParent);
        for (unsigned i = 0; i < node.mNumMeshes; ++i) readMesh(*scene_.mMeshes[node.mMeshes[i]], *number);
    }

    void readMesh(const aiMesh& mesh, std::uint32_t node) {
        const auto first = static_cast<std::uint32_t>(result_.rig.positions.size());
        for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
            result_.rig.positions.push_back(toGlm(mesh.mVertices[i]));
            result_.rig.normals.push_back(mesh.mNormals ? toGlm(mesh.mNormals[i]) : glm::vec3(0.0f));
            if (!checked_.hasTexture) continue;
            // Assimp turned v upwards; pictures count it downwards, as glTF does.
            const aiVector3D uv =
                mesh.mTextureCoords[0] ? mesh.mTextureCoords[0][i] : aiVector3D(0.0f, 1.0f, 0.0f);
            result_.mesh.textureCoordinates.emplace_back(uv.x, 1.0f - uv.y);
        }
        for (unsigned i = 0; i < mesh.mNumFaces; ++i) {
            const aiFace& face = mesh.mFaces[i];
            if (face.mNumIndices != 3) continue;
            for (unsigned k = 0; k < 3; ++k) result_.mesh.indices.push_back(first + face.mIndices[k]);
        }
        readWeights(mesh, node, first);
        readMorphTargets(mesh, node, first);
    }

    void readWeights(const aiMesh& mesh, std::uint32_t node, std::uint32_t first) {
        std::vector<JointWeights>& weights = result_.rig.weights;
        const auto own = static_cast<std::uint32_t>(result_.rig.joints.size());
        result_.rig.joints.push_back({node, glm::mat4(1.0f)});
        weights.resize(result_.rig.positions.size(),
                       JointWeights{{own, own, own, own}, {0.0f, 0.0f, 0.0f, 0.0f}});
        for (unsigned b = 0; b < mesh.mNumBones; ++b) {
            const aiBone& bone = *mesh.mBones[b];
            const auto joint = static_cast<std::uint32_t>(result_.rig.joints.size());
            result_.rig.joints.push_back({knownNumber(bone.mName), toGlm(bone.mOffsetMatrix)});
            for (unsigned k = 0; k < bone.mNumWeights; ++k) {
                addWeight(weights[first + bone.mWeights[k].mVertexId], joint, bone.mWeights[k].mWeight);
            }
        }
        for (std::size_t i = first; i < weights.size(); ++i) normalizeWeights(weights[i]);
    }

    static void addWeight(JointWeights& follows, std::uint32_t joint, float weight) {
        const auto smallest = std::min_element(follows.weights.begin(), follows.weights.end());
        if (weight <= *smallest) return;
        follows.joints[static_cast<std::size_t>(smallest - follows.weights.begin())] = joint;
        *smallest = weight;
    }

    /// A vertex that no joint claims follows its node.
    static void normalizeWeights(JointWeights& follows) {
        float sum = 0.0f;
        for (const float weight : follows.weights) sum += weight;
        if (!(sum > 0.0f)) {
            follows.weights[0] = sum = 1.0f;
        }
        for (float& weight : follows.weights) weight /= sum;
    }

    void readMorphTargets(const aiMesh& mesh, std::uint32_t node, std::uint32_t first) {
        std::vector<float>& weights = result_.rig.nodes[node].morphWeights;
        weights.assign(mesh.mNumAnimMeshes, 0.0f);
        for (unsigned t = 0; t < mesh.mNumAnimMeshes; ++t) {
            const aiAnimMesh& moved = *mesh.mAnimMeshes[t];
            weights[t] = moved.mWeight;
            MorphTarget target{node, t, {}};
            for (unsigned i = 0; i < std::min(mesh.mNumVertices, moved.mNumVertices); ++i) {
                MorphOffset offset{first + i};
                if (moved.mVertices) offset.position = toGlm(moved.mVertices[i] - mesh.mVertices[i]);
                if (moved.mNormals && mesh.mNormals)
                    offset.normal = toGlm(moved.mNormals[i] - mesh.mNormals[i]);
                const bool still = offset.position == glm::vec3(0.0f) && offset.normal == glm::vec3(0.0f);
                if (!still) target.offsets.push_back(offset);
            }
            result_.rig.morphTargets.push_back(std::move(target));
        }
    }

    void readClip(const aiAnimation& animation, const std::string& name) {
        Clip clip{name, 0.0, {}};
        for (unsigned i = 0; i < animation.mNumChannels; ++i)
            clip.tracks.push_back(movement(*animation.mChannels[i]));
        for (unsigned i = 0; i < animation.mNumMorphMeshChannels; ++i) {
            clip.tracks.push_back(morphing(*animation.mMorphMeshChannels[i]));
        }
        const auto extend = [&](const auto& keys) {
            if (!keys.empty()) clip.duration = std::max(clip.duration, keys.back().seconds);
        };
        for (const NodeTrack& track : clip.tracks) {
            extend(track.translations);
            extend(track.rotations);
            extend(track.scales);
            extend(track.morphWeights);
        }
        result_.rig.clips.push_back(std::move(clip));
    }

    NodeTrack movement(const aiNodeAnim& channel) const {
        NodeTrack track;
        track.node = knownNumber(channel.mNodeName);
        for (unsigned k = 0; k < channel.mNumPositionKeys; ++k) {
            const aiVectorKey& key = channel.mPositionKeys[k];
            track.translations.push_back({key.mTime * secondsPerTick, toGlm(key.mValue)});
        }
        for (unsigned k = 0; k < channel.mNumRotationKeys; ++k) {
            const aiQuatKey& key = channel.mRotationKeys[k];
            track.rotations.push_back({key.mTime * secondsPerTick, toGlm(key.mValue)});
        }
        for (unsigned k = 0; k < channel.mNumScalingKeys; ++k) {
            const aiVectorKey& key = channel.mScalingKeys[k];
            track.scales.push_back({key.mTime * secondsPerTick, toGlm(key.mValue)});
        }
        if (track.translations.empty() || track.rotations.empty() || track.scales.empty()) {
            throw RunError("Assimp gave a node animation without keys");
        }
        return track;
    }

    /// The weights were written as positive and negative parts (see gltf_check.cpp).
    NodeTrack morphing(const aiMeshMorphAnim& channel) const {
        NodeTrack track;
        track.node = knownNumber(channel.mName);
        for (unsigned k = 0; k < channel.mNumKeys; ++k) {
            const aiMeshMorphKey& key = channel.mKeys[k];
            const unsigned count = key.mNumValuesAndWeights / 2;
            std::vector<float> weights(count);
            for (unsigned i = 0; i < count; ++i)
                weights[i] = static_cast<float>(key.mWeights[i] - key.mWeights[count + i]);
            track.morphWeights.push_back({key.mTime * secondsPerTick, std::move(weights)});
        }
        return track;
    }

    /// Fills the mesh with the rig at rest; a triangle that a mirroring transform turned over is turned back.
    void readRestPose() {
        Pose pose = evaluate(result_.rig, nullptr, 0.0);
        result_.mesh.positions = std::move(pose.positions);
        if (!checked_.smoothNormals) result_.mesh.normals = std::move(pose.normals);
        const std::vector<bool> mirrored = mirroringJoints();
        std::vector<std::uint32_t>& indices = result_.mesh.indices;
        for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
            if (mirrored[result_.rig.weights[indices[i]].joints[0]])
                std::swap(indices[i + 1], indices[i + 2]);
        }
    }

    std::vector<bool> mirroringJoints() const {
        const std::vector<RigNode>& nodes = result_.rig.nodes;
        std::vector<bool> mirroringNodes(nodes.size());
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            const bool above = nodes[i].parent != noParent && mirroringNodes[nodes[i].parent];
            mirroringNodes[i] = above != (glm::determinant(glm::dmat3(nodes[i].local)) < 0.0);
        }
        std::vector<bool> mirroring;
        for (const RigJoint& joint : result_.rig.joints) {
            const bool bind = glm::determinant(glm::dmat3(joint.inverseBind)) < 0.0;
            mirroring.push_back(mirroringNodes[joint.node] != bind);
        }
        return mirroring;
    }

    const aiScene& scene_;
    const CheckedGltf& checked_;
    RiggedMesh result_;
};

}  // namespace

RiggedMesh importGltf(const CheckedGltf& checked, const std::string& file) {
    Assimp::Importer importer;
    const aiScene* scene = nullptr;
    std::string fault;
    try {
        scene = importer.ReadFileFromMemory(checked.glb.data(), checked.glb.size(), 0, "glb");
        fault = importer.GetErrorString();
    } catch (const std::exception& exception) {
        fault = exception.what();
    }
    if (!scene || !scene->mRootNode) {
        throw InputError({file, 0, 0}, fmt::format("Assimp cannot import the file: {}", fault));
    }
    return SceneReader(*scene, checked).read();
}

}  // namespace nephrite::scene
