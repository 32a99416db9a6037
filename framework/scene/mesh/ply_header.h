// The header of a PLY file: which elements follow, and what each of their properties is.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "text/diagnostics.h"

namespace nephrite::scene::ply {

enum class Format { ascii, littleEndian, bigEndian };
enum class Type { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

std::size_t bytesOf(Type type);

struct Property {
    std::string name;
    Type type = Type::float32;
    std::optional<Type> countType;  ///< of a list: what its length is stored as
};

struct Element {
    std::string name;
    std::uint64_t count = 0;
    std::vector<Property> properties;
    SourceLocation where;
};

struct Header {
    Format format = Format::ascii;
    std::vector<Element> elements;
    std::size_t bodyOffset = 0;  ///< the first byte after the line end_header
};

/// Reads the header. Throws InputError with line and column.
Header readHeader(std::string_view bytes, const std::string& file);

}  // namespace nephrite::scene::ply
