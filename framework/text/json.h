// JSON with the source position of every value, and readers that turn objects into structs while naming each
// fault.
//
// Comments and trailing commas are allowed; duplicate keys, unknown keys, numbers that overflow a double and
// text after the value are errors. JsonCpp does the parsing; this file adds positions and checked access.
#pragma once

#include <json/value.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "text/diagnostics.h"

namespace nephrite::json {

/// Where a member's key and its value start, as byte offsets in the text.
struct KeyPlace {
    std::size_t value = 0;
    std::size_t key = 0;
};

/// The text of one JSON file and its parsed tree; values know their byte offsets in the text.
struct Document {
    std::string file;
    std::string text;
    Json::Value root;
    std::vector<std::size_t> lineStarts;
    std::vector<KeyPlace> keys;  ///< of every member of every object, by ascending value
};

/// A value in a document. Cheap to copy; keeps its document alive.
class Value {
  public:
    Value(std::shared_ptr<const Document> document, const Json::Value* value);

    SourceLocation where() const;     ///< where the value starts
    SourceLocation whereKey() const;  ///< where its key starts if it is an object's member, else where()
    std::string describe()
        const;  ///< what was found, short, for "found ...": `the string "abc"`, `an object`
    std::string_view sourceText() const;  ///< the bytes of the value as written
    const Json::Value& raw() const { return *value_; }

    // Byte offsets in the document's text.
    const Document& document() const { return *document_; }
    std::size_t start() const;     ///< of the value's first byte
    std::size_t end() const;       ///< one past its last byte
    std::size_t keyStart() const;  ///< of its key if it is an object's member, else start()

    bool isObject() const;
    bool isArray() const;
    bool isString() const;
    bool isNumber() const;
    bool isBool() const;
    bool isNull() const;

    std::size_t size() const;                               ///< elements of an array, members of an object
    Value at(std::size_t index) const;                      ///< an array's element
    std::optional<Value> find(std::string_view key) const;  ///< an object's member
    /// An object's members in the order the file has them.
    std::vector<std::pair<std::string, Value>> members() const;

    // Checked access: on a wrong type adds `expected WHAT, found ...` to `diagnostics` and returns nothing.
    std::optional<double> number(Diagnostics& diagnostics, std::string_view what) const;
    std::optional<std::int64_t> integer(Diagnostics& diagnostics, std::string_view what) const;
    std::optional<bool> boolean(Diagnostics& diagnostics, std::string_view what) const;
    std::optional<std::string> string(Diagnostics& diagnostics, std::string_view what) const;
    /// An array of `count` numbers (any count if 0).
    std::optional<std::vector<double>> numbers(Diagnostics& diagnostics, std::string_view what,
                                               std::size_t count = 0) const;

  private:
    std::shared_ptr<const Document> document_;
    const Json::Value* value_;
};

/// Parses `text`; `file` is only the name faults carry. Throws InputError (line and column of the fault).
Value parse(std::string text, std::string file);

/// Reads and parses a file. Throws InputError (`FILE: error: ...` when it cannot be read).
Value parseFile(const std::filesystem::path& path);

/// A key that an object may have. Tables of these say what a reader accepts, and schemas are made from the
/// same tables.
struct Key {
    std::string_view name;
    std::string_view schema;  ///< JSON Schema of its value, as JSON text
    std::string_view doc;
    bool required = false;
};

/// Reads one object: asks for its keys one by one, then `finish` reports the keys nobody asked for, with a
/// suggestion.
///
///     ObjectReader object(value, "a light", diagnostics);
///     auto type = object.required("type");
///     object.finish();
class ObjectReader {
  public:
    /// Adds an error if `value` is not an object; every later call then finds nothing.
    ObjectReader(const Value& value, std::string what, Diagnostics& diagnostics);
    /// The object may have the keys of this table only; a missing one that is required is an error at once.
    ObjectReader(const Value& value, std::string what, std::span<const Key> keys, Diagnostics& diagnostics);

    std::optional<Value> optional(std::string_view key);
    /// Adds `WHAT needs "key"` if it is missing.
    std::optional<Value> required(std::string_view key);
    /// One error for each member never asked for.
    void finish();

    Diagnostics& diagnostics() { return diagnostics_; }
    const Value& value() const { return value_; }

  private:
    Value value_;
    std::string what_;
    Diagnostics& diagnostics_;
    std::vector<std::string> asked_;
};

}  // namespace nephrite::json
