// The body of a PLY file: vertices and faces.
#include "scene/mesh/ply.h"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <cmath>
#include <optional>

#include "scene/mesh/ply_header.h"
#include "scene/mesh/ply_values.h"

namespace nephrite::scene {
namespace {

using ply::Element;
using ply::Header;
using ply::Property;

/// What a vertex property is for: an index into the vertex's eight numbers, or nothing.
enum Slot : std::size_t { slotX, slotY, slotZ, slotNX, slotNY, slotNZ, slotU, slotV, slotCount };

std::optional<std::size_t> slotOf(const Property& property) {
    constexpr std::pair<std::string_view, Slot> slots[] = {
        {"x", slotX}, {"y", slotY}, {"z", slotZ}, {"nx", slotNX}, {"ny", slotNY},       {"nz", slotNZ},
        {"s", slotU}, {"t", slotV}, {"u", slotU}, {"v", slotV},   {"texture_u", slotU}, {"texture_v", slotV}};
    if (property.countType) return std::nullopt;
    for (const auto& [name, slot] : slots) {
        if (property.name == name) return slot;
    }
    return std::nullopt;
}

bool isIndexList(const Property& property) {
    return property.countType && (property.name == "vertex_indices" || property.name == "vertex_index");
}

/// The element of that name; two of them, or none, is a fault.
const Element& findElement(const Header& header, std::string_view name, const std::string& file) {
    const Element* found = nullptr;
    for (const Element& element : header.elements) {
        if (element.name != name) continue;
        if (found) throw InputError(element.where, fmt::format("a second element \"{}\"", name));
        found = &element;
    }
    if (!found) throw InputError({file, 0, 0}, fmt::format("the PLY file has no element \"{}\"", name));
    return *found;
}

template<typename Values>
class BodyReader {
  public:
    BodyReader(const Header& header, Values values, const std::string& file)
        : header_(header),
          values_(std::move(values)),
          vertices_(findElement(header, "vertex", file)),
          faces_(findElement(header, "face", file)) {
        checkProperties();
    }

    Mesh read(const std::string& file, Diagnostics& diagnostics) {
        for (const Element& element : header_.elements) {
            if (element.properties.empty()) continue;
            checkSize(element);
            if (&element == &vertices_) {
                readVertices();
            } else if (&element == &faces_) {
                readFaces();
            } else {
                skipElement(element);
            }
        }
        if (const std::size_t unread = values_.unread(); unread > 0) {
            diagnostics.warning({file, 0, 0},
                                fmt::format("{} bytes after the last element are ignored", unread));
        }
        return std::move(mesh_);
    }

  private:
    void checkProperties() {
        std::array<bool, slotCount> has{};
        for (const Property& property : vertices_.properties) {
            const std::optional<std::size_t> slot = slotOf(property);
            if (slot && has[*slot]) {
                throw InputError(vertices_.where,
                                 fmt::format("vertex property \"{}\" is given twice", property.name));
            }
            if (slot) has[*slot] = true;
            slots_.push_back(slot);
        }
        if (!has[slotX] || !has[slotY] || !has[slotZ]) {
            throw InputError(vertices_.where, "element \"vertex\" needs the properties x, y and z");
        }
        hasNormals_ = has[slotNX] && has[slotNY] && has[slotNZ];
        hasTexture_ = has[slotU] && has[slotV];
        std::size_t lists = 0;
        for (const Property& property : faces_.properties) lists += isIndexList(property) ? 1 : 0;
        if (lists != 1)
            throw InputError(faces_.where, "element \"face\" needs one list property vertex_indices");
    }

    /// Refuses a count that the rest of the file cannot hold, before anything is reserved for it.
    void checkSize(const Element& element) {
        // The last line of a text file may lack its end: one byte less.
        const std::uint64_t possible = (std::uint64_t{values_.remaining()} + 1) / values_.leastBytes(element);
        if (element.count > possible || element.count >= 0xffffffffu) {
            values_.fail(fmt::format(
                "the file is truncated: its header names {} elements \"{}\", but {} bytes are left",
                element.count, element.name, values_.remaining()));
        }
    }

