// `nephrite bench`, run as a user would, on small graphs.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <json/json.h>

#include <algorithm>
#include <fstream>

#include "program.h"

namespace nephrite::tools::test {
namespace {

using testing::HasSubstr;

Json::Value readJson(const std::filesystem::path& file) {
    Json::Value value;
    std::ifstream(file) >> value;
    return value;
}

TEST(BenchCompile, ReportsEverySizeOfAShape) {
    const Workplace place;
    const Answer answer = place.run("bench compile --passes 1,10,200 --shape random --json b.json");
    ASSERT_EQ(answer.status, 0) << answer.errors;
    EXPECT_THAT(answer.output, HasSubstr("us/pass"));
    const Json::Value rows = readJson(place.path() / "b.json");
    ASSERT_EQ(rows.size(), 3U);
    EXPECT_EQ(rows[0]["passes"].asUInt(), 1U);
    EXPECT_EQ(rows[2]["passes"].asUInt(), 200U);
    for (const Json::Value& row : rows) {
        EXPECT_EQ(row["shape"].asString(), "random");
        EXPECT_GT(row["microsecondsPerPass"].asDouble(), 0);
        EXPECT_GT(row["floorMicrosecondsPerPass"].asDouble(), 0);
        EXPECT_GE(row["heapBytes"].asUInt64(), row["peakLiveBytes"].asUInt64());
        EXPECT_LE(row["barrierBatches"].asUInt(), row["naiveBarriers"].asUInt());
        EXPECT_EQ(row["policy"].asString(), "barriers");
    }
}

/// Two results of a chain are alive at once, and each pass but the first waits for the one before it.
TEST(BenchCompile, CompilesAChainToABatchAPass) {
    const Workplace place;
    ASSERT_EQ(place.run("bench compile --passes 50 --shape chain --json b.json").status, 0);
    const Json::Value row = readJson(place.path() / "b.json")[0];
    EXPECT_GE(row["barrierBatches"].asUInt(), 50U);
    EXPECT_LE(row["barrierBatches"].asUInt(), 51U);
    EXPECT_LE(row["peakLiveBytes"].asUInt64(), 2U * 1920 * 1080 * 8);
}

TEST(BenchCompile, KnowsEveryShapeAndBothPolicies) {
    const Workplace place;
    const Answer answer = place.run("bench compile --passes 10 --policy memory --json b.json");
    ASSERT_EQ(answer.status, 0) << answer.errors;
    const Json::Value rows = readJson(place.path() / "b.json");
    std::vector<std::string> shapes;
    for (const Json::Value& row : rows) shapes.push_back(row["shape"].asString());
    EXPECT_THAT(shapes, testing::ElementsAre("random", "chain", "ladder", "fan", "dead-chains"));
    EXPECT_EQ(rows[0]["policy"].asString(), "memory");
}

TEST(BenchCompile, SaysWhatIsWrong) {
    const Workplace place;
    for (const std::string passes : {"0", "ten", "10,,20", "-5", "10000001", "1e3"}) {
        const Answer answer = place.run("bench compile --shape chain --passes " + passes);
        EXPECT_EQ(answer.status, 2) << passes;
        EXPECT_EQ(std::count(answer.errors.begin(), answer.errors.end(), '\n'), 1) << answer.errors;
    }
    const Answer shape = place.run("bench compile --passes 10 --shape randon");
    EXPECT_EQ(shape.status, 2);
    EXPECT_THAT(shape.errors, HasSubstr("did you mean \"random\"?"));
    EXPECT_EQ(place.run("bench compile --passes 10 --policy speed").status, 2);
    EXPECT_EQ(place.run("bench").status, 2);
    EXPECT_EQ(place.run("bench compiler").status, 2);
}

TEST(BenchCompile, FailsWhereItsFileCannotBeWritten) {
    const Workplace place;
    const Answer answer = place.run("bench compile --passes 10 --shape chain --json missing/b.json");
    EXPECT_EQ(answer.status, 1);
    EXPECT_THAT(answer.errors, HasSubstr("missing/b.json: error: "));
}

}  // namespace
}  // namespace nephrite::tools::test
