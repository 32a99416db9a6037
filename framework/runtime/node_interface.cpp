// Generates the GLSL interface of a node; node_interface.h says what it is for.
#include "runtime/node_interface.h"

#include <fmt/format.h>

#include <bit>

#include "runtime/glsl_template.h"
#include "runtime/image_port.h"

namespace nephrite::runtime {
namespace {

using graph::InputRead;
using graph::Plan;
using graph::PlannedPass;
using graph::Resource;

constexpr std::uint32_t setIndex = 1;

// An input without a source, or whose source is skipped.
constexpr std::string_view neutralInput = R"(
const @VECTOR@ neutral_@NAME@ = @VECTOR@(@VALUE@);
ivec2 extent_@NAME@() { return ivec2(@WIDTH@, @HEIGHT@); }
int layers_@NAME@() { return 1; }
int levels_@NAME@() { return 1; }
@VECTOR@ load_@NAME@(ivec2 p) { return neutral_@NAME@; }
@VECTOR@ load_@NAME@(ivec2 p, int level) { return neutral_@NAME@; }
@VECTOR@ loadLevel_@NAME@(ivec2 p, int level) { return neutral_@NAME@; }
@VECTOR@ loadLayer_@NAME@(ivec2 p, int layer) { return neutral_@NAME@; }
@VECTOR@ sample_@NAME@(vec2 uv) { return neutral_@NAME@; }
@VECTOR@ sampleLevel_@NAME@(vec2 uv, float level) { return neutral_@NAME@; }
@VECTOR@ sampleLayer_@NAME@(vec2 uv, int layer) { return neutral_@NAME@; }
)";

constexpr std::string_view pixelEntry = R"(
void main() {
    uvec2 p = gl_GlobalInvocationID.xy;
    if (p.x < dispatch.width && p.y < dispatch.height) pixel(ivec2(p));
}
)";

constexpr std::string_view gridEntry = R"(
void main() { compute(gl_GlobalInvocationID); }
)";

// A long buffer takes several rows of workgroups.
constexpr std::string_view linearEntry = R"(
void main() {
    uint row = gl_NumWorkGroups.x * gl_WorkGroupSize.x;
    compute(uvec3(gl_GlobalInvocationID.y * row + gl_GlobalInvocationID.x, 0u, 0u));
}
)";

constexpr std::string_view fragmentEntry = R"(
layout(location = 0) in vec3 fragmentPosition;
layout(location = 1) in vec3 fragmentNormal;
layout(location = 2) in vec2 fragmentUv;
layout(location = 3) in flat uint fragmentMaterial;
void main() {
    float squaredLength = dot(fragmentNormal, fragmentNormal);
    vec3 unit = squaredLength > 0.0 ? fragmentNormal * inversesqrt(squaredLength) : vec3(0.0, 0.0, 1.0);
    vec3 towardsViewer = gl_FrontFacing ? unit : -unit;
    fragment(Fragment(fragmentPosition, towardsViewer, fragmentUv, fragmentMaterial, ivec2(gl_FragCoord.xy), gl_FrontFacing));
}
)";

/// Words of the parameter block, handed out one by one, and the GLSL that reads each back.
class ParameterBlock {
  public:
    std::string append(std::uint32_t word, std::string_view type) {
        const std::size_t index = words_.size();
        words_.push_back(word);
        const std::string bits = fmt::format("parameterBlock.words[{}].{}", index / 4, "xyzw"[index % 4]);
        if (type == "float") return fmt::format("uintBitsToFloat({})", bits);
        if (type == "int") return fmt::format("int({})", bits);
        if (type == "bool") return fmt::format("({} != 0u)", bits);
        return bits;
    }
    std::vector<std::uint32_t> padded() const {
        std::vector<std::uint32_t> result = words_;
        result.resize((result.size() + 3) / 4 * 4);
        return result;
    }

  private:
    std::vector<std::uint32_t> words_;
};

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

std::string defaultLiteral(std::string_view scalar) {
    if (scalar == "float") return "0.0";
    if (scalar == "bool") return "false";
    return scalar == "uint" ? "0u" : "0";
}

/// Builds one NodeInterface; each function adds a part of it.
class Builder {
  public:
    Builder(const Plan& plan, const PlannedPass& pass, const Filterable& filterable)
        : plan_(plan), pass_(pass), type_(plan.typeOf(pass)), filterable_(filterable) {}

