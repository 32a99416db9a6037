// Reading sweeps, their runs, and their tables.
#include "sweep/sweep.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <json/reader.h>

#include <set>
#include <sstream>

#include "sweep/runs.h"
#include "sweep/table.h"
#include "text/faults.h"

namespace nephrite::sweep {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

Sweep read(const std::string& text, const std::string& file = "some/where/sweep.json") {
    return readSweep(json::parse(text, file));
}

Json::Value parsed(const std::string& text) {
    Json::Value value;
    std::istringstream(text) >> value;
    return value;
}

const std::string named = R"("scenes": {"s": "s.json"}, "graphs": {"g": "g.json"})";

/// A fault at the @ and no other.
void expectFault(const std::string& marked, const std::string& message) {
    const tests::MarkedText text = tests::unmarked(marked);
    const auto faults = tests::faultsOf([&] { read(text.text, "sweep.json"); });
    ASSERT_EQ(faults.size(), 1U) << marked;
    EXPECT_THAT(faults[0], StartsWith("sweep.json:" + text.place + ": error: ")) << marked;
    EXPECT_THAT(faults[0], HasSubstr(message)) << marked;
}

TEST(Sweep, IsReadWhole) {
    const Sweep sweep = read(R"({ "name": "all", "doc": "all of it", "sizes": [[64, 48], [8, 8]], // two
        "scenes": {"a": "../a.json", "b": {"scene": "b.json", "reference": "b.exr", "secondHalf": "c.exr", "bins": 4}},
        "graphs": {"slow": {"graph": "/g/slow.json", "set": {"x": 1}, "skip": false}, "fast": "fast.json"},
        "grid": {"node.taps": [1, 2.5], "weights": [[0, 1]]}, "list": [{"y": true}, {}],
        "frames": 7, "warmup": 0, "time": 0.5, "passes": true, "port": "node.radiance", "pictures": "exr", })");
    EXPECT_EQ(sweep.name, "all");
    EXPECT_EQ(sweep.sizes[1], (graph::Extent{8, 8}));
    EXPECT_EQ(sweep.scenes[0].file, "some/a.json");
    EXPECT_EQ(sweep.scenes[1].reference, "some/where/b.exr");
    EXPECT_EQ(sweep.scenes[1].secondHalf, "some/where/c.exr");
    EXPECT_EQ(sweep.scenes[1].bins, 4U);
    EXPECT_EQ(sweep.graphs[0].name, "slow");
    EXPECT_FALSE(sweep.graphs[0].skip);
    EXPECT_EQ(sweep.graphs[0].settings.at(0).text(), "x=1");
    EXPECT_EQ(sweep.grid[0].values[1].text(), "node.taps=2.5");
    EXPECT_EQ(sweep.grid[1].values[0].text(), "weights=[0, 1]");
    EXPECT_EQ(sweep.list[0][0].text(), "y=true");
    EXPECT_EQ(sweep.frames, 7U);
    EXPECT_EQ(sweep.time, 0.5);
    EXPECT_TRUE(sweep.passes);
    EXPECT_EQ(sweep.port, "node.radiance");
    EXPECT_EQ(sweep.pictures, Pictures::Exr);
    EXPECT_EQ(read("{" + named + "}").name, "sweep");
    EXPECT_EQ(read("{" + named + R"(, "timings": false})").frames, 1U);
}

TEST(Sweep, NamesEachFaultAtItsPlace) {
    expectFault("@[]", "a sweep");
    expectFault("@{\"scenes\": {\"s\": \"s\"}}", "a sweep needs \"graphs\"");
    expectFault("{\"scenes\": @{}, \"graphs\": {\"g\": \"g\"}}", "at least one of its scenes");
    expectFault("{" + named + ", @\"gird\": {}}", "did you mean \"grid\"?");
    expectFault("{" + named + ", \"grid\": {\"x\": @[]}}", "an array of values");
    expectFault("{" + named + ", \"grid\": {\"x\": [1, 2, @1.0]}}", "x=1 is there already");
    expectFault("{" + named + ", \"grid\": @3}", "values by parameter");
    expectFault("{" + named + ", \"list\": @[]}", "sets of values");
    expectFault("{" + named + ", \"list\": [{\"x\": 1}, @{\"x\": 1}]}", "this set is there already");
    expectFault("{" + named + ", \"grid\": {\"x\": [1]}, \"list\": [{\"x\": @1}]}",
                "the grid has values of x");
    expectFault("{" + named + ", \"sizes\": [@[0, 1]]}", "whole numbers from 1");
    expectFault("{" + named + ", \"sizes\": [[2, 2], @[2, 2]]}", "there already");
    expectFault("{" + named + ", \"frames\": @0}", "a whole number from 1");
    expectFault("{" + named + ", \"timings\": false, \"passes\": @true}", "without \"timings\"");
    expectFault("{" + named + ", \"pictures\": @\"jpg\"}", "expected \"exr\", \"png\" or false");
    expectFault("{\"graphs\": {\"g\": \"g\"}, \"scenes\": {@\"a/b\": \"s\"}}", "cannot be called");
    expectFault("{\"graphs\": {\"g\": \"g\"}, \"scenes\": {\"s\": @{}}}", "needs \"scene\"");
    expectFault(
        "{\"graphs\": {\"g\": \"g\"}, \"scenes\": {\"s\": {\"scene\": \"s\", \"secondHalf\": @\"h\"}}}",
        "no \"reference\"");
    expectFault("{\"scenes\": {\"s\": \"s\"}, \"graphs\": {\"g\": {\"graph\": \"g\", @\"sett\": {}}}}",
                "did you mean \"set\"?");
}

