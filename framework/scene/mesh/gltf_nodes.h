// The tree of a glTF scene's nodes, checked: no cycle, one parent each, not too deep.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "scene/mesh/gltf_document.h"

namespace nephrite::scene::gltf {

/// The nodes of the default scene, parents before children.
struct NodeOrder {
    std::vector<std::size_t> original;  ///< the document's number of each node
    std::vector<std::optional<std::size_t>>
        renumbered;                                  ///< the other way; nothing for nodes outside the scene
    std::vector<std::vector<std::size_t>> children;  ///< of each node, renumbered
    std::size_t roots = 0;                           ///< the first so many nodes have no parent
};

/// Throws InputError at the node that breaks the tree.
NodeOrder orderNodes(const Document& document);

}  // namespace nephrite::scene::gltf
