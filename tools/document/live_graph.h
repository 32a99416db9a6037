// A session that shows a document: what has been edited reaches the picture between two frames.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "document/graph_document.h"
#include "runtime/session.h"

namespace nephrite::document {

/// What a session is to do with a graph beside what its file says.
struct Extras {
    std::vector<std::string> dumps;         ///< ports wanted beside the graph's outputs
    std::optional<graph::Display> display;  ///< the port that is looked at
};

/// The edited text as a session takes it.
runtime::GraphSource sourceOf(const GraphDocument& document, Extras extras);

/// The setting (`NODE.PARAM=JSON`) that makes `graph`, whose text is `before`, what `after` says, if they
/// differ in the value of one parameter and no binding.
std::optional<std::string> settingBetween(const graph::LinkedGraph& graph, const json::Value& before,
                                          const json::Value& after);

class LiveGraph {
  public:
    /// The session, which must outlive this, renders the document's file as `shown` has it.
    LiveGraph(runtime::Session& session, const GraphDocument& shown, Extras extras);

    /// Brings the session to the document and the extras, from the next frame on; true if it had to change.
    /// One parameter's value goes by Session::set, anything else by Session::setGraph, in which history and
    /// programs of passes that stay the same go on. A display's settings count only where the graph is set
    /// anew: they are parameters, too. Throws as these do, and then the session shows what it did.
    bool show(const GraphDocument& document, const Extras& extras);

  private:
    runtime::Session& session_;
    std::shared_ptr<const graph::LinkedGraph> graph_;
    json::Value root_;
    Extras extras_;
};

}  // namespace nephrite::document
