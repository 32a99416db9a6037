// Byte offsets in a text <-> lines and columns. Lines end with \n, \r\n or \r.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "text/json.h"

namespace nephrite::json {

/// The offset of each line's first byte; the first is 0.
std::vector<std::size_t> lineStartsOf(std::string_view text);

/// Line and column of a byte; a byte order mark takes no column.
SourceLocation locate(const Document& document, std::size_t offset);

}  // namespace nephrite::json
