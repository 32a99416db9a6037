// The page of a plan in a real Chromium, used as a reader does.
#include <gtest/gtest.h>

#include <chrono>
#include <fstream>

#include "browser/browser.h"
#include "graph/bench/synthetic_graph.h"
#include "graph/graph_builder.h"
#include "graph/plan_page.h"
#include "graph/plan_support.h"

namespace nephrite::graph::tests {
namespace {

using nephrite::tests::Browser;

/// One browser for all tests of this file.
class PlanPageInBrowser : public testing::Test {
  protected:
    static void SetUpTestSuite() {
        if (!nephrite::tests::findBrowser().empty()) browser_ = std::make_unique<Browser>(1400, 900);
    }
    static void TearDownTestSuite() { browser_.reset(); }
    void SetUp() override {
        if (!browser_) GTEST_SKIP() << "there is no Chromium here";
    }

    void open(const std::string& html) {
        const auto file = folder_.write("plan.html", html);
        browser_->open(file, "document.documentElement?.dataset.readyMs !== undefined");
    }
    void open(const Plan& plan, const PlanMeasurements& measurements = {}) {
        open(planAsHtml(plan, measurements));
    }

    /// Names of the nodes that match, in the order of the data.
    static std::string names(const std::string& selector) {
        return browser_
            ->evaluate("[...document.querySelectorAll('" + selector +
                       "')].map((node) => node.dataset.name).join(' ')")
            .asString();
    }
    static std::string text(const std::string& selector) {
        return browser_->evaluate("document.querySelector('" + selector + "').textContent").asString();
    }
    static int count(const std::string& selector) {
        return browser_->evaluate("document.querySelectorAll('" + selector + "').length").asInt();
    }
    void expectNoComplaint() { EXPECT_EQ(browser_->complaints(), std::vector<std::string>()); }

    static inline std::unique_ptr<Browser> browser_;
    ScratchFolder folder_;
};

Plan examplePlan() {
    CompileRequest opaque = request();
    opaque.facts.translucentMaterials = 0;
    return planOf(R"({"name": "example", "nodes": {
        "dead": {"pass": "source"}, "t": {"pass": "translucent", "in": {"a": "dead.color"}},
        "base": {"pass": "draw"}, "sums": {"pass": "measure", "in": {"a": "base.color"}},
        "last": {"pass": "summary", "in": {"sums": "sums.sums"}}, "other": {"pass": "source"},
        "c": {"pass": "blend", "in": {"a": "last.color", "b": "t.color"}},
        "d": {"pass": "blend", "in": {"a": "c.color", "b": "other.color"}}},
        "outputs": {"color": "d.color"}})",
                  opaque);
}

/// Passes take 1, 2, 4, ... ms.
PlanMeasurements doublingTimes(const Plan& plan) {
    PlanMeasurements measured;
    measured.device = "a device";
    measured.frames = 1;
    for (std::size_t i = 0; i < plan.passes.size(); ++i)
        measured.passes.push_back({static_cast<double>(1U << i), 0, false});
    return measured;
}

TEST_F(PlanPageInBrowser, ShowsEveryNodeEdgeResourceAndBarrier) {
    const Plan plan = examplePlan();
    open(plan);
    EXPECT_EQ(names(".node"), "dead t base sums last other c d color");
    EXPECT_EQ(names(".node.skipped, .node.culled"), "dead t");
    EXPECT_EQ(count(".edge"), 8);
    EXPECT_EQ(count(".edge.off"), 2);
    EXPECT_EQ(count("#timeline .life"), static_cast<int>(plan.resources.size()));
    EXPECT_EQ(count("#barriers tr[data-resource]"), static_cast<int>(plan.schedule.barriers.size()));
    EXPECT_EQ(count("#barriers .batch"), static_cast<int>(plan.schedule.batchCount));
    EXPECT_EQ(browser_->evaluate("document.title"), "Plan of example");
    expectNoComplaint();
}

