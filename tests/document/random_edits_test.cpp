// Random edits of the project's own graphs: whatever is done, comments stay, saving writes what is shown, and
// undo leads back byte by byte.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <random>

#include "document/graph_document.h"
#include "graph/compatible_types.h"
#include "graph/controls.h"
#include "runtime/loading/graph_loading.h"
#include "scratch_folder.h"

namespace nephrite::document {
namespace {

std::string bytesOf(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

/// Lines that hold nothing but a comment.
std::vector<std::string> commentLines(const std::string& text) {
    std::vector<std::string> lines;
    for (std::size_t start = 0; start < text.size();) {
        const std::size_t end = std::min(text.find('\n', start), text.size());
        const std::size_t first = text.find_first_not_of(' ', start);
        if (first < end && text.compare(first, 2, "//") == 0)
            lines.push_back(text.substr(start, end - start));
        start = end + 1;
    }
    return lines;
}

class Editor {
  public:
    Editor(GraphDocument& document, unsigned seed) : document_(document), random_(seed) {}

    void edit() {
        const graph::GraphControls controls =
            graph::controlsOf(*document_.graph(), document_.graph()->values);
        const graph::NodeControls& node = controls.nodes[below(controls.nodes.size())];
        const unsigned kind = static_cast<unsigned>(below(6));
        if (kind == 0) document_.switchNode(node.name, !document_.isOn(node.name));
        if (kind == 1) swap(node);
        if (kind == 2 && !controls.parameters.empty())
            set(controls.parameters[below(controls.parameters.size())]);
        if (kind >= 3 && !node.parameters.empty()) {
            const graph::Control& control = node.parameters[below(node.parameters.size())];
            if (kind == 3) document_.reset(control.target);
            if (kind == 4) document_.revert(control.target);
            if (kind == 5) set(control);
        }
    }

  private:
    std::size_t below(std::size_t count) { return random_() % count; }

    void set(const graph::Control& control) {
        graph::ParameterValue value = control.value;
        const auto [least, most] = control.range.value_or(std::array<double, 2>{0, 1});
        for (double& component : value.components) {
            component = std::uniform_real_distribution<double>(least, most)(random_);
            if (control.type == graph::ParameterType::Bool) component = component < 0.5 ? 0 : 1;
            if (control.type == graph::ParameterType::Int || control.type == graph::ParameterType::Uint)
                component = std::floor(component);
        }
        document_.set(control.target, graph::valueText(control, value));
    }

    void swap(const graph::NodeControls& node) {
        const auto choices = graph::choicesFor(*document_.graph(), node.node, document_.passTypes());
        for (const graph::TypeChoice& choice : choices) {
            if (choice.isCompatible() && choice.name != node.passType)
                return static_cast<void>(document_.swapPass(node.name, choice.name));
        }
    }

    GraphDocument& document_;
    std::mt19937 random_;
};

TEST(RandomEditsOfGraphs, CanAllBeUndoneAndKeepEveryComment) {
    const ScratchFolder folder;
    const std::shared_ptr<const graph::PassLibrary> passes =
        runtime::loadPassTypes(runtime::DataFolders::find(), {});
    const std::filesystem::path graphs = std::filesystem::path(NEPHRITE_SOURCE_DIR) / "graphs";
    unsigned seed = 1;
    for (const auto& entry : std::filesystem::directory_iterator(graphs)) {
        if (entry.path().extension() != ".json") continue;
        SCOPED_TRACE(entry.path());
        const std::string original = bytesOf(entry.path());
        const std::filesystem::path file = folder.write("graph.json", original);
        GraphDocument document(file, passes);
        Editor editor(document, seed++);
        for (int i = 0; i < 90; ++i) {
            editor.edit();
            ASSERT_EQ(commentLines(document.text()), commentLines(original));
        }
        EXPECT_NE(document.undoLabel(), "");
        document.save();
        EXPECT_EQ(bytesOf(file), document.text());
        const GraphDocument read(file, passes);
        EXPECT_EQ(read.graph()->values, document.graph()->values);
        while (!document.undoLabel().empty()) document.undo();
        EXPECT_EQ(document.text(), original);
    }
}

}  // namespace
}  // namespace nephrite::document
