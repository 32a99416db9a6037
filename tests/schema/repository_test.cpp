// Every graph, manifest, scene and material that ships is as its published schema says.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "graph/schema.h"
#include "scene/scene_schema.h"
#include "schema/validator.h"
#include "sweep/sweep.h"
#include "text/json.h"

namespace nephrite::tests {
namespace {

const std::filesystem::path source = NEPHRITE_SOURCE_DIR;

std::vector<std::filesystem::path> jsonFilesIn(const std::string& folder) {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(source / folder))
        if (entry.path().extension() == ".json") files.push_back(entry.path());
    return files;
}

void expectValid(const std::string& schema, const std::vector<std::string>& folders) {
    std::vector<std::filesystem::path> files;
    for (const std::string& folder : folders)
        for (const auto& file : jsonFilesIn(folder)) files.push_back(file);
    std::vector<Json::Value> values;
    for (const auto& file : files) values.push_back(json::parseFile(file).raw());
    const std::vector<Verdict> verdicts = validate(schema, values);
    ASSERT_FALSE(verdicts.empty());
    for (std::size_t i = 0; i < files.size(); ++i)
        EXPECT_TRUE(verdicts[i].accepted) << files[i] << " " << verdicts[i].words;
}

TEST(PublishedSchemas, AcceptEveryGraph) {
    expectValid(graph::graphSchema(), {"graphs"});
}

TEST(PublishedSchemas, AcceptEveryManifest) {
    expectValid(graph::passSchema(), {"passes", "passes/templates"});
}

TEST(PublishedSchemas, AcceptEveryScene) {
    expectValid(scene::sceneSchema(), {"graphs/scenes", "graphs/suites/scenes"});
}

/// A preset is what the scene's schema calls a material.
TEST(PublishedSchemas, AcceptEveryMaterial) {
    Json::Value schema = json::parse(scene::sceneSchema(), "schema").raw();
    Json::Value material = schema["definitions"]["material"];
    material["definitions"] = schema["definitions"];
    material["$schema"] = schema["$schema"];
    expectValid(material.toStyledString(), {"graphs/materials"});
}

TEST(PublishedSchemas, AreDraft4) {
    for (const std::string& text :
         {graph::graphSchema(), graph::passSchema(), scene::sceneSchema(), sweep::sweepSchema()})
        EXPECT_EQ(json::parse(text, "schema").raw()["$schema"].asString(),
                  "http://json-schema.org/draft-04/schema#");
}

}  // namespace
}  // namespace nephrite::tests
