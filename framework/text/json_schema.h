// JSON Schemas (draft 4 vocabulary) made from the key tables that readers use.
#pragma once

#include <json/value.h>

#include <span>
#include <string>
#include <string_view>

#include "text/json.h"

namespace nephrite::json {

/// A piece of a schema written in the program; throws std::logic_error if it is not JSON.
Json::Value schemaFragment(std::string_view text);

/// The schema of an object with exactly these keys.
Json::Value objectSchema(std::span<const Key> keys, std::string_view doc);

/// A whole schema as text: `schema` with a title and the definitions its $refs name.
std::string schemaDocument(Json::Value schema, std::string_view title, Json::Value definitions);

}  // namespace nephrite::json
