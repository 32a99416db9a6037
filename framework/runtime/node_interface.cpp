// Generates the GLSL interface of a node; node_interface.h says what it is for.
#include "runtime/node_interface.h"

#include <fmt/format.h>

#include <algorithm>
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

// One group a tile; the list names them by their first texel.
constexpr std::string_view tileOrigin = R"(
    uint word = tileList.words[@FIRST@u + dispatch.layer * @TILES@u + gl_WorkGroupID.x];
    uvec2 p = uvec2(word & 0xffffu, word >> 16) + gl_LocalInvocationID.xy;
    if (p.x < dispatch.width && p.y < dispatch.height) )";

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
    Builder(const Plan& plan, const PlannedPass& pass, const graph::ParameterValues& values,
            const Filterable& filterable)
        : plan_(plan), pass_(pass), type_(plan.typeOf(pass)), values_(values), filterable_(filterable) {}

    NodeInterface build() {
        addDispatch();
        addParameters();
        // An input that is modified reads what its output writes, so outputs are declared first.
        for (graph::Index port = 0; port < pass_.outputs.count; ++port) addOutput(port);
        for (graph::Index port = 0; port < pass_.inputs.count; ++port) addInput(port);
        if (pass_.tileList != graph::noIndex) addTileList();
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
    bool isOverLights() const { return pass_.forEach == graph::ForEach::Lights; }
    bool isRaster() const { return type_.kind == graph::PassKind::Raster; }
    const InputRead& read(graph::Index port) const { return plan_.inputs[pass_.inputs.first + port]; }
    graph::Index output(graph::Index port) const { return plan_.outputs[pass_.outputs.first + port]; }

    void line(std::string text) { text_.append(std::move(text)).append("\n"); }

    void addDispatch() {
        line(
            "layout(push_constant) uniform Dispatch { uint iteration; uint width; uint height; uint "
            "layer; } dispatch;");
        line("uint iteration = dispatch.iteration;");
        line(isOverLights() ? "uint iterationLight = lightViews[dispatch.iteration].light;"
                            : "const uint iterationLight = 0u;");
    }

    void addParameters() {
        if (type_.parameters.empty()) return;
        std::string members;
        std::string constructor;
        for (graph::Index i = 0; i < type_.parameters.size(); ++i) {
            const graph::ParameterDeclaration& declaration = type_.parameters[i];
            const std::string glsl = glslType(declaration);
            members += fmt::format("{} {}; ", glsl, declaration.name);
            const graph::ParameterValue& value = plan_.graph->valueOf(pass_.node, i, values_);
            constructor += fmt::format("{}{}({})", i == 0 ? "" : ", ", glsl, components(declaration, value));
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

    void addInput(graph::Index index) {
        const graph::InputPort& port = type_.inputs[index];
        const InputRead& read = this->read(index);
        line(fmt::format("bool connected_{}() {{ return {}; }}", port.name, read.resource != graph::noIndex));
        const graph::Index modifier = modifierOf(index);
        if (modifier != graph::noIndex && !isRaster()) return addModifiedInput(port, modifier);
        if (read.resource == graph::noIndex || read.modified) return addNeutralInput(port, index);
        const Resource& resource = plan_.resources[read.resource];
        if (resource.isBuffer) return addBuffer(port.name, port.bufferElement, read.resource, "readonly ");
        addImageInput(port.name, resource, read);
    }

    /// The output that modifies an input, or none.
    graph::Index modifierOf(graph::Index input) const {
        for (graph::Index port = 0; port < type_.outputs.size(); ++port)
            if (type_.outputs[port].modifiedInput == input) return port;
        return graph::noIndex;
    }

    void addModifiedInput(const graph::InputPort& port, graph::Index modifier) {
        const std::string& written = type_.outputs[modifier].name;
        if (plan_.resources[output(modifier)].isBuffer)
            return line(fmt::format("#define {} {}", port.name, written));
        PortImage image = imageOfOutput(modifier);
        if (pass_.forEach == graph::ForEach::Mips) image.mips = 1;
        text_ += ImagePort(port.name, image, isOverLights()).modifiedInputFunctions(written);
    }

    /// What an output's port shows: of a modified input the same part.
    PortImage imageOfOutput(graph::Index port) const {
        const InputRead part = partOfOutput(port);
        return PortImage::of(plan_.resources[output(port)], part.mip, part.layer);
    }

    InputRead partOfOutput(graph::Index port) const {
        const graph::Index modified = type_.outputs[port].modifiedInput;
        return modified != graph::noIndex && read(modified).modified ? read(modified) : InputRead{};
    }

    void addNeutralInput(const graph::InputPort& port, graph::Index index) {
        if (!port.bufferElement.empty()) return addNeutralBuffer(port);
        const bool isInteger = port.format && graph::info(*port.format).isUnsignedInteger;
        const auto v = neutralOf(plan_, pass_, index);
        const std::string value = fmt::format("{}, {}, {}, {}", floatLiteral(v[0]), floatLiteral(v[1]),
                                              floatLiteral(v[2]), floatLiteral(v[3]));
        text_ += fillIn(neutralInput, {{"NAME", port.name},
                                       {"VECTOR", isInteger ? "uvec4" : "vec4"},
                                       {"VALUE", value},
                                       {"WIDTH", block_.append(read(index).extent.width, "int")},
                                       {"HEIGHT", block_.append(read(index).extent.height, "int")}});
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

    std::uint32_t addDescriptor(PortDescriptor::Kind kind, graph::Index resource,
                                std::uint16_t mip = graph::every, std::uint16_t layer = graph::every) {
        const std::uint32_t binding = nextBinding_++;
        result_.descriptors.push_back({kind, binding, resource, mip, layer});
        return binding;
    }

    void addImageInput(const std::string& name, const Resource& resource, const InputRead& read) {
        const PortImage image = PortImage::of(resource, read.mip, read.layer);
        const ImagePort port(name, image, read.perIteration);
        const bool storage = plan_.inputReads == graph::InputReads::StorageImage &&
                             !graph::info(resource.format).isDepth && image.mips == 1;
        const std::uint16_t level = read.mip == graph::every ? 0 : read.mip;
        if (storage)
            text_ += port.readonlyImage(
                addDescriptor(PortDescriptor::Kind::StorageImage, read.resource, level, read.layer));
        text_ += port.sampler(
            addDescriptor(PortDescriptor::Kind::SampledImage, read.resource, read.mip, read.layer));
        text_ += port.inputFunctions(storage, filterable_(resource.format));
        if (plan_.graph->nodes[pass_.node].role == graph::NodeRole::TileList)
            line(fmt::format("const int domainChannel = {};", graph::info(resource.format).channels - 1));
    }

    void addOutput(graph::Index port) {
        const Resource& resource = plan_.resources[output(port)];
        const graph::OutputPort& declared = type_.outputs[port];
        if (resource.isBuffer) return addBuffer(declared.name, declared.bufferElement, output(port), "");
        const PortImage image = imageOfOutput(port);
        const ImagePort functions(declared.name, image, isOverLights());
        if (isRaster()) {
            if (!graph::info(resource.format).isDepth) text_ += functions.attachment(nextLocation_++);
            text_ += functions.attachmentFunctions();
            return;
        }
        const OutputAccess access =
            declared.modifiedInput == graph::noIndex ? OutputAccess::Write : OutputAccess::Modify;
        if (pass_.forEach == graph::ForEach::Mips)
            return addLevels(functions, output(port), image.mips, access);
        const InputRead part = partOfOutput(port);
        for (std::uint32_t mip = 0; mip < image.mips; ++mip) {
            const auto level = static_cast<std::uint16_t>(part.mip == graph::every ? mip : part.mip);
            text_ += functions.outputImage(
                addDescriptor(PortDescriptor::Kind::StorageImage, output(port), level, part.layer), mip,
                access);
        }
        text_ += functions.outputFunctions(access);
    }

    /// The level that an iteration writes, and those above it.
    void addLevels(const ImagePort& functions, graph::Index resource, std::uint32_t mips,
                   OutputAccess access) {
        text_ +=
            functions.outputImage(addDescriptor(PortDescriptor::Kind::StorageImage, resource), 0, access);
        result_.descriptors.back().level = PortDescriptor::Level::Iteration;
        for (std::uint32_t mip = 0; mip + 1 < std::max(mips, 2U); ++mip) {
            text_ += functions.levelAbove(
                addDescriptor(PortDescriptor::Kind::StorageImage, resource, static_cast<std::uint16_t>(mip)),
                mip);
            result_.descriptors.back().level = PortDescriptor::Level::Above;
        }
        text_ += functions.outputFunctions(OutputAccess::Mips);
    }

    void addTileList() {
        const std::uint32_t binding = addDescriptor(PortDescriptor::Kind::StorageBuffer, pass_.tileList);
        line(fmt::format(
            "layout(set = {}, binding = {}, std430) readonly buffer TileList {{ uint words[]; }} tileList;",
            setIndex, binding));
    }

    void addEntryPoint() {
        if (isRaster()) return addFragmentEntry();
        const bool linear = firstOutputIsBuffer() && pass_.tileList == graph::noIndex;
        line(linear ? "layout(local_size_x = 64) in;" : "layout(local_size_x = 8, local_size_y = 8) in;");
        if (pass_.tileList != graph::noIndex) {
            addTileEntry();
        } else if (type_.kind == graph::PassKind::Pixel) {
            result_.entryPoint = pixelEntry;
        } else {
            result_.entryPoint = linear ? linearEntry : gridEntry;
        }
    }

    void addTileEntry() {
        const std::uint32_t layers = tileListLayers(plan_, pass_);
        const std::uint32_t length = plan_.resources[pass_.tileList].extent.width;
        const std::string call =
            type_.kind == graph::PassKind::Pixel ? "pixel(ivec2(p))" : "compute(uvec3(p, 0u))";
        result_.entryPoint = "void main() {" +
                             fillIn(tileOrigin, {{"FIRST", std::to_string(4 * layers)},
                                                 {"TILES", std::to_string(length / layers - 4)}}) +
                             call + ";\n}\n";
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
    const graph::ParameterValues& values_;
    const Filterable& filterable_;
    ParameterBlock block_;
    std::string text_;
    std::uint32_t nextBinding_ = 1;
    std::uint32_t nextLocation_ = 0;
    NodeInterface result_;
};

}  // namespace

NodeInterface nodeInterface(const Plan& plan, const PlannedPass& pass, const graph::ParameterValues& values,
                            const Filterable& filterable) {
    return Builder(plan, pass, values, filterable).build();
}

std::uint32_t tileListLayers(const Plan& plan, const PlannedPass& pass) {
    const std::uint32_t tiles = ((pass.extent.width + graph::tileSide - 1) / graph::tileSide) *
                                ((pass.extent.height + graph::tileSide - 1) / graph::tileSide);
    return plan.resources[pass.tileList].extent.width / (4 + tiles);
}

std::uint32_t tileLayer(const Plan& plan, const PlannedPass& pass, std::uint32_t iteration) {
    const InputRead& domain = plan.inputs[pass.inputs.first + plan.typeOf(pass).domainInput];
    if (!domain.perIteration || domain.resource == graph::noIndex) return 0;
    return iteration * plan.resources[domain.resource].layersPerIteration;
}

}  // namespace nephrite::runtime
