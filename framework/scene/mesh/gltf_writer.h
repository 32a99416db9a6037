// Writes the plain GLB that Assimp gets: one buffer, an accessor with a view of its own for each array of
// values.
#pragma once

#include <json/value.h>

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace nephrite::scene::gltf {

class Writer {
  public:
    Writer();

    /// Each adds an accessor and returns its index. `type` is a glTF accessor type of `components` numbers.
    Json::UInt addFloats(std::span<const float> values, std::string_view type, std::size_t components);
    Json::UInt addIndices(std::span<const std::uint32_t> values);
    Json::UInt addJoints(std::span<const std::uint32_t> values);

    /// Bytes of all values so far.
    std::size_t size() const { return binary_.size(); }
    /// The document: the caller adds nodes, meshes, skins and animations.
    Json::Value& document() { return document_; }
    /// The finished GLB.
    std::string finish();

  private:
    Json::UInt addAccessor(const void* data, std::size_t bytes, int componentType, std::string_view type,
                           std::size_t count);

    Json::Value document_;
    std::string binary_;
};

}  // namespace nephrite::scene::gltf
