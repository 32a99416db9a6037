// Checking a glTF file and writing it anew in its plainest form (see gltf.h).
#include <fmt/format.h>

#include <cmath>
#include <map>

#include "scene/mesh/gltf.h"
#include "scene/mesh/gltf_animation.h"
#include "scene/mesh/gltf_container.h"
#include "scene/mesh/gltf_document.h"
#include "scene/mesh/gltf_nodes.h"
#include "scene/mesh/gltf_primitive.h"
#include "scene/mesh/gltf_writer.h"

namespace nephrite::scene {
namespace {

using namespace gltf;

void checkVersion(const Document& document) {
    const std::optional<json::Value> asset = findObject(document.root(), "asset");
    const std::optional<json::Value> version = asset ? asset->find("version") : std::nullopt;
    if (!version) fail(document.root(), "a glTF file needs \"asset\" with a \"version\"");
    if (const std::string found = text(*version, "a version"); !found.starts_with("2.")) {
        fail(*version, fmt::format("expected glTF version 2, found \"{}\"", found));
    }
    const std::optional<json::Value> extensions = findArray(document.root(), "extensionsRequired");
    for (std::size_t i = 0; extensions && i < extensions->size(); ++i) {
        // Materials and textures are not read; quantised attributes are.
        const std::string name = text(extensions->at(i), "an extension's name");
        const bool harmless = name.starts_with("KHR_materials_") || name.starts_with("KHR_texture_") ||
                              name.starts_with("EXT_texture_") || name == "KHR_mesh_quantization";
        if (!harmless)
            fail(extensions->at(i),
                 fmt::format("the file requires the extension {}, which is not read", name));
    }
}

template<typename T>
Json::Value jsonArray(const std::vector<T>& values) {
    Json::Value array(Json::arrayValue);
    for (const T& value : values) array.append(value);
    return array;
}

class Checker {
  public:
    explicit Checker(const Document& document) : document_(document), nodes_(orderNodes(document)) {}

    CheckedGltf run() {
        for (std::size_t i = 0; i < nodes_.original.size(); ++i) addNode(i);
        Json::Value& out = writer_.document();
        out["scene"] = 0;
        for (std::size_t i = 0; i < nodes_.roots; ++i)
            out["scenes"][0]["nodes"].append(static_cast<Json::UInt>(i));
        for (std::size_t i = 0; i < document_.count("animations"); ++i)
            addAnimation(document_.item("animations", i), i);
        if (!out.isMember("meshes")) fail(document_.root(), "the glTF file's scene has no triangles");
        result_.nodeCount = nodes_.original.size();
        result_.glb = writer_.finish();
        return std::move(result_);
    }

  private:
    void addNode(std::size_t i) {
        const json::Value node = document_.item("nodes", nodes_.original[i]);
        Json::Value out;
        out["name"] = std::to_string(i);
        for (const std::size_t child : nodes_.children[i])
            out["children"].append(static_cast<Json::UInt>(child));
        addTransform(node, out);
        morphCounts_.push_back(0);
        if (const auto mesh = findIndex(node, "mesh", document_.count("meshes"))) {
            const auto skin = findIndex(node, "skin", document_.count("skins"));
            addMesh(document_.item("meshes", *mesh), node, skin, out);
        }
        writer_.document()["nodes"].append(out);
    }

    void addTransform(const json::Value& node, Json::Value& out) {
        const std::optional<json::Value> matrix = node.find("matrix");
        if (matrix) {
            out["matrix"] = jsonArray(numbers(*matrix, 16, "a matrix of 16 numbers"));
            return;
        }
        const auto part = [&](std::string_view key, std::vector<float> fallback) {
            const std::optional<json::Value> value = node.find(key);
            return value ? numbers(*value, fallback.size(), fmt::format("\"{}\"", key)) : fallback;
        };
        const std::vector<float> rotation = part("rotation", {0.0f, 0.0f, 0.0f, 1.0f});
        if (rotation == std::vector<float>(4, 0.0f)) fail(node, "a node's rotation is the zero quaternion");
        out["translation"] = jsonArray(part("translation", {0.0f, 0.0f, 0.0f}));
        out["rotation"] = jsonArray(rotation);
        out["scale"] = jsonArray(part("scale", {1.0f, 1.0f, 1.0f}));
    }

