// The expression language: values, precedence, faults with exact columns.
#include "graph/expression.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>

#include "graph/small_library.h"
#include "text/faults.h"

namespace nephrite::graph {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using Space = ExpressionName::Space;

double valueOf(const std::string& text, const std::map<std::string, double>& names = {}) {
    return tests::expression(text).evaluate([&](const ExpressionName& name) { return names.at(name.name); });
}

struct Case {
    std::string text;
    double value;
};
class ExpressionValue : public testing::TestWithParam<Case> {};
TEST_P(ExpressionValue, IsThatOfArithmetic) {
    EXPECT_EQ(valueOf(GetParam().text), GetParam().value) << GetParam().text;
}
INSTANTIATE_TEST_SUITE_P(
    All, ExpressionValue,
    testing::Values(
        // Numbers and booleans.
        Case{"12", 12}, Case{"0.25", 0.25}, Case{".5", 0.5}, Case{"1e3", 1000}, Case{"2.5e-1", 0.25},
        Case{"true", 1}, Case{"false", 0}, Case{"  7\t", 7},
        // * and / before + and -, each from left to right.
        Case{"2 + 3 * 4", 14}, Case{"2 * 3 + 4", 10}, Case{"10 - 4 - 3", 3}, Case{"100 / 10 / 5", 2},
        Case{"2 - 3 + 4", 3}, Case{"12 / 4 * 3", 9}, Case{"2 * (3 + 4)", 14}, Case{"(2 + 3) * (4 - 1)", 15},
        // Prefix operators bind tightest.
        Case{"-2 + 5", 3}, Case{"-2 * -3", 6}, Case{"3 - -2", 5}, Case{"--2", 2}, Case{"!0", 1},
        Case{"!5", 0}, Case{"!!5", 1}, Case{"!0 == 1", 1}, Case{"!(0 == 1)", 1}, Case{"-(2 + 3)", -5},
        Case{"!true || true", 1}, Case{"!(true || true)", 0},
        // Arithmetic before comparison before equality before && before ||.
        Case{"1 + 1 == 2", 1}, Case{"1 < 2 == true", 1}, Case{"3 > 2 == 2 > 1", 1},
        Case{"2 == 2 && 3 == 4", 0}, Case{"1 || 1 && 0", 1}, Case{"(1 || 1) && 0", 0}, Case{"0 && 0 || 1", 1},
        Case{"2 <= 2", 1}, Case{"2 >= 3", 0}, Case{"2 < 2", 0}, Case{"3 > 2", 1}, Case{"2 != 2", 0},
        Case{"2 != 3", 1}, Case{"5 && 7", 1}, Case{"0 || 7", 1}, Case{"1 - 1 || 0", 0}));

TEST(Expression, DivisionByZeroIsAnInfinityAsInIeee754) {
    EXPECT_EQ(valueOf("1 / 0"), std::numeric_limits<double>::infinity());
    EXPECT_EQ(valueOf("-1 / 0"), -std::numeric_limits<double>::infinity());
    EXPECT_TRUE(std::isnan(valueOf("0 / 0")));
    EXPECT_EQ(valueOf("0 / 0 == 0 / 0"), 0);
}

TEST(Expression, NamesAndTheirPlaces) {
    const Expression e = tests::expression(
        "params.taps > params.w[2] && graph.on || $size < scene.objects + inputs.ao.neutral");
    ASSERT_EQ(e.names().size(), 6U);
    const auto place = [](std::uint32_t column) { return SourceLocation{"e", 1, column}; };
    EXPECT_EQ(e.names()[0], (ExpressionName{Space::Parameter, "taps", std::nullopt, place(1)}));
    EXPECT_EQ(e.names()[1], (ExpressionName{Space::Parameter, "w", 2, place(15)}));
    EXPECT_EQ(e.names()[2], (ExpressionName{Space::GraphParameter, "on", std::nullopt, place(30)}));
    EXPECT_EQ(e.names()[3], (ExpressionName{Space::GraphParameter, "size", std::nullopt, place(42)}));
    EXPECT_EQ(e.names()[4], (ExpressionName{Space::SceneFact, "objects", std::nullopt, place(50)}));
    EXPECT_EQ(e.names()[5], (ExpressionName{Space::InputNeutral, "ao", std::nullopt, place(66)}));
}

TEST(Expression, NamesTakeTheirValuesFromTheLookup) {
    EXPECT_EQ(valueOf("params.a * 2 + scene.b / graph.c", {{"a", 3}, {"b", 10}, {"c", 4}}), 8.5);
    EXPECT_EQ(valueOf("inputs.x.neutral || params.y", {{"x", 0}, {"y", 1}}), 1);
}

TEST(Expression, LiteralIsKnownOnlyWithoutNames) {
    EXPECT_EQ(tests::expression("2 * -3").literal(), -6);
    EXPECT_FALSE(tests::expression("params.a").literal().has_value());
    EXPECT_EQ(Expression::constant(4).literal(), 4);
    EXPECT_EQ(Expression::constant(0.5).text(), "0.5");
}

TEST(Expression, GraphParameterIsADollarName) {
    const Expression e = Expression::graphParameter("size", {"g", 4, 2});
    EXPECT_EQ(e.text(), "$size");
    ASSERT_EQ(e.names().size(), 1U);
    EXPECT_EQ(e.names()[0], (ExpressionName{Space::GraphParameter, "size", std::nullopt, {"g", 4, 2}}));
    EXPECT_EQ(e.evaluate([](const ExpressionName&) { return 7.0; }), 7);
}

struct Fault {
    std::string marked;
    std::string message;
};
class ExpressionFault : public testing::TestWithParam<Fault> {};
TEST_P(ExpressionFault, NamesItsColumn) {
    const auto text = nephrite::tests::unmarked(GetParam().marked);
    EXPECT_THAT(nephrite::tests::faultsOf([&] { tests::expression(text.text); }),
                ElementsAre("e:" + text.place + ": error: " + GetParam().message));
}
const std::string operand =
    "expected a number or one of params.X, graph.X, scene.X and inputs.X.neutral, found ";
INSTANTIATE_TEST_SUITE_P(
    All, ExpressionFault,
    testing::Values(
        Fault{"@", "expected a number, a name or \"(\", found the end of the expression"},
        Fault{"1 +@", "expected a number, a name or \"(\", found the end of the expression"},
        Fault{"1 @2", "expected an operator, found \"2\""}, Fault{"1 + @* 2", operand + "\"*\""},
        Fault{"@(1 + 2", "this \"(\" is never closed"}, Fault{"@(1 + (2 * 3)", "this \"(\" is never closed"},
        Fault{"1 + 2@)", "this \")\" closes nothing"}, Fault{"(@)", operand + "\")\""},
        Fault{"1 @= 2", "expected an operator, found \"=\""},
        Fault{"1 @& 2", "expected an operator, found \"&\""},
        Fault{"@parms.x", operand + "\"parms\", did you mean \"params\"?"},
        Fault{"1 + @frue", operand + "\"frue\", did you mean \"true\"?"},
        Fault{"params@", "expected \".\" and a name after \"params\", found the end of the expression"},
        Fault{"params.@", "expected a name after \"params\", found the end of the expression"},
        Fault{"$@ + 1", "expected a name after \"$\", found \" \""},
        Fault{"inputs.a@ + 1", "expected \".neutral\" after inputs.a, found \" \""},
        Fault{"inputs.a@.natural", "expected \".neutral\" after inputs.a, found \".\""},
        Fault{"params.a[@x]", "expected an element's number, found \"x\""},
        Fault{"params.a[@-1]", "expected an element's number, found \"-\""},
        Fault{"params.a[@99999999999]", "expected an element's number, found \"99999999999\""},
        Fault{"params.a[1@", "expected \"]\" after the element's number, found the end of the expression"},
        Fault{"graph.a@[0]", "expected an operator, found \"[\""},
        Fault{"@previous(a.b)", operand + "\"previous\""},
        Fault{"1 + @3px", "expected an operator after the number 3"},
        Fault{"@1.2.3", "expected an operator after the number 1.2"},
        Fault{"@1e999", "out of a double's range: the number 1e999"},
        Fault{"@\xC3\xA9", operand + "\"\xC3\xA9\""}));

TEST(Expression, ColumnsCountFromWhereTheTextStands) {
    Diagnostics diagnostics;
    EXPECT_FALSE(Expression::compile("1 + ?", {"g.json", 7, 20}, diagnostics));
    ASSERT_EQ(diagnostics.errors().size(), 1U);
    EXPECT_EQ(diagnostics.errors()[0].where, (SourceLocation{"g.json", 7, 24}));
}

TEST(Expression, DeepNestingIsRefusedNotFollowed) {
    const auto fault = [](const std::string& text) {
        const auto faults = nephrite::tests::faultsOf([&] { tests::expression(text); });
        return faults.size() == 1 ? faults[0] : "";
    };
    EXPECT_EQ(fault(std::string(100000, '(')),
              "e:1:1: error: an expression has at most 4096 characters, found 100000");
    EXPECT_EQ(fault(std::string(4000, '(')), "e:1:201: error: parentheses are nested deeper than 200 levels");
    EXPECT_EQ(valueOf(std::string(200, '(') + "7" + std::string(200, ')')), 7);
    EXPECT_EQ(valueOf(std::string(4000, '-') + "7"), 7);
    EXPECT_EQ(valueOf(std::string(4001 - 2, '!') + "7"), 0);
}

/// Random expressions, written out and computed side by side, with every parenthesis in place.
struct RandomExpression {
    std::mt19937 random{7};
    std::string text;
    double value = 0;

