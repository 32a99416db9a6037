// A session whose parameters, size and camera change, with frames under way, and one that loses its device.
#include <gmock/gmock.h>

#include "every_graph.h"
#include "pass_folder.h"
#include "text/diagnostics.h"

namespace nephrite::runtime {
namespace {

using test::valueAt;

class SessionChanges : public test::WithPasses {
  protected:
    SessionOptions factor() const {
        addPass("scaled", "pixel", R"("outputs": {"color": {"format": "rg32f"}},
                    "parameters": {"factor": {"type": "float", "default": 1, "range": [0, 100]}})",
                "void pixel(ivec2 p) { store(color, p, vec4(params.factor, time, 0.0, 0.0)); }");
        return graph(R"("nodes": {"scaled": {"pass": "scaled"}}, "outputs": {"color": "scaled.color"})");
    }
};

TEST_F(SessionChanges, AParameterChangesWithoutAnotherPlan) {
    Session session(factor());
    session.renderFrame(0);
    const SessionFigures before = session.figures();
    for (int frame = 0; frame < 5; ++frame) {
        session.set("scaled.factor=" + std::to_string(frame * 3));
        session.startFrame(frame);
    }
    EXPECT_EQ(valueAt(session, "color", 0, 0), 12);
    EXPECT_EQ(valueAt(session, "color", 0, 0, 1), 4);
    EXPECT_EQ(session.figures().plans, before.plans);
    EXPECT_EQ(session.figures().pipelines, before.pipelines);
    EXPECT_EQ(session.figures().deviceAllocations, before.deviceAllocations);
}

TEST_F(SessionChanges, AValueThatIsRefusedChangesNothing) {
    Session session(factor());
    session.set("scaled.factor=7");
    EXPECT_THROW(session.set("scaled.factor=101"), InputError);
    EXPECT_THROW(session.set("scaled.faktor=1"), InputError);
    EXPECT_THROW(session.resize({0, 16}), InputError);
    session.renderFrame(0);
    EXPECT_EQ(session.read("color").width, 16U);
    EXPECT_EQ(valueAt(session, "color", 0, 0), 7);
}

TEST_F(SessionChanges, FramesUnderWayGiveThePictureOfTheLast) {
    SessionOptions options;
    options.graph = std::string(NEPHRITE_SOURCE_DIR) + "/graphs/gbuffer.json";
    options.scene = std::string(NEPHRITE_SOURCE_DIR) + "/graphs/scenes/moving.json";
    options.size = {64, 64};
    options.validation = Validation::Sync;
    options.framesInFlight = 3;
    Session flying(options);
    for (int frame = 0; frame <= 10; ++frame) flying.startFrame(frame / 10.0);
    Session waiting(options);
    waiting.renderFrame(1);
    EXPECT_EQ(flying.read("color").pixels, waiting.read("color").pixels);
}

TEST_F(SessionChanges, PipelinesOfUnchangedPassesAreKept) {
    addCounter();
    Session session(
        graph(R"json("nodes": {"counter": {"pass": "counter", "in": {"before": "previous(counter.color)"}}},
                                    "outputs": {"color": "counter.color"})json"));
    const std::uint64_t built = session.figures().pipelines;
    session.resize({40, 30});
    EXPECT_EQ(session.figures().pipelines, built);
    session.set("counter.step=5");
    EXPECT_EQ(session.figures().pipelines, built + 1);
    session.set("counter.step=1");
    EXPECT_EQ(session.figures().pipelines, built + 1) << "it was built before";
}

// Few and small pipelines, but history, a light's view, a list of tiles and a node that comes and goes.
TEST_F(SessionChanges, NothingIsLostToManyChanges) {
    addCounter();
    addPass("masked", "pixel",
            R"("domain": "mask", "inputs": {"mask": {}, "light": {}, "color": {}}, "outputs": {"sum": {}})",
            "void pixel(ivec2 p) { store(sum, p, load(mask, p) + load(light, p) + load(color, p)); }");
    SessionOptions options = graph(R"json("parameters": {"counts": {"value": 1}}, "nodes": {
        "gbuffer": {"pass": "gbuffer", "view": "camera"},
        "light": {"pass": "gbuffer", "view": "light", "forEach": "lights", "size": [16, 16]},
        "counter": {"pass": "counter", "in": {"before": "previous(counter.color)"}, "when": "graph.counts == 1"},
        "masked": {"pass": "masked", "in": {"mask": "gbuffer.position", "light": "layer(light.position, 0)", "color": "counter.color"}}},
        "outputs": {"color": "masked.sum"})json");
    options.reuse = true;
    Session session(options);
    const auto round = [&] {
        for (const std::uint32_t side : {24U, 40U, 32U}) {
            session.resize({side, 32});
            session.set("counts=0");
            session.renderFrame(0);
            session.set("counts=1");
            session.renderFrame(0);
        }
    };
    round();
    const SessionFigures before = session.figures();
    for (int i = 0; i < 2; ++i) round();
    EXPECT_EQ(session.figures().deviceAllocations, before.deviceAllocations);
    EXPECT_EQ(session.figures().deviceBytes, before.deviceBytes);
    EXPECT_EQ(session.figures().pipelines, before.pipelines);
}

TEST_F(SessionChanges, AnotherGraphGoesOnWithTheHistoryThatFits) {
    addCounter();
    const std::string node =
        R"json("counter": {"pass": "counter", "in": {"before": "previous(counter.color)"}})json";
    const auto file = [&](const std::string& name, const std::string& more, const std::string& output) {
        return folder_.write(
            name, "{\"nodes\": {" + node + more + "}, \"outputs\": {\"color\": \"" + output + "\"}}");
    };
    addPass("double", "pixel", R"("inputs": {"of": {}}, "outputs": {"color": {"format": "r32f"}})",
            "void pixel(ivec2 p) { store(color, p, 2.0 * load(of, p)); }");
    SessionOptions options = graph("\"nodes\": {}, \"outputs\": {}");
    options.graph = file("one.json", "", "counter.color");
    Session session(options);
    for (int frame = 0; frame < 3; ++frame) session.renderFrame(0);
    session.setGraph(
        {file("other.json", R"json(, "double": {"pass": "double", "in": {"of": "counter.color"}})json",
              "double.color"),
         {"counter.bonus=5"},
         {"counter.color"}});
    session.renderFrame(0);
    EXPECT_EQ(valueAt(session, "counter.color", 2, 3), 13 + 1 + 5);
    EXPECT_EQ(valueAt(session, "color", 2, 3), 2 * (13 + 1 + 5));
}

TEST_F(SessionChanges, AGraphThatIsRefusedChangesNothing) {
    addCounter();
    Session session(
        graph(R"json("nodes": {"counter": {"pass": "counter", "in": {"before": "previous(counter.color)"}}},
                                    "outputs": {"color": "counter.color"})json"));
    for (int frame = 0; frame < 3; ++frame) session.renderFrame(0);
    const SessionFigures before = session.figures();
    addPass("wrong", "pixel", R"("outputs": {"color": {"format": "r32f"}})",
            "void pixel(ivec2 p) { store(color, p, nothing); }");
    const auto wrong = folder_.write("wrong.json", R"json({"nodes": {
            "counter": {"pass": "counter", "size": [64, 64], "in": {"before": "previous(counter.color)"}},
            "wrong": {"pass": "wrong"}},
            "outputs": {"color": "counter.color", "other": "wrong.color"}})json");
    EXPECT_THROW(session.setGraph({wrong, {}, {}}), InputError);
    EXPECT_THROW(session.setGraph({folder_.path() / "missing.json", {}, {}}), InputError);
    EXPECT_THROW(session.setGraph({folder_.path() / "graph.json", {"counter.step=x"}, {}}), InputError);
    EXPECT_EQ(session.figures().plans, before.plans);
    session.set("counter.bonus=5");
    session.renderFrame(0);
    EXPECT_EQ(valueAt(session, "color", 0, 0), 13 + 1 + 5);
}

