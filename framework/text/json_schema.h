// JSON Schemas (draft 4 vocabulary) made from the key tables that readers use.
#pragma once

#include <json/value.h>

#include <initializer_list>
#include <span>
#include <string>
#include <string_view>

#include "text/json.h"

namespace nephrite::json {

/// A piece of a schema written in the program; throws std::logic_error if it is not JSON.
Json::Value schemaFragment(std::string_view text);

/// The schema of an object with exactly these keys.
Json::Value objectSchema(std::span<const Key> keys, std::string_view doc);

/// Whatever the schema's definition of that name accepts.
Json::Value definition(std::string_view name);

/// A number from `least` to `most`; if `open`, the bounds themselves are not allowed.
Json::Value numberSchema(double least, double most, bool open = false);

/// The same for a whole number, which may be written 2 or 2.0.
Json::Value wholeNumberSchema(double least, double most);

/// An array of `count` values.
Json::Value arraySchema(Json::Value element, unsigned count);

/// An object whose members have names that match the regular expression, and values as `value` says.
Json::Value namedSchema(std::string_view pattern, Json::Value value);

/// What one of `choices` accepts.
Json::Value anyOf(std::initializer_list<Json::Value> choices);

/// A whole schema as text: `schema` with a title and the definitions its $refs name.
std::string schemaDocument(Json::Value schema, std::string_view title, Json::Value definitions);

}  // namespace nephrite::json
