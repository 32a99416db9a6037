// A session that shows a document: what has been edited reaches the picture between two frames.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "document/graph_document.h"
#include "runtime/session.h"

namespace nephrite::document {

/// The edited text as a session takes it, with the ports that are wanted beside the graph's outputs.
runtime::GraphSource sourceOf(const GraphDocument& document, std::vector<std::string> dumps);

/// The setting (`NODE.PARAM=JSON`) that makes `graph`, whose text is `before`, what `after` says, if they
/// differ in the value of one parameter and no binding.
std::optional<std::string> settingBetween(const graph::LinkedGraph& graph, const json::Value& before,
                                          const json::Value& after);

class LiveGraph {
  public:
    /// The session, which must outlive this, renders the document's file as `shown` has it.
    LiveGraph(runtime::Session& session, const GraphDocument& shown, std::vector<std::string> dumps);

    /// Brings the session to the document and the dumps, from the next frame on; true if it had to change.
    /// One parameter's value goes by Session::set, anything else by Session::setGraph, in which history and
    /// programs of passes that stay the same go on. Throws as these do, and then the session shows what it
    /// did.
    bool show(const GraphDocument& document, const std::vector<std::string>& dumps);

  private:
    runtime::Session& session_;
    std::shared_ptr<const graph::LinkedGraph> graph_;
    json::Value root_;
    std::vector<std::string> dumps_;
};

}  // namespace nephrite::document
