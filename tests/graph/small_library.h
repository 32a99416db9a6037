// A few pass types made from manifests in memory, for tests of reading and linking.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "graph/linked_graph.h"

namespace nephrite::graph::tests {

/// A pass type from a manifest's text; throws InputError with every fault.
PassType passFrom(std::string_view manifest, std::string name = "p");

/// source: no inputs -> color; blend: a, b? -> color; counters: -> count (r32u), samples (buffer of vec4);
/// readers: count (r32u)?, samples (buffer)? -> color; depth: raster -> color, depth (d32f);
/// accumulate: now, history? -> color; reduce: once a mip, image -> pyramid; draw: raster, under, mask? ->
/// over, which modifies under; append: list (buffer of vec4), image (r32u)? -> longer, which modifies list;
/// shade: surface?, its domain, light? -> color.
PassLibrary smallLibrary();

/// A graph read from text called "g.json" and linked against smallLibrary().
std::shared_ptr<const LinkedGraph> linked(std::string_view text);

/// The expression `text` at line 1, column 1 of "e"; throws InputError if it is malformed.
Expression expression(const std::string& text);

}  // namespace nephrite::graph::tests
