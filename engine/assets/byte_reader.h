// Numbers out of bytes that nobody vouches for: reading past the end gives zeros and is remembered.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>

namespace plumbline::assets {

/// Four bytes from `at`, the lowest first; all four must be there.
inline std::uint32_t little_u32(std::string_view bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 4; i-- > 0;) {
        value = value << 8U | static_cast<std::uint8_t>(bytes[at + i]);
    }
    return value;
}

class ByteReader {
public:
    explicit ByteReader(std::string_view bytes) : bytes_(bytes) {}

    std::size_t left() const { return bytes_.size() - place_; }
    bool failed() const { return failed_; }

    std::string_view take(std::size_t count) {
        if (count > left()) {
            failed_ = true;
            count = left();
        }
        place_ += count;
        return bytes_.substr(place_ - count, count);
    }

    template <class T>
    T number(std::endian order = std::endian::little) {
        std::array<char, sizeof(T)> raw{};
        const std::string_view source = take(sizeof(T));
        if (source.size() < sizeof(T)) return T{};
        std::copy(source.begin(), source.end(), raw.begin());
        if (order != std::endian::native) std::reverse(raw.begin(), raw.end());
        T value{};
        std::memcpy(&value, raw.data(), sizeof(T));
        return value;
    }

private:
    std::string_view bytes_;
    std::size_t place_{0};
    bool failed_{false};
};

}  // namespace plumbline::assets
