// Writes JSON values as text that people can read and programs read back exactly.
#pragma once

#include <json/value.h>

#include <string>

namespace nephrite::json {

/// Members of objects stand on lines of their own, arrays without objects in one line. Doubles have the
/// digits that name them and no more; what is not finite is null. Ends with a newline.
std::string toText(const Json::Value& value);

}  // namespace nephrite::json
