// Random JSON texts with comments, trailing commas and every layout.
#pragma once

#include <random>
#include <string>
#include <vector>

#include "text/json_edit.h"

namespace nephrite::json::tests {

using Random = std::mt19937;

inline unsigned below(Random& random, unsigned n) {
    return static_cast<unsigned>(random() % n);
}
/// True once in `n` times.
inline bool oneIn(Random& random, unsigned n) {
    return below(random, n) == 0;
}

/// An object whose members hold objects, arrays, strings, numbers and words.
std::string randomDocument(Random& random);
/// One value without comments, as an edit would give it.
std::string randomValue(Random& random);

/// A comment and the byte it starts at.
struct Comment {
    std::size_t at;
    std::string text;
};
std::vector<Comment> commentsIn(const std::string& text);

/// The paths of every value in a document, the root left out.
std::vector<Path> pathsOf(const Value& root);

/// The text without spaces, line breaks and commas, those in strings and comments too.
std::string squeezed(std::string_view text);

}  // namespace nephrite::json::tests
