// GLSL written as it will stand, with @PLACES@ to fill in.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>

namespace nephrite::runtime {

/// Replaces each `@NAME@` of the text by its value. A place without a value becomes nothing.
std::string fillIn(std::string_view text,
                   std::initializer_list<std::pair<std::string_view, std::string_view>> values);

}  // namespace nephrite::runtime
