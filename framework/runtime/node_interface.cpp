// Generates the GLSL interface of a node; node_interface.h says what it is for.
#include "runtime/node_interface.h"

#include <fmt/format.h>

#include <bit>

namespace nephrite::runtime {
namespace {

using graph::InputRead;
using graph::Plan;
using graph::PlannedPass;
using graph::Resource;

constexpr std::uint32_t setIndex = 1;

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
        const std::string width = block_.append(read.extent.width, "int");
        const std::string height = block_.append(read.extent.height, "int");
        const bool isInteger = port.format && graph::info(*port.format).isUnsignedInteger;
        const std::string_view vector = isInteger ? "uvec4" : "vec4";
        const auto& v = read.neutral;
        line(fmt::format("const {0} neutral_{1} = {0}({2}, {3}, {4}, {5});", vector, n, floatLiteral(v[0]),
                         floatLiteral(v[1]), floatLiteral(v[2]), floatLiteral(v[3])));
        line(fmt::format("ivec2 extent_{}() {{ return ivec2({}, {}); }}", n, width, height));
        line(fmt::format("int layers_{0}() {{ return 1; }} int levels_{0}() {{ return 1; }}", n));
        for (const std::string_view signature :
             {"load_{}(ivec2 p)", "load_{}(ivec2 p, int level)", "loadLevel_{}(ivec2 p, int level)",
              "loadLayer_{}(ivec2 p, int layer)", "sample_{}(vec2 uv)",
              "sampleLevel_{}(vec2 uv, float level)", "sampleLayer_{}(vec2 uv, int layer)"})
            line(fmt::format("{} {} {{ return neutral_{}; }}", vector,
                             fmt::format(fmt::runtime(signature), n), n));
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

    std::uint32_t addDescriptor(PortDescriptor::Kind kind, graph::Index resource, std::uint32_t mip = 0,
                                bool allMips = false) {
        const std::uint32_t binding = nextBinding_++;
        result_.descriptors.push_back({kind, binding, resource, mip, allMips});
        return binding;
    }

    /// Type names of an image: vec4 or uvec4, image2D or uimage2DArray, ...
    struct ImageTypes {
        std::string vector;
        std::string prefix;
        std::string array;
        std::string qualifier;
    };
    static ImageTypes imageTypes(const Resource& resource) {
        const graph::FormatInfo& format = graph::info(resource.format);
        return {format.isUnsignedInteger ? "uvec4" : "vec4", format.isUnsignedInteger ? "u" : "",
                resource.layers > 1 ? "Array" : "", std::string(format.glslQualifier)};
    }

    /// GLSL for the array layer of an iteration's `layer`, clamped to its block.
    std::string layerExpression(const Resource& resource, bool perIteration, std::string_view layer) const {
        const std::uint32_t block = perIteration ? resource.layersPerIteration : resource.layers;
        const std::string clamped = fmt::format("clamp({}, 0, {})", layer, block - 1);
        return perIteration ? fmt::format("int(dispatch.iteration) * {} + {}", block, clamped) : clamped;
    }

    void addImageInput(const std::string& n, const Resource& resource, const InputRead& read) {
        const ImageTypes t = imageTypes(resource);
        const bool storage = plan_.inputReads == graph::InputReads::StorageImage &&
                             !graph::info(resource.format).isDepth && resource.mips == 1;
        if (storage) {
            const std::uint32_t binding = addDescriptor(PortDescriptor::Kind::StorageImage, read.resource);
            line(fmt::format("layout(set = {}, binding = {}, {}) uniform readonly {}image2D{} input_{};",
                             setIndex, binding, t.qualifier, t.prefix, t.array, n));
        }
        const std::uint32_t binding =
            addDescriptor(PortDescriptor::Kind::SampledImage, read.resource, 0, true);
        line(fmt::format("layout(set = {}, binding = {}) uniform {}sampler2D{} sampler_{};", setIndex,
                         binding, t.prefix, t.array, n));
        addExtent(n, storage);
        addFetch(n, resource, t, storage);
        addLoads(n, resource, read, t);
        if (t.prefix.empty()) addSamples(n, resource, read);
    }

