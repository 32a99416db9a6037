// Ordering a glTF scene's nodes level by level.
#include "scene/mesh/gltf_nodes.h"

#include <fmt/format.h>

namespace nephrite::scene::gltf {
namespace {

/// Assimp walks the tree by recursion.
constexpr std::size_t deepest = 256;

json::Value defaultScene(const Document& document) {
    if (document.count("scenes") == 0) fail(document.root(), "the glTF file has no scene");
    return document.item("scenes", findIndex(document.root(), "scene", document.count("scenes")).value_or(0));
}

class Orderer {
  public:
    explicit Orderer(const Document& document) : document_(document) {
        order_.renumbered.resize(document.count("nodes"));
    }

    NodeOrder run() {
        addAll(defaultScene(document_), "nodes");
        order_.roots = order_.original.size();
        std::size_t levelEnd = order_.original.size();
        std::size_t depth = 1;
        for (std::size_t i = 0; i < order_.original.size(); ++i) {
            const json::Value node = document_.item("nodes", order_.original[i]);
            if (i == levelEnd) {
                levelEnd = order_.original.size();
                if (++depth > deepest) fail(node, fmt::format("nodes nested more than {} deep", deepest));
            }
            order_.children.push_back(addAll(node, "children"));
        }
        return std::move(order_);
    }

  private:
    /// Appends the nodes that an array names. A node named before has two parents, or is its own ancestor.
    std::vector<std::size_t> addAll(const json::Value& object, std::string_view key) {
        std::vector<std::size_t> added;
        const std::optional<json::Value> array = findArray(object, key);
        for (std::size_t k = 0; array && k < array->size(); ++k) {
            const json::Value entry = array->at(k);
            const std::size_t node = index(entry, document_.count("nodes"), "nodes");
            if (order_.renumbered[node]) {
                fail(entry, fmt::format("node {} is named twice: a cycle, or a node with two parents", node));
            }
            order_.renumbered[node] = order_.original.size();
            added.push_back(order_.original.size());
            order_.original.push_back(node);
        }
        return added;
    }

    const Document& document_;
    NodeOrder order_;
};

}  // namespace

NodeOrder orderNodes(const Document& document) {
    return Orderer(document).run();
}

}  // namespace nephrite::scene::gltf