TEST_F(SessionChanges, ALostDeviceIsAnErrorWhereverItHappens) {
    SessionOptions options = factor();
    const auto submissions = [&](std::uint32_t most) {
        options.loseDeviceAtSubmit = most;
        try {
            Session session(options);
            for (int frame = 0; frame < 3; ++frame) session.startFrame(frame);
            session.waitForFrames();
            session.read("color");
            return true;
        } catch (const RunError& error) {
            EXPECT_THAT(error.what(), testing::HasSubstr(": error: the device was lost")) << most;
            return false;
        }
    };
    std::uint32_t most = 0;
    testing::internal::CaptureStderr();
    while (most < 100 && !submissions(most)) ++most;
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "") << "nothing is destroyed while it is in use";
    EXPECT_GT(most, 4U) << "three frames, a picture and the scene are submitted";
    EXPECT_LT(most, 100U);
}

TEST(SharedMemoryOfFrames, GivesThePictureOfMemoryOfItsOwn) {
    sharedScratchFolder();
    const std::filesystem::path graphs = std::filesystem::path(NEPHRITE_SOURCE_DIR) / "graphs";
    for (const std::filesystem::path& graph : test::jsonFiles(graphs)) {
        SessionOptions options;
        options.graph = graph;
        if (graph.stem() == "paper") options.settings = {"lightSize=32", "steps=4", "taps=5"};
        options.size = {48, 40};
        options.validation = Validation::Sync;
        options.plain = true;
        Session plain(options);
        plain.renderFrame(0);
        options.plain = false;
        for (const graph::Policy policy : {graph::Policy::Barriers, graph::Policy::Memory}) {
            options.policy = policy;
            Session shared(options);
            for (int frame = 0; frame < 2; ++frame) shared.renderFrame(0);
            for (const graph::RequestedOutput& output : shared.plan().requested)
                EXPECT_EQ(shared.read(output.name).pixels, plain.read(output.name).pixels)
                    << graph << " " << output.name;
        }
    }
}

}  // namespace
}  // namespace nephrite::runtime
