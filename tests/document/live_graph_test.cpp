// Edits that reach the picture of a running session, and leave it bit by bit as it was when they are undone.
#include <gmock/gmock.h>

#include <chrono>
#include <fstream>
#include <iterator>

#include "document/live_graph.h"
#include "graph/compatible_types.h"
#include "runtime/every_graph.h"
#include "runtime/loading/graph_loading.h"
#include "runtime/pass_folder.h"
#include "runtime/reload/live_reload.h"
#include "text/faults.h"

namespace nephrite::document {
namespace {

using runtime::test::valueAt;

std::string textOf(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

std::filesystem::path projectGraph(const std::string& name) {
    return std::filesystem::path(NEPHRITE_SOURCE_DIR) / "graphs" / (name + ".json");
}

std::shared_ptr<const graph::PassLibrary> passes(const std::vector<std::filesystem::path>& more = {}) {
    return runtime::loadPassTypes(runtime::DataFolders::find(), more);
}

/// The project's screen-space graph, copied and shown, small enough to be rendered often.
class LiveScreenSpace : public testing::Test {
  protected:
    LiveScreenSpace() : document_(file_, passes()), session_(options()), live_(session_, document_, {}) {
        document_.set("lightSize", "64");
        document_.set("mostTaps", "16");
    }

    runtime::SessionOptions options() const {
        runtime::SessionOptions options;
        options.graph = file_;
        options.scene = projectGraph("scenes/sphere");
        options.size = {48, 48};
        options.validation = runtime::Validation::Sync;
        return options;
    }
    std::vector<float> picture() {
        live_.show(document_, {});
        session_.renderFrame(0);
        return session_.read("color").pixels;
    }

    ScratchFolder folder_;
    std::filesystem::path file_ = folder_.write("graph.json", textOf(projectGraph("screen-space")));
    GraphDocument document_;
    runtime::Session session_;
    LiveGraph live_;
};

TEST_F(LiveScreenSpace, SwappingAndSwitchingChangeThePictureAndUndoBringsItBack) {
    const std::vector<float> before = picture();
    const std::uint64_t pipelines = session_.figures().pipelines;
    document_.swapPass("multiple", "lambert-albedo");
    const std::vector<float> swapped = picture();
    EXPECT_NE(swapped, before);
    document_.switchNode("single-scatter", false);
    const std::vector<float> dimmer = picture();
    EXPECT_NE(dimmer, swapped);
    double lost = 0;
    for (std::size_t i = 0; i < dimmer.size(); ++i) {
        EXPECT_LE(dimmer[i], swapped[i]) << "nothing is brighter without a part of the light";
        lost += swapped[i] - dimmer[i];
    }
    EXPECT_GT(lost, 0);
    document_.undo();
    EXPECT_EQ(picture(), swapped);
    document_.undo();
    EXPECT_EQ(picture(), before);
    EXPECT_EQ(session_.figures().pipelines, pipelines + 2) << "lambert-albedo, and a sum of fewer parts";
    document_.redo();
    document_.redo();
    EXPECT_EQ(picture(), dimmer);
    EXPECT_EQ(session_.figures().pipelines, pipelines + 2);
    document_.switchNode("single-scatter", true);
    EXPECT_EQ(picture(), swapped);
}

TEST_F(LiveScreenSpace, AParameterIsSetWithoutAnotherPlan) {
    const std::vector<float> before = picture();
    const std::uint64_t plans = session_.figures().plans;
    document_.set("mostTaps", "4");
    EXPECT_NE(picture(), before);
    document_.undo();
    EXPECT_EQ(picture(), before);
    EXPECT_EQ(session_.figures().plans, plans);
    EXPECT_FALSE(live_.show(document_, {}));
}

TEST_F(LiveScreenSpace, PortsAreShownAndTheEditsStay) {
    const std::vector<float> before = picture();
    document_.swapPass("multiple", "lambert-albedo");
    const std::vector<float> swapped = picture();
    live_.show(document_, Extras{.dumps = {"multiple.radiance"}, .display = {}});
    session_.renderFrame(0);
    EXPECT_EQ(session_.read("color").pixels, swapped);
    EXPECT_EQ(session_.read("multiple.radiance").width, 48U);
    EXPECT_THROW(live_.show(document_, Extras{.dumps = {"nobody.radiance"}, .display = {}}), InputError);
    EXPECT_EQ(session_.read("color").pixels, swapped);
}

class LiveGraphs : public runtime::test::WithPasses {};

TEST_F(LiveGraphs, HistoryGoesOnWhenAnotherNodeIsSwapped) {
    addCounter();
    addPass("double", "pixel", R"("inputs": {"of": {}}, "outputs": {"color": {"format": "r32f"}})",
            "void pixel(ivec2 p) { store(color, p, 2.0 * load(of, p)); }");
    addPass("triple", "pixel", R"("inputs": {"of": {}}, "outputs": {"color": {"format": "r32f"}})",
            "void pixel(ivec2 p) { store(color, p, 3.0 * load(of, p)); }");
    const runtime::SessionOptions options = graph(R"json("nodes": {
        "counter": {"pass": "counter", "in": {"before": "previous(counter.color)"}},
        "times": {"pass": "double", "in": {"of": "counter.color"}}}, "outputs": {"color": "times.color"})json");
    runtime::Session session(options);
    GraphDocument document(options.graph, passes(options.passPaths));
    LiveGraph live(session, document, {});
    const auto next = [&] {
        live.show(document, {});
        session.renderFrame(0);
        return valueAt(session, "color", 3, 5);
    };
    EXPECT_EQ(next(), 2 * 11);
    document.swapPass("times", "triple");
    EXPECT_EQ(next(), 3 * 12);
    document.set("counter.bonus", "100");
    EXPECT_EQ(next(), 3 * 113);
    document.reset("counter.bonus");
    EXPECT_EQ(next(), 3 * 114) << "the manifest's bonus is 0";
    document.switchNode("times", false);
    EXPECT_EQ(next(), 0);
    document.undo();
    EXPECT_EQ(next(), 3 * 11) << "nobody needed the counter for a frame";
}

// What the viewer does with files that are saved: shaders are the session's business, the graph the
// document's.
TEST_F(LiveGraphs, EditsStayWhenFilesAreSaved) {
    addCounter();
    const auto addTimes = [&](const std::string& name, const std::string& factor) {
        addPass(name, "pixel", R"("inputs": {"of": {}}, "outputs": {"color": {"format": "r32f"}})",
                "void pixel(ivec2 p) { store(color, p, " + factor + " * load(of, p)); }");
    };
    addTimes("double", "2.0");
    addTimes("triple", "3.0");
    const std::string members = R"json("nodes": {
        "counter": {"pass": "counter", "in": {"before": "previous(counter.color)"}},
        "times": {"pass": "double", "in": {"of": "counter.color"}}}, "outputs": {"color": "times.color"})json";
    const runtime::SessionOptions options = graph(members);
    runtime::Session session(options);
    GraphDocument document(options.graph, passes(options.passPaths));
    LiveGraph live(session, document, {});
    runtime::LiveReload reload(session);
    const auto saved = [&] {
        for (int i = 0; i < 200; ++i) {
            if (reload.wait(std::chrono::milliseconds(50)) && reload.poll()) return true;
        }
        return false;
    };
    document.swapPass("times", "triple");
    live.show(document, {});
    reload.watchAnew();
    session.renderFrame(0);
    EXPECT_EQ(valueAt(session, "color", 0, 0), 3 * 11);