TEST_F(PlanPageInBrowser, BoxesOfTheTimelineAreLifetimesOverBytes) {
    const Plan plan = examplePlan();
    open(plan);
    const Json::Value boxes = browser_->evaluate(
        "[...document.querySelectorAll('#timeline .life rect')].map((box) => "
        "['x', 'y', 'width', 'height'].map((side) => Number(box.getAttribute(side))))");
    const Json::Value widths =
        browser_->evaluate("document.querySelector('#timeline .column').getAttribute('width') * 1");
    ASSERT_EQ(boxes.size(), plan.resources.size());
    const auto& first = plan.resources[0];
    const double pixelsPerByte = boxes[0][3].asDouble() / static_cast<double>(first.bytes);
    for (Index i = 0; i < plan.resources.size(); ++i) {
        const Resource& resource = plan.resources[i];
        const double column = widths.asDouble();
        EXPECT_NEAR(boxes[i][0].asDouble() - boxes[0][0].asDouble(),
                    (static_cast<double>(resource.first) - first.first) * column, 0.01);
        EXPECT_NEAR(boxes[i][2].asDouble(), (resource.last - resource.first + 1) * column, 0.01);
        EXPECT_NEAR(
            boxes[i][1].asDouble() - boxes[0][1].asDouble(),
            (static_cast<double>(resource.offset) - static_cast<double>(first.offset)) * pixelsPerByte, 0.01);
    }
}

TEST_F(PlanPageInBrowser, AClickMarksWhatANodeNeedsAndWhatItFeeds) {
    open(examplePlan());
    browser_->click(".node[data-name=last]");
    EXPECT_EQ(names(".node.selected"), "last");
    EXPECT_EQ(names(".node.needed"), "base sums");
    EXPECT_EQ(names(".node.fed"), "c d color");
    EXPECT_EQ(text("#details h2"), "last");
    EXPECT_EQ(count("#timeline .life.written"), 1);
    EXPECT_EQ(count("#timeline .life.read"), 1);
    browser_->press("ArrowRight");
    EXPECT_EQ(names(".node.selected"), "c");
    EXPECT_EQ(names(".node.needed"), "base sums last") << "nothing flows from what is skipped";
    browser_->press("Escape");
    EXPECT_EQ(names(".node.selected, .node.needed, .node.fed"), "");
    browser_->click(".node[data-name=t]");
    EXPECT_EQ(names(".node.needed"), "dead") << "of what does not run, what the graph declares";
    expectNoComplaint();
}

TEST_F(PlanPageInBrowser, FiltersHideNodesByStateAndBySpeed) {
    const Plan plan = examplePlan();
    open(plan, doublingTimes(plan));
    browser_->click("#filters [data-state=culled]");
    EXPECT_EQ(names(".node.hidden"), "dead");
    EXPECT_EQ(count(".edge.hidden"), 1);
    browser_->click("#filters [data-state=skipped]");
    EXPECT_EQ(names(".node.hidden"), "dead t");
    browser_->click("#filters [data-state=culled]");
    EXPECT_EQ(names(".node.hidden"), "t");
    browser_->click("#slow");  // of 63 ms: 4 ms are 6.3 %, 2 ms are 3.2 %
    EXPECT_EQ(count(".node:not(.hidden)"), static_cast<int>(plan.passes.size()) - 2);
    EXPECT_EQ(text("#slow-count"), "(4)");
    browser_->click("#slow");
    EXPECT_EQ(names(".node.hidden"), "t");
    expectNoComplaint();
}

TEST_F(PlanPageInBrowser, NamesAreFoundFromTheKeyboard) {
    open(examplePlan());
    browser_->press("/");
    browser_->type("S");
    EXPECT_EQ(names(".node.found"), "base sums last");
    EXPECT_EQ(text("#found"), "3 found");
    browser_->press("Enter");
    EXPECT_EQ(names(".node.selected"), "base");
    browser_->press("Enter");
    EXPECT_EQ(names(".node.selected"), "sums");
    expectNoComplaint();
}

TEST_F(PlanPageInBrowser, WithoutMeasurementsItSaysSo) {
    PlanMeasurements none;
    none.note = "nothing was <b>rendered</b>";
    open(examplePlan(), none);
    EXPECT_EQ(text("#details .note"), none.note);
    EXPECT_TRUE(browser_->evaluate("document.getElementById('slow').disabled").asBool());
}