    /// Every node gets a mesh of its own, since Assimp keeps one skin a mesh.
    void addMesh(const json::Value& mesh, const json::Value& node, std::optional<std::size_t> skin,
                 Json::Value& out) {
        const std::size_t joints = skin ? jointCount(*skin) : 0;
        const std::optional<json::Value> primitives = findArray(mesh, "primitives");
        std::size_t targets = 0;
        Json::Value written;
        for (std::size_t p = 0; primitives && p < primitives->size(); ++p) {
            const std::optional<Primitive> primitive = readPrimitive(document_, primitives->at(p), joints);
            if (!primitive) continue;
            if (!written["primitives"].empty() && primitive->targets.size() != targets) {
                fail(primitives->at(p), "the primitives of one mesh need the same number of morph targets");
            }
            targets = primitive->targets.size();
            written["primitives"].append(writePrimitive(*primitive));
            if (writer_.size() > largestData)
                fail(mesh, fmt::format("the meshes have more than {} bytes", largestData));
        }
        if (written["primitives"].empty()) return;
        morphCounts_.back() = targets;
        if (targets > 0) written["weights"] = jsonArray(restWeights(mesh, node, targets));
        out["mesh"] = writer_.document()["meshes"].size();
        writer_.document()["meshes"].append(written);
        if (skin) out["skin"] = writtenSkin(*skin);
    }

    std::vector<float> restWeights(const json::Value& mesh, const json::Value& node,
                                   std::size_t targets) const {
        std::optional<json::Value> weights = node.find("weights");
        if (!weights) weights = mesh.find("weights");
        return weights ? numbers(*weights, targets, "one weight for each morph target")
                       : std::vector<float>(targets);
    }

    Json::Value writePrimitive(const Primitive& primitive) {
        Json::Value out;
        Json::Value& attributes = out["attributes"];
        attributes["POSITION"] = writer_.addFloats(primitive.positions, "VEC3", 3);
        if (!primitive.normals.empty())
            attributes["NORMAL"] = writer_.addFloats(primitive.normals, "VEC3", 3);
        if (!primitive.texture.empty())
            attributes["TEXCOORD_0"] = writer_.addFloats(primitive.texture, "VEC2", 2);
        if (!primitive.weights.empty()) {
            attributes["JOINTS_0"] = writer_.addJoints(primitive.joints);
            attributes["WEIGHTS_0"] = writer_.addFloats(primitive.weights, "VEC4", 4);
        }
        out["indices"] = writer_.addIndices(primitive.indices);
        for (const Primitive::Target& target : primitive.targets) {
            Json::Value written;
            written["POSITION"] = writer_.addFloats(target.positions, "VEC3", 3);
            if (!target.normals.empty()) written["NORMAL"] = writer_.addFloats(target.normals, "VEC3", 3);
            out["targets"].append(written);
            result_.smoothNormals = result_.smoothNormals || target.lacksNormals;
        }
        result_.smoothNormals = result_.smoothNormals || primitive.normals.empty();
        result_.hasTexture = result_.hasTexture || !primitive.texture.empty();
        return out;
    }

    std::size_t jointCount(std::size_t skin) const {
        const json::Value object = document_.item("skins", skin);
        const std::optional<json::Value> joints = findArray(object, "joints");
        if (!joints || joints->size() == 0 || joints->size() > 0xffff)
            fail(object, "a skin needs 1 to 65535 joints");
        return joints->size();
    }

    Json::UInt writtenSkin(std::size_t skin) {
        const auto [entry, isNew] = skins_.emplace(skin, writer_.document()["skins"].size());
        if (isNew) writer_.document()["skins"].append(writeSkin(skin));
        return entry->second;
    }

    Json::Value writeSkin(std::size_t skin) {
        const json::Value object = document_.item("skins", skin);
        const json::Value joints = *findArray(object, "joints");
        Json::Value out;
        for (std::size_t k = 0; k < joints.size(); ++k) {
            const std::size_t node = index(joints.at(k), document_.count("nodes"), "nodes");
            if (!nodes_.renumbered[node])
                fail(joints.at(k), fmt::format("joint {} is not in the scene", node));
            out["joints"].append(static_cast<Json::UInt>(*nodes_.renumbered[node]));
        }
        std::vector<float> matrices;
        if (const auto accessor = findIndex(object, "inverseBindMatrices", document_.count("accessors"))) {
            matrices = document_.floats(*accessor, "MAT4", object);
        } else {
            for (std::size_t k = 0; k < 16 * joints.size(); ++k)
                matrices.push_back(k % 16 % 5 == 0 ? 1.0f : 0.0f);
        }
        if (matrices.size() < 16 * joints.size())
            fail(object, "a skin needs an inverse bind matrix for each joint");
        matrices.resize(16 * joints.size());
        out["inverseBindMatrices"] = writer_.addFloats(matrices, "MAT4", 16);
        return out;
    }

