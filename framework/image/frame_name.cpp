// Finds the frame number in an output's name and fills it in.
#include "image/frame_name.h"

#include <fmt/format.h>

#include <optional>
#include <string_view>
#include <utility>

#include "text/diagnostics.h"

namespace nephrite::image {
namespace {

struct Field {
    std::size_t begin = 0;
    std::size_t end = 0;
    int digits = 0;
};

/// The `%d` or `%0Nd` that starts at `begin`, if one does.
std::optional<Field> fieldAt(std::string_view name, std::size_t begin) {
    const std::string_view rest = name.substr(begin);
    if (rest.starts_with("%d")) return Field{begin, begin + 2, 1};
    if (rest.size() < 4 || !rest.starts_with("%0") || rest[3] != 'd') return std::nullopt;
    if (rest[2] < '1' || rest[2] > '9') return std::nullopt;
    return Field{begin, begin + 4, rest[2] - '0'};
}

std::optional<Field> findField(std::string_view name, std::size_t from) {
    for (std::size_t i = name.find('%', from); i != std::string_view::npos; i = name.find('%', i + 1)) {
        if (const std::optional<Field> field = fieldAt(name, i)) return field;
    }
    return std::nullopt;
}

}  // namespace

FrameName::FrameName(std::string pattern) {
    const std::optional<Field> field = findField(pattern, 0);
    if (!field) {
        before_ = std::move(pattern);
        return;
    }
    if (findField(pattern, field->end)) {
        throw InputError({pattern}, "an output's name may hold one frame number such as %04d, found two");
    }
    before_ = pattern.substr(0, field->begin);
    after_ = pattern.substr(field->end);
    digits_ = field->digits;
    isNumbered_ = true;
}

std::filesystem::path FrameName::of(std::uint32_t frame) const {
    if (!isNumbered_) return before_;
    return fmt::format("{}{:0{}}{}", before_, frame, digits_, after_);
}

}  // namespace nephrite::image
