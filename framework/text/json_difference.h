// What differs between two JSON documents, value by value, and edits carried over to a third.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "text/json_edit.h"

namespace nephrite::json {

/// One value of a document set, or taken away.
struct Change {
    Path path;
    std::optional<std::string> json;  ///< as written; nothing: the member is removed

    friend bool operator==(const Change&, const Change&) = default;
};

/// What turns the values of `before` into those of `after`. Objects are compared member by member, a new one
/// gives a change for each value in it; arrays are compared as a whole.
std::vector<Change> differences(const Value& before, const Value& after);

/// The document with the change made, see setAt and removeAt.
Value changed(const Value& root, const Change& change);

/// The edits that made `mine` of `base`, made again in `theirs`.
struct Merge {
    Value result;
    std::vector<Change> overruled;  ///< made, although `theirs` has another value there than `base`, too
    std::vector<Change> lost;       ///< not made: the object they were made in is gone
};
Merge merge(const Value& base, const Value& mine, const Value& theirs);

}  // namespace nephrite::json