    void addAnimation(const json::Value& animation, std::size_t number) {
        const std::optional<json::Value> name = animation.find("name");
        const std::optional<json::Value> channels = findArray(animation, "channels");
        Json::Value out;
        for (std::size_t k = 0; channels && k < channels->size(); ++k)
            addChannel(animation, channels->at(k), out);
        if (out.empty()) return;
        result_.clipNames.push_back(name ? text(*name, "a name") : fmt::format("animation {}", number));
        writer_.document()["animations"].append(out);
    }

    /// The path a channel moves; nothing if an extension defines it.
    static std::optional<Path> pathOf(const json::Value& target) {
        const std::optional<json::Value> value = target.find("path");
        if (!value) fail(target, "an animation's target needs a \"path\"");
        const std::string name = text(*value, "a path");
        constexpr std::string_view names[] = {"translation", "rotation", "scale", "weights"};
        for (std::size_t i = 0; i < std::size(names); ++i) {
            if (name == names[i]) return static_cast<Path>(i);
        }
        return std::nullopt;
    }

    void addChannel(const json::Value& animation, const json::Value& channel, Json::Value& out) {
        const std::optional<json::Value> target = findObject(channel, "target");
        const std::optional<json::Value> samplers = findArray(animation, "samplers");
        const auto sampler = findIndex(channel, "sampler", samplers ? samplers->size() : 0);
        if (!target || !sampler) fail(channel, "an animation's channel needs \"target\" and \"sampler\"");
        const auto original = findIndex(*target, "node", document_.count("nodes"));
        const std::optional<Path> path = pathOf(*target);
        if (!original || !path || !nodes_.renumbered[*original]) return;
        const std::size_t node = *nodes_.renumbered[*original];
        if (*path == Path::weights && morphCounts_[node] == 0) return;
        if (*path != Path::weights && document_.item("nodes", *original).find("matrix")) {
            fail(*target, fmt::format("node {} has a matrix, so it cannot be animated", *original));
        }
        writeChannel(readKeys(document_, samplers->at(*sampler), *path, morphCounts_[node]), node, *path,
                     out);
        if (writer_.size() > largestData)
            fail(channel, fmt::format("the keys have more than {} bytes", largestData));
    }

    void writeChannel(const LinearKeys& keys, std::size_t node, Path path, Json::Value& out) {
        constexpr std::string_view paths[] = {"translation", "rotation", "scale", "weights"};
        constexpr std::string_view types[] = {"VEC3", "VEC4", "VEC3", "SCALAR"};
        const std::vector<float> values = path == Path::weights ? signedPairs(keys) : keys.values;
        const std::size_t components = path == Path::weights ? 1 : keys.components;
        Json::Value sampler;
        sampler["input"] = writer_.addFloats(keys.times, "SCALAR", 1);
        sampler["output"] = writer_.addFloats(values, types[static_cast<std::size_t>(path)], components);
        Json::Value channel;
        channel["sampler"] = out["samplers"].size();
        channel["target"]["node"] = static_cast<Json::UInt>(node);
        channel["target"]["path"] = std::string(paths[static_cast<std::size_t>(path)]);
        out["samplers"].append(sampler);
        out["channels"].append(channel);
    }

    /// Assimp turns negative weights into 0, so each key holds the weights' positive parts, then their
    /// negative ones.
    static std::vector<float> signedPairs(const LinearKeys& keys) {
        std::vector<float> pairs;
        for (std::size_t i = 0; i < keys.values.size(); i += keys.components) {
            for (std::size_t k = 0; k < keys.components; ++k)
                pairs.push_back(std::max(keys.values[i + k], 0.0f));
            for (std::size_t k = 0; k < keys.components; ++k)
                pairs.push_back(std::max(-keys.values[i + k], 0.0f));
        }
        return pairs;
    }

    const Document& document_;
    NodeOrder nodes_;
    Writer writer_;
    std::map<std::size_t, Json::UInt> skins_;
    std::vector<std::size_t> morphCounts_;  ///< of each node
    CheckedGltf result_;
};

}  // namespace

CheckedGltf checkGltf(std::string_view bytes, const std::string& file, const BufferLoader& loader) {
    const Container container = splitContainer(bytes, file);
    const Document document(json::parse(std::string(container.json), file), container.binary, loader);
    checkVersion(document);
    return Checker(document).run();
}

}  // namespace nephrite::scene
