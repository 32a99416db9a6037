// Reading a glTF primitive.
#include "scene/mesh/gltf_primitive.h"

#include <fmt/format.h>

namespace nephrite::scene::gltf {
namespace {

enum Mode : std::size_t { triangles = 4, triangleStrip = 5, triangleFan = 6, modeCount = 7 };

class PrimitiveReader {
  public:
    PrimitiveReader(const Document& document, const json::Value& primitive, std::size_t jointCount)
        : document_(document), primitive_(primitive), jointCount_(jointCount) {}

    std::optional<Primitive> read() {
        const std::size_t mode = findIndex(primitive_, "mode", modeCount).value_or(triangles);
        if (mode < triangles) return std::nullopt;
        const std::optional<json::Value> attributes = findObject(primitive_, "attributes");
        if (!attributes || !attributes->find("POSITION"))
            fail(primitive_, "a primitive needs the attribute POSITION");
        result_.positions = document_.floats(*accessor(*attributes, "POSITION"), "VEC3", *attributes);
        vertices_ = result_.positions.size() / 3;
        result_.normals = attribute(*attributes, "NORMAL", "VEC3", 3);
        result_.texture = attribute(*attributes, "TEXCOORD_0", "VEC2", 2);
        if (jointCount_ > 0) readJoints(*attributes);
        readIndices(static_cast<Mode>(mode));
        if (result_.indices.empty()) return std::nullopt;
        readTargets();
        return std::move(result_);
    }

  private:
    std::optional<std::size_t> accessor(const json::Value& object, std::string_view key) const {
        return findIndex(object, key, document_.count("accessors"));
    }

    void checkCount(const json::Value& where, std::string_view key, std::size_t found) const {
        if (found == vertices_) return;
        fail(where, fmt::format("{} has {} elements, but POSITION has {}", key, found, vertices_));
    }

    std::vector<float> attribute(const json::Value& object, std::string_view key, std::string_view type,
                                 std::size_t components) const {
        const std::optional<std::size_t> found = accessor(object, key);
        if (!found) return {};
        std::vector<float> values = document_.floats(*found, type, object);
        checkCount(object, key, values.size() / components);
        return values;
    }

    void readJoints(const json::Value& attributes) {
        const std::optional<std::size_t> joints = accessor(attributes, "JOINTS_0");
        if (!joints) return;
        result_.joints = document_.integers(*joints, "VEC4", attributes);
        checkCount(attributes, "JOINTS_0", result_.joints.size() / 4);
        result_.weights = attribute(attributes, "WEIGHTS_0", "VEC4", 4);
        if (result_.weights.empty()) fail(attributes, "JOINTS_0 needs WEIGHTS_0");
        for (std::size_t i = 0; i < result_.joints.size(); ++i) {
            if (result_.weights[i] < 0.0f)
                fail(attributes, fmt::format("a negative weight, {}", result_.weights[i]));
            if (result_.joints[i] < jointCount_) continue;
            fail(attributes, fmt::format("a vertex follows joint {}, but the skin has {}", result_.joints[i],
                                         jointCount_));
        }
    }

    void readIndices(Mode mode) {
        std::vector<std::uint32_t> list;
        if (const std::optional<std::size_t> found = accessor(primitive_, "indices")) {
            list = document_.integers(*found, "SCALAR", primitive_);
        } else {
            for (std::uint32_t i = 0; i < vertices_; ++i) list.push_back(i);
        }
        for (const std::uint32_t vertex : list) {
            if (vertex < vertices_) continue;
            fail(primitive_,
                 fmt::format("the indices name vertex {}, but there are {} vertices", vertex, vertices_));
        }
        if (mode == triangles && list.size() % 3 != 0) {
            fail(primitive_,
                 fmt::format("a triangle list needs three indices a triangle, found {}", list.size()));
        }
        result_.indices = mode == triangles ? std::move(list) : unrolled(list, mode);
    }

    /// A strip's or fan's triangles, all turned the same way.
    static std::vector<std::uint32_t> unrolled(const std::vector<std::uint32_t>& list, Mode mode) {
        std::vector<std::uint32_t> indices;
        for (std::size_t i = 0; i + 2 < list.size(); ++i) {
            if (mode == triangleFan) {
                indices.insert(indices.end(), {list[0], list[i + 1], list[i + 2]});
            } else if (i % 2 == 0) {
                indices.insert(indices.end(), {list[i], list[i + 1], list[i + 2]});
            } else {
                indices.insert(indices.end(), {list[i + 1], list[i], list[i + 2]});
            }
        }
        return indices;
    }

    void readTargets() {
        const std::optional<json::Value> targets = findArray(primitive_, "targets");
        std::size_t values = 0;
        for (std::size_t i = 0; targets && i < targets->size(); ++i) {
            const json::Value object = targets->at(i);
            if (!object.isObject())
                fail(object, fmt::format("expected a morph target, found {}", object.describe()));
            Primitive::Target target;
            target.positions = attribute(object, "POSITION", "VEC3", 3);
            target.normals = attribute(object, "NORMAL", "VEC3", 3);
            target.lacksNormals = !target.positions.empty() && target.normals.empty();
            target.positions.resize(result_.positions.size(), 0.0f);
            target.normals.resize(result_.normals.size(), 0.0f);
            result_.targets.push_back(std::move(target));
            values += 2 * result_.positions.size();
            if (values * sizeof(float) > largestData) fail(*targets, "too many morph targets");
        }
    }

    const Document& document_;
    const json::Value& primitive_;
    std::size_t jointCount_;
    std::size_t vertices_ = 0;
    Primitive result_;
};

}  // namespace

std::optional<Primitive> readPrimitive(const Document& document, const json::Value& primitive,
                                       std::size_t joints) {
    if (!primitive.isObject())
        fail(primitive, fmt::format("expected a primitive, found {}", primitive.describe()));
    return PrimitiveReader(document, primitive, joints).read();
}

}  // namespace nephrite::scene::gltf