    void addExtent(const std::string& n, bool storage) {
        line(storage ? fmt::format("ivec2 extent_{0}() {{ return imageSize(input_{0}).xy; }} int "
                                   "levels_{0}() {{ return 1; }}",
                                   n)
                     : fmt::format("ivec2 extent_{0}() {{ return textureSize(sampler_{0}, 0).xy; }} int "
                                   "levels_{0}() {{ return textureQueryLevels(sampler_{0}); }}",
                                   n));
    }

    /// fetch_NAME(p, layer of the whole image, level): the texel, p clamped to the level.
    void addFetch(const std::string& n, const Resource& resource, const ImageTypes& t, bool storage) {
        const std::string_view coordinate = resource.layers > 1 ? "ivec3(p, layer)" : "p";
        if (storage) {
            line(
                fmt::format("{0} fetch_{1}(ivec2 p, int layer, int level) {{ p = clamp(p, ivec2(0), "
                            "extent_{1}() - 1); return imageLoad(input_{1}, {2}); }}",
                            t.vector, n, coordinate));
            return;
        }
        line(
            fmt::format("{0} fetch_{1}(ivec2 p, int layer, int level) {{ level = clamp(level, 0, "
                        "levels_{1}() - 1); p = clamp(p, ivec2(0), textureSize(sampler_{1}, level).xy - 1); "
                        "return texelFetch(sampler_{1}, {2}, level); }}",
                        t.vector, n, coordinate));
    }

    void addLoads(const std::string& n, const Resource& resource, const InputRead& read,
                  const ImageTypes& t) {
        const std::string zero = layerExpression(resource, read.perIteration, "0");
        line(fmt::format("{0} load_{1}(ivec2 p) {{ return fetch_{1}(p, {2}, 0); }}", t.vector, n, zero));
        line(fmt::format("{0} load_{1}(ivec2 p, int level) {{ return fetch_{1}(p, {2}, level); }}", t.vector,
                         n, zero));
        line(fmt::format("{0} loadLevel_{1}(ivec2 p, int level) {{ return fetch_{1}(p, {2}, level); }}",
                         t.vector, n, zero));
        line(fmt::format("{0} loadLayer_{1}(ivec2 p, int layer) {{ return fetch_{1}(p, {2}, 0); }}", t.vector,
                         n, layerExpression(resource, read.perIteration, "layer")));
        line(fmt::format("int layers_{}() {{ return {}; }}", n,
                         read.perIteration ? resource.layersPerIteration : resource.layers));
    }

    void addSamples(const std::string& n, const Resource& resource, const InputRead& read) {
        const std::string_view coordinate = resource.layers > 1 ? "vec3(uv, float(layer))" : "uv";
        if (filterable_(resource.format)) {
            line(
                fmt::format("vec4 filter_{0}(vec2 uv, int layer, float level) {{ return "
                            "textureLod(sampler_{0}, {1}, level); }}",
                            n, coordinate));
        } else {
            // Some devices cannot filter 32-bit floats; the four texels are mixed here then, on the nearest
            // level.
            line(fmt::format(
                "vec4 filter_{0}(vec2 uv, int layer, float level) {{ int l = int(level + 0.5); vec2 t = uv * "
                "vec2(textureSize(sampler_{0}, l).xy) - 0.5; "
                "ivec2 p = ivec2(floor(t)); vec2 f = t - floor(t); "
                "return mix(mix(fetch_{0}(p, layer, l), fetch_{0}(p + ivec2(1, 0), layer, l), f.x), "
                "mix(fetch_{0}(p + ivec2(0, 1), layer, l), fetch_{0}(p + ivec2(1, 1), layer, l), f.x), f.y); "
                "}}",
                n));
        }
        const std::string zero = layerExpression(resource, read.perIteration, "0");
        line(fmt::format("vec4 sample_{0}(vec2 uv) {{ return filter_{0}(uv, {1}, 0.0); }}", n, zero));
        line(fmt::format(
            "vec4 sampleLevel_{0}(vec2 uv, float level) {{ return filter_{0}(uv, {1}, level); }}", n, zero));
        line(fmt::format("vec4 sampleLayer_{0}(vec2 uv, int layer) {{ return filter_{0}(uv, {1}, 0.0); }}", n,
                         layerExpression(resource, read.perIteration, "layer")));
    }

