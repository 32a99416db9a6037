// Whether a process that does the same for a long time comes to hold more and more memory.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace nephrite::runtime::test {

/// What a process holds at one moment, bytes.
struct MemorySample {
    double resident = 0;  ///< pages in memory
    double heap = 0;      ///< handed out by malloc and not given back, in all libraries
};

/// Of this process, now.
MemorySample sampleMemory();

/// Samples taken at even distances over a long run, the first tenth of which may do anything.
class MemoryGrowth {
  public:
    void add(const MemorySample& sample) { samples_.push_back(sample); }

    /// How much larger the mean over the last third is than that over as many samples after the first tenth,
    /// as a share of the latter: 0 is flat. Needs ten samples.
    MemorySample share() const;
    /// The mean of each tenth, in MB.
    std::string table() const;

  private:
    MemorySample mean(std::size_t first, std::size_t last) const;

    std::vector<MemorySample> samples_;
};

}  // namespace nephrite::runtime::test
