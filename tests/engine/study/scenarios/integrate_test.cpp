#include "engine/study/scenarios/integrate.h"

#include <gtest/gtest.h>

namespace plumbline::study {
namespace {

TEST(Integrate, BothFollowTheExponential) {
    const auto rate = [](double, const State<1>& s) { return State<1>{-2 * s[0]}; };
    EXPECT_NEAR(dormand_prince(rate, State<1>{1}, 0, 3)[0], std::exp(-6), 1e-12);
    EXPECT_NEAR(gauss_legendre(rate, State<1>{1}, 0, 3, 1e-2)[0], std::exp(-6), 1e-13);
}

TEST(Integrate, TimeIsTheirsToo) {
    const auto rate = [](double t, const State<1>&) { return State<1>{std::cos(t)}; };
    EXPECT_NEAR(dormand_prince(rate, State<1>{0}, 0, 2)[0], std::sin(2), 1e-11);
    EXPECT_NEAR(gauss_legendre(rate, State<1>{0}, 0, 2, 1e-2)[0], std::sin(2), 1e-13);
}

TEST(Integrate, GaussIsOfSixthOrder) {
    const auto rate = [](double, const State<2>& s) { return State<2>{s[1], -s[0]}; };
    const auto error = [&](double h) {
        return std::abs(gauss_legendre(rate, State<2>{1, 0}, 0, 8, h)[0] - std::cos(8.0));
    };
    EXPECT_NEAR(std::log2(error(0.5) / error(0.25)), 6, 0.2);
}

/// The published values of the scenario's body.
TEST(Integrate, ABoxTurnsOverAsOthersFoundIt) {
    const auto rate = [](double, const State<3>& w) {
        return State<3>{(10.0 - 5) / 13 * w[1] * w[2],
                        (5.0 - 13) / 10 * w[2] * w[0],
                        (13.0 - 10) / 5 * w[0] * w[1]};
    };
    const Agreed<3> at = integrate(rate, State<3>{0.01, 5, 0.01}, 0, 10);
    EXPECT_LT(at.difference, 1e-10);
    EXPECT_NEAR(at.state[0], 1.035165, 1e-6);
    EXPECT_NEAR(at.state[1], 4.771933, 1e-6);
    EXPECT_NEAR(at.state[2], -1.292900, 1e-6);
}

}  // namespace
}  // namespace plumbline::study
