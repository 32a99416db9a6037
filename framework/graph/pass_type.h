// What a pass manifest (passes/NAME.json) says: a pass type's ports, parameters and skip conditions.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "graph/expression.h"
#include "graph/format.h"
#include "text/json.h"

namespace nephrite::graph {

using Index = std::uint32_t;
inline constexpr Index noIndex = ~Index{0};

enum class PassKind : std::uint8_t { Pixel, Compute, Raster, Native };
std::string_view name(PassKind kind);

/// Width and height of a port. Absolute 0 stands for the view's own width or height.
struct SizeRule {
    enum class Kind : std::uint8_t { Absolute, ScaleOfView, Like };
    Kind kind = Kind::ScaleOfView;
    Expression width = Expression::constant(1);   ///< Absolute: pixels; ScaleOfView: the factor
    Expression height = Expression::constant(1);  ///< Absolute only
    std::string like;  ///< Like: in a manifest an input's name, in a graph "node.port"
    SourceLocation where;
};

enum class ParameterType : std::uint8_t { Bool, Int, Uint, Float, Vec2, Vec3, Vec4, FloatArray };
std::string_view name(ParameterType type);

/// A parameter's value: as many components as its type has (FloatArray: any number). Bool is 0 or 1.
struct ParameterValue {
    std::vector<double> components;
    friend bool operator==(const ParameterValue&, const ParameterValue&) = default;
};

struct ParameterDeclaration {
    std::string name;
    ParameterType type = ParameterType::Float;
    std::uint32_t count = 1;  ///< components: 1, 2..4, or N of float[N]
    ParameterValue defaultValue;
    std::optional<std::array<double, 2>> range;  ///< inclusive, each component
    bool specialize = false;                     ///< becomes a specialization constant
    std::string doc;
    SourceLocation where;
};

/// Checks a JSON value against a declaration (type, count, range); adds faults to `diagnostics`.
std::optional<ParameterValue> readParameterValue(const json::Value& value,
                                                 const ParameterDeclaration& declaration,
                                                 Diagnostics& diagnostics);

struct InputPort {
    std::string name;
    std::string doc;
    bool optional = false;
    std::array<double, 4> neutral{0, 0, 0, 0};  ///< what an unconnected or skipped input reads as
    std::optional<Expression> neededWhen;
    std::optional<Format> format;  ///< what it expects; only r32u matters (read as uvec4, not as vec4)
    std::string bufferElement;     ///< GLSL element type when the port is a buffer, else empty
    SourceLocation where;
};

struct OutputPort {
    std::string name;
    std::string doc;
    Format format = Format::rgba16f;
    std::optional<SizeRule> size;
    std::array<double, 4> neutral{0, 0, 0, 0};    ///< what its readers get when the pass is skipped
    Expression mips = Expression::constant(1);    ///< levels; 0 = down to 1x1
    Expression layers = Expression::constant(1);  ///< an iteration (forEach) has this many layers of its own
    std::string bufferElement;                    ///< GLSL element type when the port is a buffer, else empty
    Expression bufferCount = Expression::constant(0);
    std::string
        modifies;  ///< an input's name: the output is that input's image or buffer, written again in place
    Index modifiedInput = noIndex;  ///< its index in PassType::inputs
    SourceLocation where;
    SourceLocation whereModifies{};  ///< of the "modifies" value
};

/// What a node is repeated over.
enum class ForEach : std::uint8_t {
    Nothing,  ///< it runs once
    Lights,   ///< once a light view; each writes array layers of its own
    Mips,     ///< once a level of its first output; iteration i writes level i of every output and may load
              ///< level i - 1
};
std::string_view name(ForEach forEach);  ///< "lights", "mips" as in a manifest; "" of Nothing

/// How a raster pass draws the scene (manifest key "raster"): which surface along a ray is kept, and which
/// side is culled.
struct RasterState {
    enum class Keep : std::uint8_t { Nearest, Farthest };
    enum class Cull : std::uint8_t { None, Back, Front };
    Keep keep = Keep::Nearest;
    Cull cull = Cull::None;
};

struct PassType {
    std::string name;  ///< the manifest's file name without .json
    PassKind kind = PassKind::Pixel;
    std::string doc;
    std::filesystem::path manifest;
    std::filesystem::path
        shader;  ///< resolved: beside the manifest, else in the shader folder; empty for native
    std::vector<InputPort> inputs;  ///< in the manifest's order
    std::vector<OutputPort> outputs;
    std::vector<ParameterDeclaration> parameters;
    std::optional<Expression> skipWhen;
    RasterState raster;
    ForEach forEach = ForEach::Nothing;  ///< unless its node says otherwise
    std::string domain;  ///< an input's name: where its last channel is 0 every output is neutral and nothing
                         ///< is computed
    Index domainInput = noIndex;  ///< its index in `inputs`
    bool sideEffect = false;      ///< keeps itself alive although nothing reads it
    SourceLocation where;
};

/// Reads one manifest. Throws InputError. `shaderFolder` is searched after the manifest's own folder.
PassType readPassType(const std::filesystem::path& manifest, const std::filesystem::path& shaderFolder);
/// The same from text already parsed (for tests and fuzzing); the shader's existence is not checked.
PassType readPassType(const json::Value& value, std::string name, Diagnostics& diagnostics);

/// The pass types of a run, by name. Later folders override earlier ones.
class PassLibrary {
  public:
    PassLibrary() = default;
    /// Lists each folder's *.json; a manifest is read when it is first asked for, so a broken one hurts only
    /// its users.
    PassLibrary(const std::vector<std::filesystem::path>& folders, std::filesystem::path shaderFolder);

    void add(PassType type);  ///< for tests and generated graphs
    /// The type of that name or nullptr; the pointer stays valid as long as the library. Throws InputError if
    /// its manifest is wrong.
    const PassType* find(std::string_view name) const;
    std::vector<std::string> names() const;  ///< sorted

  private:
    struct Entry {
        std::filesystem::path manifest;
        mutable std::unique_ptr<const PassType> type;
    };
    std::filesystem::path shaderFolder_;
    std::map<std::string, Entry, std::less<>> entries_;
};

}  // namespace nephrite::graph
