// From the keys of a deformation to what it does.
#include "scene/deformation_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scene/shape_keys.h"
#include "scene/value_rules.h"

namespace nephrite::scene {
namespace {

using json::ObjectReader;
using json::Value;

std::optional<std::size_t> kindOf(const Value& value, Diagnostics& diagnostics) {
    const auto type = ObjectReader(value, "a deformation", diagnostics).required("type");
    if (!type) return std::nullopt;
    return readWord(*type, "a deformation's type", keys::namesOf(keys::deformation()), diagnostics);
}

void readDirection(const Value& value, std::string_view key, glm::dvec3& direction,
                   Diagnostics& diagnostics) {
    glm::dvec3 read = direction;
    readVector(value, directionRule, read, diagnostics);
    const double length = glm::length(read);
    if (length > 1e-12)
        direction = read / length;
    else
        diagnostics.error(value.where(),
                          fmt::format("\"{}\" needs a direction, found {}", key, value.sourceText()));
}

void readMember(std::string_view key, const Value& value, Deformation& deformation,
                Diagnostics& diagnostics) {
    if (key == "axis") readDirection(value, key, deformation.axis, diagnostics);
    if (key == "towards") readDirection(value, key, deformation.towards, diagnostics);
    if (key == "degrees") readNumber(value, degreesRule, deformation.degrees, diagnostics);
    if (key == "amount") readNumber(value, amountRule, deformation.amount, diagnostics);
    if (key == "waves") readNumber(value, wavesRule, deformation.waves, diagnostics);
    if (key == "period") readNumber(value, periodRule, deformation.period, diagnostics);
}

/// A bend's ends move across its axis.
void settleTowards(ObjectReader& object, Deformation& bend) {
    const auto towards = object.optional("towards");
    if (!towards && std::abs(glm::dot(bend.axis, bend.towards)) > 0.9) bend.towards = {0, 1, 0};
    if (glm::length(glm::cross(bend.axis, bend.towards)) < 1e-6)
        object.diagnostics().error(towards ? towards->where() : object.value().where(),
                                   "\"towards\" must not be parallel to \"axis\"");
}

}  // namespace

bool isDeformation(std::string_view type) {
    const auto kinds = keys::deformation();
    return std::any_of(kinds.begin(), kinds.end(), [&](const keys::Kind& kind) { return kind.name == type; });
}

std::optional<Deformation> readDeformation(const Value& value, Diagnostics& diagnostics) {
    const std::size_t faults = diagnostics.errors().size();
    const auto kind = kindOf(value, diagnostics);
    if (!kind) return std::nullopt;
    ObjectReader object(value, "a deformation", keys::deformation()[*kind].keys, diagnostics);
    object.finish();
    Deformation deformation;
    deformation.kind = static_cast<DeformationKind>(*kind);
    for (const json::Key& key : keys::deformation()[*kind].keys)
        if (const auto member = object.optional(key.name))
            readMember(key.name, *member, deformation, diagnostics);
    if (deformation.kind == DeformationKind::bend) settleTowards(object, deformation);
    if (diagnostics.errors().size() != faults) return std::nullopt;
    return deformation;
}

}  // namespace nephrite::scene