    addTimes("triple", "5.0");
    ASSERT_TRUE(saved());
    session.renderFrame(0);
    EXPECT_EQ(valueAt(session, "color", 0, 0), 5 * 12);

    graph("// by another hand\n" +
          std::string(members).insert(members.find(", \"in\""), R"(, "set": {"bonus": 7})"));
    ASSERT_TRUE(saved());
    EXPECT_TRUE(document.reload().fileChanged);
    EXPECT_TRUE(live.show(document, {}));
    session.renderFrame(0);
    EXPECT_EQ(valueAt(session, "color", 0, 0), 5 * 20);
    EXPECT_THAT(document.text(), testing::HasSubstr("// by another hand"));
    EXPECT_TRUE(document.isModified());
}

TEST_F(LiveGraphs, AnEditedTextStandsForTheFile) {
    addPass(
        "flat", "pixel",
        R"("outputs": {"color": {"format": "r32f"}}, "parameters": {"level": {"type": "float", "default": 1}})",
        "void pixel(ivec2 p) { store(color, p, vec4(params.level)); }");
    const runtime::SessionOptions options =
        graph(R"("nodes": {"flat": {"pass": "flat"}}, "outputs": {"color": "flat.color"})");
    runtime::Session session(options);
    runtime::GraphSource source{options.graph, {}, {}};
    source.text =
        "{\"nodes\": {\"flat\": {\"pass\": \"flat\", \"set\": {\"level\": 7}}},\n \"outputs\": {\"color\": "
        "\"flat.color\"}}";
    session.setGraph(source);
    session.renderFrame(0);
    EXPECT_EQ(valueAt(session, "color", 0, 0), 7);
    source.text =
        "{\"nodes\": {\"flat\": {\"pass\": \"flat\"}},\n \"outputs\": {\"color\": \"flatt.color\"}}";
    EXPECT_THAT(nephrite::tests::faultsOf([&] { session.setGraph(source); }),
                testing::ElementsAre(options.graph.string() +
                                     ":2:23: error: unknown node \"flatt\", did you mean \"flat\"?"));
    source.text =
        "{\"imports\": {\"i\": {\"image\": \"images/none.exr\"}},\n\"nodes\": {\"flat\": {\"pass\": "
        "\"flat\"}}, \"outputs\": {\"color\": \"flat.color\"}}";
    EXPECT_THAT(nephrite::tests::faultsOf([&] { session.setGraph(source); }),
                testing::Contains(testing::HasSubstr((folder_.path() / "images/none.exr").string())));
    session.renderFrame(0);
    EXPECT_EQ(valueAt(session, "color", 0, 0), 7);
}

