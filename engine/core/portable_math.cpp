// Sums and products carry their rounding error along (a Pair) wherever it would be seen in the
// result: T. J. Dekker, "A floating-point technique for extending the available precision" (1971).
// Series are those of Taylor, long enough for the interval that an argument is reduced to.
#include "engine/core/portable_math.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

namespace plumbline {
namespace {

/// A number as the sum of two doubles, the second at most half a unit in the last place of the first.
struct Pair {
    double high{0};
    double low{0};
};

constexpr Pair kPi_rad{0x1.921fb54442d18p+1, 0x1.1a62633145c07p-53};
constexpr Pair kQuarterTurn_rad{0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54};
constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();

/// a + b, exactly.
Pair sum(double a, double b) {
    const double high = a + b;
    const double of_b = high - a;
    return {high, (a - (high - of_b)) + (b - of_b)};
}

/// a * b, exactly, for factors below 1e300 whose product is no subnormal number.
Pair product(double a, double b) {
    constexpr double kSplit = 0x1p27 + 1;
    const double big_a = a * kSplit;
    const double big_b = b * kSplit;
    const double a_high = big_a - (big_a - a);
    const double b_high = big_b - (big_b - b);
    const double a_low = a - a_high;
    const double b_low = b - b_high;
    const double high = a * b;
    return {high, ((a_high * b_high - high) + a_high * b_low + a_low * b_high) + a_low * b_low};
}

/// c[0] + x c[1] + x² c[2] + …
template <std::size_t kCount>
double series(const std::array<double, kCount>& c, double x) {
    double value = c[kCount - 1];
    for (std::size_t i = kCount - 1; i-- > 0;) value = value * x + c[i];
    return value;
}

/// first / (n (n + 1)), that / ((n + 2) (n + 3)), …, with signs that alternate.
template <std::size_t kCount>
constexpr std::array<double, kCount> falling(double first, int n) {
    std::array<double, kCount> c{};
    double value = first;
    for (std::size_t i = 0; i < kCount; ++i, n += 2) {
        value /= static_cast<double>(n) * (n + 1);
        c[i] = value;
        value = -value;
    }
    return c;
}

// --- angles -------------------------------------------------------------------------------------

/// An angle less its quarter turns.
struct Reduced {
    int quarter_turns{0};  ///< modulo 4
    Pair angle_rad{};      ///< from -pi/4 to pi/4
};

/// Angles below 2^19: their quarter turns times the first three parts, of 33 bits each, are exact.
Reduced reduced_small(double angle_rad) {
    constexpr std::array<double, 4> kParts{
        0x1.921fb544p+0, 0x1.0b4611a6p-34, 0x1.3198a2e0p-69, 0x1.b839a252049c1p-104};
    const double turns = std::floor(angle_rad * 0x1.45f306dc9c883p-1 + 0.5);
    const Pair first = sum(angle_rad - turns * kParts[0], -turns * kParts[1]);
    const Pair second = sum(first.high, -turns * kParts[2]);
    const Pair angle = sum(second.high, (first.low + second.low) - turns * kParts[3]);
    return {static_cast<int>(static_cast<std::int64_t>(turns) & 3), angle};
}

__extension__ typedef unsigned __int128 Wide;  // NOLINT(modernize-use-using): no pedantic warning

/// M. H. Payne and R. N. Hanek, "Radian reduction for trigonometric functions" (1983): of the digits
/// of 2/pi only those count that give the fraction of a turn.
Reduced reduced_large(double angle_rad) {
    // Below the point of 2/pi, behind 64 zeros.
    constexpr std::array<std::uint64_t, 21> kDigits{
        0x0000000000000000, 0xa2f9836e4e441529, 0xfc2757d1f534ddc0, 0xdb6295993c439041,
        0xfe5163abdebbc561, 0xb7246e3a424dd2e0, 0x06492eea09d1921c, 0xfe1deb1cb129a73e,
        0xe88235f52ebb4484, 0xe99c7026b45f7e41, 0x3991d639835339f4, 0x9c845f8bbdf9283b,
        0x1ff897ffde05980f, 0xef2f118b5a0a6d1f, 0x6d367ecf27cb09b7, 0x4f463f669e5fea2d,
        0x7527bac7ebe5f17b, 0x3d0739f78a5292ea, 0x6bfb5fb11f8d5d08, 0x56033046fc7b6bab,
        0xf0cfbc209af4361d};
    constexpr int kMantissaBits = 52;
    const auto bits = std::bit_cast<std::uint64_t>(std::abs(angle_rad));
    const int exponent = static_cast<int>(bits >> kMantissaBits) - 1023 - kMantissaBits;
    const std::uint64_t mantissa =
        (bits & ((std::uint64_t{1} << kMantissaBits) - 1)) | (std::uint64_t{1} << kMantissaBits);
    // From the digit on whose product with the mantissa is below four quarter turns.
    const auto from = static_cast<std::size_t>(exponent - 2 + 64);
    const auto word = [&](std::size_t i) {
        const std::size_t at = from / 64 + i;
        const std::size_t shift = from % 64;
        if (shift == 0) return kDigits[at];
        return kDigits[at] << shift | kDigits[at + 1] >> (64 - shift);
    };
    const Wide last = Wide{mantissa} * word(2);
    const Wide middle = Wide{mantissa} * word(1) + (last >> 64U);
    const std::uint64_t top = mantissa * word(0) + static_cast<std::uint64_t>(middle >> 64U);
    const Wide fraction = (Wide{top} << 66U) | (Wide{static_cast<std::uint64_t>(middle)} << 2U) |
                          (static_cast<std::uint64_t>(last) >> 62U);
    const bool past_half = (fraction >> 127U) != 0;
    const Wide size = past_half ? Wide{0} - fraction : fraction;
    const double sign = past_half != (angle_rad < 0) ? -0x1p-128 : 0x1p-128;
    const auto high = static_cast<double>(size);
    const auto whole = static_cast<Wide>(high);
    const double low =
        size < whole ? -static_cast<double>(whole - size) : static_cast<double>(size - whole);
    const Pair share{sign * high, sign * low};
    const Pair angle = product(share.high, kQuarterTurn_rad.high);
    const double rest =
        angle.low + share.high * kQuarterTurn_rad.low + share.low * kQuarterTurn_rad.high;
    const int turns = static_cast<int>(top >> 62U) + (past_half ? 1 : 0);
    return {(angle_rad < 0 ? -turns : turns) & 3, sum(angle.high, rest)};
}

/// Of angles up to pi/4.
double sine_of(const Pair& angle) {
    static constexpr std::array<double, 8> kSeries = falling<8>(-1.0, 2);
    const double x = angle.high;
    const double square = x * x;
    return x + (x * square * series(kSeries, square) + angle.low * (1 - square / 2));
}

double cosine_of(const Pair& angle) {
    static constexpr std::array<double, 7> kSeries = falling<7>(0.5, 3);
    const double square = angle.high * angle.high;
    const double half = square / 2;
    const double most = 1 - half;
    return most + (((1 - most) - half) +
                   (square * square * series(kSeries, square) - angle.high * angle.low));
}

/// The sine of an angle and so many quarter turns more.
double sine(double angle_rad, int quarter_turns) {
    if (!std::isfinite(angle_rad)) return kNotANumber;
    const Reduced reduced =
        std::abs(angle_rad) < 0x1p19 ? reduced_small(angle_rad) : reduced_large(angle_rad);
    const int turns = (reduced.quarter_turns + quarter_turns) & 3;
    const double value = turns % 2 == 0 ? sine_of(reduced.angle_rad) : cosine_of(reduced.angle_rad);
    return turns >= 2 ? -value : value;
}

/// The angle whose tangent is y / x, 0 <= y <= x, x > 0: that of the nearest eighth, known, and the
/// small one between the two.
Pair angle_below_eighth_turn(const Pair& y, const Pair& x) {
    constexpr std::array<Pair, 9> kOfEighths{{{0, 0},
                                              {0x1.fd5ba9aac2f6ep-4, -0x1.cd37686760c17p-59},
                                              {0x1.f5b75f92c80ddp-3, 0x1.8ab6e3cf7afbdp-57},
                                              {0x1.6f61941e4def1p-2, -0x1.c63aae6f6e918p-56},
                                              {0x1.dac670561bb4fp-2, 0x1.a2b7f222f65e2p-56},
                                              {0x1.1e00babdefeb4p-1, -0x1.928df287a668fp-58},
                                              {0x1.4978fa3269ee1p-1, 0x1.2419a87f2a458p-56},
                                              {0x1.700a7c5784634p-1, -0x1.8c34d25aadef6p-56},
                                              {0x1.921fb54442d18p-1, 0x1.1a62633145c07p-55}}};
    static constexpr std::array<double, 7> kSeries{
        -1.0 / 3, 1.0 / 5, -1.0 / 7, 1.0 / 9, -1.0 / 11, 1.0 / 13, -1.0 / 15};
    const double eighths = std::floor(8 * (y.high / x.high) + 0.5);
    const double slope = eighths / 8;
    // (y - slope x) / (x + slope y)
    const Pair less = product(slope, x.high);
    const Pair more = product(slope, y.high);
    const Pair above = sum(y.high, -less.high);
    const Pair below = sum(x.high, more.high);
    const double above_low = above.low - less.low + y.low - slope * x.low;
    const double below_low = below.low + more.low + x.low + slope * y.low;
    const double tangent = above.high / below.high;
    const Pair back = product(tangent, below.high);
    const double missing =
        (((above.high - back.high) - back.low) + above_low - tangent * below_low) / below.high;
    const double square = tangent * tangent;
    const Pair known = kOfEighths[static_cast<std::size_t>(eighths)];
    const Pair angle = sum(known.high, tangent);
    return {angle.high,
            angle.low + (known.low + (missing + tangent * square * series(kSeries, square)))};
}

/// Both finite, not both 0, neither so large or small that products leave the range of doubles.
double angle_of(Pair y, Pair x) {
    const bool is_left = x.high < 0;
    const bool is_below = y.high < 0;
    if (is_left) x = {-x.high, -x.low};
    if (is_below) y = {-y.high, -y.low};
    const bool is_steep = y.high > x.high;
    if (is_steep) std::swap(x, y);
    Pair angle = angle_below_eighth_turn(y, x);
    const auto from = [&](const Pair& whole) {
        const Pair left = sum(whole.high, -angle.high);
        angle = {left.high, left.low + (whole.low - angle.low)};
    };
    if (is_steep) from(kQuarterTurn_rad);
    if (is_left) from(kPi_rad);
    const double value = angle.high + angle.low;
    return is_below ? -value : value;
}

/// The other leg of a right triangle whose longest side is 1.
Pair other_leg(double leg) {
    const Pair square = product(leg, leg);
    const Pair left = sum(1, -square.high);
    const double high = std::sqrt(left.high);
    if (high == 0) return {};
    const Pair back = product(high, high);
    return {high, (((left.high - back.high) - back.low) + (left.low - square.low)) / (2 * high)};
}

// --- powers of e --------------------------------------------------------------------------------

/// x less its multiples of ln 2, and exp of what is left less 1, without the last sum.
struct Power {
    int twos{0};
    double rest{0};   ///< from -ln 2 / 2 to ln 2 / 2
    double above{0};  ///< exp(rest) - 1 - rest
};

Power power_of(double x) {
    constexpr double kPerTwo = 0x1.71547652b82fep+0;
    constexpr Pair kTwo{0x1.62e42fee00000p-1, 0x1.a39ef35793c76p-33};
    static constexpr auto kSeries = [] {
        std::array<double, 13> c{};  // 1/2!, 1/3!, …
        double value = 1;
        for (std::size_t i = 0; i < c.size(); ++i)
            c[i] = value = value / static_cast<double>(i + 2);
        return c;
    }();
    const double twos = std::floor(x * kPerTwo + 0.5);
    const Pair rest = sum(x - twos * kTwo.high, -twos * kTwo.low);
    const double square = rest.high * rest.high;
    return {static_cast<int>(twos),
            rest.high,
            square * series(kSeries, rest.high) + rest.low * (1 + rest.high)};
}

constexpr double kMostExponent = 800;  // beyond it exp is 0 or infinite

}  // namespace

double portable_sin(double angle_rad) {
    return angle_rad == 0 ? angle_rad : sine(angle_rad, 0);
}

double portable_cos(double angle_rad) {
    return sine(angle_rad, 1);
}

double portable_asin(double sine) {
    if (!(std::abs(sine) <= 1)) return kNotANumber;
    if (std::abs(sine) < 0x1p-30) return sine;
    return angle_of({sine, 0}, other_leg(sine));
}

double portable_acos(double cosine) {
    if (!(std::abs(cosine) <= 1)) return kNotANumber;
    return angle_of(other_leg(cosine), {cosine, 0});
}

double portable_atan2(double y, double x) {
    if (std::isnan(x) || std::isnan(y)) return kNotANumber;
    const bool any_infinite = std::isinf(x) || std::isinf(y);
    if (any_infinite) {
        // Towards a side or a corner.
        x = std::copysign(std::isinf(x) ? 1.0 : 0.0, x);
        y = std::copysign(std::isinf(y) ? 1.0 : 0.0, y);
    }
    if (y == 0) return std::copysign(std::signbit(x) ? kPi_rad.high : 0.0, y);
    const double larger = std::max(std::abs(x), std::abs(y));
    const double scale = larger > 0x1p900 ? 0x1p-200 : larger < 0x1p-700 ? 0x1p300 : 1;
    return angle_of({y * scale, 0}, {x * scale, 0});
}

double portable_exp(double x) {
    if (std::isnan(x)) return x;
    if (x > kMostExponent) return std::numeric_limits<double>::infinity();
    if (x < -kMostExponent) return 0;
    const Power power = power_of(x);
    return std::ldexp(1 + (power.rest + power.above), power.twos);
}

double portable_expm1(double x) {
    if (std::isnan(x) || x == 0) return x;
    if (x > kMostExponent) return std::numeric_limits<double>::infinity();
    if (x < -kMostExponent) return -1;
    const Power power = power_of(x);
    const Pair share = sum(power.rest, power.above);
    if (power.twos == 0) return share.high;
    if (power.twos > 1000) return std::ldexp(1 + share.high, power.twos);
    const double two = std::ldexp(1, power.twos);
    // Up to 2^50 - 1 the difference is exact; beyond it 1 is less than the rounding.
    const double less = power.twos > 50 ? 1 : 0;
    const Pair whole = sum(two - (1 - less), two * share.high);
    return whole.high + (whole.low + two * share.low - less);
}

}  // namespace plumbline
