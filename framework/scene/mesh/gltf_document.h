// A glTF document whose references are followed with checks: arrays of objects, buffers, buffer views,
// accessors.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/mesh/gltf.h"
#include "text/json.h"

namespace nephrite::scene::gltf {

/// More than this from one file (loaded, or unfolded by shared references) is refused.
inline constexpr std::size_t largestData = std::size_t{1} << 28;

// Checked access to JSON. Each throws InputError at the value if it is not what was asked for.
[[noreturn]] void fail(const json::Value& value, const std::string& message);
/// An object's member that is an integer from 0 to `below` - 1.
std::optional<std::size_t> findIndex(const json::Value& object, std::string_view key, std::size_t below);
std::size_t index(const json::Value& value, std::size_t below, std::string_view what);
std::size_t natural(const json::Value& value, std::size_t highest, std::string_view what);
std::size_t naturalMember(const json::Value& object, std::string_view key, std::size_t fallback);
json::Value requiredMember(const json::Value& object, std::string_view key);
std::vector<float> numbers(const json::Value& value, std::size_t count, std::string_view what);
std::string text(const json::Value& value, std::string_view what);
/// The member `key` that must be an array or an object; nothing if it is absent.
std::optional<json::Value> findArray(const json::Value& object, std::string_view key);
std::optional<json::Value> findObject(const json::Value& object, std::string_view key);

/// A range of a buffer's bytes.
struct View {
    std::string_view bytes;
    std::size_t stride = 0;  ///< bytes from one element to the next; 0: they are packed
};

class Document {
  public:
    Document(json::Value root, std::optional<std::string_view> binary, const BufferLoader& loader);

    /// How many objects the top-level array `name` has.
    std::size_t count(std::string_view name) const;
    /// Object i of the top-level array `name`.
    json::Value item(std::string_view name, std::size_t i) const;
    const json::Value& root() const { return root_; }

    /// The bytes of buffer view `i`.
    View view(std::size_t i) const;

    /// The values of accessor `i`, element by element; integers are normalised where the accessor says so.
    /// Throws at `where` unless the accessor has that `type` and all values are finite.
    std::vector<float> floats(std::size_t i, std::string_view type, const json::Value& where) const;
    /// The values of a SCALAR or VEC4 accessor of unsigned integers.
    std::vector<std::uint32_t> integers(std::size_t i, std::string_view type, const json::Value& where) const;

  private:
    std::string loadBuffer(std::size_t i, std::optional<std::string_view> binary,
                           const BufferLoader& loader) const;

    json::Value root_;
    std::vector<std::string> buffers_;
};

}  // namespace nephrite::scene::gltf
