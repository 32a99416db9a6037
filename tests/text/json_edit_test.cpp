// Edits of JSON texts: what they write, and that nothing else changes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <charconv>
#include <cmath>

#include "text/faults.h"
#include "text/json_edit.h"
#include "text/random_json.h"

namespace nephrite::json {
namespace {

using nephrite::tests::faultsOf;
using testing::ElementsAre;

std::string afterSet(std::string text, const Path& path, std::string_view json) {
    return setAt(parse(std::move(text), "f"), path, json).document().text;
}
std::string afterRemoval(std::string text, const Path& path) {
    return removeAt(parse(std::move(text), "f"), path).document().text;
}

TEST(JsonEdit, ReplacesAValueAlone) {
    EXPECT_EQ(afterSet("// c\n{ \"a\" : 1.50 /* one */, }", {"a"}, " [2] "),
              "// c\n{ \"a\" : [2] /* one */, }");
    EXPECT_EQ(afterSet("{\"a\": {\"b\": [1, 2]}}", {"a", "b", "1"}, "3"), "{\"a\": {\"b\": [1, 3]}}");
    EXPECT_EQ(afterSet("{\"a\": 1.50}", {"a"}, "1.5"), "{\"a\": 1.50}") << "the value is the same";
    EXPECT_EQ(afterSet("[1]", {}, "2"), "2");
}

TEST(JsonEdit, OfAnArrayOnlyWhatDiffers) {
    EXPECT_EQ(afterSet("{\"w\": [ 0.30, // red\n 0.30,\n /* blue */ [5, 6], ]}", {"w"}, "[0.3, 0.4, [5, 7]]"),
              "{\"w\": [ 0.30, // red\n 0.4,\n /* blue */ [5, 7], ]}");
    EXPECT_EQ(afterSet("[1, 2]", {}, "[1]"), "[1]");
}

TEST(JsonEdit, AddsAKeyAsTheLastOneStands) {
    EXPECT_EQ(afterSet("{}", {"a"}, "1"), "{\"a\": 1}");
    EXPECT_EQ(afterSet("{ // none\n}", {"a"}, "1"), "{\"a\": 1 // none\n}");
    EXPECT_EQ(afterSet("{\"a\": 1}", {"b"}, "2"), "{\"a\": 1, \"b\": 2}");
    EXPECT_EQ(afterSet("{\"a\": 1,}", {"b"}, "2"), "{\"a\": 1, \"b\": 2,}");
    EXPECT_EQ(afterSet("{\n  \"a\": 1 // one\n}", {"b"}, "2"), "{\n  \"a\": 1, // one\n  \"b\": 2\n}");
    EXPECT_EQ(afterSet("{\r\n\t\"a\": 1, /* one */ // uno\r\n}", {"b"}, "2"),
              "{\r\n\t\"a\": 1, /* one */ // uno\r\n\t\"b\": 2,\r\n}");
    EXPECT_EQ(afterSet("{\"a\": 1,\n \"b\": {\"c\": 2} }", {"b", "d"}, "3"),
              "{\"a\": 1,\n \"b\": {\"c\": 2, \"d\": 3} }");
    EXPECT_EQ(afterSet("{\"a\": 1,\n \"b\": 2 }", {"c"}, "3"), "{\"a\": 1,\n \"b\": 2,\n \"c\": 3 }");
}

TEST(JsonEdit, MakesTheObjectsOnTheWay) {
    EXPECT_EQ(afterSet("{\"n\": {\"pass\": \"p\"}}", {"n", "set", "taps"}, "3"),
              "{\"n\": {\"pass\": \"p\", \"set\": {\"taps\": 3}}}");
    EXPECT_EQ(afterSet("{}", {"a\"b", "c"}, "3"), "{\"a\\\"b\": {\"c\": 3}}");
}

TEST(JsonEdit, RemovesAKeyAndItsComma) {
    EXPECT_EQ(afterRemoval("{\"a\": 1, \"b\": 2, \"c\": 3}", {"a"}), "{\"b\": 2, \"c\": 3}");
    EXPECT_EQ(afterRemoval("{\"a\": 1, \"b\": 2, \"c\": 3}", {"b"}), "{\"a\": 1, \"c\": 3}");
    EXPECT_EQ(afterRemoval("{\"a\": 1, \"b\": 2, \"c\": 3}", {"c"}), "{\"a\": 1, \"b\": 2}");
    EXPECT_EQ(afterRemoval("{\"a\": 1, \"b\": 2,}", {"b"}), "{\"a\": 1,}");
    EXPECT_EQ(afterRemoval("{\"a\": 1}", {"a"}), "{}");
    EXPECT_EQ(afterRemoval("{\n  \"a\": 1,\n  \"b\": 2\n}", {"a"}), "{\n  \"b\": 2\n}");
    EXPECT_EQ(afterRemoval("{\n  \"a\": 1,\n  \"b\": 2\n}", {"b"}), "{\n  \"a\": 1\n}");
    EXPECT_EQ(afterRemoval("{\"a\": {}}", {"a", "b", "c"}), "{\"a\": {}}") << "there is none";
}

TEST(JsonEdit, CommentsOfNeighboursStay) {
    EXPECT_EQ(afterRemoval("{\n  \"a\": 1, // one\n  \"b\": 2 // two\n}", {"b"}),
              "{\n  \"a\": 1 // one\n  // two\n}");
    EXPECT_EQ(afterRemoval("{\"a\": 1, // one\n  \"b\": 2}", {"b"}), "{\"a\": 1 // one\n  }");
    EXPECT_EQ(afterRemoval("{\"a\": 1 // one\n , \"b\": 2}", {"a"}), "{// one\n  \"b\": 2}");
}

TEST(JsonEdit, RefusesWhatCannotBeDone) {
    EXPECT_THAT(faultsOf([] {
                    afterSet("{\"a\": 1}", {"a", "b"}, "2");
                }),
                ElementsAre("f:1:7: error: expected something with \"b\" in it, found the number 1"));
    EXPECT_THAT(faultsOf([] {
                    afterSet("{\"a\": [1]}", {"a", "1"}, "2");
                }),
                ElementsAre("f:1:7: error: expected something with \"1\" in it, found an array of 1"));
    EXPECT_THAT(faultsOf([] { afterSet("{\"a\": 1}", {"a"}, "1, 2"); }),
                ElementsAre("a:1:2: error: expected nothing after the value, found \",\""));
    EXPECT_THAT(faultsOf([] {
                    afterRemoval("{\"a\": [1]}", {"a", "0"});
                }),
                ElementsAre("f:1:7: error: a.0 is an element of an array"));
}

// Comments within [from, to) of the old text may be gone; no other may.
void expectCommentsStay(const std::string& before, const std::string& after, std::size_t from,
                        std::size_t to) {
    std::vector<std::string> expected, found;
    for (const auto& comment : tests::commentsIn(before))
        if (comment.at < from || comment.at >= to) expected.push_back(comment.text);
    for (const auto& comment : tests::commentsIn(after)) found.push_back(comment.text);
    if (to == 0 || expected.size() == found.size()) {
        EXPECT_EQ(found, expected);
        return;
    }
    // Elements of an array are replaced one by one, and comments between them stay.
    std::size_t matched = 0;
    for (const std::string& comment : found)
        if (matched < expected.size() && comment == expected[matched]) ++matched;
    EXPECT_EQ(matched, expected.size());
}

class RandomEdits : public testing::Test {
  protected:
    Json::Value* targetOf(Json::Value& root, const Path& path) {
        Json::Value* value = &root;
        for (const std::string& step : path)
            value = value->isArray() ? &(*value)[std::stoi(step)] : &(*value)[step];
        return value;
    }
    void set(const Value& root, const Path& path) {
        const std::string json = tests::randomValue(random_);
        Json::Value model = root.raw();
        *targetOf(model, path) = parse(json, "v").raw();
        const Value old = *findAt(root, path);
        const std::string& before = root.document().text;
        const std::string after = setAt(root, path, json).document().text;
        EXPECT_EQ(parse(after, "f").raw(), model);
        EXPECT_EQ(after.substr(0, old.start()), before.substr(0, old.start()));
        const std::size_t behind = before.size() - old.end();
        EXPECT_EQ(after.substr(after.size() - behind), before.substr(old.end()));
        expectCommentsStay(before, after, old.start(), old.end());
    }
    void add(const Value& root, const Path& object) {
        const std::string json = tests::randomValue(random_);
        Path path = object;
        path.push_back("added");
        std::string member = "\"added\":" + json;
        if (tests::oneIn(random_, 3)) path.push_back("in"), member = "\"added\":{\"in\":" + json + "}";
        Json::Value model = root.raw();
        *targetOf(model, path) = parse(json, "v").raw();
        const std::string& before = root.document().text;
        const std::string after = setAt(root, path, json).document().text;
        EXPECT_EQ(parse(after, "f").raw(), model);
        const std::string squeezed = tests::squeezed(after);
        member = tests::squeezed(member);
        const std::size_t at = squeezed.find(member);
        ASSERT_NE(at, std::string::npos);
        EXPECT_EQ(squeezed.substr(0, at) + squeezed.substr(at + member.size()), tests::squeezed(before));
        expectCommentsStay(before, after, 0, 0);
    }
    void remove(const Value& root, const Path& path) {
        const Value old = *findAt(root, path);
        Json::Value model = root.raw();
        targetOf(model, Path(path.begin(), path.end() - 1))->removeMember(path.back());
        const std::string& before = root.document().text;
        const std::string after = removeAt(root, path).document().text;
        EXPECT_EQ(parse(after, "f").raw(), model);
        EXPECT_EQ(tests::squeezed(after), tests::squeezed(before.substr(0, old.keyStart())) +
                                              tests::squeezed(before.substr(old.end())));
        expectCommentsStay(before, after, old.keyStart(), old.end());
    }

