// What an ear would say of samples, in numbers: loudness, spectrum, pitch, reverberation.
#pragma once

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <utility>
#include <vector>

namespace plumbline::test {

inline double rms_of(const std::vector<double>& samples) {
    double sum = 0;
    for (const double sample : samples) sum += sample * sample;
    return samples.empty() ? 0.0 : std::sqrt(sum / static_cast<double>(samples.size()));
}

/// In place; as many as a power of two.
inline void fourier(std::vector<std::complex<double>>& values) {
    const std::size_t count = values.size();
    for (std::size_t i = 1, j = 0; i < count; ++i) {
        std::size_t bit = count >> 1U;
        for (; (j & bit) != 0; bit >>= 1U) j ^= bit;
        j ^= bit;
        if (i < j) std::swap(values[i], values[j]);
    }
    for (std::size_t length = 2; length <= count; length *= 2) {
        const double angle = -2.0 * std::acos(-1.0) / static_cast<double>(length);
        for (std::size_t at = 0; at < count; at += length) {
            for (std::size_t k = 0; k < length / 2; ++k) {
                const auto turn = std::polar(1.0, angle * static_cast<double>(k));
                const auto even = values[at + k];
                const auto odd = values[at + k + length / 2] * turn;
                values[at + k] = even + odd;
                values[at + k + length / 2] = even - odd;
            }
        }
    }
}

/// Energy by frequency, rate/count hertz a bin: the mean over Hann windows of `count` samples.
inline std::vector<double> spectrum_of(const std::vector<double>& samples,
                                       std::size_t count = 4096) {
    std::vector<double> energy(count / 2, 0.0);
    for (std::size_t at = 0; at + count <= samples.size(); at += count / 2) {
        std::vector<std::complex<double>> window(count);
        for (std::size_t i = 0; i < count; ++i) {
            const double turn =
                2.0 * std::acos(-1.0) * static_cast<double>(i) / static_cast<double>(count);
            window[i] = samples[at + i] * (0.5 - 0.5 * std::cos(turn));
        }
        fourier(window);
        for (std::size_t i = 0; i < energy.size(); ++i) energy[i] += std::norm(window[i]);
    }
    return energy;
}

/// Of the energy, what lies above a frequency: 0…1.
inline double share_above(const std::vector<double>& samples, double rate_hz, double frequency_hz) {
    const std::vector<double> energy = spectrum_of(samples);
    double above = 0;
    double all = 0;
    for (std::size_t i = 0; i < energy.size(); ++i) {
        const double bin_hz =
            rate_hz * static_cast<double>(i) / static_cast<double>(2 * energy.size());
        all += energy[i];
        if (bin_hz > frequency_hz) above += energy[i];
    }
    return all > 0 ? above / all : 0.0;
}

/// Of one tone, by where its energy lies.
inline double pitch_of_hz(const std::vector<double>& samples, double rate_hz) {
    constexpr std::size_t kCount = 16384;
    const std::vector<double> energy = spectrum_of(samples, kCount);
    const auto most = static_cast<std::size_t>(std::ranges::max_element(energy) - energy.begin());
    double sum = 0;
    double weighted = 0;
    for (std::size_t i = most < 3 ? 0 : most - 3; i < std::min(most + 4, energy.size()); ++i) {
        sum += energy[i];
        weighted += energy[i] * static_cast<double>(i);
    }
    return sum > 0 ? rate_hz * weighted / sum / kCount : 0.0;
}

/// Seconds in which what follows an impulse falls by 60 dB: Schroeder's integral backwards, the line
/// from -5 to -25 dB.
inline double decay_60dB_s(const std::vector<double>& samples, double rate_hz) {
    double left = 0;
    for (const double sample : samples) left += sample * sample;
    const double all = left;
    std::size_t from = 0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const double level_dB = 10.0 * std::log10(std::max(left / all, 1e-30));
        if (level_dB > -5.0) from = i;
        if (level_dB < -25.0) return 3.0 * static_cast<double>(i - from) / rate_hz;
        left -= samples[i] * samples[i];
    }
    return 0.0;
}

}  // namespace plumbline::test
