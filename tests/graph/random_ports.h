// What random graphs are put together from: random choices, and the ports that are there to be read.
#pragma once

#include <random>
#include <vector>

#include "graph/description.h"
#include "graph/plan.h"

namespace nephrite::graph::tests {

class Chance {
  public:
    explicit Chance(std::uint64_t seed) : random_(seed) {}
    /// 0 to bound - 1.
    std::uint32_t below(std::uint32_t bound) { return static_cast<std::uint32_t>(random_() % bound); }
    bool oneIn(std::uint32_t count) { return below(count) == 0; }
    template<class List>
    auto oneOf(const List& list) {
        return list[below(static_cast<std::uint32_t>(list.size()))];
    }

  private:
    std::mt19937_64 random_;
};

enum class PortSort : std::uint8_t { Float, Uint, Depth, Buffer };

/// An output that later nodes may read.
struct RandomPort {
    Index node = noIndex;  ///< or noIndex: an import
    std::string nodeName;
    std::string portName;
    PortSort sort = PortSort::Float;
    Format format = Format::rgba16f;
    Extent extent{};  ///< 0 x 0: not known here
    std::uint32_t mips = 1;
    std::uint32_t layersPerIteration = 1;
    std::uint32_t layers = 1;
    bool perLight = false;
    bool isOverwritten = false;  ///< a later node modifies it
    bool isAskedFor = false;     ///< requested, or read in later frames: nothing may modify it
};

/// A reference to it, now and then to one level or one layer.
PortReference reference(const RandomPort& port, Chance& chance);
/// Makes an input fit a port.
void expect(InputPort& input, const RandomPort& port);

}  // namespace nephrite::graph::tests