TEST_F(LiveGraphs, OnlyOneValueAloneIsASetting) {
    addCounter();
    const runtime::SessionOptions options =
        graph(R"json("parameters": {"b": {"value": 2}, "w": {"value": [1, 2]}},
        "nodes": {"counter": {"pass": "counter", "in": {"before": "previous(counter.color)"}, "set": {"bonus": 3}}},
        "outputs": {"color": "counter.color"})json");
    GraphDocument document(options.graph, passes(options.passPaths));
    const auto graph = document.graph();
    const json::Value before = document.root();
    const auto setting = [&] { return settingBetween(*graph, before, document.root()); };
    EXPECT_EQ(setting(), std::nullopt);
    document.set("w", "[1, 3]");
    EXPECT_EQ(setting(), "w=[1, 3]");
    document.set("b", "4");
    EXPECT_EQ(setting(), std::nullopt) << "two";
    document.undo();
    document.undo();
    document.reset("counter.bonus");
    EXPECT_EQ(setting(), "counter.bonus=0");
    document.undo();
    document.set("counter.bonus", "\"$b\"");
    EXPECT_EQ(setting(), std::nullopt) << "a binding";
    const json::Value longer = json::setAt(before, {"parameters", "w", "value"}, "[1, 2, 3]");
    EXPECT_EQ(settingBetween(*graph, before, longer), std::nullopt) << "another shape";
}

TEST(ProjectGraphs, TakeTheirOwnTypesAndNameAReasonForOthers) {
    const auto library = passes();
    std::size_t others = 0;
    for (const std::filesystem::path& file : runtime::test::jsonFiles(projectGraph("x").parent_path())) {
        const GraphDocument document(file, library);
        for (graph::Index node = 0; node < document.graph()->nodes.size(); ++node) {
            const graph::LinkedNode& linked = document.graph()->nodes[node];
            if (linked.role != graph::NodeRole::Pass) continue;
            for (const graph::TypeChoice& choice : graph::choicesFor(*document.graph(), node, *library)) {
                if (choice.name == linked.type->name) {
                    EXPECT_TRUE(choice.isCompatible()) << file << " " << choice.reasons.front();
                } else if (choice.isCompatible()) {
                    ++others;
                    GraphDocument copy(file, library);
                    EXPECT_NO_THROW(copy.swapPass(document.graph()->nodeName(node), choice.name));
                }
            }
        }
    }
    EXPECT_GT(others, 5U);
}

}  // namespace
}  // namespace nephrite::document
