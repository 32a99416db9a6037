// The parameters of a pass manifest.
#include <fmt/format.h>

#include <array>
#include <charconv>

#include "graph/keys.h"
#include "graph/manifest_ports.h"
#include "graph/value_readers.h"

namespace nephrite::graph {
namespace {

constexpr std::uint32_t longestArray = 1024;

struct TypeAndCount {
    ParameterType type = ParameterType::Float;
    std::uint32_t count = 1;
};

/// The N of "float[N]", or 0.
std::uint32_t arrayLength(std::string_view text) {
    constexpr std::string_view start = "float[";
    if (text.substr(0, start.size()) != start || text.back() != ']') return 0;
    const std::string_view digits = text.substr(start.size(), text.size() - start.size() - 1);
    std::uint32_t length = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), length);
    return error == std::errc() && end == digits.data() + digits.size() && digits.front() != '0' ? length : 0;
}

std::optional<TypeAndCount> typeNamed(std::string_view text) {
    static constexpr std::array<ParameterType, 7> simple{
        ParameterType::Bool, ParameterType::Int,  ParameterType::Uint, ParameterType::Float,
        ParameterType::Vec2, ParameterType::Vec3, ParameterType::Vec4};
    for (const ParameterType type : simple) {
        if (name(type) != text) continue;
        const char last = text.back();
        return TypeAndCount{type, last >= '2' && last <= '4' ? static_cast<std::uint32_t>(last - '0') : 1};
    }
    const std::uint32_t length = arrayLength(text);
    if (length == 0 || length > longestArray) return std::nullopt;
    return TypeAndCount{ParameterType::FloatArray, length};
}

bool readType(json::ObjectReader& object, ParameterDeclaration& parameter) {
    const auto value = object.optional("type");
    if (!value) return false;
    const auto text = value->string(object.diagnostics(), "a parameter type such as \"float\"");
    if (!text) return false;
    const auto found = typeNamed(*text);
    if (!found) {
        static constexpr std::array<std::string_view, 7> known{"bool", "int",  "uint", "float",
                                                               "vec2", "vec3", "vec4"};
        object.diagnostics().error(
            value->where(),
            fmt::format("unknown parameter type {}, expected bool, int, uint, float, vec2, vec3, vec4 or "
                        "float[N] with N from 1 to {}{}",
                        inQuotes(*text), longestArray, suggestion(*text, known)));
        return false;
    }
    parameter.type = found->type;
    parameter.count = found->count;
    return true;
}

void readSpecialize(json::ObjectReader& object, ParameterDeclaration& parameter) {
    const auto value = object.optional("specialize");
    if (!value) return;
    parameter.specialize = value->boolean(object.diagnostics(), "true or false").value_or(false);
    if (parameter.specialize && (parameter.count > 1 || parameter.type == ParameterType::FloatArray)) {
        object.diagnostics().error(value->where(), "only a bool, int, uint or float can be specialized");
    }
}

ParameterDeclaration readParameter(const std::string& name, const json::Value& value,
                                   Diagnostics& diagnostics) {
    ParameterDeclaration parameter;
    parameter.name = name;
    parameter.where = value.whereKey();
    json::ObjectReader object(value, "a parameter", keys::parameter(), diagnostics);
    const bool typed = readType(object, parameter);
    readSpecialize(object, parameter);
    if (const auto doc = object.optional("doc"))
        parameter.doc = doc->string(diagnostics, "a string").value_or("");
    if (const auto range = object.optional("range")) {
        parameter.range = readRange(*range, diagnostics);
        if (parameter.type == ParameterType::Bool)
            diagnostics.error(range->whereKey(), "a bool has no range");
    }
    const auto defaultValue = object.optional("default");
    if (typed && defaultValue) {
        auto read = readParameterValue(*defaultValue, parameter, diagnostics);
        if (read) parameter.defaultValue = std::move(*read);
    }
    object.finish();
    return parameter;
}

}  // namespace

std::vector<ParameterDeclaration> readParameters(const json::Value& value, Diagnostics& diagnostics) {
    std::vector<ParameterDeclaration> parameters;
    if (!value.isObject()) {
        diagnostics.error(value.where(), fmt::format("expected an object of parameters by name, found {}",
                                                     value.describe()));
    }
    for (const auto& [name, member] : value.members()) {
        checkGlslName(name, member.whereKey(), "a parameter", diagnostics);
        parameters.push_back(readParameter(name, member, diagnostics));
    }
    return parameters;
}

}  // namespace nephrite::graph
