// Samples on the CPU.
#pragma once

#include <cstdint>
#include <vector>

namespace plumbline::assets {

/// Signed 16-bit, channels interleaved. Only mono sounds are placed in space.
struct SoundData {
    int sample_rate_hz{44'100};
    int channels{1};
    std::vector<std::int16_t> samples;
};

}  // namespace plumbline::assets
