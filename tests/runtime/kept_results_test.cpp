// What goes on when a graph, a shader or a scene is read anew: programs, kept results, history.
#include <gmock/gmock.h>

#include "pass_folder.h"
#include "runtime/draft.h"
#include "scene/scene.h"
#include "text/diagnostics.h"

namespace nephrite::runtime {
namespace {

using test::ranIn;
using test::valueAt;
using testing::ElementsAre;
using testing::IsEmpty;

/// source -> middle -> end, and beside it a view of the scene; each kind of change reaches some of them.
class KeptResults : public test::WithPasses {
  protected:
    KeptResults() {
        addMade("source", "", "vec4(params.value)");
        addMade("middle", R"("inputs": {"of": {}},)", "load(of, p) + params.value");
        addMade("end", R"("inputs": {"of": {}, "with": {}},)",
                "load(of, p) * params.value + 0.0 * load(with, p)");
        addMade("lit", "", "vec4(lights[0].intensity.x)");
        writeScene(5, 1);
        writeGraph("1");
        options_.graph = folder_.path() / "graph.json";
        options_.scene = folder_.path() / "scene.json";
        options_.passPaths = {folder_.path() / "passes"};
        options_.size = {16, 16};
        options_.validation = Validation::Sync;
        options_.reuse = true;
        options_.dumps = {"source.color", "middle.color", "lit.color"};
    }

