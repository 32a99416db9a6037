// Editing the files of a session while it renders.
#include "runtime/reload/live_reload.h"

#include <gmock/gmock.h>

#include <filesystem>

#include "pass_folder.h"

namespace nephrite::runtime {
namespace {

using namespace std::chrono_literals;
using test::valueAt;
using testing::HasSubstr;
using testing::IsEmpty;

class LiveReloadTest : public test::WithPasses {
  protected:
    LiveReloadTest() {
        writeShader("#include \"part.glsl\"\n");
        folder_.write("passes/part.glsl", "float part() { return 2.0; }\n");
        folder_.write("passes/shown.json", manifest);
        addCounter();
        writeGraph("");
        options_.graph = folder_.path() / "graph.json";
        options_.passPaths = {folder_.path() / "passes"};
        options_.size = {16, 16};
        options_.validation = Validation::Sync;
        options_.reuse = true;
        options_.dumps = {"counter.color"};
    }

    void writeShader(const std::string& before, const std::string& value = "part() * params.factor") const {
        folder_.write("passes/shown.glsl",
                      before + "void pixel(ivec2 p) { store(color, p, vec4(" + value + ")); }");
    }
    void writeGraph(const std::string& set) const {
        folder_.write("graph.json", R"json({"nodes": {
            "shown": {"pass": "shown")json" +
                                        set + R"json(},
            "counter": {"pass": "counter", "in": {"before": "previous(counter.color)"}}},
            "outputs": {"color": "shown.color"}})json");
    }

    /// Saves something and takes it over.
    template<class Save>
    Reload reloadAfter(LiveReload& live, Session& session, Save save) {
        save();
        for (int i = 0; i < 100; ++i) {
            session.renderFrame(0);
            if (!live.wait(50ms)) continue;
            if (auto reload = live.poll()) {
                session.renderFrame(0);
                return std::move(*reload);
            }
        }
        ADD_FAILURE() << "nothing was noticed";
        return {};
    }

    static constexpr const char* manifest =
        R"({"kind": "pixel", "shader": "shown.glsl", "outputs": {"color": {"format": "r32f"}},
            "parameters": {"factor": {"type": "float", "default": 3}}})";
    SessionOptions options_;
};

TEST_F(LiveReloadTest, ShaderIncludeManifestAndGraph) {
    Session session(options_);
    LiveReload live(session);
    const auto valueAfter = [&](auto save) {
        const Reload reload = reloadAfter(live, session, save);
        EXPECT_TRUE(reload.shown);
        EXPECT_THAT(live.faults(), IsEmpty());
        return valueAt(session, "color", 5, 5);
    };
    EXPECT_EQ(valueAfter([&] { writeShader("#include \"part.glsl\"\n", "part() + params.factor"); }), 5);
    EXPECT_EQ(valueAfter([&] { folder_.write("passes/part.glsl", "float part() { return 4.0; }\n"); }), 7);
    EXPECT_EQ(valueAfter([&] {
                  std::string other = manifest;
                  other.replace(other.find("3}"), 1, "10");
                  folder_.write("passes/shown.json", other);
              }),
              14);
    EXPECT_EQ(valueAfter([&] { writeGraph(R"(, "set": {"factor": 1})"); }), 5);
}

TEST_F(LiveReloadTest, WhatIsWrongIsNamedAndTheLastPictureStays) {
    Session session(options_);
    LiveReload live(session);
    session.renderFrame(0);
    const Reload wrong = reloadAfter(live, session, [&] { writeShader("\n", "nothing"); });
    EXPECT_FALSE(wrong.shown);
    ASSERT_EQ(live.faults().size(), 1U);
    EXPECT_THAT(live.faults()[0].where.file, HasSubstr("passes/shown.glsl"));
    EXPECT_EQ(live.faults()[0].where.line, 2U);
    EXPECT_THAT(live.faults()[0].message, HasSubstr("nothing"));
    EXPECT_EQ(valueAt(session, "color", 5, 5), 6);
    session.set("shown.factor=5");
    session.renderFrame(0);
    EXPECT_EQ(valueAt(session, "color", 5, 5), 10) << "the broken file is in nobody's way";
    const Reload right = reloadAfter(live, session, [&] { writeShader("", "params.factor"); });
    EXPECT_TRUE(right.shown);
    EXPECT_THAT(live.faults(), IsEmpty());
    EXPECT_EQ(valueAt(session, "color", 5, 5), 5) << "and the value that was set is still set";
}

TEST_F(LiveReloadTest, ALinkToItselfIsAFileThatIsMissing) {
    Session session(options_);
    LiveReload live(session);
    const std::filesystem::path part = folder_.path() / "passes/part.glsl";
    const Reload wrong = reloadAfter(live, session, [&] {
        std::filesystem::remove(part);
        std::filesystem::create_symlink("part.glsl", part);
    });
    EXPECT_FALSE(wrong.shown);
    Reload shown;
    shown.shown = true;
    shown.files = {part};
    EXPECT_THAT(toLines(shown), testing::ElementsAre(HasSubstr("reloaded part.glsl (gone) in")));
}

