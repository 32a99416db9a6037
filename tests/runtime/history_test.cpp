// previous(...): images of frames ago, neutral at first, kept across plans of the same shape.
#include "pass_folder.h"

namespace nephrite::runtime {
namespace {

using test::valueAt;

class History : public test::WithPasses {
  protected:
    static constexpr const char* counterNode =
        R"json("counter": {"pass": "counter", "in": {"before": "previous(counter.color)"}})json";

    SessionOptions counting() const {
        addCounter();
        return graph(std::string("\"nodes\": {") + counterNode +
                     R"json(}, "outputs": {"color": "counter.color"})json");
    }
};

TEST_F(History, IsNeutralInTheFirstFrameAndThenTheLastFrame) {
    Session session(counting());
    for (int frame = 1; frame <= 5; ++frame) {
        session.renderFrame(0);
        EXPECT_EQ(valueAt(session, "color", 3, 7), 10 + frame);
    }
}

TEST_F(History, ReachesBackAnyNumberOfFrames) {
    addCounter();
    addPass("copy", "pixel", R"("inputs": {"source": {}}, "outputs": {"color": {"format": "r32f"}})",
            "void pixel(ivec2 p) { store(color, p, load(source, p)); }");
    Session session(graph(std::string("\"nodes\": {") + counterNode + R"json(,
        "two": {"pass": "copy", "in": {"source": "previous(counter.color, 2)"}},
        "five": {"pass": "copy", "in": {"source": "previous(previous(counter.color, 2), 3)"}}},
        "outputs": {"color": "two.color", "older": "five.color"})json"));
    for (int frame = 1; frame <= 12; ++frame) {
        session.renderFrame(0);
        EXPECT_EQ(valueAt(session, "color", 0, 0), frame > 2 ? 10 + frame - 2 : 10) << frame;
        EXPECT_EQ(valueAt(session, "older", 0, 0), frame > 5 ? 10 + frame - 5 : 10) << frame;
    }
}

TEST_F(History, IsReadFromThePortItself) {
    SessionOptions options = counting();
    options.graph = folder_.write("both.json", std::string(R"({"name": "both", "nodes": {)") + counterNode +
                                                   R"json(}, "outputs": {"color": "counter.color",
                                                       "before": "previous(counter.color)"}})json");
    Session session(options);
    for (int frame = 1; frame <= 3; ++frame) {
        session.renderFrame(0);
        EXPECT_EQ(valueAt(session, "color", 1, 1), 10 + frame);
        EXPECT_EQ(valueAt(session, "before", 1, 1), 10 + frame - 1);
    }
}

TEST_F(History, SurvivesAnotherPlanOfTheSameShape) {
    Session session(counting());
    for (int frame = 0; frame < 3; ++frame) session.renderFrame(0);
    const std::uint64_t plans = session.figures().plans;
    session.set("counter.step=100");
    EXPECT_EQ(session.figures().plans, plans + 1) << "a specialized parameter needs another pipeline";
    session.renderFrame(0);
    EXPECT_EQ(valueAt(session, "color", 0, 0), 10 + 3 + 100);
}

TEST_F(History, SurvivesAReaderThatComesAndGoes) {
    addCounter();
    addPass("copy", "pixel", R"("inputs": {"source": {}}, "outputs": {"color": {"format": "r32f"}})",
            "void pixel(ivec2 p) { store(color, p, load(source, p)); }");
    Session session(graph(std::string(R"json("parameters": {"deep": {"value": false}}, "nodes": {)json") +
                          counterNode + R"json(,
        "older": {"pass": "copy", "when": "$deep", "in": {"source": "previous(counter.color, 3)"}}},
        "outputs": {"color": "counter.color", "older": "older.color"})json"));
    for (int frame = 0; frame < 3; ++frame) session.renderFrame(0);
    session.set("deep=true");
    session.renderFrame(0);
    EXPECT_EQ(valueAt(session, "color", 0, 0), 10 + 4);
    session.set("deep=false");
    session.renderFrame(0);
    EXPECT_EQ(valueAt(session, "color", 0, 0), 10 + 5);
}

TEST_F(History, OfANodeThatIsSwitchedOffIsNeutral) {
    SessionOptions options = counting();
    options.graph = folder_.write("off.json", R"json({"name": "off", "nodes": {
        "counter": {"pass": "counter", "when": false, "in": {"before": "previous(counter.color)"}}},
        "outputs": {"color": "counter.color", "before": "previous(counter.color, 2)"}})json");
    Session session(options);
    for (int frame = 0; frame < 2; ++frame) {
        session.renderFrame(0);
        EXPECT_EQ(valueAt(session, "before", 1, 1), 10);
    }
}

TEST_F(History, StartsAnewInAnotherSize) {
    Session session(counting());
    for (int frame = 0; frame < 3; ++frame) session.renderFrame(0);
    session.resize({8, 24});
    session.renderFrame(0);
    EXPECT_EQ(session.read("color").height, 24U);
    EXPECT_EQ(valueAt(session, "color", 7, 23), 11);
}

TEST_F(History, GoesOnWithoutWaitingForFrames) {
    SessionOptions options = counting();
    options.framesInFlight = 3;
    Session session(options);
    for (int frame = 0; frame < 20; ++frame) session.startFrame(0);
    EXPECT_EQ(valueAt(session, "color", 15, 15), 30);
}

TEST_F(History, RunsAlsoWhereNothingElseChanges) {
    SessionOptions options = counting();
    options.reuse = true;
    Session session(options);
    for (int frame = 0; frame < 4; ++frame) session.renderFrame(0);
    EXPECT_EQ(valueAt(session, "color", 0, 0), 14);
}

}  // namespace
}  // namespace nephrite::runtime
