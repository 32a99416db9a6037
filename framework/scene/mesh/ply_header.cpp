// Reading the header of a PLY file, line by line.
#include "scene/mesh/ply_header.h"

#include <fmt/format.h>

#include <charconv>
#include <utility>

#include "scene/mesh/text_cursor.h"

namespace nephrite::scene::ply {
namespace {

/// No honest header is longer; a binary file of another kind is refused early.
constexpr std::size_t longestHeader = 1 << 20;

constexpr std::pair<std::string_view, Type> typeNames[] = {
    {"char", Type::int8},       {"int8", Type::int8},       {"uchar", Type::uint8},
    {"uint8", Type::uint8},     {"short", Type::int16},     {"int16", Type::int16},
    {"ushort", Type::uint16},   {"uint16", Type::uint16},   {"int", Type::int32},
    {"int32", Type::int32},     {"uint", Type::uint32},     {"uint32", Type::uint32},
    {"float", Type::float32},   {"float32", Type::float32}, {"double", Type::float64},
    {"float64", Type::float64},
};

Type readType(TextCursor& cursor) {
    const std::string_view word = cursor.word();
    for (const auto& [name, type] : typeNames) {
        if (name == word) return type;
    }
    std::vector<std::string_view> known;
    for (const auto& [name, type] : typeNames) known.push_back(name);
    cursor.fail(fmt::format("expected a property type, found {}{}", quoted(word), suggestion(word, known)));
}

std::string readName(TextCursor& cursor, std::string_view what) {
    const std::string_view word = cursor.word();
    if (word.empty()) cursor.fail(fmt::format("expected the name of {}", what));
    return std::string(word);
}

Format readFormat(TextCursor& cursor) {
    constexpr std::string_view known[] = {"ascii", "binary_little_endian", "binary_big_endian"};
    const std::string_view word = cursor.word();
    for (std::size_t i = 0; i < std::size(known); ++i) {
        if (word != known[i]) continue;
        const std::string_view version = cursor.word();
        if (version != "1.0") cursor.fail(fmt::format("expected PLY version 1.0, found {}", quoted(version)));
        return static_cast<Format>(i);
    }
    cursor.fail(fmt::format("expected a PLY format, found {}{}", quoted(word), suggestion(word, known)));
}

Element readElement(TextCursor& cursor) {
    Element element;
    element.where = cursor.where();
    element.name = readName(cursor, "an element");
    const std::string_view word = cursor.word();
    const auto [end, fault] = std::from_chars(word.data(), word.data() + word.size(), element.count);
    if (word.empty() || fault != std::errc() || end != word.data() + word.size()) {
        cursor.fail(
            fmt::format("expected how many elements \"{}\" there are, found {}", element.name, quoted(word)));
    }
    return element;
}

Property readProperty(TextCursor& cursor) {
    Property property;
    TextCursor ahead = cursor;
    if (ahead.word() == "list") {
        cursor.word();
        property.countType = readType(cursor);
        if (*property.countType == Type::float32 || *property.countType == Type::float64) {
            cursor.fail("expected an integer type for the length of a list");
        }
    }
    property.type = readType(cursor);
    property.name = readName(cursor, "a property");
    return property;
}

class HeaderReader {
  public:
    HeaderReader(std::string_view bytes, const std::string& file)
        : cursor_(bytes.substr(0, longestHeader), file) {}

    Header read() {
        if (cursor_.word() != "ply") cursor_.fail("not a PLY file: the first line is not \"ply\"");
        cursor_.endLine("\"ply\"");
        while (readLine()) {
        }
        if (!hasFormat_) cursor_.fail("the PLY header has no \"format\" line");
        header_.bodyOffset = cursor_.offset();
        return std::move(header_);
    }

  private:
    /// False after end_header.
    bool readLine() {
        if (!cursor_.findLine()) cursor_.fail("the file ends within the PLY header (no \"end_header\")");
        const std::string_view keyword = cursor_.word();
        if (keyword == "comment" || keyword == "obj_info") {
            cursor_.skipLine();
            return true;
        }
        readKeyword(keyword);
        cursor_.endLine(fmt::format("\"{}\"", keyword));
        return keyword != "end_header";
    }

    void readKeyword(std::string_view keyword) {
        constexpr std::string_view known[] = {"format",  "element",  "property",
                                              "comment", "obj_info", "end_header"};
        if (keyword == "format") {
            header_.format = readFormat(cursor_);
            hasFormat_ = true;
        } else if (keyword == "element") {
            header_.elements.push_back(readElement(cursor_));
        } else if (keyword == "property") {
            if (header_.elements.empty()) cursor_.fail("a property before the first element");
            header_.elements.back().properties.push_back(readProperty(cursor_));
        } else if (keyword != "end_header") {
            cursor_.fail(fmt::format("expected a PLY header line, found {}{}", quoted(keyword),
                                     suggestion(keyword, known)));
        }
    }

    TextCursor cursor_;
    Header header_;
    bool hasFormat_ = false;
};

}  // namespace

std::size_t bytesOf(Type type) {
    switch (type) {
        case Type::int8:
        case Type::uint8:
            return 1;
        case Type::int16:
        case Type::uint16:
            return 2;
        case Type::int32:
        case Type::uint32:
        case Type::float32:
            return 4;
        case Type::float64:
            return 8;
    }
    return 8;
}

Header readHeader(std::string_view bytes, const std::string& file) {
    return HeaderReader(bytes, file).read();
}

}  // namespace nephrite::scene::ply