TEST_F(PlanPageInBrowser, OddNamesAreTextAndNothingElse) {
    const std::string name = "</script><img src=x onerror=alert(1)>\"'&";
    GraphBuilder builder;
    builder.addOutput(builder.addNode(builder.addType(passType("source", PassKind::Pixel, 0, 1)), {}), 0);
    const auto owner = builder.build();
    auto graph = std::make_shared<LinkedGraph>(*owner);
    graph->description.nodes[0].name = name;
    CompileRequest odd = request();
    odd.graph = {std::shared_ptr<const void>(new auto(std::pair(owner, graph))), graph.get()};
    open(compile(odd));
    EXPECT_EQ(text("#passes tbody button"), name);
    EXPECT_EQ(count("img"), 0);
    browser_->click(".node");
    EXPECT_EQ(text("#details h2"), name);
    expectNoComplaint();
}

/// What is wrong with the names of the nodes as they stand on the screen: too small, out of their boxes,
/// broken in a word, or shortened to something that is not the name's two ends. One line each.
constexpr const char* faultsOfNames = R"js((() => {
    const faults = [];
    for (const box of document.querySelectorAll(".node")) {
        const name = box.dataset.name, shown = box.querySelector(".name");
        const size = parseFloat(getComputedStyle(shown).fontSize) * view.zoom;
        if (!(size >= 11)) faults.push(`${name}: ${size} px`);
        const outer = box.getBoundingClientRect(), inner = document.createRange();
        inner.selectNodeContents(shown);
        const text = inner.getBoundingClientRect();
        if (text.width === 0 || text.right > outer.right || text.bottom > outer.bottom)
            faults.push(`${name}: not in its box`);
        if (!box.title.includes(name)) faults.push(`${name}: no tooltip`);
        const words = shown.textContent;
        const [head, tail] = words.split("\u2026");
        if (tail !== undefined && !(head.length >= 3 && tail.length >= 3 && name.startsWith(head) && name.endsWith(tail)))
            faults.push(`${name}: shortened to ${words}`);
        if (tail === undefined && words.replaceAll("\n", "") !== name) faults.push(`${name}: is ${words}`);
        if (words.split("\n").slice(0, -1).some((line) => !/[-_. (]$/.test(line)))
            faults.push(`${name}: broken into ${words}`);
    }
    return faults.slice(0, 5).join("; ");
})())js";

/// A pass that reads tiles, with names that are too long for a box.
std::string longNames() {
    return R"({"nodes": {
        "base": {"pass": "draw"}, "a-name-of-several-words": {"pass": "measure", "in": {"a": "base.color"}},
        "last": {"pass": "summary", "in": {"sums": "a-name-of-several-words.sums"}},
        "anamewithoutanyplacewhereitcouldbebroken": {"pass": "blend", "in": {"a": "last.color", "b": "base.color"}}},
        "outputs": {"color": "anamewithoutanyplacewhereitcouldbebroken.color"}})";
}

TEST_F(PlanPageInBrowser, NamesCanBeReadFromTheStartAndWhileZooming) {
    open(planOf(longNames()));
    EXPECT_EQ(browser_->evaluate(faultsOfNames).asString(), "");
    for (const double zoom : {0.45, 0.6, 1.0, 2.5}) {
        browser_->evaluate("zoomAt(" + std::to_string(zoom) + " / view.zoom)");
        EXPECT_EQ(browser_->evaluate(faultsOfNames).asString(), "") << "at zoom " << zoom;
    }
    expectNoComplaint();
}

TEST_F(PlanPageInBrowser, ASmallGraphFillsItsPane) {
    open(examplePlan());
    const Json::Value shares = browser_->evaluate(
        "[plan.drawing.width * view.zoom / graph.clientWidth, plan.drawing.height * view.zoom / "
        "graph.clientHeight]");
    EXPECT_LE(shares[0].asDouble(), 1);
    EXPECT_LE(shares[1].asDouble(), 1);
    EXPECT_GT(std::max(shares[0].asDouble(), shares[1].asDouble()), 0.85);
    EXPECT_GT(shares[0].asDouble() * shares[1].asDouble(), 0.35);
}

