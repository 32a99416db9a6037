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

TEST_F(SessionChanges, NothingIsLostToManyChanges) {
    SessionOptions options;
    options.graph = std::string(NEPHRITE_SOURCE_DIR) + "/graphs/paper.json";
    options.size = {32, 32};
    options.validation = Validation::Sync;
    options.reuse = true;
    Session session(options);
    const auto round = [&] {
        for (const std::uint32_t side : {24U, 40U, 32U}) {
            session.resize({side, 32});
            session.set("weights=[0.3, 0.3, 0, 0, 0]");
            session.renderFrame(0);
            session.set("weights=[0.3, 0.3, 0.05, 0.05, 0.3]");
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
    const std::filesystem::path graphs = std::filesystem::path(NEPHRITE_SOURCE_DIR) / "graphs";
    for (const std::filesystem::path& graph : test::jsonFiles(graphs)) {
        SessionOptions options;
        options.graph = graph;
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
