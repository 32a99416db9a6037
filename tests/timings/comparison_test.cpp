// Comparisons of made-up dumps whose differences are known.
#include "timings/comparison.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "text/faults.h"
#include "timings/trace_events.h"

namespace nephrite::timings {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

Series series(const std::string& name, double milliseconds, unsigned seed, bool isPass = true) {
    std::mt19937 random(seed);
    std::normal_distribution<double> noise(1, 0.02);
    Series result{name, isPass, {}};
    for (int i = 0; i < 30; ++i) result.ms.push_back(milliseconds * noise(random));
    return result;
}

Dump dump(std::vector<Series> all) {
    return {"d.json", "device", "driver", "scene", 64, 64, true, std::move(all)};
}

Verdict verdictOn(const Comparison& comparison, const std::string& name) {
    for (const ComparedSeries& series : comparison.series)
        if (series.name == name) return series.verdict;
    throw std::runtime_error("no row " + name);
}

TEST(Comparison, SaysWhatChanged) {
    const Dump before = dump({series("same", 5, 1),
                              series("slower", 5, 2),
                              series("faster", 5, 3),
                              series("gone", 5, 4),
                              {"never", true, {}},
                              series("wall", 20, 5, false)});
    const Dump after = dump({series("slower", 6, 6),
                             series("same", 5, 7),
                             series("faster", 2.5, 8),
                             series("new", 5, 9),
                             {"never", true, {}},
                             series("wall", 18.5, 10, false)});
    const Comparison comparison = compare(before, after, {});
    EXPECT_TRUE(comparison.warnings.empty());
    std::vector<std::string> rows;
    for (const ComparedSeries& row : comparison.series) rows.push_back(row.name);
    EXPECT_THAT(rows, ElementsAre("slower", "same", "faster", "new", "gone", "wall"));
    EXPECT_EQ(verdictOn(comparison, "same"), Verdict::Same);
    EXPECT_EQ(verdictOn(comparison, "slower"), Verdict::Slower);
    EXPECT_EQ(verdictOn(comparison, "faster"), Verdict::Faster);
    EXPECT_EQ(verdictOn(comparison, "gone"), Verdict::OnlyBefore);
    EXPECT_EQ(verdictOn(comparison, "new"), Verdict::OnlyAfter);
    EXPECT_EQ(verdictOn(comparison, "wall"), Verdict::Faster);
    EXPECT_NEAR(comparison.series[0].shift->estimate, 1, 0.1);
    const std::string table = asTable(comparison);
    EXPECT_THAT(table,
                HasSubstr("changed: slower (slower), faster (faster), new (only in B), gone (only in A), "
                          "wall (faster)\n"));
    const Json::Value json = test::parsed(asJson(comparison, before, after));
    EXPECT_EQ(json["rows"][0]["verdict"], "slower");
    EXPECT_NEAR(json["rows"][0]["change"].asDouble(), 0.2, 0.02);
    EXPECT_EQ(json["rows"][4]["verdict"], "only in A");
    EXPECT_TRUE(json["rows"][4]["afterMs"].isNull());
    EXPECT_EQ(json["rows"][5]["kind"], "frame");
}

TEST(Comparison, LetsSmallChangesBe) {
    const Dump before = dump({series("p", 5, 1)});
    const Dump after = dump({series("p", 5.2, 2)});
    EXPECT_EQ(verdictOn(compare(before, after, {}), "p"), Verdict::Same);
    EXPECT_EQ(verdictOn(compare(before, after, {0.95, 0, 0}), "p"), Verdict::Slower);
    EXPECT_EQ(verdictOn(compare(before, after, {0.95, 0, 1}), "p"), Verdict::Same);
    EXPECT_THAT(asTable(compare(before, after, {})), HasSubstr("nothing changed beyond the noise"));
}

TEST(Comparison, DoesNotSeeChangesInManyEqualPasses) {
    int changed = 0;
    for (unsigned trial = 0; trial < 200; ++trial) {
        std::vector<Series> before;
        std::vector<Series> after;
        for (unsigned pass = 0; pass < 20; ++pass) {
            before.push_back(series("p" + std::to_string(pass), 5, 1000 * trial + 2 * pass));
            after.push_back(series("p" + std::to_string(pass), 5, 1000 * trial + 2 * pass + 1));
        }
        const Comparison comparison = compare(dump(before), dump(after), {0.95, 0, 0});
        changed += std::any_of(comparison.series.begin(), comparison.series.end(),
                               [](const auto& row) { return row.verdict != Verdict::Same; });
    }
    // 5 % of 200 is 10, with a standard deviation of 3.
    EXPECT_LE(changed, 19);
}

TEST(Comparison, OfTooFewFramesSaysSo) {
    Series before{"p", true, {1, 1.1}};
    Series after{"p", true, {9, 9.1}};
    EXPECT_EQ(verdictOn(compare(dump({before}), dump({after}), {}), "p"), Verdict::TooFewFrames);
}

TEST(Comparison, WarnsOfWhatDoesNotCompare) {
    Dump before = dump({series("p", 5, 1)});
    Dump after = before;
    after.device = "other";
    after.driver = "newer";
    after.width = 128;
    after.profiled = false;
    EXPECT_THAT(compare(before, after, {}).warnings,
                ElementsAre(HasSubstr("another device: \"device\" and \"other\""), HasSubstr("driver"),
                            HasSubstr("\"64 x 64\" and \"128 x 64\""), HasSubstr("\"not profiled\"")));
    before.profiled = false;
    EXPECT_THAT(compare(before, before, {}).warnings, ElementsAre(HasSubstr("only hints")));
}

/// A dump as text, `@` before the fault, and what is said of it.
void expectFault(const std::string& marked, const std::string& message) {
    const tests::MarkedText text = tests::unmarked(marked);
    const auto faults = tests::faultsOf([&] { readDump(json::parse(text.text, "d.json")); });
    ASSERT_EQ(faults.size(), 1U) << marked;
    EXPECT_THAT(faults[0], StartsWith("d.json:" + text.place + ": error: "));
    EXPECT_THAT(faults[0], HasSubstr(message));
}

const std::string head =
    R"("device": "d", "driver": "e", "scene": "s", "width": 1, "height": 2, "profiled": true)";
const std::string wall = R"("wallMs": {"median": 1, "samples": [1, 2]})";

TEST(TimingDump, IsReadWithItsRows) {
    const Dump read = readDump(json::parse("{" + head + ", " + wall + R"(, "else": 1,
        "passes": [{"name": "a", "gpuMs": {"samples": [3]}}],
        "rows": [{"name": "waiting", "cpuMs": {"samples": [4, 5]}}]})",
                                           "d.json"));
    EXPECT_EQ(read.height, 2U);
    EXPECT_TRUE(read.profiled);
    ASSERT_EQ(read.series.size(), 3U);
    EXPECT_EQ(read.series[0].name, "a");
    EXPECT_TRUE(read.series[0].isPass);
    EXPECT_THAT(read.series[1].ms, ElementsAre(4, 5));
    EXPECT_EQ(read.series[2].name, "wall");
}

