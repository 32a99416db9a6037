// Philox, and the streams made from it.
#include "scattering/random.h"

#include <cmath>

namespace nephrite::scattering {
namespace {

std::uint32_t highWord(std::uint64_t bits) {
    return static_cast<std::uint32_t>(bits >> 32);
}

std::uint32_t lowWord(std::uint64_t bits) {
    return static_cast<std::uint32_t>(bits);
}

std::uint64_t joined(std::uint32_t low, std::uint32_t high) {
    return std::uint64_t{high} << 32 | low;
}

}  // namespace

std::array<std::uint32_t, 4> philox(std::array<std::uint32_t, 4> counter, std::array<std::uint32_t, 2> key) {
    constexpr int rounds = 10;
    constexpr std::uint64_t firstMultiplier = 0xD2511F53;
    constexpr std::uint64_t secondMultiplier = 0xCD9E8D57;
    constexpr std::uint32_t firstIncrement = 0x9E3779B9;   // golden ratio
    constexpr std::uint32_t secondIncrement = 0xBB67AE85;  // sqrt(3) - 1
    for (int round = 0; round < rounds; ++round) {
        const std::uint64_t first = firstMultiplier * counter[0];
        const std::uint64_t second = secondMultiplier * counter[2];
        counter = {highWord(second) ^ counter[1] ^ key[0], lowWord(second),
                   highWord(first) ^ counter[3] ^ key[1], lowWord(first)};
        key[0] += firstIncrement;
        key[1] += secondIncrement;
    }
    return counter;
}

Random::Random(std::uint64_t seed, std::uint32_t pixel, std::uint64_t sample) : state_{} {
    const std::array<std::uint32_t, 2> key{lowWord(seed), highWord(seed)};
    for (std::uint32_t block = 0; block < 2; ++block) {
        const auto words = philox({lowWord(sample), highWord(sample), pixel, block}, key);
        state_[2 * block] = joined(words[0], words[1]);
        state_[2 * block + 1] = joined(words[2], words[3]);
    }
}

double Random::exponential() {
    return -std::log1p(-uniform());
}

}  // namespace nephrite::scattering