    void addOutput(const std::string& n, graph::Index index) {
        const Resource& resource = plan_.resources[index];
        if (resource.isBuffer) return addBuffer(n, type_.outputs[resource.port].bufferElement, index, "");
        if (type_.kind == graph::PassKind::Raster) return addAttachment(n, resource);
        const ImageTypes t = imageTypes(resource);
        for (std::uint32_t mip = 0; mip < resource.mips; ++mip) {
            const std::uint32_t binding = addDescriptor(PortDescriptor::Kind::StorageImage, index, mip);
            line(fmt::format("layout(set = {}, binding = {}, {}) uniform writeonly {}image2D{} output_{}_{};",
                             setIndex, binding, t.qualifier, t.prefix, t.array, n, mip));
        }
        addStores(n, resource, t);
    }

    void addStores(const std::string& n, const Resource& resource, const ImageTypes& t) {
        const std::string_view coordinate = resource.layers > 1 ? "ivec3(p, layer)" : "p";
        std::string cases;
        for (std::uint32_t mip = 0; mip < resource.mips; ++mip)
            cases +=
                fmt::format("case {0}: imageStore(output_{1}_{0}, {2}, value); break; ", mip, n, coordinate);
        line(fmt::format("void put_{}(ivec2 p, int layer, int level, {} value) {{ switch (level) {{ {}}} }}",
                         n, t.vector, cases));
        const std::string zero = layerExpression(resource, isForEach(), "0");
        line(fmt::format("void store_{0}(ivec2 p, {1} value) {{ put_{0}(p, {2}, 0, value); }}", n, t.vector,
                         zero));
        line(fmt::format(
            "void storeLevel_{0}(ivec2 p, int level, {1} value) {{ put_{0}(p, {2}, level, value); }}", n,
            t.vector, zero));
        line(
            fmt::format("void storeLayer_{0}(ivec2 p, int layer, {1} value) {{ put_{0}(p, {2}, 0, value); }}",
                        n, t.vector, layerExpression(resource, isForEach(), "layer")));
        line(
            fmt::format("ivec2 extent_{0}() {{ return imageSize(output_{0}_0).xy; }} int levels_{0}() {{ "
                        "return {1}; }} int layers_{0}() {{ return {2}; }}",
                        n, resource.mips, isForEach() ? resource.layersPerIteration : resource.layers));
    }

    void addAttachment(const std::string& n, const Resource& resource) {
        line(fmt::format("ivec2 extent_{}() {{ return ivec2(dispatch.width, dispatch.height); }}", n));
        if (graph::info(resource.format).isDepth) return;
        const ImageTypes t = imageTypes(resource);
        line(fmt::format("layout(location = {}) out {} output_{};", nextLocation_++, t.vector, n));
        line(fmt::format("void store_{0}(ivec2 p, {1} value) {{ output_{0} = value; }}", n, t.vector));
    }

    void addEntryPoint() {
        switch (type_.kind) {
            case graph::PassKind::Pixel:
                line("layout(local_size_x = 8, local_size_y = 8) in;");
                result_.entryPoint =
                    "void main() { uvec2 p = gl_GlobalInvocationID.xy; if (p.x < dispatch.width && p.y < "
                    "dispatch.height) pixel(ivec2(p)); }\n";
                break;
            case graph::PassKind::Raster:
                addFragmentEntry();
                break;
            default:
                line(firstOutputIsBuffer() ? "layout(local_size_x = 64) in;"
                                           : "layout(local_size_x = 8, local_size_y = 8) in;");
                result_.entryPoint = "void main() { compute(gl_GlobalInvocationID); }\n";
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
        result_.entryPoint =
            "layout(location = 0) in vec3 fragmentPosition;\n"
            "layout(location = 1) in vec3 fragmentNormal;\n"
            "layout(location = 2) in vec2 fragmentUv;\n"
            "layout(location = 3) in flat uint fragmentMaterial;\n"
            "void main() {\n"
            "    float squaredLength = dot(fragmentNormal, fragmentNormal);\n"
            "    vec3 unit = squaredLength > 0.0 ? fragmentNormal * inversesqrt(squaredLength) : vec3(0.0, "
            "0.0, 1.0);\n"
            "    fragment(Fragment(fragmentPosition, gl_FrontFacing ? unit : -unit, fragmentUv, "
            "fragmentMaterial, ivec2(gl_FragCoord.xy), gl_FrontFacing));\n"
            "}\n";
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
