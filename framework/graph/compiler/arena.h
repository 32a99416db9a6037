// Memory for what is needed only for a while and given back all at once.
#pragma once

#include <array>
#include <cstddef>
#include <memory_resource>

namespace nephrite::graph {

/// The first `bytes` are its own, so that small graphs are compiled with few calls of the allocator: those
/// took a third of the time of a graph of ten passes.
template<std::size_t bytes>
class Arena {
  public:
    Arena() = default;
    Arena(const Arena&) = delete;
    Arena& operator=(const Arena&) = delete;
    std::pmr::memory_resource* memory() { return &resource_; }

  private:
    alignas(std::max_align_t) std::array<std::byte, bytes> own_;  // not initialised
    std::pmr::monotonic_buffer_resource resource_{own_.data(), bytes};
};

}  // namespace nephrite::graph
