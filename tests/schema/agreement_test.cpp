// Reader and schema agree on faulty files: what the schema refuses is a fault for the reader, and what the
// reader refuses the schema refuses, too, but for what draft 4 cannot say.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <regex>

#include "graph/description.h"
#include "graph/linked_graph.h"
#include "graph/schema.h"
#include "scene/procedural_reader.h"
#include "scene/scene.h"
#include "scene/scene_description.h"
#include "scene/scene_schema.h"
#include "scene/scene_support.h"
#include "schema/mutations.h"
#include "schema/validator.h"
#include "sweep/sweep.h"
#include "text/faults.h"
#include "text/json_write.h"

namespace nephrite::tests {
namespace {

/// What a reader says of a file: what is wrong with the file itself, and what is wrong once the names in it
/// are looked up.
struct Reading {
    std::vector<std::string> faults;
    std::vector<std::string> faultsOfNames;
};
using Reader = Reading (*)(const json::Value&);

const std::filesystem::path examples = std::filesystem::path(NEPHRITE_SOURCE_DIR) / "tests/schema/examples";

/// The passes that the example graphs use; their shaders do not exist.
graph::PassLibrary exampleLibrary() {
    graph::PassLibrary library;
    for (const auto& file : std::filesystem::directory_iterator(examples / "graphs/passes")) {
        Diagnostics diagnostics;
        library.add(graph::readPassType(json::parseFile(file.path()), file.path().stem(), diagnostics));
        diagnostics.throwIfErrors();
    }
    return library;
}

Reading readGraphFile(const json::Value& value) {
    static const graph::PassLibrary library = exampleLibrary();
    Reading reading;
    reading.faults = faultsOf([&] { graph::readGraph(value); });
    if (reading.faults.empty())
        reading.faultsOfNames = faultsOf([&] { link(graph::readGraph(value), library); });
    return reading;
}

Reading readPassFile(const json::Value& value) {
    Diagnostics diagnostics;
    graph::readPassType(value, "p", diagnostics);
    return {scene::test::errorLines(diagnostics), {}};
}

/// Shapes are read when they are made, which takes a while: once for each that is asked for.
const std::vector<std::string>& faultsOfShape(const json::Value& shape) {
    static std::map<std::string, std::vector<std::string>, std::less<>> known;
    const auto found = known.find(shape.sourceText());
    if (found != known.end()) return found->second;
    Diagnostics diagnostics;
    scene::readProcedural(shape, diagnostics);
    return known.emplace(shape.sourceText(), scene::test::errorLines(diagnostics)).first->second;
}

Reading readSceneFile(const json::Value& value) {
    Diagnostics diagnostics;
    const scene::SceneDescription scene =
        scene::readScene(value, {scene::test::presetFolder, 0, "models"}, diagnostics);
    Reading reading{scene::test::errorLines(diagnostics), {}};
    for (const scene::ObjectDescription& object : scene.objects) {
        if (!object.mesh.procedural) continue;
        const std::vector<std::string>& faults = faultsOfShape(*object.mesh.procedural);
        reading.faults.insert(reading.faults.end(), faults.begin(), faults.end());
    }
    return reading;
}

Reading readSweepFile(const json::Value& value) {
    return {faultsOf([&] { sweep::readSweep(value); }), {}};
}

/// True if each of the faults is one that a draft 4 schema cannot name.
bool areBeyondSchemas(const std::vector<std::string>& faults, const std::regex& beyond) {
    return std::all_of(faults.begin(), faults.end(),
                       [&](const std::string& fault) { return std::regex_search(fault, beyond); });
}

/// A format: how its files are read, what its schema is, and the faults that the schema cannot name.
struct Format {
    std::string name;
    std::string schema;
    Reader read;
    std::string folder;  ///< of good files that together use every key
    std::string beyond;  ///< a regular expression
};

void PrintTo(const Format& format, std::ostream* stream) {
    *stream << format.name;
}

const std::string expressions = "expected a number or one of params|unknown (input|parameter)";

Format graphFormat() {
    return {"graph", graph::graphSchema(), readGraphFile, "graphs",
            expressions + "|least value comes first|out of range"};
}
Format passFormat() {
    return {"pass", graph::passSchema(), readPassFile, "passes",
            expressions +
                "|least value comes first|out of range|has 1 mip|has type float.3.: expected an array of 3"};
}
Format sceneFormat() {
    return {"scene", scene::sceneSchema(), readSceneFile, "scenes",
            "no (material or )?preset is called|must be less than its far|same place|is zero|not zero|needs "
            "a direction|parallel"};
}
Format sweepFormat() {
    return {"sweep", sweep::sweepSchema(), readSweepFile, "sweeps", "is there already|could be the half of"};
}

class Schemas : public testing::TestWithParam<Format> {
  protected:
    static std::vector<json::Value> goodFiles() {
        std::vector<json::Value> files;
        for (const auto& entry : std::filesystem::directory_iterator(examples / GetParam().folder))
            if (entry.is_regular_file()) files.push_back(json::parseFile(entry.path()));
        return files;
    }
};

TEST_P(Schemas, AcceptTheExamples) {
    std::vector<Json::Value> files;
    for (const json::Value& value : goodFiles()) {
        const Reading reading = GetParam().read(value);
        EXPECT_THAT(reading.faults, testing::IsEmpty());
        EXPECT_THAT(reading.faultsOfNames, testing::IsEmpty());
        files.push_back(value.raw());
    }
    for (const Verdict& verdict : validate(GetParam().schema, files))
        EXPECT_TRUE(verdict.accepted) << verdict.words;
}

TEST_P(Schemas, AgreeWithTheReaderOnFaultyFiles) {
    const std::regex beyond(GetParam().beyond);
    std::size_t refusedByBoth = 0, acceptedByBoth = 0, beyondTheSchema = 0;
    for (const json::Value& example : goodFiles()) {
        const std::vector<Mutation> mutations = mutationsOf(example.raw());
        std::vector<Json::Value> files;
        for (const Mutation& mutation : mutations) files.push_back(mutation.value);
        const std::vector<Verdict> verdicts = validate(GetParam().schema, files);
        for (std::size_t i = 0; i < files.size(); ++i) {
            const Reading reading = GetParam().read(json::parse(json::toText(files[i]), "example.json"));
            const bool refused = !reading.faults.empty() || !reading.faultsOfNames.empty();
            SCOPED_TRACE(mutations[i].what);
            if (!verdicts[i].accepted) {
                EXPECT_TRUE(refused) << "the schema alone has a fault: " << verdicts[i].words;
                ++refusedByBoth;
            } else if (!reading.faults.empty()) {
                EXPECT_TRUE(areBeyondSchemas(reading.faults, beyond))
                    << "the reader alone has a fault: " << reading.faults.front();
                ++beyondTheSchema;
            } else {
                ++acceptedByBoth;
            }
        }
    }
    std::printf("%zu files refused by both, %zu accepted by both, %zu with faults a schema cannot name\n",
                refusedByBoth, acceptedByBoth, beyondTheSchema);
    EXPECT_GE(refusedByBoth, 200u);
}

INSTANTIATE_TEST_SUITE_P(Of, Schemas,
                         testing::Values(graphFormat(), passFormat(), sceneFormat(), sweepFormat()),
                         [](const auto& format) { return format.param.name; });

}  // namespace
}  // namespace nephrite::tests
