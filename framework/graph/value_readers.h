// Reading what graph and manifest files have in common: expressions, sizes, formats, names.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "graph/pass_type.h"

namespace nephrite::graph {

inline constexpr double largestSide = 1e6;    ///< pixels; no device comes near it
inline constexpr double largestScale = 1000;  ///< of the view

/// [A-Za-z_][A-Za-z0-9_]*, with dashes after the first character too if `dashes`.
bool isIdentifier(std::string_view name, bool dashes = false);
/// The regular expression (ECMA 262) of such names.
std::string_view identifierPattern(bool dashes = false);
/// Adds a fault unless GLSL can use the name: an identifier without "gl_" at its start, without "__" and no
/// keyword.
void checkGlslName(const std::string& name, const SourceLocation& where, std::string_view what,
                   Diagnostics& diagnostics);
/// The regular expression of names that GLSL can use.
std::string glslNamePattern();

/// A number, a boolean or an expression string.
std::optional<Expression> readExpression(const json::Value& value, Diagnostics& diagnostics);
/// An expression that counts something: if it uses no names it must be an integer in [least, most].
std::optional<Expression> readCount(const json::Value& value, std::string_view what, double least,
                                    double most, Diagnostics& diagnostics);
/// [w, h], {"scale": s} or {"like": name}. `like` is not looked up.
std::optional<SizeRule> readSize(const json::Value& value, Diagnostics& diagnostics);
std::optional<Format> readFormat(const json::Value& value, Diagnostics& diagnostics);
/// The index of a string among `choices`.
std::optional<std::size_t> readChoice(const json::Value& value, std::span<const std::string_view> choices,
                                      Diagnostics& diagnostics);
/// "lights" or "mips".
std::optional<ForEach> readForEach(const json::Value& value, Diagnostics& diagnostics);
/// [least, greatest].
std::optional<std::array<double, 2>> readRange(const json::Value& value, Diagnostics& diagnostics);

/// `did you mean` for the `.name` of each element of a list.
template<class List>
std::string suggestionAmong(std::string_view found, const List& list) {
    std::vector<std::string_view> names;
    for (const auto& element : list) names.push_back(element.name);
    return suggestion(found, std::span<const std::string_view>(names));
}

/// The element of a list with that `.name`, or nullptr.
template<class List>
auto* findNamed(List& list, std::string_view name) {
    for (auto& element : list) {
        if (element.name == name) return &element;
    }
    return static_cast<decltype(list.data())>(nullptr);
}

/// What the names in an expression may be.
struct ExpressionScope {
    std::span<const ParameterDeclaration> parameters;
    std::span<const InputPort> inputs;
    bool inputsAllowed = false;  ///< inputs.PORT.neutral may be used
    /// Checks a graph.NAME; empty where there is no graph.
    std::function<void(const ExpressionName&)> checkGraphParameter;
};
/// One fault for each name that does not exist there.
void checkNames(const Expression& expression, const ExpressionScope& scope, Diagnostics& diagnostics);
void checkNames(const SizeRule& size, const ExpressionScope& scope, Diagnostics& diagnostics);

}  // namespace nephrite::graph
