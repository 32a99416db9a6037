// A node's parameters in GLSL: the struct `params`, filled from specialization constants and the parameter
// block.
#include <fmt/format.h>

#include <bit>

#include "runtime/interface/draft.h"

namespace nephrite::runtime {
namespace {

std::string_view scalarType(graph::ParameterType type) {
    switch (type) {
        case graph::ParameterType::Bool:
            return "bool";
        case graph::ParameterType::Int:
            return "int";
        case graph::ParameterType::Uint:
            return "uint";
        default:
            return "float";
    }
}

std::string glslType(const graph::ParameterDeclaration& declaration) {
    switch (declaration.type) {
        case graph::ParameterType::Vec2:
            return "vec2";
        case graph::ParameterType::Vec3:
            return "vec3";
        case graph::ParameterType::Vec4:
            return "vec4";
        case graph::ParameterType::FloatArray:
            return fmt::format("float[{}]", declaration.count);
        default:
            return std::string(scalarType(declaration.type));
    }
}

/// The bits of one component as a shader variable of `scalar` holds them.
std::uint32_t wordOf(double component, std::string_view scalar) {
    if (scalar == "float") return std::bit_cast<std::uint32_t>(static_cast<float>(component));
    if (scalar == "int") return std::bit_cast<std::uint32_t>(static_cast<std::int32_t>(component));
    if (scalar == "bool") return component != 0 ? 1U : 0U;
    return static_cast<std::uint32_t>(component);
}

std::string_view defaultLiteral(std::string_view scalar) {
    if (scalar == "float") return "0.0";
    if (scalar == "bool") return "false";
    return scalar == "uint" ? "0u" : "0";
}

/// Declares a specialization constant for one component; its name.
std::string specialized(InterfaceDraft& draft, const std::string& parameter, std::size_t component,
                        std::uint32_t word, std::string_view scalar) {
    const std::string constant = fmt::format("specialized_{}_{}", parameter, component);
    draft.addLine(fmt::format("layout(constant_id = {}) const {} {} = {};", draft.specialization().size(),
                              scalar, constant, defaultLiteral(scalar)));
    draft.specialization().push_back({word});
    return constant;
}

/// The GLSL arguments that build one parameter.
std::string components(InterfaceDraft& draft, const graph::ParameterDeclaration& declaration,
                       const graph::ParameterValue& value) {
    const std::string_view scalar = scalarType(declaration.type);
    std::string arguments;
    for (std::size_t i = 0; i < value.components.size(); ++i) {
        const std::uint32_t word = wordOf(value.components[i], scalar);
        if (i != 0) arguments += ", ";
        arguments += declaration.specialize ? specialized(draft, declaration.name, i, word, scalar)
                                            : draft.block().append(word, scalar);
    }
    return arguments;
}

}  // namespace

void addParameters(InterfaceDraft& draft, const graph::ParameterValues& values) {
    const std::vector<graph::ParameterDeclaration>& parameters = draft.type().parameters;
    if (parameters.empty()) return;
    std::string members;
    std::string constructor;
    for (graph::Index i = 0; i < parameters.size(); ++i) {
        const std::string glsl = glslType(parameters[i]);
        const graph::ParameterValue& value = draft.plan().graph->valueOf(draft.pass().node, i, values);
        members += fmt::format("{} {}; ", glsl, parameters[i].name);
        constructor +=
            fmt::format("{}{}({})", i == 0 ? "" : ", ", glsl, components(draft, parameters[i], value));
    }
    draft.addLine(fmt::format("struct Parameters {{ {}}};", members));
    draft.addLine(fmt::format("Parameters params = Parameters({});", constructor));
}

}  // namespace nephrite::runtime
