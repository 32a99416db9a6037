// Range checks and readers of numbers, vectors, booleans and words.
#include "scene/value_rules.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace nephrite::scene {

bool obeys(const NumberRule& rule, double number, const json::Value& where, Diagnostics& diagnostics) {
    const bool inside =
        rule.open ? number > rule.least && number < rule.most : number >= rule.least && number <= rule.most;
    if (!inside)
        diagnostics.error(where.where(), fmt::format("expected {}, found {}", rule.expected, number));
    return inside;
}

void readNumber(const json::Value& value, const NumberRule& rule, double& target, Diagnostics& diagnostics) {
    const auto number = value.number(diagnostics, "a number");
    if (number && obeys(rule, *number, value, diagnostics)) target = *number;
}

void readVector(const json::Value& value, const NumberRule& rule, glm::dvec3& target,
                Diagnostics& diagnostics, glm::length_t count) {
    const auto size = static_cast<std::size_t>(count);
    const auto numbers = value.numbers(diagnostics, fmt::format("an array of {} numbers", count), size);
    if (!numbers) return;
    for (std::size_t i = 0; i < size; ++i)
        if (!obeys(rule, (*numbers)[i], value.at(i), diagnostics)) return;
    for (glm::length_t i = 0; i < count; ++i) target[i] = (*numbers)[static_cast<std::size_t>(i)];
}

void readNumber(json::ObjectReader& object, std::string_view key, const NumberRule& rule, double& target) {
    if (const auto value = object.optional(key)) readNumber(*value, rule, target, object.diagnostics());
}

void readVector(json::ObjectReader& object, std::string_view key, const NumberRule& rule,
                glm::dvec3& target) {
    if (const auto value = object.optional(key)) readVector(*value, rule, target, object.diagnostics());
}

void readBool(json::ObjectReader& object, std::string_view key, bool& target) {
    const auto value = object.optional(key);
    if (!value) return;
    if (const auto flag = value->boolean(object.diagnostics(), "true or false")) target = *flag;
}

std::optional<std::size_t> readWord(const json::Value& value, std::string_view what,
                                    std::span<const std::string_view> known, Diagnostics& diagnostics) {
    const auto word = value.string(diagnostics, what);
    if (!word) return std::nullopt;
    const auto found = std::find(known.begin(), known.end(), *word);
    if (found != known.end()) return static_cast<std::size_t>(found - known.begin());
    diagnostics.error(value.where(),
                      fmt::format("expected {} (\"{}\"), found \"{}\"{}", what, fmt::join(known, "\", \""),
                                  *word, suggestion(*word, known)));
    return std::nullopt;
}

}  // namespace nephrite::scene
