// Numbers of a PLY body, from text or binary.
#include "scene/mesh/ply_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

namespace nephrite::scene::ply {
namespace {

template<typename T>
double decode(const char* bytes, bool swapBytes) {
    std::array<char, sizeof(T)> raw;
    std::memcpy(raw.data(), bytes, sizeof(T));
    if (swapBytes) std::reverse(raw.begin(), raw.end());
    return static_cast<double>(std::bit_cast<T>(raw));
}

double decode(Type type, const char* bytes, bool swapBytes) {
    switch (type) {
        case Type::int8:
            return decode<std::int8_t>(bytes, swapBytes);
        case Type::uint8:
            return decode<std::uint8_t>(bytes, swapBytes);
        case Type::int16:
            return decode<std::int16_t>(bytes, swapBytes);
        case Type::uint16:
            return decode<std::uint16_t>(bytes, swapBytes);
        case Type::int32:
            return decode<std::int32_t>(bytes, swapBytes);
        case Type::uint32:
            return decode<std::uint32_t>(bytes, swapBytes);
        case Type::float32:
            return decode<float>(bytes, swapBytes);
        case Type::float64:
            return decode<double>(bytes, swapBytes);
    }
    return 0.0;
}

bool isInteger(Type type) {
    return type != Type::float32 && type != Type::float64;
}

}  // namespace

TextValues::TextValues(std::string_view bytes, std::size_t bodyOffset, const std::string& file)
    : cursor_(bytes, file) {
    while (cursor_.offset() < bodyOffset) cursor_.skipLine();
}

double TextValues::number(Type type, std::string_view what) {
    const double value = cursor_.number(what);
    if (isInteger(type) && value != std::floor(value)) {
        cursor_.fail(fmt::format("expected {}, a whole number, found {}", what, value));
    }
    return value;
}

void TextValues::skip(Type) {
    if (cursor_.word().empty())
        cursor_.fail("expected another number of the element, found the end of the line");
}

void TextValues::startItem() {
    if (!cursor_.findLine())
        cursor_.fail("the file is truncated: it ends before the last element its header names");
}

void TextValues::endItem() {
    cursor_.endLine("the element");
}

std::uint64_t TextValues::leastBytes(const Element& element) const {
    return 2 * element.properties.size();  // a digit each, and a blank or the line's end after it
}

std::size_t TextValues::unread() {
    return cursor_.findLine() ? cursor_.remaining() : 0;
}

BinaryValues::BinaryValues(std::string_view bytes, std::size_t bodyOffset, const std::string& file,
                           bool swapBytes)
    : bytes_(bytes), file_(file), swapBytes_(swapBytes), offset_(bodyOffset), itemStart_(bodyOffset) {}

const char* BinaryValues::take(std::size_t count) {
    if (remaining() < count) {
        fail(fmt::format("the file is truncated: it ends at byte {}, within the element", bytes_.size()));
    }
    const char* taken = bytes_.data() + offset_;
    offset_ += count;
    return taken;
}

double BinaryValues::number(Type type, std::string_view what) {
    const double value = decode(type, take(bytesOf(type)), swapBytes_);
    if (!(std::abs(value) <= std::numeric_limits<float>::max()) && !isInteger(type)) {
        fail(fmt::format("expected {}, found {}, which is not a finite number", what, value));
    }
    return value;
}

std::uint64_t BinaryValues::leastBytes(const Element& element) const {
    std::uint64_t bytes = 0;
    for (const Property& property : element.properties)
        bytes += bytesOf(property.countType.value_or(property.type));
    return bytes;
}

void BinaryValues::fail(const std::string& message) const {
    throw InputError({file_, 0, 0}, fmt::format("{} (element at byte {})", message, itemStart_));
}

}  // namespace nephrite::scene::ply