    NodeInterface build() {
        addDispatch();
        addParameters();
        const auto inputs = graph::slice(plan_.inputs, pass_.inputs);
        for (std::size_t i = 0; i < inputs.size(); ++i) addInput(type_.inputs[i], inputs[i]);
        const auto outputs = graph::slice(plan_.outputs, pass_.outputs);
        for (std::size_t i = 0; i < outputs.size(); ++i) addOutput(type_.outputs[i].name, outputs[i]);
        addEntryPoint();
        result_.parameterWords = block_.padded();
        if (!result_.parameterWords.empty()) {
            result_.descriptors.insert(result_.descriptors.begin(),
                                       {PortDescriptor::Kind::ParameterBlock, 0});
            text_.insert(0, fmt::format("layout(set = {}, binding = 0, std140) uniform ParameterBlock {{ "
                                        "uvec4 words[{}]; }} parameterBlock;\n",
                                        setIndex, result_.parameterWords.size() / 4));
        }
        result_.declarations = std::move(text_);
        return std::move(result_);
    }

  private:
    bool isForEach() const { return plan_.graph->description.nodes[pass_.node].forEachLight; }

    void line(std::string text) { text_.append(std::move(text)).append("\n"); }

    void addDispatch() {
        line(
            "layout(push_constant) uniform Dispatch { uint iteration; uint width; uint height; uint "
            "reserved; } dispatch;");
        line("uint iteration = dispatch.iteration;");
        line(isForEach() ? "uint iterationLight = lightViews[dispatch.iteration].light;"
                         : "const uint iterationLight = 0u;");
    }

    void addParameters() {
        if (type_.parameters.empty()) return;
        const auto values = graph::slice(plan_.parameters, pass_.parameters);
        std::string members;
        std::string constructor;
        for (std::size_t i = 0; i < values.size(); ++i) {
            const graph::ParameterDeclaration& declaration = type_.parameters[i];
            const std::string glsl = glslType(declaration);
            members += fmt::format("{} {}; ", glsl, declaration.name);
            constructor +=
                fmt::format("{}{}({})", i == 0 ? "" : ", ", glsl, components(declaration, values[i]));
        }
        line(fmt::format("struct Parameters {{ {}}};", members));
        line(fmt::format("Parameters params = Parameters({});", constructor));
    }

    /// The GLSL arguments that build one parameter.
    std::string components(const graph::ParameterDeclaration& declaration,
                           const graph::ParameterValue& value) {
        const std::string_view scalar = scalarType(declaration.type);
        std::string arguments;
        for (std::size_t i = 0; i < value.components.size(); ++i) {
            const std::uint32_t word = wordOf(value.components[i], scalar);
            if (i != 0) arguments += ", ";
            arguments += declaration.specialize ? specialized(declaration.name, i, word, scalar)
                                                : block_.append(word, scalar);
        }
        return arguments;
    }

    std::string specialized(const std::string& parameter, std::size_t component, std::uint32_t word,
                            std::string_view scalar) {
        const std::string constant = fmt::format("specialized_{}_{}", parameter, component);
        line(fmt::format("layout(constant_id = {}) const {} {} = {};", result_.specialization.size(), scalar,
                         constant, defaultLiteral(scalar)));
        result_.specialization.push_back({word});
        return constant;
    }

    void addInput(const graph::InputPort& port, const InputRead& read) {
        line(fmt::format("bool connected_{}() {{ return {}; }}", port.name, read.resource != graph::noIndex));
        if (read.resource == graph::noIndex) return addNeutralInput(port, read);
        const Resource& resource = plan_.resources[read.resource];
        if (resource.isBuffer) return addBuffer(port.name, port.bufferElement, read.resource, "readonly ");
        addImageInput(port.name, resource, read);
    }

    void addNeutralInput(const graph::InputPort& port, const InputRead& read) {
        const std::string& n = port.name;
        if (!port.bufferElement.empty()) return addNeutralBuffer(port);
        const bool isInteger = port.format && graph::info(*port.format).isUnsignedInteger;
        const auto& v = read.neutral;
        const std::string value = fmt::format("{}, {}, {}, {}", floatLiteral(v[0]), floatLiteral(v[1]),
                                              floatLiteral(v[2]), floatLiteral(v[3]));
        text_ += fillIn(neutralInput, {{"NAME", n},
                                       {"VECTOR", isInteger ? "uvec4" : "vec4"},
                                       {"VALUE", value},
                                       {"WIDTH", block_.append(read.extent.width, "int")},
                                       {"HEIGHT", block_.append(read.extent.height, "int")}});
    }

