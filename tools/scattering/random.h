// Random numbers in streams that are named, not shared: the same (seed, pixel, sample) gives the same numbers
// on any machine and in any order, so work can be split at will.
#pragma once

#include <array>
#include <bit>
#include <cstdint>

namespace nephrite::scattering {

/// Philox-4x32-10 (Salmon et al. 2011): a keyed bijection of 128-bit counters whose values look random.
std::array<std::uint32_t, 4> philox(std::array<std::uint32_t, 4> counter, std::array<std::uint32_t, 2> key);

/// xoshiro256++ (Blackman and Vigna 2021), 2^256 - 1 long.
class Random {
  public:
    using result_type = std::uint64_t;

    /// The stream of one sample of one pixel. Philox makes the state, so that neighbouring streams have
    /// nothing in common.
    Random(std::uint64_t seed, std::uint32_t pixel, std::uint64_t sample);
    /// Continues from a state, which must not be all zero.
    explicit Random(const std::array<std::uint64_t, 4>& state) : state_(state) {}

    /// 64 random bits.
    std::uint64_t operator()() {
        const std::uint64_t result = std::rotl(state_[0] + state_[3], 23) + state_[0];
        const std::uint64_t shifted = state_[1] << 17;
        state_[2] ^= state_[0];
        state_[3] ^= state_[1];
        state_[1] ^= state_[2];
        state_[0] ^= state_[3];
        state_[2] ^= shifted;
        state_[3] = std::rotl(state_[3], 45);
        return result;
    }
    static constexpr std::uint64_t min() { return 0; }
    static constexpr std::uint64_t max() { return ~std::uint64_t{0}; }

    /// A multiple of 2^-53 in [0, 1).
    double uniform() { return static_cast<double>((*this)() >> 11) * 0x1p-53; }
    /// Exponentially distributed with mean 1: from 0 to about 37.
    double exponential();

  private:
    std::array<std::uint64_t, 4> state_;
};

}  // namespace nephrite::scattering
