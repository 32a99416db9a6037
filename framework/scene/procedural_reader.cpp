// From the keys of a procedural shape to its mesh.
#include "scene/procedural_reader.h"

#include "scene/mesh/procedural.h"
#include "scene/shape_keys.h"
#include "scene/value_rules.h"

namespace nephrite::scene {
namespace {

using json::ObjectReader;

/// What shapes have; each kind its own of these.
struct Lengths {
    double radius = 1;
    double tube = 0.25;
    glm::dvec3 size{1};
};

const keys::Kind* kindOf(const json::Value& value, Diagnostics& diagnostics) {
    const auto name = ObjectReader(value, "a procedural mesh", diagnostics).required("procedural");
    if (!name) return nullptr;
    const auto index = readWord(*name, "a procedural mesh", keys::namesOf(keys::procedural()), diagnostics);
    return index ? &keys::procedural()[*index] : nullptr;
}

/// One side that all have, or the first two or all three.
void readSize(const json::Value& value, std::string_view shape, glm::dvec3& size, Diagnostics& diagnostics) {
    if (shape == "cube") {
        double side = 1;
        readNumber(value, lengthRule, side, diagnostics);
        size = glm::dvec3(side);
    } else if (shape == "plane") {
        readVector(value, lengthRule, size, diagnostics, 2);
    } else {
        readVector(value, lengthRule, size, diagnostics);
    }
}

Mesh make(std::string_view shape, const Lengths& lengths) {
    const auto radius = static_cast<float>(lengths.radius);
    const glm::vec3 size(lengths.size);
    if (shape == "sphere") return sphere(radius);
    if (shape == "torus") return torus(radius, static_cast<float>(lengths.tube));
    if (shape == "plane") return plane({size.x, size.y});
    if (shape == "teapot") return teapot();
    return slab(size);
}

}  // namespace

std::optional<Mesh> readProcedural(const json::Value& value, Diagnostics& diagnostics) {
    const std::size_t faults = diagnostics.errors().size();
    const keys::Kind* kind = kindOf(value, diagnostics);
    if (!kind) return std::nullopt;
    ObjectReader object(value, "a procedural mesh", kind->keys, diagnostics);
    object.finish();
    Lengths lengths;
    for (const json::Key& key : kind->keys) {
        const auto member = object.optional(key.name);
        if (!member) continue;
        if (key.name == "radius") readNumber(*member, lengthRule, lengths.radius, diagnostics);
        if (key.name == "tube") readNumber(*member, lengthRule, lengths.tube, diagnostics);
        if (key.name == "size") readSize(*member, kind->name, lengths.size, diagnostics);
    }
    if (diagnostics.errors().size() != faults) return std::nullopt;
    return make(kind->name, lengths);
}

}  // namespace nephrite::scene
