// Edits of a graph made again in a text that somebody else has changed.
#pragma once

#include <functional>

#include "document/graph_document.h"
#include "text/json_difference.h"

namespace nephrite::document {

/// A document that links, with what became of the edits.
struct Rebased {
    json::Value root;
    Rebase report;
};

/// The edits that made `mine` of `base`, made again in `theirs`, which links: all of them if the result
/// links, else one by one those with which it still does. `link` throws InputError.
Rebased rebased(const json::Value& base, const json::Value& mine, const json::Value& theirs,
                const std::function<void(const json::Value&)>& link);

}  // namespace nephrite::document