TEST_F(LiveReloadTest, NamesTheFirstFewOfManyFiles) {
    Reload shown;
    shown.shown = true;
    for (const char* name : {"a.glsl", "b.glsl", "c.glsl", "d.glsl", "e.glsl"})
        shown.files.push_back(folder_.write(name, ""));
    EXPECT_THAT(toLines(shown),
                testing::ElementsAre(HasSubstr("reloaded a.glsl, b.glsl, c.glsl and 2 more in")));
}

TEST_F(LiveReloadTest, HistoryGoesOn) {
    Session session(options_);
    LiveReload live(session);
    session.renderFrame(0);
    const float before = valueAt(session, "counter.color", 1, 1);
    reloadAfter(live, session, [&] { writeShader("", "1.0"); });
    EXPECT_GE(valueAt(session, "counter.color", 1, 1), before + 2);
}

TEST_F(LiveReloadTest, AFileThatWasMissingIsFoundOnceItIsThere) {
    Session session(options_);
    LiveReload live(session);
    const Reload wrong =
        reloadAfter(live, session, [&] { writeShader("#include \"deep/er.glsl\"\n", "deeper()"); });
    EXPECT_FALSE(wrong.shown);
    reloadAfter(live, session,
                [&] { folder_.write("passes/deep/er.glsl", "float deeper() { return 8.0; }\n"); });
    for (int i = 0; i < 20 && !live.faults().empty(); ++i)
        if (live.wait(100ms)) live.poll();
    session.renderFrame(0);
    EXPECT_THAT(live.faults(), IsEmpty());
    EXPECT_EQ(valueAt(session, "color", 5, 5), 8);
}

TEST_F(LiveReloadTest, AShaderThatComesToLieInFrontOfTheIncludedOne) {
    folder_.write("passes/shown.glsl",
                  "#include \"sampling.glsl\"\nvoid pixel(ivec2 p) { store(color, p, vec4(1.0)); }");
    Session session(options_);
    LiveReload live(session);
    const Reload wrong = reloadAfter(live, session, [&] { folder_.write("passes/sampling.glsl", "broken"); });
    EXPECT_FALSE(wrong.shown) << "beside the including file comes before shaders/";
    const Reload right =
        reloadAfter(live, session, [&] { std::filesystem::remove(folder_.path() / "passes/sampling.glsl"); });
    EXPECT_TRUE(right.shown);
}

TEST_F(LiveReloadTest, AGraphGivenByOtherMeansIsWatchedFromThenOn) {
    Session session(options_);
    LiveReload live(session);
    const auto other = folder_.write("other.json", R"({"nodes": {"shown": {"pass": "shown"}},
                                                       "outputs": {"color": "shown.color"}})");
    session.setGraph({other, {}, {}});
    live.watchAnew();
    const Reload reload = reloadAfter(live, session, [&] {
        folder_.write("other.json", R"({"nodes": {"shown": {"pass": "shown", "set": {"factor": 50}}},
                                        "outputs": {"color": "shown.color"}})");
    });
    EXPECT_TRUE(reload.shown);
    EXPECT_EQ(valueAt(session, "color", 5, 5), 100);
}

TEST_F(LiveReloadTest, AGraphSetWhileADraftIsBuiltWins) {
    Session session(options_);
    Draft draft = session.draft(session.shown());
    writeGraph(R"(, "set": {"factor": 1})");
    session.setGraph({options_.graph, {"shown.factor=2"}, {"counter.color"}});
    draft.build();
    EXPECT_FALSE(session.adopt(draft));
    session.renderFrame(0);
    EXPECT_EQ(valueAt(session, "color", 5, 5), 4);
}

TEST_F(LiveReloadTest, AValueSetWhileADraftIsBuiltIsSetInIt) {
    Session session(options_);
    Draft draft = session.draft(session.shown());
    writeShader("", "100.0 + params.factor");
    session.set("shown.factor=2");
    draft.build();
    EXPECT_TRUE(session.adopt(draft));
    session.renderFrame(0);
    EXPECT_EQ(valueAt(session, "color", 5, 5), 102);
}

TEST_F(LiveReloadTest, SceneAndWhatItNames) {
    const auto sceneOf = [](double x) {
        return R"({"camera": {"position": [0, 0, 40], "target": [0, 0, 0]},
            "lights": [{"type": "point", "position": [)" +
               std::to_string(x) + R"(, 30, 30], "intensity": [1, 1, 1]}],
            "materials": {"grey": {"diffuse": [0.5, 0.5, 0.5], "roughness": 1}},
            "objects": [{"mesh": "mesh.obj", "material": "grey"}]})";
    };
    options_.scene = folder_.write("scene.json", sceneOf(1));
    folder_.write("mesh.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    writeShader("", "lights[0].position.x");
    Session session(options_);
    LiveReload live(session);
    reloadAfter(live, session, [&] { folder_.write("scene.json", sceneOf(4)); });
    EXPECT_EQ(valueAt(session, "color", 5, 5), 4);
    const Reload wrong = reloadAfter(live, session, [&] { folder_.write("mesh.obj", "f 1 2 3\n"); });
    EXPECT_FALSE(wrong.shown);
    EXPECT_THAT(toLines(wrong), testing::Contains(HasSubstr("mesh.obj")));
    const Reload right = reloadAfter(
        live, session, [&] { folder_.write("mesh.obj", "v 0 0 0\nv 9 0 0\nv 0 9 0\nf 1 2 3\n"); });
    EXPECT_TRUE(right.shown);
}

}  // namespace
}  // namespace nephrite::runtime
