// Passes of which nothing they read has changed are left out, and the picture stays the same bit for bit.
#include <gmock/gmock.h>

#include <algorithm>

#include "pass_folder.h"
#include "scene/scene.h"
#include "text/diagnostics.h"

namespace nephrite::runtime {
namespace {

using test::ranIn;
using testing::Contains;
using testing::IsEmpty;
using testing::Not;

const std::string sources = NEPHRITE_SOURCE_DIR;

class Reuse : public test::WithPasses {
  protected:
    /// A graph of the project, every frame of which is held against one without skipping.
    SessionOptions audited(const std::string& name) const {
        SessionOptions options;
        options.graph = sources + "/graphs/" + name + ".json";
        options.scene = sources + "/graphs/scenes/sphere.json";
        options.size = {32, 32};
        options.reuse = true;
        options.auditSkips = true;
        options.validation = Validation::Sync;
        return options;
    }
};

TEST_F(Reuse, AnUnchangedFrameRunsNothing) {
    Session session(audited("diffuse"));
    const std::vector<std::string> first = ranIn(session.renderFrame(0), session);
    EXPECT_EQ(first.size(), session.plan().passes.size());
    for (int frame = 0; frame < 3; ++frame) EXPECT_THAT(ranIn(session.renderFrame(0), session), IsEmpty());
}

TEST_F(Reuse, AMovedCameraDoesNotRedrawTheLightView) {
    Session session(audited("diffuse"));
    session.renderFrame(0);
    scene::CameraDescription camera = session.scene().description().camera;
    camera.position.x += 3;
    session.setCamera(camera);
    const std::vector<std::string> ran = ranIn(session.renderFrame(0), session);
    EXPECT_THAT(ran, Contains("gbuffer"));
    EXPECT_THAT(ran, Contains("composite"));
    EXPECT_THAT(ran, Not(Contains("light")));
}

TEST_F(Reuse, ParametersRunWhatDependsOnThemAndWeightZeroRemovesATermsPasses) {
    SessionOptions options = audited("paper");
    options.validation = Validation::Off;
    Session session(options);
    session.renderFrame(0);
    const std::uint64_t plans = session.figures().plans;
    session.set("weights=[0.2, 0.2, 0.2, 0.2, 0.2]");
    const std::vector<std::string> ran = ranIn(session.renderFrame(0), session);
    EXPECT_EQ(session.figures().plans, plans);
    EXPECT_THAT(ran, Contains("composite"));
    // Terms that change less often than the picture are kept; others were in shared memory and are made
    // again.
    for (const char* kept : {"light", "gbuffer", "direct", "specular", "single-scatter"})
        EXPECT_THAT(ran, Not(Contains(kept)));

    const std::size_t passes = session.plan().passes.size();
    session.set("weights=[0.2, 0.2, 0.2, 0.2, 0]");
    session.renderFrame(0);
    EXPECT_LT(session.plan().passes.size(), passes);
}

TEST_F(Reuse, AMovingSceneRunsAgain) {
    SessionOptions options = audited("diffuse");
    options.scene = sources + "/graphs/scenes/moving.json";
    Session session(options);
    session.renderFrame(0);
    EXPECT_THAT(ranIn(session.renderFrame(0.5), session), Contains("light"));
    EXPECT_THAT(ranIn(session.renderFrame(0.5), session), IsEmpty());
}

TEST_F(Reuse, AFrameWithoutChangesCostsAtMostAHundredth) {
    SessionOptions options = audited("paper");
    options.size = {256, 256};
    options.auditSkips = false;
    options.validation = Validation::Off;
    Session session(options);
    session.renderFrame(0);
    double full = 1e30;
    double unchanged = 1e30;
    for (int frame = 0; frame < 6; ++frame) {
        scene::CameraDescription camera = session.scene().description().camera;
        camera.position.x += frame + 1;
        session.setCamera(camera);
        full = std::min(full, session.renderFrame(0).wallMs);
        unchanged = std::min(unchanged, session.renderFrame(0).wallMs);
    }
    RecordProperty("fullMs", std::to_string(full));
    RecordProperty("unchangedMs", std::to_string(unchanged));
    EXPECT_LE(unchanged, 0.01 * full);
}

TEST_F(Reuse, WhatIsNotKeptIsMadeAgain) {
    // "slow" changes never and "fast" with the time; "mix" reads both, so slow is kept and fast is not.
    addPass("slow", "pixel", R"("outputs": {"color": {"format": "r32f"}})",
            "void pixel(ivec2 p) { store(color, p, vec4(p.x)); }");
    addPass("fast", "pixel", R"("outputs": {"color": {"format": "r32f"}})",
            "void pixel(ivec2 p) { store(color, p, vec4(time)); }");
    addPass("mix", "pixel", R"("inputs": {"a": {}, "b": {}}, "outputs": {"color": {"format": "r32f"}},
                               "parameters": {"factor": {"type": "float", "default": 1}})",
            "void pixel(ivec2 p) { store(color, p, (load(a, p) + load(b, p)) * params.factor); }");
    SessionOptions options = graph(R"("nodes": {"slow": {"pass": "slow"}, "fast": {"pass": "fast"},
        "mix": {"pass": "mix", "in": {"a": "slow.color", "b": "fast.color"}}}, "outputs": {"color": "mix.color"})");
    options.reuse = true;
    options.auditSkips = true;
    Session session(options);
    session.renderFrame(1);
    EXPECT_EQ(ranIn(session.renderFrame(2), session), (std::vector<std::string>{"fast", "mix"}));
    EXPECT_EQ(test::valueAt(session, "color", 5, 0), 7);
    session.set("mix.factor=2");
    EXPECT_THAT(ranIn(session.renderFrame(2), session), Not(Contains("slow")));
    EXPECT_EQ(test::valueAt(session, "color", 5, 0), 14);
}

TEST_F(Reuse, TheAuditNamesWhatSkippingChanges) {
    // The manifest says "neutral outside the domain", the shader writes 1 there.
    addPass("liar", "pixel",
            R"("domain": "position", "inputs": {"position": {}}, "outputs": {"color": {"format": "r32f"}})",
            "void pixel(ivec2 p) { store(color, p, vec4(1.0)); }");
    SessionOptions options = graph(R"("nodes": {"gbuffer": {"pass": "gbuffer"},
        "liar": {"pass": "liar", "in": {"position": "gbuffer.position"}}}, "outputs": {"color": "liar.color"})");
    options.size = {64, 64};
    options.auditSkips = true;
    Session session(options);
    try {
        session.renderFrame(0);
        FAIL() << "the audit passed";
    } catch (const RunError& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr("color: error: skipping changes the picture at (0, 0)"));
    }
}

}  // namespace
}  // namespace nephrite::runtime