TEST(TimingDump, IsToldFromOtherFilesInOneLine) {
    for (const auto& [text, whatItIs] :
         {std::pair{"[]", ""}, std::pair{R"({"name": "a graph", "nodes": {}, "outputs": {}})", ""},
          std::pair{R"({"otherData": {"device": "d"}, "traceEvents": []})", " in JSON but a Chrome trace"}}) {
        EXPECT_THAT(tests::faultsOf([&] { readDump(json::parse(text, "d.json")); }),
                    ElementsAre(std::string("d.json: error: this is no timings file") + whatItIs +
                                ": render --timings F.json writes what is compared"));
    }
}

TEST(TimingDump, NamesWhatIsWrong) {
    expectFault("@{" + wall + R"(, "driver": "e", "scene": "s", "width": 1, "height": 2, "profiled": true,
        "passes": [], "rows": []})",
                "a timing dump needs \"device\"");
    expectFault("@{" + head + ", " + wall + ", \"passes\": []}", "needs \"rows\"");
    expectFault("{" + head + ", \"passes\": [], \"rows\": [], \"wallMs\": @{}}", "needs \"samples\"");
    expectFault("{" + head + ", " + wall + ", \"rows\": [], \"passes\": @1}", "expected an array");
    expectFault("{" + head + ", " + wall + ", \"rows\": [], \"passes\": [@{\"name\": \"a\"}]}", "gpuMs");
    expectFault("{" + head + ", " + wall +
                    ", \"rows\": [], \"passes\": [{\"name\": \"a\", \"gpuMs\": {\"samples\": [1, @\"x\"]}}]}",
                "a number");
    expectFault("{" + head + ", " + wall +
                    ", \"rows\": [], \"passes\": [{\"name\": \"a\", \"gpuMs\": {\"samples\": [1]}}, "
                    "{\"name\": @\"a\", \"gpuMs\": {\"samples\": [1]}}]}",
                "another \"a\"");
}

}  // namespace
}  // namespace nephrite::timings
