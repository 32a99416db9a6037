// Manifests that say what a pass is repeated over, what its outputs modify and where it is limited to a
// domain.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "graph/small_library.h"
#include "text/faults.h"

namespace nephrite::graph {
namespace {

using testing::ElementsAre;

TEST(PassRoles, ForEachIsRead) {
    const auto forEach = [](const std::string& keys) {
        return tests::passFrom(R"({"kind": "pixel", "shader": "s", "outputs": {"c": {"mips": 0}})" + keys +
                               "}")
            .forEach;
    };
    EXPECT_EQ(forEach(""), ForEach::Nothing);
    EXPECT_EQ(forEach(R"(, "forEach": "lights")"), ForEach::Lights);
    EXPECT_EQ(forEach(R"(, "forEach": "mips")"), ForEach::Mips);
    EXPECT_EQ(name(ForEach::Lights), "lights");
    EXPECT_EQ(name(ForEach::Mips), "mips");
    EXPECT_EQ(name(ForEach::Nothing), "");
}

TEST(PassRoles, DomainIsAnInput) {
    const PassType type = tests::passFrom(
        R"({"kind": "pixel", "shader": "s", "domain": "b", "inputs": {"a": {}, "b": {}}, "outputs": {"c": {}}})");
    EXPECT_EQ(type.domain, "b");
    EXPECT_EQ(type.domainInput, 1U);
    EXPECT_EQ(tests::passFrom(R"({"kind": "native"})").domainInput, noIndex);
}

TEST(PassRoles, ModifyingOutputTakesOverTheInputsSort) {
    const PassType type = tests::passFrom(R"({"kind": "compute", "shader": "s",
        "inputs": {"a": {}, "n": {"format": "r32u"}, "list": {"buffer": "uvec2"}},
        "outputs": {"new": {"buffer": "float", "count": 3}, "list2": {"modifies": "list"}, "a2": {"modifies": "a"},
                    "n2": {"modifies": "n"}}})");
    EXPECT_EQ(type.outputs[0].modifiedInput, noIndex);
    EXPECT_EQ(type.outputs[1].modifiedInput, 2U);
    EXPECT_EQ(type.outputs[1].modifies, "list");
    EXPECT_EQ(type.outputs[1].bufferElement, "uvec2");
    EXPECT_EQ(type.outputs[2].modifiedInput, 0U);
    EXPECT_EQ(type.outputs[2].bufferElement, "");
    EXPECT_EQ(type.outputs[3].format, Format::r32u);
}

TEST(PassRoles, ModifyingOutputMayRepeatTheSort) {
    const PassType type =
        tests::passFrom(R"({"kind": "raster", "shader": "s", "inputs": {"depth": {}, "color": {}},
        "outputs": {"depth2": {"modifies": "depth", "format": "d32f"}, "color2": {"modifies": "color", "format": "rgba32f"}}})");
    EXPECT_EQ(type.outputs[0].format, Format::d32f);
    EXPECT_EQ(type.outputs[1].format, Format::rgba32f);
}

struct Fault {
    std::string name;
    std::string marked;
    std::string message;
};
class RoleFault : public testing::TestWithParam<Fault> {};
TEST_P(RoleFault, IsNamedAtItsPlace) {
    const auto text = nephrite::tests::unmarked(GetParam().marked);
    EXPECT_THAT(nephrite::tests::faultsOf([&] { tests::passFrom(text.text); }),
                ElementsAre("p.json:" + text.place + ": error: " + GetParam().message));
}

/// A pass of inputs a, n (unsigned integers), l (a buffer) and o (optional), with what is given.
std::string pass(const std::string& kind, const std::string& outputs, const std::string& more = "") {
    return R"({"kind": ")" + kind +
           R"(", "shader": "s", "inputs": {"a": {}, "n": {"format": "r32u"}, "l": {"buffer": "vec4"},
        "o": {"optional": true}}, "outputs": {)" +
           outputs + "}" + more + "}";
}
std::string modifying(const std::string& keys) {
    return pass("compute", "\"c\": {" + keys + "}");
}

