// The keys of graph and manifest files: what the readers accept and what the schemas are made of.
#pragma once

#include <span>

#include "text/json.h"

namespace nephrite::graph::keys {

// A graph file.
std::span<const json::Key> graph();
std::span<const json::Key> graphParameter();
std::span<const json::Key> graphImport();
std::span<const json::Key> node();

// A pass manifest.
std::span<const json::Key> manifest();
std::span<const json::Key> input();
std::span<const json::Key> output();
std::span<const json::Key> parameter();
std::span<const json::Key> raster();

}  // namespace nephrite::graph::keys
