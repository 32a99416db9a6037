// Edits of a JSON text that touch nothing but what changes: comments, order, spaces and every other value
// stay byte for byte.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "text/json.h"

namespace nephrite::json {

/// The way from the root to a value: the keys of objects, and for an element of an array its index in
/// decimals, as the tokens of a JSON pointer (RFC 6901).
using Path = std::vector<std::string>;

/// `nodes.blur.set.radius`, for messages.
std::string toText(const Path& path);

/// The value at `path`, or nothing.
std::optional<Value> findAt(const Value& root, const Path& path);

/// The document with the value at `path` set to `json`, the text of one JSON value, which is written as it is
/// given. Of an array that is set to another of the same length only the elements that differ are written. A
/// key that is missing is added as the last of its object, on a line of its own if the key before it stands
/// so; objects missing on the way are made. Comments inside a value that is replaced go with it. `root` is a
/// whole document. Throws InputError: `json` is no JSON value, or something on the way is neither an object
/// nor an array that long.
Value setAt(const Value& root, const Path& path, std::string_view json);

/// The document without the member at `path` and its comma; the same document if there is none. Comments
/// stay, but for those between its key and the end of its value. Throws InputError if `path` ends in an
/// array.
Value removeAt(const Value& root, const Path& path);

/// A string as JSON writes it, with its quotes.
std::string jsonString(std::string_view text);

/// The shortest number that reads back as `value`, which must be finite.
std::string shortestNumber(double value);
/// The shortest number that reads back as `value` when it is rounded to a float: 0.1 of 0.1f.
std::string shortestNumber(float value);

}  // namespace nephrite::json
