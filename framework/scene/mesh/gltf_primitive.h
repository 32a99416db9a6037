// One primitive of a glTF mesh as plain arrays: a triangle list with its attributes and morph targets.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "scene/mesh/gltf_document.h"

namespace nephrite::scene::gltf {

struct Primitive {
    /// Displacements, three numbers a vertex; normals only if the primitive has them.
    struct Target {
        std::vector<float> positions;
        std::vector<float> normals;
        bool lacksNormals = false;  ///< it moves positions, but the file does not say how the normals follow
    };

    std::vector<float> positions;
    std::vector<float> normals;         ///< empty if the file has none
    std::vector<float> texture;         ///< empty if the file has none
    std::vector<std::uint32_t> joints;  ///< four a vertex; empty without a skin
    std::vector<float> weights;         ///< four a vertex; empty without a skin
    std::vector<std::uint32_t> indices;
    std::vector<Target> targets;
};

/// Reads a primitive of triangles; nothing for points and lines, or without a single triangle. `joints` is
/// how many joints the node's skin has, 0 without one. Throws InputError at the fault.
std::optional<Primitive> readPrimitive(const Document& document, const json::Value& primitive,
                                       std::size_t joints);

}  // namespace nephrite::scene::gltf
