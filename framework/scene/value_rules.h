// Checked reading of the numbers, vectors and colours of scene files: each with its range, each fault named.
#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string_view>

#include "text/json.h"

namespace nephrite::scene {

/// What a number must be. The default bounds keep values, and their products, inside a float.
struct NumberRule {
    std::string_view expected = "a number between -1e15 and 1e15";
    double least = -1e15;
    double most = 1e15;
    bool open = false;  ///< the bounds themselves are not allowed
};

inline constexpr NumberRule anyNumber{};
inline constexpr NumberRule notNegative{"a number that is not negative (and at most 1e15)", 0};
inline constexpr NumberRule positive{"a number greater than 0 (and less than 1e15)", 0, 1e15, true};
inline constexpr NumberRule unitInterval{"a number between 0 and 1", 0, 1};
inline constexpr NumberRule anisotropy{"a number between -1 and 1", -1, 1};
inline constexpr NumberRule fieldOfView{"an angle greater than 0 and less than 180 degrees", 0, 180, true};
inline constexpr NumberRule unitRule{"a length greater than 0 and at most 1e6", 1e-9, 1e6};
/// Keeps a place on a path, and what is fitted or scaled, inside the range of a float.
inline constexpr NumberRule scaleRule{"a scale greater than 0 and at most 1e6", 1e-12, 1e6};
/// Of a procedural shape.
inline constexpr NumberRule lengthRule{"a length from 1e-6 to 1e6", 1e-6, 1e6};

// Of a deformation.
inline constexpr NumberRule directionRule{"a number between -1e12 and 1e12", -1e12, 1e12, true};
inline constexpr NumberRule degreesRule{"an angle from -1e6 to 1e6 degrees", -1e6, 1e6};
/// At 1 the mesh would be flat at times, and have no normals.
inline constexpr NumberRule amountRule{"a number greater than -1 and less than 1", -1, 1, true};
inline constexpr NumberRule wavesRule{"a number from -1e6 to 1e6", -1e6, 1e6};
inline constexpr NumberRule periodRule{"a time greater than 1e-6 and less than 1e9 seconds", 1e-6, 1e9, true};

/// Adds a fault and returns false if a number read at `where` breaks the rule.
bool obeys(const NumberRule& rule, double number, const json::Value& where, Diagnostics& diagnostics);

/// Sets `target` (the first `count` of its numbers) from a value if that is a number (so many numbers) that
/// obeys the rule, else adds a fault.
void readNumber(const json::Value& value, const NumberRule& rule, double& target, Diagnostics& diagnostics);
void readVector(const json::Value& value, const NumberRule& rule, glm::dvec3& target,
                Diagnostics& diagnostics, glm::length_t count = 3);

/// The same for a member that may be missing; `target` then keeps its default.
void readNumber(json::ObjectReader& object, std::string_view key, const NumberRule& rule, double& target);
void readVector(json::ObjectReader& object, std::string_view key, const NumberRule& rule, glm::dvec3& target);
void readBool(json::ObjectReader& object, std::string_view key, bool& target);

/// The index of a string among the words known; adds a fault with a suggestion and returns nothing if it is
/// none of them.
std::optional<std::size_t> readWord(const json::Value& value, std::string_view what,
                                    std::span<const std::string_view> known, Diagnostics& diagnostics);

}  // namespace nephrite::scene
