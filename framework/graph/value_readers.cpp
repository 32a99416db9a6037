// See value_readers.h.
#include "graph/value_readers.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "graph/compile.h"

namespace nephrite::graph {
namespace {

constexpr std::array<std::string_view, 34> glslKeywords{
    "bool",   "int",     "uint",  "float",   "double",    "vec2",     "vec3",   "vec4", "mat2",
    "mat3",   "mat4",    "void",  "if",      "else",      "for",      "while",  "do",   "switch",
    "case",   "default", "break", "const",   "return",    "continue", "in",     "out",  "inout",
    "struct", "true",    "false", "discard", "sampler2D", "image2D",  "uniform"};

/// Of ForEach, but Nothing.
constexpr std::array<std::string_view, 2> forEachNames{"lights", "mips"};

SourceLocation insideString(const json::Value& value) {
    SourceLocation where = value.where();
    ++where.column;
    return where;
}

/// A side of a size: a fault if it can be told now that no image has it.
std::optional<Expression> readSide(const json::Value& value, Diagnostics& diagnostics) {
    return readCount(value, "a side of an image", 0, largestSide, diagnostics);
}

std::optional<SizeRule> readAbsoluteSize(const json::Value& value, Diagnostics& diagnostics) {
    if (value.size() != 2) {
        diagnostics.error(value.where(),
                          fmt::format("expected a size [width, height], found {}", value.describe()));
        return std::nullopt;
    }
    std::optional<Expression> width = readSide(value.at(0), diagnostics);
    std::optional<Expression> height = readSide(value.at(1), diagnostics);
    if (!width || !height) return std::nullopt;
    return SizeRule{SizeRule::Kind::Absolute, std::move(*width), std::move(*height), {}, value.where()};
}

std::optional<SizeRule> readScale(const json::Value& scale, const SourceLocation& where,
                                  Diagnostics& diagnostics) {
    std::optional<Expression> factor = readExpression(scale, diagnostics);
    if (!factor) return std::nullopt;
    const std::optional<double> literal = factor->literal();
    if (literal && !(*literal > 0 && *literal <= largestScale)) {
        diagnostics.error(
            scale.where(),
            fmt::format("a scale of the view is above 0 and at most {}, found {}", largestScale, *literal));
        return std::nullopt;
    }
    SizeRule rule;
    rule.width = std::move(*factor);
    rule.where = where;
    return rule;
}

void checkParameterName(const ExpressionName& name, std::span<const ParameterDeclaration> parameters,
                        Diagnostics& diagnostics) {
    const ParameterDeclaration* parameter = findNamed(parameters, name.name);
    if (parameter == nullptr) {
        diagnostics.error(name.where, fmt::format("unknown parameter {}{}", inQuotes(name.name),
                                                  suggestionAmong(name.name, parameters)));
        return;
    }
    const bool hasElements = parameter->count > 1 || parameter->type == ParameterType::FloatArray;
    if (!hasElements && name.element) {
        diagnostics.error(name.where, fmt::format("params.{} is one number and has no elements", name.name));
    } else if (hasElements && !name.element) {
        diagnostics.error(
            name.where, fmt::format("params.{0} has {1} elements, expected params.{0}[0] to params.{0}[{2}]",
                                    name.name, parameter->count, parameter->count - 1));
    } else if (hasElements && *name.element >= parameter->count) {
        diagnostics.error(name.where, fmt::format("params.{} has {} elements, the first is [0], found [{}]",
                                                  name.name, parameter->count, *name.element));
    }
}

void checkSceneFact(const ExpressionName& name, Diagnostics& diagnostics) {
    const std::vector<std::string_view> facts = SceneFacts::names();
    if (std::find(facts.begin(), facts.end(), name.name) != facts.end()) return;
    diagnostics.error(name.where,
                      fmt::format("unknown scene fact {}{}", inQuotes(name.name),
                                  suggestion(name.name, std::span<const std::string_view>(facts))));
}

void checkInputName(const ExpressionName& name, const ExpressionScope& scope, Diagnostics& diagnostics) {
    if (!scope.inputsAllowed) {
        diagnostics.error(name.where,
                          "inputs.PORT.neutral can be used in conditions only, not in sizes and counts");
    } else if (findNamed(scope.inputs, name.name) == nullptr) {
        diagnostics.error(name.where, fmt::format("unknown input {}{}", inQuotes(name.name),
                                                  suggestionAmong(name.name, scope.inputs)));
    }
}

}  // namespace

bool isIdentifier(std::string_view name, bool dashes) {
    const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; };
    const auto follows = [&](char c) { return letter(c) || (c >= '0' && c <= '9') || (dashes && c == '-'); };
    return !name.empty() && letter(name[0]) && std::all_of(name.begin(), name.end(), follows);
}

std::string_view identifierPattern(bool dashes) {
    return dashes ? "^[A-Za-z_][A-Za-z0-9_-]*$" : "^[A-Za-z_][A-Za-z0-9_]*$";
}

std::string glslNamePattern() {
    return fmt::format("^(?!gl_)(?!.*__)(?!({})$)[A-Za-z_][A-Za-z0-9_]*$", fmt::join(glslKeywords, "|"));
}

void checkGlslName(const std::string& name, const SourceLocation& where, std::string_view what,
                   Diagnostics& diagnostics) {
    const bool keyword = std::find(glslKeywords.begin(), glslKeywords.end(), name) != glslKeywords.end();
    const auto refuse = [&](std::string_view why) {
        diagnostics.error(where, fmt::format("{} cannot be called {}: {}", what, inQuotes(name), why));
    };
    if (!isIdentifier(name)) {
        refuse("expected letters, digits and _, no digit first");
    } else if (name.compare(0, 3, "gl_") == 0 || name.find("__") != std::string::npos) {
        refuse("GLSL keeps names with gl_ at the start or __ inside for itself");
    } else if (keyword) {
        refuse("it is a word of GLSL");
    }
}

