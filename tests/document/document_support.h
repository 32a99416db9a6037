// A graph file in a folder of its own with a few pass types, and the document that edits it.
#pragma once

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <memory>
#include <string>

#include "document/graph_document.h"
#include "scratch_folder.h"

namespace nephrite::document::tests {

inline constexpr std::string_view smallGraph = R"(// A small graph.
{ "parameters": {
    "gain": {"value": 0.50, "range": [0, 4], "doc": "factor"},
    "tint": {"value": [1, 0.5, 0.25]} },
  "nodes": {
    "source": {"pass": "source"},   // where it starts
    "blur": {"pass": "blur", "in": {"image": "source.color"}, "set": {"radius": 3, "gain": "$gain"}},
    "sum": {"pass": "sum", "in": {"a": "source.color", "b": "blur.color"},
            "when": "graph.gain > 0"} },
  "outputs": {"color": "sum.color"} }
)";

/// The pass types of smallGraph. blur and sharpen can stand in for each other; sharpen has no "gain".
std::shared_ptr<const graph::PassLibrary> smallPasses();

class WithDocument : public testing::Test {
  protected:
    std::string onDisk() const {
        std::ifstream stream(file_, std::ios::binary);
        return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
    }
    /// smallGraph with one piece of its text replaced.
    static std::string with(std::string_view piece, std::string_view replacement) {
        std::string text(smallGraph);
        const std::size_t at = text.find(piece);
        EXPECT_NE(at, std::string::npos) << piece;
        return text.replace(at, piece.size(), replacement);
    }

    ScratchFolder folder_;
    std::filesystem::path file_ = folder_.write("g.json", std::string(smallGraph));
    GraphDocument document_{file_, smallPasses()};
};

}  // namespace nephrite::document::tests
