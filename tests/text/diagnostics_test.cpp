// How faults are worded and which words are suggested.
#include "text/diagnostics.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>

namespace nephrite {
namespace {

using testing::ElementsAre;

TEST(Diagnostics, LineNamesFileLineAndColumn) {
    EXPECT_EQ(toLine({{"a.json", 3, 7}, "expected a number"}), "a.json:3:7: error: expected a number");
    EXPECT_EQ(toLine({{"a.json", 3, 7}, "odd"}, "warning"), "a.json:3:7: warning: odd");
}

TEST(Diagnostics, LineOfAWholeFileHasNoNumbers) {
    EXPECT_EQ(toLine({{"a.ply", 0, 0}, "truncated"}), "a.ply: error: truncated");
}

TEST(Diagnostics, OneFaultIsOneLineWhateverItQuotes) {
    EXPECT_EQ(toLine({{"a\nb", 1, 2}, "x\r\ny"}), "a b:1:2: error: x  y");
}

TEST(Diagnostics, InputErrorCarriesEveryFaultInOrder) {
    Diagnostics diagnostics;
    EXPECT_NO_THROW(diagnostics.throwIfErrors());
    diagnostics.warning({"f", 1, 1}, "only a warning");
    EXPECT_FALSE(diagnostics.hasErrors());
    EXPECT_NO_THROW(diagnostics.throwIfErrors());
    diagnostics.error({"f", 1, 2}, "first");
    diagnostics.error({"f", 3, 4}, "second");
    try {
        diagnostics.throwIfErrors();
        FAIL() << "no InputError";
    } catch (const InputError& error) {
        EXPECT_STREQ(error.what(), "f:1:2: error: first\nf:3:4: error: second");
        EXPECT_EQ(error.faults().size(), 2U);
    }
}

TEST(Diagnostics, QuotesEscapeControlCharactersAndCutLongText) {
    EXPECT_EQ(inQuotes("a\tb\nc\x01"), "\"a\\tb\\nc\\u0001\"");
    const std::string cut = inQuotes(std::string(1000, 'x'));
    EXPECT_EQ(cut, "\"" + std::string(60, 'x') + "...\"");
    // A cut never splits the two bytes of an "é".
    const std::string accents = inQuotes("x" + std::string(40, 'y') +
                                         "\xC3\xA9\xC3\xA9\xC3\xA9\xC3\xA9\xC3\xA9\xC3\xA9"
                                         "\xC3\xA9\xC3\xA9\xC3\xA9\xC3\xA9\xC3\xA9");
    EXPECT_EQ(accents.substr(accents.size() - 6), "\xC3\xA9...\"");
}

std::string suggested(std::string_view found, std::vector<std::string> known) {
    return suggestion(found, std::span<const std::string>(known));
}

TEST(Suggestion, NearestKnownWord) {
    EXPECT_EQ(suggested("postion", {"normal", "position", "depth"}), ", did you mean \"position\"?");
    EXPECT_EQ(suggested("dpeth", {"normal", "position", "depth"}), ", did you mean \"depth\"?");
    EXPECT_EQ(suggested("Depth", {"death", "depth"}), ", did you mean \"depth\"?");
}

TEST(Suggestion, NothingWhenNoneIsNear) {
    EXPECT_EQ(suggested("albedo", {"normal", "position", "depth"}), "");
    EXPECT_EQ(suggested("", {"a"}), "");
    EXPECT_EQ(suggested("x", {}), "");
    EXPECT_EQ(suggested(std::string(100000, 'a'), {std::string(100000, 'a') + "b"}), "");
}

TEST(Suggestion, DistanceGrowsWithLength) {
    // Three letters: one edit is near, two are not.
    EXPECT_EQ(suggested("abc", {"abd"}), ", did you mean \"abd\"?");
    EXPECT_EQ(suggested("abc", {"axd"}), "");
    // Nine letters: three edits.
    EXPECT_EQ(suggested("abcdefghi", {"abcdefxyz"}), ", did you mean \"abcdefxyz\"?");
    EXPECT_EQ(suggested("abcdefghi", {"abcdewxyz"}), "");
}

TEST(Suggestion, TakesStringViewsToo) {
    constexpr std::array<std::string_view, 2> known{"camera", "light"};
    EXPECT_EQ(suggestion("camara", known), ", did you mean \"camera\"?");
}

}  // namespace
}  // namespace nephrite
