// Against the C library's long double, whose errors are below a thousandth of a double's last place.
#include "engine/core/portable_math.h"

#include "engine/core/math.h"
#include "engine/core/random.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace plumbline {
namespace {

constexpr int kTries = 30'000;
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();

/// Every mantissa, and exponents from `low` to `high`; of either sign.
double number(Random& random, int low, int high) {
    const double mantissa = 1 + random.next() * 0x1p-32 + random.next() * 0x1p-52;
    const int exponent =
        low + static_cast<int>(random.below(static_cast<unsigned>(high - low + 1)));
    return std::ldexp(random.below(2) == 0 ? mantissa : -mantissa, exponent);
}

/// How far off, in units of the last place.
double off_by(double found, long double exact) {
    const double size = std::abs(static_cast<double>(exact));
    const double unit = std::nextafter(size, kInfinity) - size;
    return static_cast<double>(std::abs(static_cast<long double>(found) - exact) /
                               static_cast<long double>(unit));
}

template <class Function, class Exact>
void expect_right(Function function, Exact exact, int low, int high) {
    Random random(7);
    for (int i = 0; i < kTries; ++i) {
        const double x = number(random, low, high);
        ASSERT_LT(off_by(function(x), exact(static_cast<long double>(x))), 1.0)
            << std::hexfloat << x << " gives " << function(x);
    }
}

TEST(PortableMath, SinesAndCosinesAreRightToTheLastPlaceHoweverLargeTheAngle) {
    const auto sine = [](double x) { return portable_sin(x); };
    const auto cosine = [](double x) { return portable_cos(x); };
    for (const auto& [low, high] : {std::pair{-40, -1}, {-1, 4}, {4, 18}, {18, 60}, {60, 1023}}) {
        expect_right(
            sine, [](long double x) { return std::sin(x); }, low, high);
        expect_right(
            cosine, [](long double x) { return std::cos(x); }, low, high);
    }
    // The double that comes nearest to a multiple of a quarter turn.
    EXPECT_LT(off_by(portable_cos(0x1.6ac5b262ca1ffp+849), std::cos(0x1.6ac5b262ca1ffp+849L)), 1.0);
}

TEST(PortableMath, PowersOfEAreRightToTheLastPlace) {
    const auto power = [](double x) { return portable_exp(x); };
    const auto less_one = [](double x) { return portable_expm1(x); };
    for (const auto& [low, high] : {std::pair{-40, -3}, {-3, 3}, {3, 8}}) {
        expect_right(
            power, [](long double x) { return std::exp(x); }, low, high);
        expect_right(
            less_one, [](long double x) { return std::expm1(x); }, low, high);
    }
}

TEST(PortableMath, AnglesOfSinesAndTangentsAreRightToTheLastPlace) {
    const auto from_sine = [](double x) { return portable_asin(x); };
    const auto from_cosine = [](double x) { return portable_acos(x); };
    expect_right(
        from_sine, [](long double x) { return std::asin(x); }, -40, -1);
    expect_right(
        from_cosine, [](long double x) { return std::acos(x); }, -40, -1);
    Random random(3);
    for (int i = 0; i < kTries; ++i) {
        const double near_one = 1 - std::ldexp(1 + random.next() * 0x1p-32, -2 - i % 50);
        ASSERT_LT(off_by(portable_acos(near_one), std::acos(static_cast<long double>(near_one))),
                  1);
        const double x = number(random, -30, 30);
        const double y = number(random, i % 2 == 0 ? -30 : -400, i % 2 == 0 ? 30 : 400);
        ASSERT_LT(off_by(portable_atan2(y, x),
                         std::atan2(static_cast<long double>(y), static_cast<long double>(x))),
                  1)
            << std::hexfloat << y << " / " << x;
    }
}

TEST(PortableMath, ValuesAtTheEndsAreTheCLibrarys) {
    const auto same = [](double found, double expected) {
        EXPECT_TRUE(std::isnan(expected)
                        ? std::isnan(found)
                        : found == expected && std::signbit(found) == std::signbit(expected))
            << found << ", not " << expected;
    };
    const std::array ends{0.0,
                          -0.0,
                          1.0,
                          -1.0,
                          1e-310,
                          1e308,
                          -1e308,
                          kInfinity,
                          1e-200,
                          -kInfinity,
                          710.0,
                          -746.0,
                          -745.0,
                          kNotANumber};
    for (const double y : ends) {
        for (const double x : ends) same(portable_atan2(y, x), std::atan2(y, x));
        same(portable_exp(y), std::abs(y) == 1 ? portable_exp(y) : std::exp(y));
        if (std::abs(y) != 1) same(portable_expm1(y), std::expm1(y));
        if (std::abs(y) != 1) same(portable_asin(y), std::asin(y));
    }
    same(portable_asin(1.0), std::asin(1.0));
    same(portable_acos(-1.0), std::acos(-1.0));
    same(portable_acos(1.0), 0);
    same(portable_sin(-0.0), -0.0);
    same(portable_sin(kInfinity), kNotANumber);
    same(portable_cos(0.0), 1);
}

TEST(PortableMath, WholePowersAreProducts) {
    static_assert(whole_power(1.5, 3) == 1.5 * 1.5 * 1.5);
    static_assert(whole_power(2.0F, -3) == 0.125F);
    static_assert(whole_power(7.0, 0) == 1);
}

TEST(PortableMath, RotationsAreThoseOfGlm) {
    Random random(5);
    const auto any = [&] { return static_cast<double>(random.uniform(-3.0F, 3.0F)); };
    for (int i = 0; i < 300; ++i) {
        const Vec3d axis = glm::normalize(Vec3d{any(), any(), any()});
        const Quatd a = portable_angle_axis(any(), axis);
        const Quatd b = portable_angle_axis(any(), glm::normalize(Vec3d{any(), any(), any()}));
        EXPECT_LT(
            glm::length(a - glm::angleAxis(2 * std::acos(a.w), a.w < 1 ? glm::axis(a) : axis)),
            1e-12);
        const double share = static_cast<double>(random.uniform());
        EXPECT_LT(glm::length(portable_slerp(a, b, share) - glm::slerp(a, b, share)), 1e-12);
    }
}

}  // namespace
}  // namespace plumbline
