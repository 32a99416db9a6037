// From a choice to parameters of the pass `display`.
#include "view/picture_choice.h"

#include <fmt/format.h>

namespace nephrite::view {

std::vector<std::string> displaySettings(const PictureChoice& choice) {
    // What a reference is compared in is the picture's own first level and layer.
    const bool compares = choice.difference && !choice.reference.empty();
    return {fmt::format("exposure={:.17g}", choice.exposure),
            fmt::format("channel={}", choice.channel),
            fmt::format("curve={}", choice.curve),
            fmt::format("level={}", choice.level),
            fmt::format("layer={}", choice.layer),
            fmt::format("difference={}", compares)};
}

graph::Display displayOf(const PictureChoice& choice) {
    return {choice.port, choice.reference, displaySettings(choice)};
}

}  // namespace nephrite::view
