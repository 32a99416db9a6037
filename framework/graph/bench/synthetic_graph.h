// Graphs of any size, made up to be compiled: what the compiler's time and its use of memory are measured on.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>

#include "graph/linked_graph.h"

namespace nephrite::graph {

enum class GraphShape : std::uint8_t {
    Random,  ///< each pass reads 1 to 3 of the last 32 results and writes 1 or 2; 30 % are dead, in chains
    Chain,   ///< each reads the one before it
    Ladder,  ///< two chains; each pass also reads the step before it in the other
    Fan,     ///< half of the passes read one result; the others gather what these make, two by two
    DeadChains,  ///< half of the passes are a chain; the others hang from it in chains that nobody reads
};
inline constexpr std::array graphShapes{GraphShape::Random, GraphShape::Chain, GraphShape::Ladder,
                                        GraphShape::Fan, GraphShape::DeadChains};
std::string_view name(GraphShape shape);  ///< "random", ..., "dead-chains"
std::optional<GraphShape> graphShapeNamed(std::string_view name);

/// The pass types of all made-up graphs: 0 to 3 images read, 1 or 2 written, rgba16f, of one of several sizes
/// from 256 x 256 to 1920 x 1080. They have no shaders.
PassLibrary syntheticTypes();

/// `passes` >= 1 nodes, the culled ones among them; equal seeds give equal graphs, and different seeds
/// different ones. `types` are syntheticTypes() and must outlive the result.
std::shared_ptr<const LinkedGraph> syntheticGraph(GraphShape shape, Index passes, std::uint64_t seed,
                                                  const PassLibrary& types);

}  // namespace nephrite::graph