    void addNeutralBuffer(const graph::InputPort& port) {
        line(fmt::format("{0} {1}[1] = {0}[1]({0}(0));", port.bufferElement, port.name));
    }

    static std::string floatLiteral(double value) { return fmt::format("{:.9e}", static_cast<float>(value)); }

    void addBuffer(const std::string& name, const std::string& element, graph::Index resource,
                   std::string_view access) {
        const std::uint32_t binding = addDescriptor(PortDescriptor::Kind::StorageBuffer, resource);
        line(fmt::format("layout(set = {}, binding = {}, std430) {}buffer Buffer_{} {{ {} {}[]; }};",
                         setIndex, binding, access, name, element, name));
    }

    std::uint32_t addDescriptor(PortDescriptor::Kind kind, graph::Index resource, std::uint32_t mip = 0) {
        const std::uint32_t binding = nextBinding_++;
        result_.descriptors.push_back({kind, binding, resource, mip});
        return binding;
    }

    void addImageInput(const std::string& name, const Resource& resource, const InputRead& read) {
        const ImagePort port(name, resource, read.perIteration);
        const bool storage = plan_.inputReads == graph::InputReads::StorageImage &&
                             !graph::info(resource.format).isDepth && resource.mips == 1;
        if (storage)
            text_ += port.readonlyImage(addDescriptor(PortDescriptor::Kind::StorageImage, read.resource));
        text_ += port.sampler(addDescriptor(PortDescriptor::Kind::SampledImage, read.resource));
        text_ += port.inputFunctions(storage, filterable_(resource.format));
    }

    void addOutput(const std::string& name, graph::Index index) {
        const Resource& resource = plan_.resources[index];
        if (resource.isBuffer) return addBuffer(name, type_.outputs[resource.port].bufferElement, index, "");
        const ImagePort port(name, resource, isForEach());
        if (type_.kind == graph::PassKind::Raster) {
            if (!graph::info(resource.format).isDepth) text_ += port.attachment(nextLocation_++);
            text_ += port.attachmentFunctions();
            return;
        }
        for (std::uint32_t mip = 0; mip < resource.mips; ++mip)
            text_ += port.writeonlyImage(addDescriptor(PortDescriptor::Kind::StorageImage, index, mip), mip);
        text_ += port.outputFunctions();
    }

    void addEntryPoint() {
        switch (type_.kind) {
            case graph::PassKind::Pixel:
                line("layout(local_size_x = 8, local_size_y = 8) in;");
                result_.entryPoint = pixelEntry;
                break;
            case graph::PassKind::Raster:
                addFragmentEntry();
                break;
            default:
                line(firstOutputIsBuffer() ? "layout(local_size_x = 64) in;"
                                           : "layout(local_size_x = 8, local_size_y = 8) in;");
                result_.entryPoint = firstOutputIsBuffer() ? linearEntry : gridEntry;
                break;
        }
    }

    bool firstOutputIsBuffer() const {
        const auto outputs = graph::slice(plan_.outputs, pass_.outputs);
        return !outputs.empty() && plan_.resources[outputs.front()].isBuffer;
    }

    void addFragmentEntry() {
        line(
            "struct Fragment { vec3 position; vec3 normal; vec2 uv; uint material; ivec2 pixel; bool front; "
            "};");
        result_.entryPoint = fragmentEntry;
    }

    const Plan& plan_;
    const PlannedPass& pass_;
    const graph::PassType& type_;
    const Filterable& filterable_;
    ParameterBlock block_;
    std::string text_;
    std::uint32_t nextBinding_ = 1;
    std::uint32_t nextLocation_ = 0;
    NodeInterface result_;
};

}  // namespace

NodeInterface nodeInterface(const Plan& plan, const PlannedPass& pass, const Filterable& filterable) {
    return Builder(plan, pass, filterable).build();
}

}  // namespace nephrite::runtime
