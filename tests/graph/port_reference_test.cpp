// References to ports: what each form means, and each fault at its column.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "graph/description.h"
#include "text/faults.h"

namespace nephrite::graph {
namespace {

using nephrite::tests::faultsOf;
using testing::ElementsAre;

/// A reference as it stands in a JSON string that starts at line 3, column 10.
PortReference read(const std::string& text) {
    Diagnostics diagnostics;
    const auto reference = readPortReference(text, {"g.json", 3, 10}, diagnostics);
    diagnostics.throwIfErrors();
    return *reference;
}

TEST(PortReference, PortIsThisFramesWhole) {
    const PortReference plain = read("g-buffer.position");
    EXPECT_EQ(plain.node, "g-buffer");
    EXPECT_EQ(plain.port, "position");
    EXPECT_EQ(plain.framesBack, 0U);
    EXPECT_FALSE(plain.mip);
    EXPECT_FALSE(plain.layer);
    EXPECT_EQ(plain.where, (SourceLocation{"g.json", 3, 10}));
}

TEST(PortReference, ImportIsANodeOfThatName) {
    for (const char* text : {"import(table)", "import( table )"}) {
        EXPECT_EQ(read(text).node, "import(table)");
        EXPECT_EQ(read(text).port, "image");
    }
}

TEST(PortReference, PreviousAddsUp) {
    EXPECT_EQ(read("previous(a.b)").framesBack, 1U);
    EXPECT_EQ(read("previous(a.b, 3)").framesBack, 3U);
    EXPECT_EQ(read("previous(previous(a.b, 3))").framesBack, 4U);
    EXPECT_EQ(read("previous(a.b,64)").framesBack, 64U);
}

TEST(PortReference, MipAndLayerInAnyOrder) {
    for (const char* text :
         {"mip(layer(previous(a.b, 2), 5), 3)", "previous( layer( mip( a.b , 3 ), 5), 2 )"}) {
        const PortReference reference = read(text);
        EXPECT_EQ(reference.node, "a");
        EXPECT_EQ(reference.port, "b");
        EXPECT_EQ(reference.mip, 3U);
        EXPECT_EQ(reference.layer, 5U);
        EXPECT_EQ(reference.framesBack, 2U);
    }
    EXPECT_EQ(read("mip(import(table), 1)").mip, 1U);
}

TEST(PortReference, NodesMayBeCalledAsTheForms) {
    EXPECT_EQ(read("previous.mip").node, "previous");
    EXPECT_EQ(read("previous(import.layer)").node, "import");
}

TEST(PortReference, TextReadsAsTheSameReference) {
    for (const char* text : {"a.b", "import(x)", "previous(a.b)", "previous(a.b, 7)", "mip(a.b, 0)",
                             "layer(mip(import(x), 31), 65534)", "previous(layer(mip(a-1.b_2, 3), 0), 64)"}) {
        EXPECT_EQ(toText(read(text)), text);
    }
    EXPECT_EQ(toText(read("previous(mip(previous(a.b), 2))")), "previous(mip(a.b, 2), 2)");
}

struct Fault {
    std::string name;
    std::string marked;  ///< @ before the fault
    std::string message;
};
class ReferenceFault : public testing::TestWithParam<Fault> {};
TEST_P(ReferenceFault, IsNamedAtItsColumn) {
    std::string text = GetParam().marked;
    const std::size_t at = text.find('@');
    text.erase(at, 1);
    const std::size_t column = at == 0 ? 10 : 11 + at;  // after the quote; a fault of the whole at the quote
    EXPECT_THAT(faultsOf([&] { read(text); }),
                ElementsAre("g.json:3:" + std::to_string(column) + ": error: " + GetParam().message));
}
INSTANTIATE_TEST_SUITE_P(
    All, ReferenceFault,
    testing::Values(
        Fault{"Empty", "@", "expected a \"node.port\", found \"\""},
        Fault{"NoPort", "@a", "expected a \"node.port\", found \"a\""},
        Fault{"ThreeParts", "@a.b.c", "expected a \"node.port\", found \"a.b.c\""},
        Fault{"SpaceBefore", "@ a.b", "expected a \"node.port\", found \" a.b\""},
        Fault{"NoPortInside", "previous(@a)", "expected a \"node.port\", found \"a\""},
        Fault{"NothingInside", "previous(@)", "expected a \"node.port\", found \")\""},
        Fault{"NothingFollows", "mip(@", "expected a \"node.port\", found the end"},
        Fault{"Misspelt", "@prevoius(a.b)",
              "expected \"previous\", \"mip\", \"layer\" or \"import\" before \"(\", found \"prevoius\", did "
              "you "
              "mean \"previous\"?"},
        Fault{"MisspeltInside", "mip(@leyer(a.b, 1), 2)",
              "expected \"previous\", \"mip\", \"layer\" or \"import\" before \"(\", found \"leyer\", did "
              "you mean "
              "\"layer\"?"},
        Fault{"NotClosed", "previous(a.b@", "expected \")\", found the end"},
        Fault{"ClosedTwice", "previous(a.b)@)", "expected the end after \"previous(a.b)\", found \")\""},
        Fault{"ClosedOnly", "a.b@)", "expected the end after \"a.b\", found \")\""},
        Fault{"MipWithoutLevel", "mip(a.b@)", "expected \",\" and a mip level's number, found \")\""},
        Fault{"LayerWithoutIndex", "layer(a.b, @)", "expected an array layer's number, found \")\""},
        Fault{"NegativeMip", "mip(a.b, @-1)", "expected a mip level's number, found \"-1\""},
        Fault{"FractionalMip", "mip(a.b, @1.5)", "expected a mip level's number, found \"1.5\""},
        Fault{"HighMip", "mip(a.b, @32)", "a mip level's number is from 0 to 31, found 32"},
        Fault{"HighLayer", "layer(a.b, @65535)", "an array layer's number is from 0 to 65534, found 65535"},
        Fault{"HugeLayer", "layer(a.b, @99999999999)",
              "expected an array layer's number, found \"99999999999\""},
        Fault{"TwoMips", "mip(layer(@mip(a.b, 1), 2), 3)", "mip(...) stands here twice"},
        Fault{"TwoLayers", "layer(@layer(a.b, 1), 2)", "layer(...) stands here twice"},
        Fault{"NoFrame", "previous(a.b, @0)", "previous(...) goes back 1 to 64 frames, found 0"},
        Fault{"TooFarBack", "previous(a.b, @65)", "previous(...) goes back 1 to 64 frames, found 65"},
        Fault{"TooFarBackTogether", "previous(previous(a.b, 32), @33)",
              "previous(...) goes back 1 to 64 frames, found 65"},
        Fault{"FramesNoNumber", "previous(a.b, @n)", "expected how many frames, found \"n\""},
        Fault{"ImportName", "import(@a.b)", "expected an import's name, found \"a.b\""},
        Fault{"ImportNothing", "import(@)", "expected an import's name, found \")\""},
        Fault{"ImportNotClosed", "previous(import(a@", "expected \")\", found the end"},
        Fault{"ImportNumber", "import(a@, 1)", "expected \")\", found \",\""}),
    [](const auto& test) { return test.param.name; });

TEST(PortReference, NestingWithoutEndIsRefused) {
    std::string deep;
    for (int i = 0; i < 100000; ++i) deep += "previous(";
    const auto faults = faultsOf([&] { read(deep); });
    EXPECT_THAT(faults, ElementsAre("g.json:3:587: error: previous(...) goes back 1 to 64 frames, found 65"));
}

TEST(PortReference, FaultWithoutALineHasNone) {
    const auto faults = faultsOf([] {
        Diagnostics diagnostics;
        readPortReference("mip(a.b)", {"--dump", 0, 0}, diagnostics);
        diagnostics.throwIfErrors();
    });
    EXPECT_THAT(faults, ElementsAre("--dump: error: expected \",\" and a mip level's number, found \")\""));
}

}  // namespace
}  // namespace nephrite::graph
