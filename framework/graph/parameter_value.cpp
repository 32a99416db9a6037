// A parameter's value checked against its declaration.
#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "graph/parameter_checks.h"

namespace nephrite::graph {
namespace {

/// What a value of that type is called in "expected ...".
std::string expectation(const ParameterDeclaration& declaration) {
    switch (declaration.type) {
        case ParameterType::Bool:
            return "true or false";
        case ParameterType::Int:
            return "an integer";
        case ParameterType::Uint:
            return "an integer that is not negative";
        case ParameterType::Float:
            return "a number";
        case ParameterType::Vec2:
        case ParameterType::Vec3:
        case ParameterType::Vec4:
        case ParameterType::FloatArray:
            return fmt::format("an array of {} numbers", declaration.count);
    }
    return {};
}

bool isIntegral(ParameterType type) {
    return type == ParameterType::Int || type == ParameterType::Uint;
}

}  // namespace

std::array<double, 2> limits(ParameterType type) {
    if (type == ParameterType::Int) return {-2147483648.0, 2147483647.0};
    if (type == ParameterType::Uint) return {0.0, 4294967295.0};
    const double largest = std::numeric_limits<float>::max();
    return {-largest, largest};
}

std::string_view name(ParameterType type) {
    static constexpr std::array<std::string_view, 8> names{"bool", "int",  "uint", "float",
                                                           "vec2", "vec3", "vec4", "float[N]"};
    return names[static_cast<std::size_t>(type)];
}

std::string typeName(const ParameterDeclaration& declaration) {
    if (declaration.type == ParameterType::FloatArray) return fmt::format("float[{}]", declaration.count);
    return std::string(name(declaration.type));
}

std::optional<std::string> componentFault(const ParameterValue& value,
                                          const ParameterDeclaration& declaration) {
    if (declaration.type == ParameterType::Bool) return std::nullopt;
    const auto [least, most] = limits(declaration.type);
    for (const double component : value.components) {
        if (isIntegral(declaration.type) && component != std::floor(component)) {
            return fmt::format("{} ({}) is an integer, found {}", declaration.name, typeName(declaration),
                               component);
        }
        const bool inRange = !declaration.range ||
                             (component >= (*declaration.range)[0] && component <= (*declaration.range)[1]);
        if (!inRange) {
            return fmt::format("{} is out of range, expected {} to {}, found {}", declaration.name,
                               (*declaration.range)[0], (*declaration.range)[1], component);
        }
        if (!(component >= least && component <= most)) {
            return fmt::format("{} does not fit its type {}, found {}", declaration.name,
                               typeName(declaration), component);
        }
    }
    return std::nullopt;
}

std::optional<ParameterValue> readParameterValue(const json::Value& value,
                                                 const ParameterDeclaration& declaration,
                                                 Diagnostics& diagnostics) {
    const bool isArray = declaration.count > 1 || declaration.type == ParameterType::FloatArray;
    const bool fits = declaration.type == ParameterType::Bool ? value.isBool()
                      : isArray ? value.isArray() && value.size() == declaration.count
                                : value.isNumber();
    if (!fits) {
        diagnostics.error(value.where(),
                          fmt::format("{} has type {}: expected {}, found {}", declaration.name,
                                      typeName(declaration), expectation(declaration), value.describe()));
        return std::nullopt;
    }
    ParameterValue result;
    if (declaration.type == ParameterType::Bool) {
        result.components = {value.raw().asBool() ? 1.0 : 0.0};
    } else if (isArray) {
        auto numbers = value.numbers(diagnostics, expectation(declaration));
        if (!numbers) return std::nullopt;
        result.components = std::move(*numbers);
    } else {
        result.components = {value.raw().asDouble()};
    }
    if (const auto fault = componentFault(result, declaration)) {
        diagnostics.error(value.where(), *fault);
        return std::nullopt;
    }
    return result;
}

}  // namespace nephrite::graph
