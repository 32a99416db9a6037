// Filling in of GLSL templates.
#include "runtime/interface/glsl_template.h"

namespace nephrite::runtime {

std::string fillIn(std::string_view text,
                   std::initializer_list<std::pair<std::string_view, std::string_view>> values) {
    std::string result;
    while (!text.empty()) {
        const std::size_t open = text.find('@');
        result += text.substr(0, open);
        if (open == std::string_view::npos) break;
        text.remove_prefix(open + 1);
        const std::size_t close = text.find('@');
        const std::string_view place = text.substr(0, close);
        for (const auto& [name, value] : values)
            if (name == place) result += value;
        text.remove_prefix(close == std::string_view::npos ? text.size() : close + 1);
    }
    return result;
}

}  // namespace nephrite::runtime
