// See memory_growth.h.
#include "memory_growth.h"

#include <fmt/format.h>
#include <malloc.h>
#include <unistd.h>

#include <fstream>

namespace nephrite::runtime::test {

MemorySample sampleMemory() {
    malloc_trim(0);  // what malloc keeps for later is not held
    std::ifstream file("/proc/self/statm");
    double pages = 0;
    double resident = 0;
    file >> pages >> resident;
    const auto heap = mallinfo2();
    return {resident * static_cast<double>(sysconf(_SC_PAGESIZE)),
            static_cast<double>(heap.uordblks + heap.hblkhd)};
}

MemorySample MemoryGrowth::mean(std::size_t first, std::size_t last) const {
    MemorySample sum;
    for (std::size_t i = first; i < last; ++i) {
        sum.resident += samples_[i].resident;
        sum.heap += samples_[i].heap;
    }
    const auto count = static_cast<double>(last - first);
    return {sum.resident / count, sum.heap / count};
}

MemorySample MemoryGrowth::share() const {
    const std::size_t count = samples_.size();
    const std::size_t third = count / 3;
    const MemorySample early = mean(count / 10, count / 10 + third);
    const MemorySample late = mean(count - third, count);
    return {late.resident / early.resident - 1, late.heap / early.heap - 1};
}

std::string MemoryGrowth::table() const {
    std::string text;
    for (std::size_t tenth = 0; tenth < 10; ++tenth) {
        const MemorySample held = mean(samples_.size() * tenth / 10, samples_.size() * (tenth + 1) / 10);
        text += fmt::format("tenth {}: resident {:.1f} MB, heap {:.1f} MB\n", tenth + 1, held.resident / 1e6,
                            held.heap / 1e6);
    }
    return text;
}

}  // namespace nephrite::runtime::test
