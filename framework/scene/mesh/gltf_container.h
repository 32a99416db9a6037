// The outer forms of glTF data: GLB chunks, data URIs, percent-encoded paths.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "text/diagnostics.h"

namespace nephrite::scene::gltf {

/// The JSON text and, for a GLB that has one, the binary chunk; views into the file's bytes.
struct Container {
    std::string_view json;
    std::optional<std::string_view> binary;
};

/// Splits a file. Throws InputError with the byte offset if a GLB's header or chunks are wrong or truncated.
Container splitContainer(std::string_view bytes, const std::string& file);

/// Joins a JSON text and a binary chunk to a GLB.
std::string makeGlb(std::string json, std::string binary);

/// The bytes of `data:...;base64,...`; nothing if it is not base64.
std::optional<std::string> decodeDataUri(std::string_view uri);

/// Replaces %XX; nothing if a % is not followed by two hexadecimal digits.
std::optional<std::string> decodePercent(std::string_view uri);

}  // namespace nephrite::scene::gltf
