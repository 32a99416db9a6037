// The scene schema against the scenes and presets that ship, with a validator for the part of draft 4 it
// uses.
#include <gtest/gtest.h>
#include <json/reader.h>

#include <memory>
#include <regex>

#include "scene/scene_schema.h"
#include "scene/scene_support.h"

namespace nephrite::scene {
namespace {

/// Checks values against a draft 4 schema; the schemas here nest only a few levels.
class Validator {
  public:
    explicit Validator(const Json::Value& root) : root_(root) {}

    bool accepts(const Json::Value& value, const Json::Value& schema) const {
        if (schema.isMember("$ref")) return accepts(value, definition(schema["$ref"].asString()));
        return typeFits(value, schema) && enumFits(value, schema) && numberFits(value, schema) &&
               arrayFits(value, schema) && objectFits(value, schema) && combinationsFit(value, schema);
    }

  private:
    const Json::Value& definition(const std::string& reference) const {
        const std::string name = reference.substr(std::string("#/definitions/").size());
        if (!root_["definitions"].isMember(name)) throw std::runtime_error("no definition " + name);
        return root_["definitions"][name];
    }
    static bool typeFits(const Json::Value& value, const Json::Value& schema) {
        if (!schema.isMember("type")) return true;
        const std::string type = schema["type"].asString();
        return (type == "object" && value.isObject()) || (type == "array" && value.isArray()) ||
               (type == "string" && value.isString()) || (type == "number" && value.isNumeric()) ||
               (type == "boolean" && value.isBool()) || (type == "null" && value.isNull());
    }
    static bool enumFits(const Json::Value& value, const Json::Value& schema) {
        if (!schema.isMember("enum")) return true;
        for (const Json::Value& word : schema["enum"])
            if (word == value) return true;
        return false;
    }
    static bool numberFits(const Json::Value& value, const Json::Value& schema) {
        if (!value.isNumeric()) return true;
        const double x = value.asDouble();
        if (schema.isMember("minimum")) {
            const double least = schema["minimum"].asDouble();
            if (x < least || (schema["exclusiveMinimum"].asBool() && x == least)) return false;
        }
        if (!schema.isMember("maximum")) return true;
        const double most = schema["maximum"].asDouble();
        return x < most || (x == most && !schema["exclusiveMaximum"].asBool());
    }
    bool arrayFits(const Json::Value& value, const Json::Value& schema) const {
        if (!value.isArray()) return true;
        if (schema.isMember("minItems") && value.size() < schema["minItems"].asUInt()) return false;
        if (schema.isMember("maxItems") && value.size() > schema["maxItems"].asUInt()) return false;
        for (const Json::Value& item : value)
            if (schema.isMember("items") && !accepts(item, schema["items"])) return false;
        return true;
    }
    bool objectFits(const Json::Value& value, const Json::Value& schema) const {
        if (!value.isObject()) return true;
        for (const Json::Value& key : schema["required"])
            if (!value.isMember(key.asString())) return false;
        for (const std::string& key : value.getMemberNames()) {
            const Json::Value& properties = schema["properties"];
            const Json::Value& rest = schema["additionalProperties"];
            if (properties.isMember(key)) {
                if (!accepts(value[key], properties[key])) return false;
            } else if ((rest.isBool() && !rest.asBool()) || (rest.isObject() && !accepts(value[key], rest))) {
                return false;
            }
        }
        return true;
    }
    bool combinationsFit(const Json::Value& value, const Json::Value& schema) const {
        for (const Json::Value& part : schema["allOf"])
            if (!accepts(value, part)) return false;
        if (!schema.isMember("anyOf")) return true;
        for (const Json::Value& part : schema["anyOf"])
            if (accepts(value, part)) return true;
        return false;
    }

    const Json::Value& root_;
};

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

TEST(SceneSchema, AcceptsTheShippedScenesAndPresets) {
    const Json::Value schema = schemaValue();
    const Validator validator(schema);
    for (const auto& entry : std::filesystem::directory_iterator(test::dataFolder / "scenes"))
        EXPECT_TRUE(validator.accepts(json::parseFile(entry.path()).raw(), schema)) << entry.path();
    for (const auto& entry : std::filesystem::directory_iterator(test::presetFolder))
        EXPECT_TRUE(validator.accepts(json::parseFile(entry.path()).raw(), schema["definitions"]["material"]))
            << entry.path();
}

TEST(SceneSchema, RefusesWhatTheReaderRefuses) {
    const Json::Value schema = schemaValue();
    const Validator validator(schema);
    const std::string camera = test::anyCamera;
    for (const std::string& text :
         {std::string("{}"), "{" + camera + ", \"light\": []}",
          std::string(R"({"camera": {"position": [0, 0]}})"),
          std::string(R"({"camera": {"position": [0, 0, 9], "fovY": 180}})"),
          "{" + camera + R"(, "materials": {"m": {"g": 2}}})",
          "{" + camera +
              R"(, "materials": {"m": {"layers": [{"absorption": [0, -1, 0], "scattering": [1, 1, 1]}]}}})",
          "{" + camera + R"(, "objects": [{"mesh": {"model": 7}, "material": "apple"}]})",
          "{" + camera + R"(, "objects": [{"mesh": {"procedural": "spheer"}, "material": "apple"}]})",
          "{" + camera +
              R"(, "objects": [{"mesh": "a.ply", "material": "apple", "transform": {"scale": 0}}]})",
          "{" + camera +
              R"(, "objects": [{"mesh": "a.ply", "material": "apple", "animation": {"type": "path"}}]})"}) {
        EXPECT_FALSE(validator.accepts(json::parse(text, "scene.json").raw(), schema)) << text;
        Diagnostics diagnostics;
        test::readText(text, diagnostics);
        const bool isMeshFault = text.find("spheer") != std::string::npos;  // reported when meshes are made
        EXPECT_NE(diagnostics.hasErrors(), isMeshFault) << text;
    }
}

}  // namespace
}  // namespace nephrite::scene
