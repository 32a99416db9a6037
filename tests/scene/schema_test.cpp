// The scene schema has the properties that the format promises; tests/schema/ holds it against files.
#include <gtest/gtest.h>
#include <json/reader.h>

#include <memory>

#include "scene/scene_schema.h"

namespace nephrite::scene {
namespace {

Json::Value schemaValue() {
    const std::string text = sceneSchema();
    const std::unique_ptr<Json::CharReader> reader(Json::CharReaderBuilder().newCharReader());
    Json::Value value;
    std::string faults;
    EXPECT_TRUE(reader->parse(text.data(), text.data() + text.size(), &value, &faults)) << faults;
    return value;
}

TEST(SceneSchema, IsDraft4WithTheContractsProperties) {
    const Json::Value schema = schemaValue();
    EXPECT_EQ(schema["$schema"].asString(), "http://json-schema.org/draft-04/schema#");
    for (const char* key : {"millimetersPerUnit", "camera", "lights", "environment", "materials", "objects"})
        EXPECT_TRUE(schema["properties"].isMember(key)) << key;
}

}  // namespace
}  // namespace nephrite::scene