    tests::Random random_{5};
};

TEST_F(RandomEdits, DoWhatTheSameEditsOfTheTreeDo) {
    int edits = 0;
    for (int i = 0; i < 1500 && !HasFailure(); ++i) {
        const Value root = parse(tests::randomDocument(random_), "f");
        SCOPED_TRACE(root.document().text);
        std::vector<Path> paths = tests::pathsOf(root);
        add(root, {});
        for (const Path& path : paths) {
            SCOPED_TRACE(toText(path));
            set(root, path);
            if (findAt(root, path)->isObject()) add(root, path);
            if (findAt(root, Path(path.begin(), path.end() - 1))->isObject()) remove(root, path);
            ++edits;
        }
    }
    EXPECT_GT(edits, 5000);
}

TEST_F(RandomEdits, OneAfterTheOtherKeepEveryComment) {
    for (int i = 0; i < 300 && !HasFailure(); ++i) {
        Value root = parse(tests::randomDocument(random_), "f");
        const std::size_t comments = tests::commentsIn(root.document().text).size();
        for (int n = 0; n < 6; ++n) root = setAt(root, {"added" + std::to_string(n)}, "1");
        for (int n = 5; n >= 0; --n) root = removeAt(root, {"added" + std::to_string(n)});
        EXPECT_EQ(tests::commentsIn(root.document().text).size(), comments) << root.document().text;
    }
}

TEST(ShortestNumber, IsAsPeopleWriteIt) {
    EXPECT_EQ(shortestNumber(0.1F), "0.1");
    EXPECT_EQ(shortestNumber(static_cast<double>(0.1F)), "0.10000000149011612");
    EXPECT_EQ(shortestNumber(0.1), "0.1");
    EXPECT_EQ(shortestNumber(12.0), "12");
    EXPECT_EQ(shortestNumber(1e6), "1e6");
    EXPECT_EQ(shortestNumber(-2.5e-7), "-2.5e-7");
    EXPECT_EQ(shortestNumber(16384.0F), "16384");
    EXPECT_EQ(shortestNumber(1000.0), "1000");
    EXPECT_EQ(shortestNumber(6111943458816.0F), "6.1119435e12");
    EXPECT_THROW(shortestNumber(std::nan("")), std::invalid_argument);
}

TEST(ShortestNumber, EveryFloatComesBackFromFewDigits) {
    tests::Random random(7);
    for (int i = 0; i < 200000; ++i) {
        const float value = std::bit_cast<float>(static_cast<std::uint32_t>(random()));
        if (!std::isfinite(value)) continue;
        const std::string text = shortestNumber(value);
        double read = 0;
        std::from_chars(text.data(), text.data() + text.size(), read);
        ASSERT_EQ(static_cast<float>(read), value) << text;
        ASSERT_LE(text.size(), std::string_view("-1.23456789e-38").size()) << text;
        ASSERT_TRUE(parse(text, "f").isNumber()) << text;
    }
}

}  // namespace
}  // namespace nephrite::json