INSTANTIATE_TEST_SUITE_P(
    Modifies, RoleFault,
    testing::Values(
        Fault{"Unknown", modifying(R"("modifies": @"m")"), "unknown input \"m\", did you mean \"a\"?"},
        Fault{"NoString", modifying(R"("modifies": @3)"), "expected an input's name, found the number 3"},
        Fault{"Empty", modifying(R"("modifies": @"")"), "expected an input's name, found \"\""},
        Fault{"Optional", modifying(R"("modifies": @"o")"),
              "\"o\" is optional: an input that is modified must be connected"},
        Fault{"Twice", pass("compute", R"("c": {"modifies": "a"}, "d": {"modifies": @"a"})"),
              "\"c\" modifies \"a\" already"},
        Fault{"Size", modifying(R"("modifies": "a", @"size": [1, 1])"),
              "an output that modifies an input has that input's size"},
        Fault{"Mips", modifying(R"("modifies": "a", @"mips": 2)"),
              "an output that modifies an input has that input's mips"},
        Fault{"Layers", modifying(R"("modifies": "a", @"layers": 2)"),
              "an output that modifies an input has that input's layers"},
        Fault{"Count", modifying(R"("modifies": "l", "buffer": "vec4", @"count": 2)"),
              "an output that modifies an input has that input's count"},
        Fault{"IntegersAsFloats", modifying(R"("modifies": @"n", "format": "r32f")"),
              "\"c\" is an image of floats, but \"n\", which it modifies, is an image of unsigned integers "
              "(r32u)"},
        Fault{"FloatsAsIntegers", modifying(R"("modifies": @"a", "format": "r32u")"),
              "\"c\" is an image of unsigned integers (r32u), but \"a\", which it modifies, is an image of "
              "floats"},
        Fault{"MipsOfRaster", pass("raster", R"("c": {@"mips": 2})"),
              "a raster pass draws to one of its mips"},
        Fault{"LayersOfRaster",
              pass("raster", R"("c": {@"layers": "params.n"}, "d": {"layers": 1})",
                   R"(, "parameters": {"n": {"type": "uint", "default": 1}})"),
              "a raster pass draws to one of its layers"},
        Fault{"OtherBuffer", modifying(R"("modifies": @"l", "buffer": "float")"),
              "\"c\" is a buffer of float, but \"l\", which it modifies, is a buffer of vec4"},
        Fault{"ImageAsBuffer", modifying(R"("modifies": @"a", "buffer": "float")"),
              "\"c\" is a buffer of float, but \"a\", which it modifies, is an image of floats"},
        Fault{"FormatOfBuffer", modifying(R"("modifies": "l", @"format": "rgba32f")"),
              "\"format\" describes an image, but this port is a buffer"},
        Fault{"BufferOfRaster", pass("raster", R"(@"c": {"modifies": "l"})"),
              "a raster pass writes images, it cannot have a buffer as an output"},
        Fault{"InDomain", pass("pixel", R"("c": {"modifies": @"a"})", R"(, "domain": "a")"),
              "a pass with a domain leaves its outputs neutral outside it, so they cannot modify inputs"}),
    [](const auto& test) { return test.param.name; });

INSTANTIATE_TEST_SUITE_P(
    Domain, RoleFault,
    testing::Values(Fault{"Unknown", pass("pixel", R"("c": {})", R"(, "domain": @"m")"),
                          "unknown input \"m\", did you mean \"a\"?"},
                    Fault{"NoString", pass("pixel", R"("c": {})", R"(, "domain": @3)"),
                          "expected an input's name, found the number 3"},
                    Fault{"Compute", pass("compute", R"("c": {})", R"(, "domain": @"a")"),
                          "only a pixel pass has a domain, this one is compute"},
                    Fault{"Buffer", pass("pixel", R"("c": {})", R"(, "domain": @"l")"),
                          "\"l\" is a buffer, a domain is an image of floats"},
                    Fault{"Integers", pass("pixel", R"("c": {})", R"(, "domain": @"n")"),
                          "\"n\" holds unsigned integers, a domain is an image of floats"},
                    Fault{"ForEachMip",
                          pass("pixel", R"("c": {"mips": 0})", R"(, "forEach": "mips", "domain": @"a")"),
                          "a pass that runs for each of its mips has no domain"}),
    [](const auto& test) { return test.param.name; });

INSTANTIATE_TEST_SUITE_P(
    ForEach, RoleFault,
    testing::Values(Fault{"Unknown", pass("pixel", R"("c": {})", R"(, "forEach": @"mip")"),
                          "expected \"lights\" or \"mips\", found \"mip\", did you mean \"mips\"?"},
                    Fault{"RasterMips", "@" + pass("raster", R"("c": {"mips": 0})", R"(, "forEach": "mips")"),
                          "a raster pass draws to one level and cannot run for each of its mips"},
                    Fault{"OneMip", pass("pixel", R"(@"c": {})", R"(, "forEach": "mips")"),
                          "\"c\" has 1 mip, but the pass runs for each of its mips"},
                    Fault{"MipsOfBuffer",
                          pass("compute", R"("d": {"mips": 2}, @"c": {"buffer": "vec4", "count": 1})",
                               R"(, "forEach": "mips")"),
                          "\"c\" is a buffer, but the pass runs for each of its mips"},
                    Fault{"NoOutput", R"(@{"kind": "native", "forEach": "mips"})",
                          "a pass that runs for each of its mips needs an image as an output"}),
    [](const auto& test) { return test.param.name; });

TEST(PassRoles, MipsThatAnExpressionCountsAreAccepted) {
    EXPECT_NO_THROW(tests::passFrom(R"({"kind": "pixel", "shader": "s", "forEach": "mips",
        "outputs": {"c": {"mips": "params.n"}}, "parameters": {"n": {"type": "int", "default": 1}}})"));
    EXPECT_NO_THROW(tests::passFrom(R"({"kind": "compute", "shader": "s", "forEach": "mips",
        "inputs": {"a": {}}, "outputs": {"c": {"modifies": "a"}}})"));
}

}  // namespace
}  // namespace nephrite::graph