TEST(Sweep, RefusesMoreRunsThanAnybodyWaitsFor) {
    std::string values = "0";
    for (int i = 1; i < 50; ++i) values += ", " + std::to_string(i);
    const std::string axis = "[" + values + "]";
    expectFault("@{" + named + ", \"grid\": {\"x\": " + axis + ", \"y\": " + axis + ", \"z\": " + axis + "}}",
                "more than 100000");
}

std::vector<std::string> namesOf(const Sweep& sweep) {
    std::vector<std::string> names;
    for (const Run& run : runsOf(sweep)) names.push_back(run.name());
    return names;
}

TEST(Runs, AreEveryCombinationInOrder) {
    const Sweep sweep =
        read(R"({"scenes": {"t": "t", "s": "s"}, "graphs": {"g": {"graph": "g", "set": {"k": 9}}},
        "sizes": [[2, 1]], "list": [{"c": 1}, {"c": 2, "d": 3}], "grid": {"b": [1, 2], "a": [[5, 6]]}})");
    EXPECT_THAT(namesOf(sweep), ElementsAre("t/g/2x1 c=1 b=1 a=[5, 6]", "t/g/2x1 c=1 b=2 a=[5, 6]",
                                            "t/g/2x1 c=2 d=3 b=1 a=[5, 6]", "t/g/2x1 c=2 d=3 b=2 a=[5, 6]",
                                            "s/g/2x1 c=1 b=1 a=[5, 6]", "s/g/2x1 c=1 b=2 a=[5, 6]",
                                            "s/g/2x1 c=2 d=3 b=1 a=[5, 6]", "s/g/2x1 c=2 d=3 b=2 a=[5, 6]"));
    EXPECT_THAT(runsOf(sweep)[2].settings(), ElementsAre("k=9", "c=2", "d=3", "b=1", "a=[5, 6]"));
    EXPECT_THAT(namesOf(read("{" + named + "}")), ElementsAre("s/g/512x512"));
}

TEST(Runs, KeepTheirIdsWhateverStandsBesideThem) {
    const auto ids = [](const std::string& grid) {
        const Sweep sweep = read("{" + named + ", \"grid\": " + grid + "}");
        std::set<std::string> all;
        for (const auto& run : runsOf(sweep)) all.insert(run.id());
        return all;
    };
    const auto few = ids(R"({"x": [1, 2], "y": [3]})");
    const auto many = ids(R"({"y": [7, 3], "x": [2.0, 5, 1]})");
    EXPECT_EQ(few.size(), 2U);
    EXPECT_EQ(many.size(), 6U);
    for (const std::string& id : few) EXPECT_TRUE(many.count(id) == 1) << id;
}

TEST(SweepTable, HasAColumnForEverythingThatARowHas) {
    const std::vector<Json::Value> rows{
        parsed(R"({"id": "1", "scene": "s", "parameters": {"x": 1, "w": [0, 1, 0]}, "error": 0.5,
                   "metrics": {"relRMSE": [1, 2, null]}, "device": "a, b"})"),
        parsed(R"({"id": "2", "scene": "s", "parameters": {"y": true}, "wallMs": {"median": 2},
                   "passes": [{"name": "p", "gpuMs": {"min": 3}, "cpuMs": {"min": 4}}]})")};
    EXPECT_EQ(
        rowsAsCsv(rows),
        "id,scene,parameters.w,parameters.x,error,metrics.relRMSE.R,metrics.relRMSE.G,metrics.relRMSE.B,"
        "device,parameters.y,wallMs.median,passes.p.gpuMs.min,passes.p.cpuMs.min\n"
        "1,s,\"[0, 1, 0]\",1,0.5,1,2,,\"a, b\",,,,\n"
        "2,s,,,,,,,,true,2.000000,3.000000,4.000000\n");
    const Json::Value json = parsed(rowsAsJson("n", rows));
    EXPECT_EQ(json["sweep"], "n");
    EXPECT_EQ(json["runs"][1]["passes"][0]["name"], "p");
}

/// What stands below a column in the table of one row.
std::string fieldOf(const std::string& row, const std::string& column) {
    std::istringstream table(rowsAsCsv({parsed(row)}));
    std::string head;
    std::string line;
    std::getline(std::getline(table, head), line);
    std::istringstream columns(head);
    std::istringstream fields(line);
    for (std::string name, field; std::getline(columns, name, ',') && std::getline(fields, field, ',');)
        if (name == column) return field;
    return "no such column";
}

TEST(SweepTable, RoundsTimesToNanosecondsAndNothingElse) {
    const std::string row = R"({"parameters": {"x": 0.1}, "error": 0.12345678901234567,
        "wallMs": {"median": 12.345678499999, "min": 0.0000004},
        "passes": [{"name": "p", "gpuMs": {"p95": 1234.5}, "cpuMs": {"min": 3.0000006}}]})";
    EXPECT_EQ(fieldOf(row, "wallMs.median"), "12.345678");
    EXPECT_EQ(fieldOf(row, "wallMs.min"), "0.000000");
    EXPECT_EQ(fieldOf(row, "passes.p.gpuMs.p95"), "1234.500000");
    EXPECT_EQ(fieldOf(row, "passes.p.cpuMs.min"), "3.000001");
    EXPECT_EQ(std::stod(fieldOf(row, "parameters.x")), 0.1);
    EXPECT_EQ(std::stod(fieldOf(row, "error")), 0.12345678901234567);
}

TEST(SweepSchema, HasTheKeysOfTheReader) {
    const Json::Value schema = parsed(sweepSchema());
    for (const json::Key& key : sweepKeys())
        EXPECT_TRUE(schema["properties"].isMember(std::string(key.name)));
    EXPECT_EQ(schema["required"].size(), 2U);
    EXPECT_TRUE(schema["definitions"]["scene"]["properties"].isMember("reference"));
}

}  // namespace
}  // namespace nephrite::sweep