    void readVertices() {
        mesh_.positions.reserve(vertices_.count);
        if (hasNormals_) mesh_.normals.reserve(vertices_.count);
        if (hasTexture_) mesh_.textureCoordinates.reserve(vertices_.count);
        for (std::uint64_t i = 0; i < vertices_.count; ++i) {
            values_.startItem();
            std::array<float, slotCount> vertex{};
            for (std::size_t k = 0; k < slots_.size(); ++k)
                readVertexProperty(vertices_.properties[k], slots_[k], vertex);
            values_.endItem();
            mesh_.positions.emplace_back(vertex[slotX], vertex[slotY], vertex[slotZ]);
            if (hasNormals_) mesh_.normals.emplace_back(vertex[slotNX], vertex[slotNY], vertex[slotNZ]);
            if (hasTexture_) mesh_.textureCoordinates.emplace_back(vertex[slotU], 1.0f - vertex[slotV]);
        }
    }

    void readVertexProperty(const Property& property, std::optional<std::size_t> slot,
                            std::array<float, slotCount>& vertex) {
        if (!slot) {
            skipProperty(property);
        } else {
            vertex[*slot] = static_cast<float>(values_.number(property.type, "a vertex's number"));
        }
    }

    void readFaces() {
        mesh_.indices.reserve(3 * faces_.count);
        for (std::uint64_t i = 0; i < faces_.count; ++i) {
            values_.startItem();
            for (const Property& property : faces_.properties) {
                if (isIndexList(property)) {
                    readPolygon(property);
                } else {
                    skipProperty(property);
                }
            }
            values_.endItem();
        }
    }

    void readPolygon(const Property& property) {
        const std::uint64_t corners = readLength(property);
        if (corners < 3) values_.fail(fmt::format("a face has {} corners, but needs at least 3", corners));
        const std::uint32_t first = readIndex(property);
        std::uint32_t previous = readIndex(property);
        for (std::uint64_t k = 2; k < corners; ++k) {
            const std::uint32_t current = readIndex(property);
            mesh_.indices.insert(mesh_.indices.end(), {first, previous, current});
            previous = current;
        }
    }

    std::uint64_t readLength(const Property& property) {
        const double length = values_.number(*property.countType, "the length of a list");
        if (!(length >= 0.0)) values_.fail(fmt::format("a list has the negative length {}", length));
        return static_cast<std::uint64_t>(length);
    }

    std::uint32_t readIndex(const Property& property) {
        const double index = values_.number(property.type, "a vertex index");
        if (!(index >= 0.0) || index >= static_cast<double>(vertices_.count) || index != std::floor(index)) {
            values_.fail(fmt::format("a face names vertex {}, but there are {} vertices (0 to {})", index,
                                     vertices_.count, static_cast<std::int64_t>(vertices_.count) - 1));
        }
        return static_cast<std::uint32_t>(index);
    }

    void skipElement(const Element& element) {
        for (std::uint64_t i = 0; i < element.count; ++i) {
            values_.startItem();
            for (const Property& property : element.properties) skipProperty(property);
            values_.endItem();
        }
    }

    void skipProperty(const Property& property) {
        const std::uint64_t values = property.countType ? readLength(property) : 1;
        for (std::uint64_t i = 0; i < values; ++i) values_.skip(property.type);
    }

    const Header& header_;
    Values values_;
    const Element& vertices_;
    const Element& faces_;
    std::vector<std::optional<std::size_t>> slots_;
    bool hasNormals_ = false;
    bool hasTexture_ = false;
    Mesh mesh_;
};

}  // namespace

Mesh readPly(std::string_view bytes, const std::string& file, Diagnostics& diagnostics) {
    const Header header = ply::readHeader(bytes, file);
    if (header.format == ply::Format::ascii) {
        ply::TextValues values(bytes, header.bodyOffset, file);
        return BodyReader(header, std::move(values), file).read(file, diagnostics);
    }
    const bool fileIsLittle = header.format == ply::Format::littleEndian;
    const bool hostIsLittle = std::endian::native == std::endian::little;
    ply::BinaryValues values(bytes, header.bodyOffset, file, fileIsLittle != hostIsLittle);
    return BodyReader(header, std::move(values), file).read(file, diagnostics);
}

}  // namespace nephrite::scene
