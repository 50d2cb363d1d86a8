// A small seeded generator. There is no global randomness: who needs some keeps one of these.
#pragma once

#include <cstdint>

namespace plumbline {

/// PCG32 (O'Neill 2014, "PCG: A Family of Simple Fast Space-Efficient Statistically Good
/// Algorithms for Random Number Generation", section 6.3): same seed, same sequence, everywhere.
class Random {
public:
    explicit Random(std::uint64_t seed) : state_(seed + kIncrement) { next(); }

    std::uint32_t next() {
        const std::uint64_t old = state_;
        state_ = old * 6364136223846793005ULL + kIncrement;
        const auto shifted = static_cast<std::uint32_t>(((old >> 18U) ^ old) >> 27U);
        const auto rotation = static_cast<std::uint32_t>(old >> 59U);
        return (shifted >> rotation) | (shifted << ((32U - rotation) & 31U));
    }

    /// In [0, 1).
    float uniform() { return static_cast<float>(next() >> 8U) * (1.0F / 16777216.0F); }
    /// In [low, high).
    float uniform(float low, float high) { return low + (high - low) * uniform(); }
    /// In [0, count); count > 0.
    std::uint32_t below(std::uint32_t count) { return next() % count; }

    void serialize(auto& archive) { archive(state_); }

private:
    static constexpr std::uint64_t kIncrement = 1442695040888963407ULL;
    std::uint64_t state_;
};

}  // namespace plumbline