    void addMade(const std::string& name, const std::string& inputs, const std::string& value) const {
        addPass(name, "pixel", inputs + R"("outputs": {"color": {"format": "r32f"}},
                            "parameters": {"value": {"type": "float", "default": 1}})",
                "void pixel(ivec2 p) { store(color, p, vec4(" + value + ")); }");
    }
    void writeGraph(const std::string& value) const {
        folder_.write("graph.json", R"json({"nodes": {
            "source": {"pass": "source", "set": {"value": 3}},
            "middle": {"pass": "middle", "in": {"of": "source.color"}, "set": {"value": )json" +
                                        value + R"json(}},
            "lit": {"pass": "lit"},
            "end": {"pass": "end", "in": {"of": "middle.color", "with": "lit.color"}, "set": {"value": 2}}},
            "outputs": {"color": "end.color"}})json");
    }
    void writeScene(int intensity, double radius, double diffuse = 0.5) const {
        folder_.write("scene.json", R"({"camera": {"position": [0, 0, 40], "target": [0, 0, 0]},
            "lights": [{"type": "point", "position": [0, 30, 30], "intensity": [)" +
                                        std::to_string(intensity) +
                                        R"(, 1, 1]}], "materials": {"grey": {"diffuse": [0.5, 0.5, )" +
                                        std::to_string(diffuse) + R"(], "roughness": 1}},
            "objects": [{"mesh": {"procedural": "sphere", "radius": )" +
                                        std::to_string(radius) + R"(}, "material": "grey"}]})");
    }
    std::vector<std::string> passesOfNextFrame(Session& session) const {
        return ranIn(session.renderFrame(0), session);
    }

    SessionOptions options_;
};

TEST_F(KeptResults, GoOnWhenTheSameGraphIsReadAnew) {
    Session session(options_);
    session.renderFrame(0);
    session.setGraph(session.shown().graph);
    EXPECT_THAT(passesOfNextFrame(session), IsEmpty());
    EXPECT_EQ(valueAt(session, "color", 3, 3), 8);
}

TEST_F(KeptResults, OnlyWhatDependsOnAShaderRunsAgain) {
    Session session(options_);
    session.renderFrame(0);
    const std::uint64_t pipelines = session.figures().pipelines;
    addMade("middle", R"("inputs": {"of": {}},)", "load(of, p) + 10.0 * params.value");
    session.setGraph(session.shown().graph);
    EXPECT_EQ(session.figures().pipelines, pipelines + 1);
    EXPECT_THAT(passesOfNextFrame(session), ElementsAre("middle", "end"));
    EXPECT_EQ(valueAt(session, "color", 3, 3), 26);
}

TEST_F(KeptResults, OnlyWhatDependsOnAValueInTheFileRunsAgain) {
    Session session(options_);
    session.renderFrame(0);
    writeGraph("4");
    session.setGraph(session.shown().graph);
    EXPECT_THAT(passesOfNextFrame(session), ElementsAre("middle", "end"));
    EXPECT_EQ(valueAt(session, "color", 3, 3), 14);
}

TEST_F(KeptResults, AnotherShapeIsMadeAnew) {
    Session session(options_);
    session.renderFrame(0);
    session.resize({24, 16});
    EXPECT_EQ(passesOfNextFrame(session).size(), 4U);
    EXPECT_EQ(valueAt(session, "color", 20, 3), 8);
}

TEST_F(KeptResults, AFrameThatFailsToBuildLeavesThemAsTheyWere) {
    Session session(options_);
    session.renderFrame(0);
    addMade("middle", R"("inputs": {"of": {}},)", "nothing");
    EXPECT_THROW(session.setGraph(session.shown().graph), InputError);
    EXPECT_THAT(passesOfNextFrame(session), IsEmpty());
    EXPECT_EQ(valueAt(session, "color", 3, 3), 8);
    session.set("end.value=1");
    EXPECT_THAT(passesOfNextFrame(session), ElementsAre("end")) << "the broken file is not read for that";
    EXPECT_EQ(valueAt(session, "color", 3, 3), 4);
}

TEST_F(KeptResults, OfTheSceneOnlyWhatDiffersCounts) {
    Session session(options_);
    session.renderFrame(0);
    session.setScene(options_.scene);
    EXPECT_THAT(passesOfNextFrame(session), IsEmpty());
    writeScene(5, 1, 0.25);
    session.setScene(options_.scene);
    EXPECT_THAT(passesOfNextFrame(session), IsEmpty()) << "no pass looks at the material";
    writeScene(7, 1, 0.25);
    session.setScene(options_.scene);
    EXPECT_THAT(passesOfNextFrame(session), ElementsAre("lit", "end"));
    EXPECT_EQ(valueAt(session, "lit.color", 3, 3), 7);
}

TEST_F(KeptResults, AWrongSceneChangesNothing) {
    Session session(options_);
    session.renderFrame(0);
    folder_.write("scene.json", "{\"camera\": ");
    EXPECT_THROW(session.setScene(options_.scene), InputError);
    EXPECT_THAT(passesOfNextFrame(session), IsEmpty());
    EXPECT_EQ(session.scene().facts().objects, 1U);
}

TEST_F(KeptResults, TheGeometryOfAnotherSceneIsDrawn) {
    options_.graph = std::string(NEPHRITE_SOURCE_DIR) + "/graphs/gbuffer.json";
    options_.passPaths.clear();
    options_.dumps = {"gbuffer.position"};
    options_.auditSkips = true;
    Session session(options_);
    session.renderFrame(0);
    EXPECT_EQ(valueAt(session, "gbuffer.position", 2, 8, 3), 0);
    writeScene(5, 12);
    session.setScene(options_.scene);
    session.renderFrame(0);
    EXPECT_EQ(valueAt(session, "gbuffer.position", 2, 8, 3), 1);
}

TEST_F(KeptResults, ValuesSetWhileItRanStayUnlessTheFileSaysOtherwise) {
    Session session(options_);
    session.set("middle.value=6");
    session.set("source.value=1");
    session.set("source.value=2");
    session.setGraph(session.shown().graph);
    session.renderFrame(0);
    EXPECT_EQ(valueAt(session, "color", 3, 3), 16) << "(2 + 6) * 2";
    writeGraph("4");
    session.setGraph(session.shown().graph);
    session.renderFrame(0);
    EXPECT_EQ(valueAt(session, "color", 3, 3), 12) << "(2 + 4) * 2: the file has the last word";
}

TEST_F(KeptResults, ReadingAnewTakesNoMoreMemory) {
    Session session(options_);
    session.renderFrame(0);
    const SessionFigures before = session.figures();
    for (int i = 0; i < 5; ++i) {
        writeGraph(std::to_string(i));
        session.setGraph(session.shown().graph);
        session.setScene(options_.scene);
        session.renderFrame(0);
    }
    EXPECT_EQ(session.figures().deviceAllocations, before.deviceAllocations);
    EXPECT_EQ(session.figures().deviceBytes, before.deviceBytes);
}

}  // namespace
}  // namespace nephrite::runtime
