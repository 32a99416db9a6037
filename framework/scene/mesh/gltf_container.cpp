// GLB chunks, base64 and percent encoding.
#include "scene/mesh/gltf_container.h"

#include <fmt/format.h>

#include <charconv>
#include <cstdint>

namespace nephrite::scene::gltf {
namespace {

constexpr std::uint32_t magic = 0x46546c67;        // "glTF"
constexpr std::uint32_t jsonChunk = 0x4e4f534a;    // "JSON"
constexpr std::uint32_t binaryChunk = 0x004e4942;  // "BIN"

/// GLB numbers are little-endian.
std::uint32_t wordAt(std::string_view bytes, std::size_t offset) {
    std::uint32_t word = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        word |= std::uint32_t{static_cast<unsigned char>(bytes[offset + i])} << (8 * i);
    }
    return word;
}

void appendWord(std::string& bytes, std::uint32_t word) {
    for (int i = 0; i < 4; ++i) bytes.push_back(static_cast<char>((word >> (8 * i)) & 0xff));
}

struct Chunk {
    std::uint32_t type = 0;
    std::string_view data;
};

Chunk chunkAt(std::string_view bytes, std::size_t offset, const std::string& file) {
    if (bytes.size() - offset < 8) {
        throw InputError({file, 0, 0}, fmt::format("the GLB file is truncated: no chunk at byte {}", offset));
    }
    const std::uint32_t length = wordAt(bytes, offset);
    if (length > bytes.size() - offset - 8) {
        throw InputError({file, 0, 0},
                         fmt::format("the GLB file is truncated: the chunk at byte {} has {} bytes, but "
                                     "{} are left",
                                     offset, length, bytes.size() - offset - 8));
    }
    return {wordAt(bytes, offset + 4), bytes.substr(offset + 8, length)};
}

std::optional<std::uint32_t> base64Digit(char c) {
    if (c >= 'A' && c <= 'Z') return static_cast<std::uint32_t>(c - 'A');
    if (c >= 'a' && c <= 'z') return static_cast<std::uint32_t>(c - 'a' + 26);
    if (c >= '0' && c <= '9') return static_cast<std::uint32_t>(c - '0' + 52);
    if (c == '+' || c == '-') return 62;
    if (c == '/' || c == '_') return 63;
    return std::nullopt;
}

}  // namespace

Container splitContainer(std::string_view bytes, const std::string& file) {
    if (bytes.size() < 4 || wordAt(bytes, 0) != magic) return {bytes, std::nullopt};
    if (bytes.size() < 12)
        throw InputError({file, 0, 0}, "the GLB file is truncated: its header has 12 bytes");
    if (const std::uint32_t version = wordAt(bytes, 4); version != 2) {
        throw InputError({file, 0, 0}, fmt::format("the GLB file is of version {}, expected 2", version));
    }
    if (const std::uint32_t length = wordAt(bytes, 8); length > bytes.size()) {
        throw InputError({file, 0, 0},
                         fmt::format("the GLB file is truncated: its header names {} bytes, found {}", length,
                                     bytes.size()));
    }
    const Chunk first = chunkAt(bytes, 12, file);
    if (first.type != jsonChunk)
        throw InputError({file, 0, 0}, "the first chunk of the GLB file is not JSON");
    Container container{first.data, std::nullopt};
    const std::size_t next = 12 + 8 + first.data.size();
    if (next < bytes.size()) {
        const Chunk second = chunkAt(bytes, next, file);
        if (second.type == binaryChunk) container.binary = second.data;
    }
    return container;
}

std::string makeGlb(std::string json, std::string binary) {
    while (json.size() % 4 != 0) json.push_back(' ');
    while (binary.size() % 4 != 0) binary.push_back('\0');
    std::string glb;
    glb.reserve(28 + json.size() + binary.size());
    appendWord(glb, magic);
    appendWord(glb, 2);
    appendWord(glb, static_cast<std::uint32_t>(28 + json.size() + binary.size()));
    appendWord(glb, static_cast<std::uint32_t>(json.size()));
    appendWord(glb, jsonChunk);
    glb += json;
    appendWord(glb, static_cast<std::uint32_t>(binary.size()));
    appendWord(glb, binaryChunk);
    glb += binary;
    return glb;
}

std::optional<std::string> decodeDataUri(std::string_view uri) {
    const std::size_t comma = uri.find(',');
    if (comma == std::string_view::npos || !uri.substr(0, comma).ends_with(";base64")) return std::nullopt;
    std::string_view digits = uri.substr(comma + 1);
    while (digits.ends_with('=')) digits.remove_suffix(1);
    if (digits.size() % 4 == 1) return std::nullopt;
    std::string bytes;
    bytes.reserve(digits.size() * 3 / 4);
    std::uint32_t bits = 0;
    unsigned held = 0;
    for (const char c : digits) {
        const std::optional<std::uint32_t> digit = base64Digit(c);
        if (!digit) return std::nullopt;
        bits = (bits << 6 | *digit) & 0xfff;
        held += 6;
        if (held < 8) continue;
        held -= 8;
        bytes.push_back(static_cast<char>((bits >> held) & 0xff));
    }
    return bytes;
}

std::optional<std::string> decodePercent(std::string_view uri) {
    std::string decoded;
    for (std::size_t i = 0; i < uri.size(); ++i) {
        if (uri[i] != '%') {
            decoded.push_back(uri[i]);
            continue;
        }
        const std::string_view digits = uri.substr(i + 1, 2);
        int value = 0;
        const auto [end, fault] = std::from_chars(digits.data(), digits.data() + digits.size(), value, 16);
        if (digits.size() != 2 || fault != std::errc() || end != digits.data() + 2 || value < 0)
            return std::nullopt;
        decoded.push_back(static_cast<char>(value));
        i += 2;
    }
    return decoded;
}

}  // namespace nephrite::scene::gltf
