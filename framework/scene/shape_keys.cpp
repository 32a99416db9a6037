// The key tables of shapes and deformations: name, JSON Schema, meaning. "$ref" names a definition of
// scene_schema.cpp.
#include "scene/shape_keys.h"

namespace nephrite::scene::keys {
namespace {

using json::Key;

constexpr std::string_view length = R"({"$ref": "#/definitions/length"})";
constexpr std::string_view direction = R"({"$ref": "#/definitions/direction"})";
constexpr std::string_view degrees = R"({"$ref": "#/definitions/degrees"})";

constexpr std::string_view nameDoc = "The kind of shape.";
constexpr std::string_view typeDoc = "The kind of deformation.";

constexpr Key sphereKeys[] = {
    {"procedural", R"({"enum": ["sphere"]})", nameDoc, true},
    {"radius", length, "Radius; default 1."},
};

constexpr Key slabKeys[] = {
    {"procedural", R"({"enum": ["slab"]})", nameDoc, true},
    {"size", R"({"$ref": "#/definitions/lengths"})", "Sides along x, y and z.", true},
};

constexpr Key teapotKeys[] = {
    {"procedural", R"({"enum": ["teapot"]})", nameDoc, true},
};

constexpr Key cubeKeys[] = {
    {"procedural", R"({"enum": ["cube"]})", nameDoc, true},
    {"size", length, "Every side; default 1."},
};

constexpr Key planeKeys[] = {
    {"procedural", R"({"enum": ["plane"]})", nameDoc, true},
    {"size", R"({"$ref": "#/definitions/twoLengths"})", "Sides along x and z; default 1."},
};

constexpr Key torusKeys[] = {
    {"procedural", R"({"enum": ["torus"]})", nameDoc, true},
    {"radius", length, "Radius of the ring; default 1."},
    {"tube", length, "Radius of its tube; default 0.25."},
};

constexpr Kind proceduralKinds[] = {
    {"sphere", sphereKeys, "A sphere about the origin."},
    {"slab", slabKeys, "A box about the origin."},
    {"teapot", teapotKeys, "Newell's teapot: 3.15 high, resting on y = 0, spout towards +x."},
    {"cube", cubeKeys, "A cube about the origin."},
    {"plane", planeKeys, "A rectangle in y = 0, facing +y."},
    {"torus", torusKeys, "A torus about the y axis."},
};

constexpr Key axisKey{"axis", direction, "World direction; default +y."};
constexpr Key degreesKey{"degrees", degrees, "Greatest angle between the two ends; default 90."};
constexpr Key periodKey{"period", R"({"$ref": "#/definitions/period"})", "Seconds; default 2."};

constexpr Key twistKeys[] = {
    {"type", R"({"enum": ["twist"]})", typeDoc, true},
    axisKey,
    degreesKey,
    periodKey,
};

constexpr Key bendKeys[] = {
    {"type", R"({"enum": ["bend"]})", typeDoc, true},
    axisKey,
    {"towards", direction, "Where the ends move to; default +x, or +y where the axis is near +x."},
    degreesKey,
    periodKey,
};

constexpr Key pulseKeys[] = {
    {"type", R"({"enum": ["pulse"]})", typeDoc, true},
    axisKey,
    {"amount", R"({"$ref": "#/definitions/amount"})", "Greatest relative change of width; default 0.1."},
    {"waves", R"({"$ref": "#/definitions/waves"})", "Wavelengths along the axis; default 1."},
    periodKey,
};

constexpr Kind deformationKinds[] = {
    {"twist", twistKeys, "Turns one end against the other, back and forth."},
    {"bend", bendKeys, "Bends the axis into an arc, back and forth."},
    {"pulse", pulseKeys, "A swelling that travels along the axis."},
};

}  // namespace

std::span<const Kind> procedural() {
    return proceduralKinds;
}

std::span<const Kind> deformation() {
    return deformationKinds;
}

std::vector<std::string_view> namesOf(std::span<const Kind> kinds) {
    std::vector<std::string_view> names;
    for (const Kind& kind : kinds) names.push_back(kind.name);
    return names;
}

}  // namespace nephrite::scene::keys