std::optional<Expression> readExpression(const json::Value& value, Diagnostics& diagnostics) {
    if (value.isNumber()) return Expression::constant(value.raw().asDouble(), value.where());
    if (value.isBool()) return Expression::constant(value.raw().asBool() ? 1 : 0, value.where());
    const std::optional<std::string> text = value.string(diagnostics, "a number or an expression");
    if (!text) return std::nullopt;
    return Expression::compile(*text, insideString(value), diagnostics);
}

std::optional<Expression> readCount(const json::Value& value, std::string_view what, double least,
                                    double most, Diagnostics& diagnostics) {
    std::optional<Expression> count = readExpression(value, diagnostics);
    if (!count) return std::nullopt;
    const std::optional<double> literal = count->literal();
    if (literal && !(*literal >= least && *literal <= most && *literal == std::floor(*literal))) {
        diagnostics.error(value.where(), fmt::format("{} is an integer from {} to {}, found {}", what, least,
                                                     most, *literal));
        return std::nullopt;
    }
    return count;
}

std::optional<SizeRule> readSize(const json::Value& value, Diagnostics& diagnostics) {
    if (value.isArray()) return readAbsoluteSize(value, diagnostics);
    const std::optional<json::Value> scale = value.find("scale");
    const std::optional<json::Value> like = value.find("like");
    if (!value.isObject() || (scale.has_value() == like.has_value())) {
        diagnostics.error(
            value.where(),
            fmt::format("expected a size: [width, height], {{\"scale\": factor of the view}} "
                        "or {{\"like\": port}}, found {}",
                        value.isObject() ? value.sourceText().substr(0, 40) : value.describe()));
        return std::nullopt;
    }
    json::ObjectReader object(value, "a size", diagnostics);
    object.optional("scale");
    object.optional("like");
    object.finish();
    if (scale) return readScale(*scale, value.where(), diagnostics);
    std::optional<std::string> name = like->string(diagnostics, "a port's name");
    if (!name) return std::nullopt;
    SizeRule rule;
    rule.kind = SizeRule::Kind::Like;
    rule.like = std::move(*name);
    rule.where = like->where();
    return rule;
}

std::optional<Format> readFormat(const json::Value& value, Diagnostics& diagnostics) {
    const std::optional<std::string> name = value.string(diagnostics, "a pixel format such as \"rgba16f\"");
    if (!name) return std::nullopt;
    const std::optional<Format> format = formatNamed(*name);
    if (!format) {
        diagnostics.error(value.where(), fmt::format("unknown pixel format {}{}", inQuotes(*name),
                                                     suggestionAmong(*name, allFormats())));
    }
    return format;
}

std::optional<std::size_t> readChoice(const json::Value& value, std::span<const std::string_view> choices,
                                      Diagnostics& diagnostics) {
    std::string expected;
    for (std::size_t i = 0; i < choices.size(); ++i) {
        if (i > 0) expected += i + 1 == choices.size() ? " or " : ", ";
        expected += inQuotes(choices[i]);
    }
    const std::optional<std::string> text = value.string(diagnostics, expected);
    if (!text) return std::nullopt;
    const auto found = std::find(choices.begin(), choices.end(), *text);
    if (found != choices.end()) return static_cast<std::size_t>(found - choices.begin());
    diagnostics.error(value.where(), fmt::format("expected {}, found {}{}", expected, inQuotes(*text),
                                                 suggestion(*text, choices)));
    return std::nullopt;
}

std::string_view name(ForEach forEach) {
    return forEach == ForEach::Nothing ? std::string_view()
                                       : forEachNames[static_cast<std::size_t>(forEach) - 1];
}

std::optional<ForEach> readForEach(const json::Value& value, Diagnostics& diagnostics) {
    const auto choice = readChoice(value, forEachNames, diagnostics);
    if (!choice) return std::nullopt;
    return static_cast<ForEach>(*choice + 1);
}

std::optional<std::array<double, 2>> readRange(const json::Value& value, Diagnostics& diagnostics) {
    const auto ends = value.numbers(diagnostics, "a range [least, greatest]", 2);
    if (!ends) return std::nullopt;
    if ((*ends)[0] > (*ends)[1]) {
        diagnostics.error(value.where(), fmt::format("a range's least value comes first, found [{}, {}]",
                                                     (*ends)[0], (*ends)[1]));
        return std::nullopt;
    }
    return std::array<double, 2>{(*ends)[0], (*ends)[1]};
}

void checkNames(const Expression& expression, const ExpressionScope& scope, Diagnostics& diagnostics) {
    for (const ExpressionName& name : expression.names()) {
        switch (name.space) {
            case ExpressionName::Space::Parameter:
                checkParameterName(name, scope.parameters, diagnostics);
                break;
            case ExpressionName::Space::SceneFact:
                checkSceneFact(name, diagnostics);
                break;
            case ExpressionName::Space::InputNeutral:
                checkInputName(name, scope, diagnostics);
                break;
            case ExpressionName::Space::GraphParameter:
                if (scope.checkGraphParameter) {
                    scope.checkGraphParameter(name);
                } else {
                    diagnostics.error(name.where,
                                      fmt::format("a manifest knows no graph, found graph.{0}, did you mean "
                                                  "params.{0}?",
                                                  name.name));
                }
                break;
        }
    }
}

void checkNames(const SizeRule& size, const ExpressionScope& scope, Diagnostics& diagnostics) {
    checkNames(size.width, scope, diagnostics);
    checkNames(size.height, scope, diagnostics);
}

}  // namespace nephrite::graph
