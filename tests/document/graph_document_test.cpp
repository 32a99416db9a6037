// Edits of a graph file: what they write, what is refused, undo, saving, and a file that changes meanwhile.
#include <gmock/gmock.h>

#include <filesystem>

#include "document/document_support.h"
#include "graph/value_readers.h"
#include "text/faults.h"

namespace nephrite::document {
namespace {

using nephrite::tests::faultsOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using tests::smallGraph;
using Document = tests::WithDocument;

TEST_F(Document, SetsParametersOfGraphAndNodes) {
    document_.set("gain", "0.75");
    EXPECT_EQ(document_.text(), with("0.50", "0.75"));
    document_.undo();
    document_.set("blur.radius", "5");
    EXPECT_EQ(document_.text(), with("\"radius\": 3", "\"radius\": 5"));
    document_.undo();
    document_.set("tint", "[1, 0.5, 1]");
    EXPECT_EQ(document_.text(), with("0.25", "1"));
    EXPECT_EQ(document_.graph()->values.graph[1].components, (std::vector<double>{1, 0.5, 1}));
}

TEST_F(Document, RefusesWithTheReadersWordsAndStaysAsItWas) {
    document_.set("gain", "1");
    const std::string before = document_.text();
    const auto graph = document_.graph();
    const std::string file = file_.string();
    EXPECT_THAT(faultsOf([&] { document_.set("blur.radius", "65"); }),
                ElementsAre("set blur.radius=65: error: radius is out of range, expected 0 to 64, found 65"));
    EXPECT_THAT(faultsOf([&] { document_.set("blur.radius", "many"); }), ElementsAre(HasSubstr("many")));
    EXPECT_THAT(faultsOf([&] { document_.set("blur.radios", "1"); }),
                ElementsAre(HasSubstr("no parameter \"radios\", did you mean \"radius\"?")));
    EXPECT_THAT(faultsOf([&] { document_.set("blurr.radius", "1"); }),
                ElementsAre(file + ": error: the graph has no node \"blurr\", did you mean \"blur\"?"));
    EXPECT_THAT(faultsOf([&] { document_.set("gian", "1"); }),
                ElementsAre(file + ": error: the graph has no parameter \"gian\", did you mean \"gain\"?"));
    EXPECT_THAT(faultsOf([&] { document_.set("gain", "5"); }), ElementsAre(HasSubstr("0 to 4, found 5")));
    EXPECT_THAT(faultsOf([&] { document_.set("tint", "1"); }), ElementsAre(HasSubstr("an array of 3")));
    EXPECT_THAT(faultsOf([&] { document_.swapPass("blur", "sum"); }), testing::SizeIs(testing::Ge(1U)));
    EXPECT_THAT(faultsOf([&] { document_.swapPass("blur", "blurr"); }),
                ElementsAre(HasSubstr("unknown pass \"blurr\", did you mean \"blur\"?")));
    EXPECT_EQ(document_.text(), before);
    EXPECT_EQ(document_.graph(), graph);
    EXPECT_EQ(document_.undoLabel(), "set gain");
}

TEST_F(Document, ResetRemovesASettingAndRevertTakesTheFiles) {
    document_.reset("blur.radius");
    EXPECT_EQ(document_.text(), with("\"radius\": 3, ", ""));
    document_.reset("blur.gain");
    EXPECT_EQ(document_.text(), with(", \"set\": {\"radius\": 3, \"gain\": \"$gain\"}", ""));
    EXPECT_TRUE(document_.differsFromFile("blur.gain"));
    document_.revert("blur.gain");
    document_.revert("blur.radius");
    EXPECT_FALSE(document_.differsFromFile("blur.gain"));
    EXPECT_EQ(document_.text(),
              with("{\"radius\": 3, \"gain\": \"$gain\"}", "{\"gain\": \"$gain\", \"radius\": 3}"));
    document_.set("gain", "2");
    document_.reset("gain");
    EXPECT_THAT(document_.text(), HasSubstr("0.50"));
}

TEST_F(Document, SwitchesNodesOffAndBackToWhatStoodThere) {
    document_.switchNode("sum", false);
    EXPECT_EQ(document_.text(), with("\"graph.gain > 0\"", "false"));
    EXPECT_FALSE(document_.isOn("sum"));
    document_.save();
    document_.set("gain", "0.6");
    document_.switchNode("sum", true);
    EXPECT_EQ(document_.text(), with("0.50", "0.6"));
    document_.switchNode("source", false);
    EXPECT_THAT(document_.text(), HasSubstr("{\"pass\": \"source\", \"when\": false},   // where it starts"));
    document_.switchNode("source", true);
    EXPECT_EQ(document_.text(), with("0.50", "0.6"));
    EXPECT_TRUE(document_.isOn("source"));
}

TEST_F(Document, ANodeThatWasAlwaysOffIsOnWithoutItsCondition) {
    folder_.write("g.json", with("\"graph.gain > 0\"", "0"));
    GraphDocument document(file_, tests::smallPasses());
    EXPECT_FALSE(document.isOn("sum"));
    document.switchNode("sum", true);
    EXPECT_EQ(document.text(), with(",\n            \"when\": \"graph.gain > 0\"", ""));
}

TEST_F(Document, SwapsAPassAndDropsWhatItDoesNotHave) {
    EXPECT_THAT(document_.swapPass("blur", "sharpen"), ElementsAre("set.gain"));
    EXPECT_EQ(
        document_.text(),
        with("\"blur\", \"in\": {\"image\": \"source.color\"}, \"set\": {\"radius\": 3, \"gain\": \"$gain\"}",
             "\"sharpen\", \"in\": {\"image\": \"source.color\"}, \"set\": {\"radius\": 3}"));
    document_.undo();
    EXPECT_EQ(document_.text(), smallGraph);
    document_.set("blur.radius", "9");
    EXPECT_THAT(document_.swapPass("blur", "sharpen"), ElementsAre("set.radius", "set.gain")) << "at most 8";
}

TEST_F(Document, UndoesAndRedoesEveryEdit) {
    std::vector<std::string> texts{document_.text()};
    const auto edit = [&](auto change) {
        change();
        texts.push_back(document_.text());
    };
    edit([&] { document_.set("gain", "1"); });
    edit([&] { document_.switchNode("blur", false); });
    edit([&] { document_.swapPass("blur", "sharpen"); });
    EXPECT_EQ(document_.undoLabel(), "swap blur for sharpen");
    for (std::size_t i = 3; i > 0; --i) {
        EXPECT_EQ(document_.text(), texts[i]);
        document_.undo();
    }
    EXPECT_EQ(document_.text(), smallGraph);
    EXPECT_FALSE(document_.isModified());
    EXPECT_EQ(document_.undoLabel(), "");
    document_.undo();
    for (std::size_t i = 1; i <= 3; ++i) {
        document_.redo();
        EXPECT_EQ(document_.text(), texts[i]);
    }
    document_.undo();
    EXPECT_EQ(document_.redoLabel(), "swap blur for sharpen");
    document_.set("gain", "2");
    EXPECT_EQ(document_.redoLabel(), "");
    EXPECT_EQ(document_.graph()->values.graph[0].components[0], 2);
}

TEST_F(Document, ADragIsOneEdit) {
    document_.set("gain", "1");
    for (const char* value : {"2", "3", "3.5"}) document_.set("gain", value, Gesture::Continues);
    document_.set("gain", "1.5");
    document_.set("tint", "[0, 0, 0]", Gesture::Continues);
    document_.undo();
    EXPECT_THAT(document_.text(), HasSubstr("\"value\": 1.5"));
    document_.undo();
    EXPECT_THAT(document_.text(), HasSubstr("\"value\": 3.5"));
    document_.set("gain", "4", Gesture::Continues);
    document_.undo();
    EXPECT_THAT(document_.text(), HasSubstr("\"value\": 3.5"));
    document_.undo();
    EXPECT_EQ(document_.text(), smallGraph);
}

TEST_F(Document, SavesWhatChangedAndNothingElse) {
    document_.set("gain", "0.75");
    EXPECT_TRUE(document_.isModified());
    EXPECT_EQ(onDisk(), smallGraph);
    EXPECT_FALSE(document_.save().fileChanged);
    EXPECT_EQ(onDisk(), with("0.50", "0.75"));
    EXPECT_FALSE(document_.isModified());
    document_.undo();
    EXPECT_TRUE(document_.isModified());
    document_.save();
    EXPECT_EQ(onDisk(), smallGraph);
    std::filesystem::remove(file_);
    document_.save();
    EXPECT_EQ(onDisk(), smallGraph) << "written anew";
}

TEST_F(Document, EditsAreMadeAgainOnTopOfAChangedFile) {
    document_.set("blur.radius", "5");
    document_.set("gain", "1");
    folder_.write("g.json", "// theirs\n" + with("[1, 0.5, 0.25]", "[0, 0, 1]"));
    const Rebase report = document_.save();
    EXPECT_TRUE(report.fileChanged);
    EXPECT_THAT(report.overruled, IsEmpty());
    EXPECT_THAT(report.dropped, IsEmpty());
    EXPECT_EQ(onDisk(), document_.text());
    std::string expected = "// theirs\n" + with("[1, 0.5, 0.25]", "[0, 0, 1]");
    const std::string theirs = expected;
    expected.replace(expected.find("\"radius\": 3"), 11, "\"radius\": 5");
    const std::string afterOne = expected;
    expected.replace(expected.find("0.50"), 4, "1");
    EXPECT_EQ(onDisk(), expected);
    document_.undo();
    EXPECT_EQ(document_.text(), afterOne);
    document_.undo();
    EXPECT_EQ(document_.text(), theirs);
    EXPECT_EQ(document_.undoLabel(), "");
    document_.redo();
    document_.redo();
    EXPECT_EQ(document_.text(), expected);
}

TEST_F(Document, ReportsWhatBothChangedAndWhatNoLongerFits) {
    document_.set("gain", "1");
    document_.set("blur.radius", "20");
    folder_.write("g.json", [&] {
        std::string text = with("0.50", "2");
        text.replace(text.find("\"pass\": \"blur\""), 14, "\"pass\": \"sharpen\"");
        return text.erase(text.find(", \"gain\": \"$gain\""), 17);
    }());
    const Rebase report = document_.reload();
    EXPECT_THAT(report.overruled, ElementsAre("parameters.gain.value"));
    EXPECT_THAT(report.dropped,
                ElementsAre("nodes.blur.set.radius: radius is out of range, expected 0 to 8, found 20"));
    EXPECT_THAT(document_.text(), HasSubstr("\"gain\": {\"value\": 1,"));
    EXPECT_THAT(document_.text(), HasSubstr("\"set\": {\"radius\": 3}"));
}

TEST_F(Document, AnEditOfANodeThatIsGoneIsDropped) {
    document_.set("blur.radius", "20");
    folder_.write("g.json",
                  R"({"nodes": {"source": {"pass": "source"}}, "outputs": {"color": "source.color"}})");
    EXPECT_THAT(document_.reload().dropped, ElementsAre("nodes.blur.set.radius: what it was set in is gone"));
    EXPECT_FALSE(document_.isModified());
    EXPECT_EQ(document_.undoLabel(), "");
}

TEST_F(Document, ABrokenFileIsReportedAndNotOverwritten) {
    document_.set("gain", "1");
    const std::string edited = document_.text();
    for (const std::string& broken :
         {with("[0, 4]", "[0, 4"), with("\"pass\": \"sum\"", "\"pass\": \"sun\"")}) {
        folder_.write("g.json", broken);
        EXPECT_THAT(faultsOf([&] { document_.reload(); }), testing::SizeIs(testing::Ge(1U)));
        EXPECT_THAT(faultsOf([&] { document_.save(); }), ElementsAre(HasSubstr(file_.string() + ":")));
        EXPECT_EQ(onDisk(), broken);
        EXPECT_EQ(document_.text(), edited);
    }
    folder_.write("g.json", std::string(smallGraph));
    document_.save();
    EXPECT_EQ(onDisk(), edited);
}

TEST_F(Document, AFileThatOnlyTheEditsWouldRepairIsBroken) {
    document_.swapPass("blur", "sharpen");
    folder_.write("g.json", with("\"pass\": \"blur\"", "\"pass\": \"blurr\""));
    EXPECT_THAT(faultsOf([&] { document_.reload(); }), ElementsAre(HasSubstr("unknown pass \"blurr\"")));
}

TEST_F(Document, OtherPassTypesAreTakenOnlyIfTheGraphStillLinks) {
    const auto before = document_.graph();
    EXPECT_THROW(document_.setPassTypes(std::make_shared<graph::PassLibrary>()), InputError);
    EXPECT_EQ(document_.graph(), before);
    document_.set("gain", "1");
    document_.setPassTypes(tests::smallPasses());
    EXPECT_EQ(before->nodes[0].type->name, "source") << "its pass types live as long as it does";
}

TEST_F(Document, KeepsNoMoreVersionsThanAnybodyUndoes) {
    for (int i = 0; i < 500; ++i) document_.set("gain", std::to_string(i % 4) + ".5");
    int undone = 0;
    for (; !document_.undoLabel().empty() && undone < 500; ++undone) document_.undo();
    EXPECT_EQ(undone, 99);
}

}  // namespace
}  // namespace nephrite::document
