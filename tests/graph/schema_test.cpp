// The schemas are JSON, name every key the readers accept, and no other.
#include "graph/schema.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "graph/description.h"
#include "graph/keys.h"
#include "text/faults.h"
#include "text/json.h"

namespace nephrite::graph {
namespace {

using testing::UnorderedElementsAre;
using testing::UnorderedElementsAreArray;

std::vector<std::string> keysOf(const json::Value& object) {
    std::vector<std::string> keys;
    for (const auto& [key, value] : object.members()) keys.push_back(key);
    return keys;
}

std::vector<std::string> definitionKeys(const json::Value& schema, std::string_view definition) {
    return keysOf(*schema.find("definitions")->find(definition)->find("properties"));
}

TEST(Schema, GraphNamesEveryKeyOfTheFormat) {
    const json::Value schema = json::parse(graphSchema(), "schema");
    EXPECT_EQ(schema.find("$schema")->raw().asString(), "http://json-schema.org/draft-04/schema#");
    EXPECT_EQ(schema.find("type")->raw().asString(), "object");
    EXPECT_THAT(keysOf(*schema.find("properties")),
                UnorderedElementsAre("name", "doc", "parameters", "imports", "nodes", "outputs"));
    EXPECT_THAT(definitionKeys(schema, "node"), UnorderedElementsAre("pass", "view", "forEach", "in", "set",
                                                                     "size", "format", "when", "doc"));
    EXPECT_THAT(definitionKeys(schema, "parameter"), UnorderedElementsAre("value", "range", "doc"));
}

TEST(Schema, PassNamesEveryKeyOfTheFormat) {
    const json::Value schema = json::parse(passSchema(), "schema");
    EXPECT_THAT(keysOf(*schema.find("properties")),
                UnorderedElementsAre("kind", "shader", "doc", "inputs", "outputs", "parameters", "skipWhen",
                                     "sideEffect", "raster", "forEach", "domain"));
    EXPECT_THAT(definitionKeys(schema, "input"),
                UnorderedElementsAre("doc", "optional", "neutral", "neededWhen", "format", "buffer"));
    EXPECT_THAT(definitionKeys(schema, "output"),
                UnorderedElementsAre("doc", "format", "size", "neutral", "mips", "layers", "buffer", "count",
                                     "modifies"));
    const json::Value graph = json::parse(graphSchema(), "schema");
    EXPECT_THAT(definitionKeys(graph, "import"), UnorderedElementsAre("image", "format", "doc"));
    EXPECT_THAT(definitionKeys(schema, "parameter"),
                UnorderedElementsAre("type", "default", "range", "specialize", "doc"));
    EXPECT_THAT(definitionKeys(schema, "raster"), UnorderedElementsAre("keep", "cull"));
}

/// Every "$ref" in a schema, found without recursion.
std::set<std::string> references(const json::Value& schema) {
    std::set<std::string> found;
    std::vector<json::Value> open{schema};
    while (!open.empty()) {
        const json::Value value = open.back();
        open.pop_back();
        if (const auto reference = value.find("$ref")) found.insert(reference->raw().asString());
        for (const auto& [key, member] : value.members()) open.push_back(member);
        for (std::size_t i = 0; value.isArray() && i < value.size(); ++i) open.push_back(value.at(i));
    }
    return found;
}

TEST(Schema, EveryReferenceIsDefinedAndEveryDefinitionUsed) {
    for (const std::string& text : {graphSchema(), passSchema()}) {
        const json::Value schema = json::parse(text, "schema");
        std::vector<std::string> defined;
        for (const std::string& key : keysOf(*schema.find("definitions")))
            defined.push_back("#/definitions/" + key);
        EXPECT_THAT(references(schema), UnorderedElementsAreArray(defined));
    }
}

TEST(Schema, RequiredKeysAreThoseTheReaderMisses) {
    const json::Value schema = json::parse(graphSchema(), "schema");
    const json::Value required = *schema.find("required");
    const auto faults = tests::faultsOf([] { readGraph(json::parse("{}", "g")); });
    ASSERT_EQ(faults.size(), required.size());
    for (std::size_t i = 0; i < faults.size(); ++i) {
        EXPECT_THAT(faults[i], testing::HasSubstr(required.at(i).raw().asString()));
    }
}

TEST(Schema, EveryKeyIsDocumented) {
    for (const auto keys :
         {keys::graph(), keys::graphParameter(), keys::graphImport(), keys::node(), keys::manifest(),
          keys::input(), keys::output(), keys::parameter(), keys::raster()}) {
        for (const json::Key& key : keys) {
            EXPECT_FALSE(key.doc.empty()) << key.name;
            EXPECT_TRUE(json::parse(std::string(key.schema), "schema").isObject()) << key.name;
        }
    }
}

}  // namespace
}  // namespace nephrite::graph
