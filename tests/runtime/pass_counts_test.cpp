// What profiled passes count: shader invocations, where a formula says how many there must be.
#include "pass_folder.h"

namespace nephrite::runtime {
namespace {

class PassCounts : public test::WithPasses {
  protected:
    /// A slab before the camera, which covers the whole picture, and a pass over the pixels.
    SessionOptions slab() const {
        addPass("plain", "pixel", R"("outputs": {"color": {"format": "r32f"}})",
                "void pixel(ivec2 p) { store(color, p, vec4(1.0)); }");
        SessionOptions options =
            graph(R"("nodes": {"plain": {"pass": "plain"}, "gbuffer": {"pass": "gbuffer"}},
            "outputs": {"color": "plain.color", "position": "gbuffer.position"})");
        options.scene = folder_.write("slab.json", R"({
            "camera": {"position": [0, 0, 40], "target": [0, 0, 0], "fovY": 36, "near": 1, "far": 100},
            "materials": {"clay": {"diffuse": [1, 1, 1]}},
            "objects": [{"mesh": {"procedural": "slab", "size": [400, 400, 1]}, "material": "clay"}]})");
        options.size = {20, 12};
        options.profile = true;
        return options;
    }

    static const PassTime& pass(const Session& session, const FrameTimes& times, const std::string& name) {
        const graph::Plan& plan = session.plan();
        for (std::size_t i = 0; i < plan.passes.size(); ++i)
            if (plan.nameOf(plan.passes[i]) == name) return times.passes[i];
        throw std::runtime_error("no pass " + name);
    }
};

TEST_F(PassCounts, AreThoseOfTheWork) {
    Session session(slab());
    for (int frame = 0; frame < 3; ++frame) {
        const FrameTimes times = session.renderFrame(0);
        const auto dispatched = pass(session, times, "plain").counts;
        const auto drawn = pass(session, times, "gbuffer").counts;
        ASSERT_EQ(dispatched.has_value(), drawn.has_value());
        if (!drawn) GTEST_SKIP() << "this device does not count";
        // Workgroups of 8 x 8 pixels, 3 x 2 of them.
        EXPECT_EQ(dispatched->computeInvocations, 3U * 2U * 64U);
        EXPECT_EQ(dispatched->vertexInvocations, 0U);
        EXPECT_EQ(dispatched->fragmentInvocations, 0U);
        EXPECT_EQ(drawn->computeInvocations, 0U);
        // The 12 triangles of a box of 24 vertices; a driver may shade a vertex again for each triangle.
        EXPECT_EQ(drawn->clippingInvocations, 12U);
        EXPECT_GE(drawn->vertexInvocations, 8U);
        EXPECT_LE(drawn->vertexInvocations, 36U);
        // Every pixel once or, behind, twice; a software driver counts whole blocks.
        EXPECT_GE(drawn->fragmentInvocations, 20U * 12U);
        EXPECT_LE(drawn->fragmentInvocations, 4U * 20U * 12U);
    }
}

TEST_F(PassCounts, NeedNoDraw) {
    addPass("plain", "pixel", R"("inputs": {"before": {"optional": true, "neutral": [0, 0, 0, 0]}},
                                 "outputs": {"color": {"format": "r32f"}})",
            "void pixel(ivec2 p) { store(color, p, load(before, p) + 1.0); }");
    SessionOptions options = graph(R"("nodes": {"a": {"pass": "plain"},
        "b": {"pass": "plain", "in": {"before": "a.color"}}, "c": {"pass": "plain", "in": {"before": "b.color"}}},
        "outputs": {"color": "c.color"})");
    options.profile = true;
    Session session(options);
    for (int frame = 0; frame < 2; ++frame)
        for (const PassTime& time : session.renderFrame(0).passes) {
            if (!time.counts) GTEST_SKIP() << "this device does not count";
            EXPECT_EQ(time.counts->computeInvocations, 256U);
        }
    EXPECT_EQ(test::valueAt(session, "color", 5, 7), 3);
}

TEST_F(PassCounts, AreMissingWithoutProfiling) {
    SessionOptions options = slab();
    options.profile = false;
    Session session(options);
    const FrameTimes times = session.renderFrame(0);
    EXPECT_FALSE(pass(session, times, "plain").counts);
    EXPECT_FALSE(pass(session, times, "gbuffer").counts);
}

TEST_F(PassCounts, CountNothingWhereAPassOnlyClears) {
    addPass("skipped", "pixel", R"("outputs": {"color": {"format": "r32f", "neutral": [2, 0, 0, 0]}},
                                   "skipWhen": "true")",
            "void pixel(ivec2 p) { store(color, p, vec4(1.0)); }");
    SessionOptions options = graph(R"("nodes": {"s": {"pass": "skipped"}}, "outputs": {"color": "s.color"})");
    options.profile = true;
    Session session(options);
    const FrameTimes times = session.renderFrame(0);
    EXPECT_FALSE(times.passes.at(0).counts);
    EXPECT_EQ(test::valueAt(session, "color", 3, 3), 2);
}

}  // namespace
}  // namespace nephrite::runtime
