// Who overwrites what: outputs that modify inputs, followed from one version of a resource to the next.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "graph/linked_graph.h"

namespace nephrite::graph {

/// The output that overwrites what an output port holds.
struct Modifier {
    Index node = noIndex;
    Index port = noIndex;   ///< output of `node`
    Index input = noIndex;  ///< linked input: what it overwrites
};

/// By output port, as LinkedGraph::formats; node == noIndex where nobody overwrites it. Where several do,
/// which link() refuses, the first counts.
std::vector<Modifier> findModifiers(const LinkedGraph& graph);

/// Whether two views of one image share a level and a layer.
bool overlap(const LinkedInput& one, const LinkedInput& other);

/// Who overwrites the part of an output port that `view` shows: its modifier, or the modifier of that one's
/// result if the first leaves the part alone, and so on. nullptr if nobody does.
const Modifier* findOverwriter(const LinkedGraph& graph, const std::vector<Modifier>& modifiers,
                               const LinkedInput& view);

/// Why what `view` shows cannot be had at the end of its frame, because somebody has overwritten it; or
/// nothing.
std::optional<std::string> whyGone(const LinkedGraph& graph, const std::vector<Modifier>& modifiers,
                                   const LinkedInput& view);

}  // namespace nephrite::graph