    void grow(int steps) {
        value = number();
        text = std::to_string(static_cast<int>(value));
        for (int i = 0; i < steps; ++i) wrap();
    }
    double number() { return static_cast<double>(random() % 9 + 1); }
    void wrap() {
        const double right = number();
        const std::string rightText = std::to_string(static_cast<int>(right));
        switch (random() % 8) {
            case 0:
                text = "(" + text + ") + " + rightText;
                value = value + right;
                break;
            case 1:
                text = rightText + " - (" + text + ")";
                value = right - value;
                break;
            case 2:
                text = "(" + text + ") * " + rightText;
                value = value * right;
                break;
            case 3:
                text = "(" + text + ") / " + rightText;
                value = value / right;
                break;
            case 4:
                text = "-(" + text + ")";
                value = -value;
                break;
            case 5:
                text = "(" + text + ") < " + rightText;
                value = value < right ? 1 : 0;
                break;
            case 6:
                text = "(" + text + ") >= " + rightText;
                value = value >= right ? 1 : 0;
                break;
            default:
                text = rightText + " * (" + text + ") - 1";
                value = right * value - 1;
                break;
        }
    }
};

TEST(Expression, RandomExpressionsAgreeWithArithmetic) {
    RandomExpression expression;
    for (int i = 0; i < 2000; ++i) {
        expression.grow(static_cast<int>(i % 40));
        ASSERT_EQ(valueOf(expression.text), expression.value) << expression.text;
    }
}

}  // namespace
}  // namespace nephrite::graph
