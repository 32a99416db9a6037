// Positions and checked access.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <random>

#include "text/faults.h"
#include "text/json.h"

namespace nephrite::json {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::string place(const SourceLocation& where) {
    return std::to_string(where.line) + ":" + std::to_string(where.column);
}

TEST(JsonValue, PositionsOfValuesAndKeys) {
    const Value root = parse("{\n  \"a\": 1,\n  \"list\": [10, {\"in\": true}],\n}", "f.json");
    EXPECT_EQ(root.where(), (SourceLocation{"f.json", 1, 1}));
    EXPECT_EQ(root.whereKey(), root.where());
    EXPECT_EQ(place(root.find("a")->where()), "2:8");
    EXPECT_EQ(place(root.find("a")->whereKey()), "2:3");
    const Value list = *root.find("list");
    EXPECT_EQ(place(list.whereKey()), "3:3");
    EXPECT_EQ(place(list.at(1).where()), "3:16");
    EXPECT_EQ(place(list.at(1).whereKey()), "3:16");
    EXPECT_EQ(place(list.at(1).find("in")->whereKey()), "3:17");
}

TEST(JsonValue, KeyPositionBehindCommentsThatLookLikeKeys) {
    const Value root = parse("{ \"k\" /* \"x\": */ : // \"y\":\n /* : */ [\"z\"], \"l\":{} }", "f");
    EXPECT_EQ(place(root.find("k")->whereKey()), "1:3");
    EXPECT_EQ(place(root.find("k")->where()), "2:10");
    EXPECT_EQ(place(root.find("l")->whereKey()), "2:17");
}

TEST(JsonValue, MembersInTheFilesOrder) {
    std::vector<std::string> keys;
    for (const auto& [key, value] : parse(R"({"z": 1, "a": 2, "m": {"q": 3}, "b": []})", "f").members()) {
        keys.push_back(key);
    }
    EXPECT_THAT(keys, ElementsAre("z", "a", "m", "b"));
}

TEST(JsonValue, SourceTextIsWhatWasWritten) {
    const Value root = parse("{\"a\": [ 1, 2 ,], \"b\": 1.50e0, \"c\": \"\\u0041\"}", "f");
    EXPECT_EQ(root.find("a")->sourceText(), "[ 1, 2 ,]");
    EXPECT_EQ(root.find("b")->sourceText(), "1.50e0");
    EXPECT_EQ(root.find("c")->sourceText(), "\"\\u0041\"");
    EXPECT_EQ(root.find("c")->raw().asString(), "A");
}

TEST(JsonValue, ByteOrderMarkCommentsAndTrailingCommasAreAllowed) {
    const Value root = parse("\xEF\xBB\xBF// one\n{ /* two */ \"a\": [1, 2,], }\n", "f");
    EXPECT_EQ(root.find("a")->size(), 2U);
    EXPECT_EQ(place(root.find("a")->where()), "2:18");
}

TEST(JsonValue, TypesAreWhatJsonSays) {
    const Value root = parse(R"({"t": true, "n": null, "i": 1, "s": "x", "o": {}, "a": []})", "f");
    EXPECT_TRUE(root.find("t")->isBool());
    EXPECT_FALSE(root.find("t")->isNumber());
    EXPECT_TRUE(root.find("n")->isNull());
    EXPECT_TRUE(root.find("i")->isNumber());
    EXPECT_FALSE(root.find("i")->isBool());
    EXPECT_TRUE(root.find("s")->isString());
    EXPECT_TRUE(root.find("o")->isObject());
    EXPECT_TRUE(root.find("a")->isArray());
    EXPECT_FALSE(root.find("missing").has_value());
    EXPECT_FALSE(root.find("i")->find("x").has_value());
}

TEST(JsonValue, CheckedAccessSaysWhatWasFound) {
    const Value root = parse("[\"abc\", 1.5, {}, [], [1], null, true, [1, \"x\"]]", "f");
    Diagnostics diagnostics;
    EXPECT_FALSE(root.at(0).number(diagnostics, "a number"));
    EXPECT_FALSE(root.at(1).integer(diagnostics, "an integer"));
    EXPECT_FALSE(root.at(2).string(diagnostics, "a string"));
    EXPECT_FALSE(root.at(3).boolean(diagnostics, "true or false"));
    EXPECT_FALSE(root.at(4).numbers(diagnostics, "3 numbers", 3));
    EXPECT_FALSE(root.at(5).number(diagnostics, "a number"));
    EXPECT_FALSE(root.at(6).number(diagnostics, "a number"));
    EXPECT_FALSE(root.at(7).numbers(diagnostics, "numbers"));
    std::vector<std::string> lines;
    for (const Diagnostic& fault : diagnostics.errors()) lines.push_back(toLine(fault));
    EXPECT_THAT(lines, ElementsAre("f:1:2: error: expected a number, found the string \"abc\"",
                                   "f:1:9: error: expected an integer, found the number 1.5",
                                   "f:1:14: error: expected a string, found an object",
                                   "f:1:18: error: expected true or false, found an empty array",
                                   "f:1:22: error: expected 3 numbers, found an array of 1",
                                   "f:1:27: error: expected a number, found null",
                                   "f:1:33: error: expected a number, found true",
                                   "f:1:43: error: expected a number, found the string \"x\""));
}

TEST(JsonValue, CheckedAccessReturnsTheValue) {
    const Value root = parse("[1.5, 3e2, -9223372036854775808, \"s\", false, [1, 2.5]]", "f");
    Diagnostics diagnostics;
    EXPECT_EQ(root.at(0).number(diagnostics, ""), 1.5);
    EXPECT_EQ(root.at(1).integer(diagnostics, ""), 300);
    EXPECT_EQ(root.at(2).integer(diagnostics, ""), std::numeric_limits<std::int64_t>::min());
    EXPECT_EQ(root.at(3).string(diagnostics, ""), "s");
    EXPECT_EQ(root.at(4).boolean(diagnostics, ""), false);
    EXPECT_THAT(*root.at(5).numbers(diagnostics, "", 2), ElementsAre(1.0, 2.5));
    EXPECT_FALSE(diagnostics.hasErrors());
}

TEST(JsonObjectReader, NamesUnknownAndMissingKeys) {
    const Value root = parse("{\"type\": \"point\",\n \"postion\": [0,0,0], \"zzzzzz\": 1}", "f");
    Diagnostics diagnostics;
    ObjectReader object(root, "a light", diagnostics);
    EXPECT_TRUE(object.required("type"));
    EXPECT_FALSE(object.required("position"));
    EXPECT_FALSE(object.optional("intensity"));
    object.finish();
    std::vector<std::string> lines;
    for (const Diagnostic& fault : diagnostics.errors()) lines.push_back(toLine(fault));
    EXPECT_THAT(lines,
                ElementsAre("f:1:1: error: a light needs \"position\"",
                            "f:2:2: error: unknown key \"postion\" in a light, did you mean \"position\"?",
                            "f:2:22: error: unknown key \"zzzzzz\" in a light"));
}

TEST(JsonObjectReader, TableSaysWhichKeysAreAllowedAndRequired) {
    constexpr std::array keys{Key{"type", "{}", "", true}, Key{"size", "{}", ""}};
    Diagnostics diagnostics;
    ObjectReader object(parse(R"({"szie": 1})", "f"), "a thing", keys, diagnostics);
    object.finish();
    std::vector<std::string> lines;
    for (const Diagnostic& fault : diagnostics.errors()) lines.push_back(toLine(fault));
    EXPECT_THAT(lines, ElementsAre("f:1:1: error: a thing needs \"type\"",
                                   "f:1:2: error: unknown key \"szie\" in a thing, did you mean \"size\"?"));
}

TEST(JsonObjectReader, RefusesWhatIsNoObjectOnce) {
    Diagnostics diagnostics;
    ObjectReader object(parse("[1]", "f"), "a light", diagnostics);
    EXPECT_FALSE(object.required("type"));
    object.finish();
    ASSERT_EQ(diagnostics.errors().size(), 1U);
    EXPECT_EQ(toLine(diagnostics.errors()[0]),
              "f:1:1: error: expected a light (an object), found an array of 1");
}

TEST(JsonParse, BytesChangedAtRandomNeverCrash) {
    const std::string good =
        "// c\n{\"a\": [1, -2.5e3, \"x\\u00e9\\n\", {\"b\": null}], /* d */ \"c\": true,}";
    std::mt19937 random(1);
    int refused = 0;
    for (int i = 0; i < 20000; ++i) {
        std::string text = good;
        for (int change = 0; change < 3; ++change)
            text[random() % text.size()] = static_cast<char>(random() % 256);
        const auto faults = tests::faultsOf([&] { parse(text, "f"); });
        ASSERT_LE(faults.size(), 1U);
        refused += static_cast<int>(faults.size());
    }
    EXPECT_GT(refused, 10000);
}

}  // namespace
}  // namespace nephrite::json
