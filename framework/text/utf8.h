// UTF-8: is it well formed?
#pragma once

#include <cstddef>
#include <string_view>

namespace nephrite {

/// How many bytes from the start are well-formed UTF-8 (Unicode 15, table 3-7): all of them if the text is.
std::size_t validUtf8Length(std::string_view text);

}  // namespace nephrite
