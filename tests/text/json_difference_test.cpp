// Differences of JSON documents, and edits carried over to a text that has changed meanwhile.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "text/json_difference.h"
#include "text/random_json.h"

namespace nephrite::json {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

Value from(std::string text) {
    return parse(std::move(text), "f");
}

TEST(JsonDifferences, AreNamedValueByValue) {
    const Value before = from(R"({"a": 1, "b": {"c": [1, 2], "d": 3}, "e": 4})");
    const Value after = from(R"({"b": {"d": 3.0, "c": [1, 2, 3]}, "a": 1, "f": {"g": {"h": "x"}, "i": {}}})");
    EXPECT_THAT(differences(before, after),
                UnorderedElementsAre(Change{{"e"}, std::nullopt}, Change{{"b", "d"}, "3.0"},
                                     Change{{"b", "c"}, "[1, 2, 3]"}, Change{{"f", "g", "h"}, "\"x\""},
                                     Change{{"f", "i"}, "{}"}));
    EXPECT_THAT(differences(before, before), IsEmpty());
    EXPECT_THAT(differences(from("1"), from("{}")), ElementsAre(Change{{}, "{}"}));
}

TEST(JsonDifferences, MadeOneAfterTheOtherGiveTheOtherDocument) {
    tests::Random random(3);
    for (int i = 0; i < 500; ++i) {
        const Value before = from(tests::randomDocument(random));
        const Value after = from(tests::randomDocument(random));
        Value result = before;
        for (const Change& change : differences(before, after)) result = changed(result, change);
        ASSERT_EQ(result.raw(), after.raw()) << before.document().text << "\n" << after.document().text;
    }
}

TEST(JsonMerge, TakesTheirTextAndMyValues) {
    const Value base = from(R"({"a": 1, "b": 2, "c": {"d": 3}})");
    const Value mine = from(R"({"a": 10, "b": 2, "c": {"d": 3, "new": 5}})");
    const Value theirs = from("{ // theirs\n  \"a\": 1,\n  \"b\": 20,\n  \"c\": {\"d\": 30}\n}");
    const Merge merged = merge(base, mine, theirs);
    EXPECT_EQ(merged.result.document().text,
              "{ // theirs\n  \"a\": 10,\n  \"b\": 20,\n  \"c\": {\"d\": 30, \"new\": 5}\n}");
    EXPECT_THAT(merged.overruled, IsEmpty());
    EXPECT_THAT(merged.lost, IsEmpty());
}

TEST(JsonMerge, SaysWhatBothChangedAndWhatHasNoPlace) {
    const Value base = from(R"({"a": 1, "b": {"c": 2}, "d": 3, "e": 4, "s": 1, "g": {"h": 1}})");
    const Value mine = from(R"({"a": 5, "b": {"c": 6}, "e": 7, "s": 9, "g": {}})");
    const Value theirs = from(R"({"a": 8, "d": 9, "e": 4, "s": 9})");
    const Merge merged = merge(base, mine, theirs);
    EXPECT_EQ(merged.result.document().text, R"({"a": 5, "e": 7, "s": 9})");
    EXPECT_THAT(merged.overruled, UnorderedElementsAre(Change{{"a"}, "5"}, Change{{"d"}, std::nullopt}));
    EXPECT_THAT(merged.lost, ElementsAre(Change{{"b", "c"}, "6"}));
}

TEST(JsonMerge, ObjectsThatBecameSomethingElseHaveNoPlace) {
    const Merge merged = merge(from(R"({"a": {}})"), from(R"({"a": {"b": {"c": 1}}})"), from(R"({"a": 3})"));
    EXPECT_EQ(merged.result.document().text, R"({"a": 3})");
    EXPECT_THAT(merged.lost, ElementsAre(Change{{"a", "b", "c"}, "1"}));
}

}  // namespace
}  // namespace nephrite::json
