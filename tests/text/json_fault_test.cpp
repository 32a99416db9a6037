// Malformed JSON: one fault, at the exact place, that says what was expected and what was found.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "text/faults.h"
#include "text/json.h"

namespace nephrite::json {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

struct Malformed {
    std::string name;
    std::string marked;  ///< @ before the place of the fault
    std::string message;
};

class MalformedText : public testing::TestWithParam<Malformed> {};

TEST_P(MalformedText, IsRefusedAtItsPlace) {
    const tests::MarkedText text = tests::unmarked(GetParam().marked);
    const auto faults = tests::faultsOf([&] { parse(text.text, "f.json"); });
    EXPECT_THAT(faults, ElementsAre("f.json:" + text.place + ": error: " + GetParam().message));
}

const std::vector<Malformed> malformed{
    {"Empty", "@", "expected a value, found the end of the text"},
    {"OnlyComment", "// nothing\n@", "expected a value, found the end of the text"},
    {"DuplicateKey", "{\"a\": 1,\n \"b\": 2, @\"a\": 3}", "duplicate key \"a\", this object already has it"},
    {"MissingColon", "{\"a\" @1}", "expected \":\" after the key, found \"1\""},
    {"MissingComma", "{\"a\": 1\n @\"b\": 2}", "expected \",\" or \"}\", found the string \"b\""},
    {"MissingCommaInArray", "[1 @2]", "expected \",\" or \"]\", found \"2\""},
    {"MissingCommaBehindComment", "[1 /* x */ @2]", "expected \",\" or \"]\", found \"2\""},
    {"MissingValue", "{\"a\": @}", "expected a value, found \"}\""},
    {"MissingElement", "[1, @, 2]", "expected a value, found \",\""},
    {"MissingKey", "{@, \"a\": 1}", "expected a key in double quotes or \"}\", found \",\""},
    {"NumberAsKey", "{@1: 2}", "expected a key in double quotes or \"}\", found \"1\""},
    {"WrongBracket", "{\"a\": [1, 2@}}", "expected \",\" or \"]\", found \"}\""},
    {"Unclosed", "{\"a\": [1, 2]@", "expected \",\" or \"}\", found the end of the text"},
    {"TextAfterValue", "{} @{}", "expected nothing after the value, found \"{\""},
    {"WordWithSuggestion", "{\"a\": @tru}",
     "expected a value or a string in double quotes, found the word \"tru\", did you mean \"true\"?"},
    {"BareKey", "{@a: 1}", "expected a value or a string in double quotes, found the word \"a\""},
    {"NotANumberWord", "[@NaN]", "expected a value or a string in double quotes, found the word \"NaN\""},
    {"SingleQuotes", "{@'a': 1}", "unexpected character, found \"'\""},
    {"LoneMinus", "[@-]", "expected a number, found \"-\""},
    {"LeadingZero", "[@012]", "expected a number, found \"012\""},
    {"LeadingPlus", "[@+1]", "expected a number, found \"+1\""},
    {"LeadingPoint", "[@.5]", "expected a number, found \".5\""},
    {"TrailingPoint", "[@5.]", "expected a number, found \"5.\""},
    {"TwoPoints", "[@1.5.5]", "expected a number, found \"1.5.5\""},
    {"EmptyExponent", "[@1e]", "expected a number, found \"1e\""},
    {"Hexadecimal", "[@0x10]", "expected a number, found \"0x10\""},
    {"Overflow", "{\"a\": @1e999}", "the number \"1e999\" is too large for a double"},
    {"OpenString", "{\"a\": @\"abc\n}", "this string has no closing double quote on its line"},
    {"OpenStringAtEnd", "[@\"abc", "this string has no closing double quote on its line"},
    {"ControlCharacter", "[\"a@\tb\"]", "a control character in a string, expected the escape \\u0009"},
    {"UnknownEscape", "[\"a@\\q\"]",
     "unknown escape in a string, expected \\\" \\\\ \\/ \\b \\f \\n \\r \\t or \\uXXXX"},
    {"ShortUnicodeEscape", "[\"@\\u12\"]", "expected four hexadecimal digits after \\u"},
    {"HighSurrogateAlone", "[\"@\\ud800\"]", "half of a surrogate pair in a string"},
    {"LowSurrogateAlone", "[\"@\\udc00\"]", "half of a surrogate pair in a string"},
    {"OpenComment", "{} @/* never closed", "this comment is never closed, expected \"*/\""},
    {"LoneSlash", "{} @/ x", "unexpected character, found \"/\""},
    {"BrokenUtf8", "[\"a@\xFF\"]", "expected UTF-8 text, found the byte 0xFF"},
    {"OverlongUtf8", "[\"@\xC0\xAF\"]", "expected UTF-8 text, found the byte 0xC0"},
    {"WordAlone", "@x", "expected a value or a string in double quotes, found the word \"x\""},
};

INSTANTIATE_TEST_SUITE_P(All, MalformedText, testing::ValuesIn(malformed),
                         [](const auto& test) { return test.param.name; });

TEST(JsonFaults, ByteOrderMarkTakesNoColumn) {
    const auto faults = tests::faultsOf([] { parse("\xEF\xBB\xBF[x]", "f.json"); });
    EXPECT_THAT(faults, ElementsAre(StartsWith("f.json:1:2: error: ")));
}

TEST(JsonFaults, LinesMayEndWithCarriageReturns) {
    EXPECT_THAT(tests::faultsOf([] { parse("[1,\r\n 2,\r\n  x]", "f"); }),
                ElementsAre(StartsWith("f:3:3: error: ")));
    EXPECT_THAT(tests::faultsOf([] { parse("[1,\r 2,\r  3 4]", "f"); }),
                ElementsAre(StartsWith("f:3:5: error: ")));
    EXPECT_THAT(tests::faultsOf([] { parse("[1,\r\n 2 3]", "f"); }),
                ElementsAre(StartsWith("f:2:4: error: ")));
}

TEST(JsonFaults, DeepNestingIsRefusedNotFollowed) {
    for (const char* bracket : {"[", "{\"a\":"}) {
        std::string text;
        for (int i = 0; i < 100000; ++i) text += bracket;
        const auto faults = tests::faultsOf([&] { parse(text, "f"); });
        ASSERT_EQ(faults.size(), 1U);
        EXPECT_THAT(faults[0], HasSubstr("objects and arrays are nested deeper than 100 levels"));
    }
}

TEST(JsonFaults, HundredLevelsAreRead) {
    const std::string text = std::string(100, '[') + std::string(100, ']');
    EXPECT_TRUE(parse(text, "f").isArray());
    EXPECT_THAT(tests::faultsOf([&] { parse("[" + text + "]", "f"); }),
                ElementsAre(StartsWith("f:1:101: error: ")));
}

TEST(JsonFaults, FileThatCannotBeRead) {
    EXPECT_THAT(tests::faultsOf([] { parseFile("/nowhere/x.json"); }),
                ElementsAre("/nowhere/x.json: error: cannot be read: there is no such file"));
    EXPECT_THAT(tests::faultsOf([] { parseFile("/"); }),
                ElementsAre("/: error: cannot be read: it is a folder"));
}

}  // namespace
}  // namespace nephrite::json
