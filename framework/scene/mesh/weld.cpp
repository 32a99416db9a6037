// Merging equal vertices with an open-addressed hash table, and dropping what no triangle uses.
#include <bit>
#include <cstdint>

#include "scene/mesh/prepare.h"

namespace nephrite::scene {
namespace {

constexpr std::uint32_t none = 0xffffffffu;

/// For each item the first item equal to it. Linear probing in a table at most half full.
template<typename Hash, typename Equal>
std::vector<std::uint32_t> firstEqual(std::size_t count, const Hash& hash, const Equal& equal) {
    std::vector<std::uint32_t> table(std::bit_ceil(2 * count + 1), none);
    const std::size_t mask = table.size() - 1;
    std::vector<std::uint32_t> first(count);
    for (std::uint32_t i = 0; i < count; ++i) {
        std::size_t slot = hash(i) & mask;
        while (table[slot] != none && !equal(table[slot], i)) slot = (slot + 1) & mask;
        if (table[slot] == none) table[slot] = i;
        first[i] = table[slot];
    }
    return first;
}

/// Murmur3's finaliser over each word; -0 hashes like +0.
class Hasher {
  public:
    void add(std::uint32_t word) {
        state_ ^= word;
        state_ = (state_ ^ (state_ >> 33)) * 0xff51afd7ed558ccdull;
        state_ = (state_ ^ (state_ >> 33)) * 0xc4ceb9fe1a85ec53ull;
        state_ ^= state_ >> 33;
    }
    void add(float value) { add(std::bit_cast<std::uint32_t>(value + 0.0f)); }
    void add(const glm::vec2& value) { add(value.x), add(value.y); }
    void add(const glm::vec3& value) { add(value.x), add(value.y), add(value.z); }
    std::size_t value() const { return static_cast<std::size_t>(state_); }

  private:
    std::uint64_t state_ = 0x9e3779b97f4a7c15ull;
};

std::vector<std::uint32_t> equalVertices(const Mesh& mesh, std::span<const std::uint32_t> kinds) {
    const bool normals = !mesh.normals.empty();
    const bool texture = !mesh.textureCoordinates.empty();
    const auto hash = [&](std::uint32_t i) {
        Hasher hasher;
        hasher.add(mesh.positions[i]);
        if (normals) hasher.add(mesh.normals[i]);
        if (texture) hasher.add(mesh.textureCoordinates[i]);
        if (!kinds.empty()) hasher.add(kinds[i]);
        return hasher.value();
    };
    const auto equal = [&](std::uint32_t a, std::uint32_t b) {
        return mesh.positions[a] == mesh.positions[b] && (!normals || mesh.normals[a] == mesh.normals[b]) &&
               (!texture || mesh.textureCoordinates[a] == mesh.textureCoordinates[b]) &&
               (kinds.empty() || kinds[a] == kinds[b]);
    };
    return firstEqual(mesh.positions.size(), hash, equal);
}

/// Keeps the listed vertices of `values`, in that order; `kept` ascends.
template<typename T>
void keep(std::vector<T>& values, std::span<const std::uint32_t> kept) {
    if (values.empty()) return;
    for (std::size_t i = 0; i < kept.size(); ++i) values[i] = values[kept[i]];
    values.resize(kept.size());
    values.shrink_to_fit();
}

}  // namespace

std::vector<std::uint32_t> equalPositions(std::span<const glm::vec3> positions) {
    const auto hash = [&](std::uint32_t i) {
        Hasher hasher;
        hasher.add(positions[i]);
        return hasher.value();
    };
    return firstEqual(positions.size(), hash,
                      [&](std::uint32_t a, std::uint32_t b) { return positions[a] == positions[b]; });
}

std::vector<std::uint32_t> weld(Mesh& mesh, std::span<const std::uint32_t> kinds) {
    const std::vector<std::uint32_t> first = equalVertices(mesh, kinds);
    std::vector<std::uint32_t> renumbered(mesh.positions.size(), none);
    for (std::uint32_t& index : mesh.indices) {
        index = first[index];
        renumbered[index] = 0;
    }
    std::vector<std::uint32_t> kept;
    for (std::uint32_t i = 0; i < renumbered.size(); ++i) {
        if (renumbered[i] == none) continue;
        renumbered[i] = static_cast<std::uint32_t>(kept.size());
        kept.push_back(i);
    }
    for (std::uint32_t& index : mesh.indices) index = renumbered[index];
    keep(mesh.positions, kept);
    keep(mesh.normals, kept);
    keep(mesh.textureCoordinates, kept);
    return kept;
}

}  // namespace nephrite::scene
