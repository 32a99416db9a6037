// graph/page/* as one HTML text.
#pragma once

#include <string_view>

namespace nephrite::graph {

/// The page, with "{{data}}" where its JSON goes. The build makes it (cmake/page.cmake).
std::string_view pageTemplate();

}  // namespace nephrite::graph
