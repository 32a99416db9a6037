// The words of a JSON text checked one by one before JsonCpp sees it: JsonCpp reads a lone "-" as 0, "01" as
// 1, raw line breaks in strings and broken UTF-8, and does not say where keys stand.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "text/json.h"

namespace nephrite::json {

/// Objects and arrays inside each other, at most.
inline constexpr int maximumDepth = 100;

/// A fault at a byte offset.
struct TextFault {
    std::size_t offset = 0;
    std::string message;
};

/// What a scan finds.
struct Scan {
    std::vector<KeyPlace> keys;
    std::optional<TextFault> fault;  ///< the first
    std::string bare;  ///< the text with spaces for comments and the byte order mark, every offset the same
};
/// Goes through strings, numbers, words and comments once.
Scan scan(std::string_view text);

/// What stands at `offset`, short, for "found ...": `"}"`, `the word "tru"`, `the end of the text`.
std::string describeTextAt(std::string_view text, std::size_t offset);

/// The bytes of the byte order mark the text starts with, or 0.
std::size_t byteOrderMarkLength(std::string_view text);

}  // namespace nephrite::json