TEST_F(PlanPageInBrowser, WheelDragAndKeysMoveTheGraph) {
    open(examplePlan());
    const std::string place = "[view.x, view.y, view.zoom].map((value) => value.toFixed(3)).join()";
    const std::string whole = browser_->evaluate(place).asString();
    browser_->evaluate(
        "graph.dispatchEvent(new WheelEvent('wheel', {deltaY: -300, clientX: 300, clientY: 300}))");
    const double zoom = browser_->evaluate("view.zoom").asDouble();
    EXPECT_GT(zoom, std::stod(whole.substr(whole.rfind(',') + 1)));
    const double x = browser_->evaluate("view.x").asDouble();
    browser_->evaluate("graph.dispatchEvent(new PointerEvent('pointerdown', {clientX: 300, clientY: 300}))");
    browser_->evaluate("dispatchEvent(new PointerEvent('pointermove', {clientX: 340, clientY: 300}))");
    browser_->evaluate("dispatchEvent(new PointerEvent('pointerup'))");
    EXPECT_NEAR(browser_->evaluate("view.x").asDouble(), x + 40, 1e-6);
    browser_->press("ArrowRight");
    EXPECT_LT(browser_->evaluate("view.x").asDouble(), x + 40);
    browser_->press("f");
    EXPECT_EQ(browser_->evaluate(place).asString(), whole);
    browser_->press("-");
    EXPECT_LT(browser_->evaluate("view.zoom").asDouble(), zoom);
    browser_->click("#fit");
    EXPECT_EQ(browser_->evaluate(place).asString(), whole);
    expectNoComplaint();
}

TEST_F(PlanPageInBrowser, ThreeHundredNodesAreLaidOutInLessThanThreeSeconds) {
    const PassLibrary types = syntheticTypes();
    CompileRequest large = request();
    large.graph = syntheticGraph(GraphShape::Random, 300, 1, types);
    const Plan plan = compile(large);
    const auto start = std::chrono::steady_clock::now();
    const std::string html = planAsHtml(
        plan, doublingTimes(planOf(R"({"nodes": {"a": {"pass": "source"}}, "outputs": {"o": "a.color"}})")));
    const double written =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    open(html);
    const double shown = std::stod(browser_->evaluate("document.documentElement.dataset.readyMs").asString());
    RecordProperty("writtenMs", std::to_string(written));
    RecordProperty("shownMs", std::to_string(shown));
    std::printf("300 nodes: written in %.0f ms, shown after %.0f ms\n", written, shown);
    EXPECT_LT(written + shown, 3000);
    EXPECT_EQ(count(".node:not(.output)"), 300);
    EXPECT_EQ(count(".node.culled"), 90);  // 30 %
    EXPECT_EQ(browser_->evaluate(faultsOfNames).asString(), "");
    EXPECT_EQ(count("#overview:not(.hidden)"), 1) << "there is more than what is seen";
    const Json::Value first = browser_->evaluate(
        "(() => { const box = passNodes[0].element.getBoundingClientRect(), pane = "
        "graph.getBoundingClientRect(); "
        "return box.left >= pane.left && box.top >= pane.top && box.right <= pane.right && box.bottom <= "
        "pane.bottom; })()");
    EXPECT_TRUE(first.asBool()) << "what runs first is seen first";
    browser_->press("/");
    browser_->type("p150");
    browser_->press("Enter");
    EXPECT_EQ(names(".node.selected"), "p150");
    EXPECT_EQ(browser_->evaluate(faultsOfNames).asString(), "");
    browser_->press("Escape");
    browser_->press("f");
    EXPECT_LT(browser_->evaluate("view.zoom").asDouble(), 0.42) << "all of it, too small for names";
    browser_->press("/");
    browser_->type("p151");
    browser_->press("Enter");
    EXPECT_EQ(browser_->evaluate(faultsOfNames).asString(), "") << "large enough to be read again";
    expectNoComplaint();
}

}  // namespace
}  // namespace nephrite::graph::tests
