#include "tests/fuzz/mutate.h"

#include "engine/core/random.h"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <string_view>

namespace plumbline::fuzz {
namespace {

constexpr std::uint32_t kMostChanges = 8;
constexpr std::uint32_t kLongestPiece = 64;

constexpr std::array<std::uint64_t, 14> kIntegers{0,
                                                  1,
                                                  2,
                                                  3,
                                                  0x7f,
                                                  0xff,
                                                  0x7fff,
                                                  0xffff,
                                                  0x7fff'ffff,
                                                  0x8000'0000,
                                                  0xffff'fffe,
                                                  0xffff'ffff,
                                                  0x7fff'ffff'ffff'ffff,
                                                  0xffff'ffff'ffff'ffff};
constexpr std::array<double, 12> kNumbers{0.0,
                                          -0.0,
                                          -1.0,
                                          1e-320,
                                          1e-30,
                                          1e6,
                                          1e30,
                                          -1e30,
                                          1e300,
                                          std::numeric_limits<double>::infinity(),
                                          -std::numeric_limits<double>::infinity(),
                                          std::numeric_limits<double>::quiet_NaN()};
constexpr std::array<std::string_view, 14> kWords{"-1",
                                                  "0",
                                                  "256",
                                                  "65536",
                                                  "4294967295",
                                                  "4294967296",
                                                  "18446744073709551615",
                                                  "1e999",
                                                  "-1e30",
                                                  "1e-320",
                                                  "nan",
                                                  "inf",
                                                  "null",
                                                  "\"\""};

class Mutant {
public:
    Mutant(std::string bytes, std::span<const std::string> seeds, Random& random)
        : bytes_(std::move(bytes)), seeds_(seeds), random_(random) {}

    void change() {
        switch (random_.below(9)) {
            case 0:
                return set_byte([&](char was) { return was ^ static_cast<char>(1U << below(8)); });
            case 1:
                return set_byte([&](char) { return static_cast<char>(below(256)); });
            case 2:
                return overwrite(kIntegers[below(kIntegers.size())], std::size_t{1} << below(4));
            case 3:
                return overwrite(std::bit_cast<std::uint64_t>(kNumbers[below(kNumbers.size())]), 8);
            case 4:
                return overwrite_with_piece();
            case 5:
                return insert_piece();
            case 6:
                bytes_.erase(place(), 1 + below(kLongestPiece));
                return;
            case 7:
                return replace_number();
            default:
                if (below(8) == 0) bytes_.resize(place());
        }
    }
    std::string take() { return std::move(bytes_); }

private:
    std::size_t below(std::size_t count) {
        return count == 0 ? 0 : random_.below(static_cast<std::uint32_t>(count));
    }
    std::size_t place() { return below(bytes_.size()); }

    void set_byte(auto changed) {
        if (bytes_.empty()) return;
        char& byte = bytes_[place()];
        byte = static_cast<char>(changed(byte));
    }
    /// Lowest byte first.
    void overwrite(std::uint64_t value, std::size_t size) {
        std::size_t at = place();
        for (std::size_t i = 0; i < size && at < bytes_.size(); ++i, ++at, value >>= 8U)
            bytes_[at] = static_cast<char>(value & 0xffU);
    }
    std::string piece() {
        const std::string& from = below(2) == 0 ? bytes_ : seeds_[below(seeds_.size())];
        return from.substr(below(from.size()), 1 + below(kLongestPiece));
    }
    void overwrite_with_piece() {
        const std::string taken = piece();
        const std::size_t at = place();
        bytes_.replace(at, std::min(taken.size(), bytes_.size() - at), taken);
    }
    void insert_piece() { bytes_.insert(place(), piece()); }
    /// The next number of a text, from a place on, becomes another.
    void replace_number() {
        constexpr std::string_view kDigits = "0123456789.";
        const std::size_t begin = bytes_.find_first_of(kDigits, place());
        if (begin == std::string::npos) return;
        const std::size_t end = std::min(bytes_.find_first_not_of(kDigits, begin), bytes_.size());
        bytes_.replace(begin, end - begin, kWords[below(kWords.size())]);
    }

    std::string bytes_;
    std::span<const std::string> seeds_;
    Random& random_;
};

}  // namespace

std::string mutant(std::span<const std::string> seeds, std::uint64_t number) {
    Random random(number * 0x9e37'79b9'7f4a'7c15U);
    Mutant made(seeds[random.below(static_cast<std::uint32_t>(seeds.size()))], seeds, random);
    const std::uint32_t changes = 1 + random.below(kMostChanges);
    for (std::uint32_t i = 0; i < changes; ++i) made.change();
    return made.take();
}

}  // namespace plumbline::fuzz
