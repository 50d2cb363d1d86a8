// Reference solutions of ordinary differential equations: two integrators that share nothing, and
// how far they agree.
#pragma once

#include "engine/core/assert.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace plumbline::study {

/// The value in [low, high] above which `holds` is true, by halving.
template <class Holds>
double threshold_of(double low, double high, int halvings, const Holds& holds) {
    for (int i = 0; i < halvings; ++i) {
        const double middle = (low + high) / 2;
        (holds(middle) ? high : low) = middle;
    }
    return (low + high) / 2;
}

template <std::size_t N>
using State = std::array<double, N>;

/// What two integrators made of it.
template <std::size_t N>
struct Agreed {
    State<N> state;
    double difference;  ///< largest of any component, relative to the larger of it and 1
};

template <std::size_t N>
State<N> ahead(const State<N>& from, double factor, const State<N>& rate) {
    State<N> to = from;
    for (std::size_t i = 0; i < N; ++i) to[i] += factor * rate[i];
    return to;
}

/// A state that steps are added to without rounding piling up (Kahan 1965): what follows from a start
/// next to an unstable motion multiplies every rounding by 10^6.
template <std::size_t N>
struct SummedState {
    State<N> sum;
    State<N> lost{};

    void add(const State<N>& step) {
        for (std::size_t i = 0; i < N; ++i) {
            const double corrected = step[i] - lost[i];
            const double next = sum[i] + corrected;
            lost[i] = (next - sum[i]) - corrected;
            sum[i] = next;
        }
    }
};

template <std::size_t N>
double largest_difference(const State<N>& a, const State<N>& b) {
    double largest = 0;
    for (std::size_t i = 0; i < N; ++i)
        largest = std::max(largest, std::abs(a[i] - b[i]) / std::max(1.0, std::abs(b[i])));
    return largest;
}

/// Dormand and Prince 1980, fifth order with a fourth-order error estimate ("A family of embedded
/// Runge-Kutta formulae", J. Comput. Appl. Math. 6), step chosen by `tolerance`. `rate(t, state)`.
template <std::size_t N, class Rate>
State<N> dormand_prince(const Rate& rate, const State<N>& from, double from_s, double to_s) {
    constexpr double kTolerance = 1e-17;
    constexpr double kA[6][6] = {
        {1.0 / 5},
        {3.0 / 40, 9.0 / 40},
        {44.0 / 45, -56.0 / 15, 32.0 / 9},
        {19372.0 / 6561, -25360.0 / 2187, 64448.0 / 6561, -212.0 / 729},
        {9017.0 / 3168, -355.0 / 33, 46732.0 / 5247, 49.0 / 176, -5103.0 / 18656},
        {35.0 / 384, 0, 500.0 / 1113, 125.0 / 192, -2187.0 / 6784, 11.0 / 84}};
    constexpr double kC[7] = {0, 1.0 / 5, 3.0 / 10, 4.0 / 5, 8.0 / 9, 1, 1};
    constexpr double kError[7] = {
        71.0 / 57600, 0, -71.0 / 16695, 71.0 / 1920, -17253.0 / 339200, 22.0 / 525, -1.0 / 40};
    SummedState<N> state{from};
    double t = from_s;
    double h = std::min(1e-3, to_s - from_s);
    while (t < to_s) {
        h = std::min(h, to_s - t);
        std::array<State<N>, 7> k;
        k[0] = rate(t, state.sum);
        State<N> step{};
        for (std::size_t stage = 1; stage < 7; ++stage) {
            step = {};
            for (std::size_t i = 0; i < stage; ++i) step = ahead(step, h * kA[stage - 1][i], k[i]);
            k[stage] = rate(t + kC[stage] * h, ahead(state.sum, 1, step));
        }
        double error = 0;
        for (std::size_t i = 0; i < N; ++i) {
            double sum = 0;
            for (std::size_t stage = 0; stage < 7; ++stage) sum += kError[stage] * k[stage][i];
            error = std::max(error, std::abs(h * sum) / std::max(1.0, std::abs(state.sum[i])));
        }
        if (error <= kTolerance) {
            t += h;
            state.add(step);
        }
        h *= std::clamp(0.9 * std::pow(kTolerance / std::max(error, 1e-300), 0.2), 0.2, 4.0);
    }
    return state.sum;
}

/// Gauss and Legendre's implicit Runge-Kutta method of three stages, sixth order (Hairer, Lubich and
/// Wanner, "Geometric Numerical Integration", II.1.3), solved by fixed-point iteration.
template <std::size_t N, class Rate>
State<N> gauss_legendre(
    const Rate& rate, const State<N>& from, double from_s, double to_s, double longest_s) {
    const double root = std::sqrt(15.0);
    const double a[3][3] = {{5.0 / 36, 2.0 / 9 - root / 15, 5.0 / 36 - root / 30},
                            {5.0 / 36 + root / 24, 2.0 / 9, 5.0 / 36 - root / 24},
                            {5.0 / 36 + root / 30, 2.0 / 9 + root / 15, 5.0 / 36}};
    const double b[3] = {5.0 / 18, 4.0 / 9, 5.0 / 18};
    const double c[3] = {0.5 - root / 10, 0.5, 0.5 + root / 10};
    SummedState<N> state{from};
    const int steps = std::max(1, static_cast<int>(std::ceil((to_s - from_s) / longest_s)));
    const double h = (to_s - from_s) / steps;
    for (int n = 0; n < steps; ++n) {
        const double t = from_s + n * h;
        std::array<State<N>, 3> k;
        k.fill(rate(t, state.sum));
        for (int sweep = 0; sweep < 30; ++sweep) {
            double change = 0;
            for (std::size_t i = 0; i < 3; ++i) {
                State<N> at = state.sum;
                for (std::size_t j = 0; j < 3; ++j) at = ahead(at, h * a[i][j], k[j]);
                const State<N> found = rate(t + c[i] * h, at);
                change = std::max(change, h * largest_difference(found, k[i]));
                k[i] = found;
            }
            if (change < 1e-16) break;
        }
        State<N> step{};
        for (std::size_t i = 0; i < 3; ++i) step = ahead(step, h * b[i], k[i]);
        state.add(step);
    }
    return state.sum;
}

/// Where `state` is at `to_s`, by both.
template <std::size_t N, class Rate>
Agreed<N> integrate(
    const Rate& rate, const State<N>& state, double from_s, double to_s, double longest_s = 1e-3) {
    if (to_s <= from_s) return {state, 0};
    const State<N> one = dormand_prince(rate, state, from_s, to_s);
    const State<N> other = gauss_legendre(rate, state, from_s, to_s, longest_s);
    return {other, largest_difference(one, other)};
}

/// As integrate(), for references: that they agree to 1e-10 is ours to see to.
template <std::size_t N, class Rate>
State<N> reference(
    const Rate& rate, const State<N>& state, double from_s, double to_s, double longest_s = 1e-3) {
    const Agreed<N> agreed = integrate(rate, state, from_s, to_s, longest_s);
    PL_ASSERT(agreed.difference < 1e-10, "two integrators that agree to 1e-10");
    return agreed.state;
}

}  // namespace plumbline::study
