// The key tables of shapes and deformations: each kind goes by its name.
#include "scene/shape_keys.h"

#include <gtest/gtest.h>

#include "scene/mesh/deformation.h"
#include "text/json_schema.h"

namespace nephrite::scene::test {
namespace {

void expectNamed(std::span<const keys::Kind> kinds, std::string_view key) {
    for (const keys::Kind& kind : kinds) {
        ASSERT_EQ(kind.keys.front().name, key);
        EXPECT_TRUE(kind.keys.front().required);
        const Json::Value names = json::schemaFragment(kind.keys.front().schema)["enum"];
        ASSERT_EQ(names.size(), 1U);
        EXPECT_EQ(names[0].asString(), kind.name);
    }
}

TEST(ShapeKeys, NameTheirKind) {
    expectNamed(keys::procedural(), "procedural");
    expectNamed(keys::deformation(), "type");
}

TEST(ShapeKeys, HaveTheOrderOfDeformationKinds) {
    const auto names = keys::namesOf(keys::deformation());
    EXPECT_EQ(names.at(static_cast<std::size_t>(DeformationKind::twist)), "twist");
    EXPECT_EQ(names.at(static_cast<std::size_t>(DeformationKind::bend)), "bend");
    EXPECT_EQ(names.at(static_cast<std::size_t>(DeformationKind::pulse)), "pulse");
}

}  // namespace
}  // namespace nephrite::scene::test
