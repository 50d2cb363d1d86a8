#include "engine/physics/sheet_lines.h"

#include <type_traits>

namespace plumbline::physics {
namespace {

/// Of a point that nothing moves, kg.
constexpr double kHeld_kg = 1e12;
/// Shorter threads have no direction.
constexpr double kNoLength_m = 1e-9;
/// Lines that are solved side by side.
constexpr std::size_t kAtOnce = 4;

}  // namespace

void ThreadFamily::measure(std::span<const Vec3d> positions_m) {
    is_braced_ = false;
    for (Thread& thread : threads) {
        const Vec3d along = positions_m[thread.b] - positions_m[thread.a];
        thread.length_m = glm::length(along);
        thread.direction = thread.length_m > kNoLength_m ? along * (1 / thread.length_m) : Vec3d{0};
        thread.yields_a = thread.yields_b = thread.direction;
    }
}

void ThreadFamily::brace(std::span<const Vec3d> normals) {
    is_braced_ = true;
    for (Thread& thread : threads) {
        thread.yields_a -= normals[thread.a] * glm::dot(normals[thread.a], thread.direction);
        thread.yields_b -= normals[thread.b] * glm::dot(normals[thread.b], thread.direction);
    }
}

template <class F>
void ThreadFamily::for_lines(const F& visit) const {
    const std::size_t lines = threads.size() / per_line;
    std::size_t line = 0;
    for (; line + kAtOnce <= lines; line += kAtOnce)
        visit(std::integral_constant<std::size_t, kAtOnce>{}, line * per_line);
    for (; line < lines; ++line) visit(std::integral_constant<std::size_t, 1>{}, line * per_line);
}

void ThreadFamily::factor(double scale_s2, std::span<const double> inverse_masses) {
    factors_.resize(threads.size());
    for_lines([&](auto lines, std::size_t first) {
        factor_lines<lines>(first, scale_s2, inverse_masses);
    });
}

/// Thomas's algorithm: what of it does not depend on velocities.
template <std::size_t kLines>
void ThreadFamily::factor_lines(std::size_t first,
                                double scale_s2,
                                std::span<const double> inverse_masses) {
    for (std::size_t i = 0; i < per_line; ++i) {
        for (std::size_t line = 0; line < kLines; ++line) {
            const std::size_t at = first + line * per_line + i;
            const Thread& thread = threads[at];
            Factors& row = factors_[at];
            const double w_a = inverse_masses[thread.a];
            const double w_b = inverse_masses[thread.b];
            row.stiff_kg = w_a + w_b > 0 ? thread.stiffness_Npm * scale_s2 : 0;
            double diagonal = 1 + row.stiff_kg * (w_a * glm::dot(thread.yields_a, thread.yields_a) +
                                                  w_b * glm::dot(thread.yields_b, thread.yields_b));
            if (i > 0) {
                row.lower =
                    -row.stiff_kg * w_a * glm::dot(thread.yields_a, threads[at - 1].yields_b);
                diagonal -= row.lower * factors_[at - 1].upper;
            }
            row.inverse = 1 / diagonal;
            row.upper = i + 1 < per_line ? -row.stiff_kg * w_b * row.inverse *
                                               glm::dot(thread.yields_b, threads[at + 1].yields_a)
                                         : 0;
        }
    }
}

void ThreadFamily::relax(std::span<const double> inverse_masses,
                         std::span<Vec3d> velocities_mps,
                         std::span<Vec3d> held_Ns) {
    pulls_Ns_.resize(threads.size());
    for_lines([&](auto lines, std::size_t first) { find_pulls<lines>(first, velocities_mps); });
    const auto hold =
        [&](std::uint32_t point, const Vec3d& along, const Vec3d& yields, double pull) {
            if (!(inverse_masses[point] > 0))
                held_Ns[point] += along * pull;
            else if (is_braced_)
                held_Ns[point] += (along - yields) * pull;
        };
    for (std::size_t i = 0; i < threads.size(); ++i) {
        const Thread& thread = threads[i];
        const double pull_Ns = pulls_Ns_[i];
        velocities_mps[thread.a] += thread.yields_a * (pull_Ns * inverse_masses[thread.a]);
        velocities_mps[thread.b] -= thread.yields_b * (pull_Ns * inverse_masses[thread.b]);
        hold(thread.a, thread.direction, thread.yields_a, pull_Ns);
        hold(thread.b, thread.direction, thread.yields_b, -pull_Ns);
    }
}

template <std::size_t kLines>
void ThreadFamily::find_pulls(std::size_t first, std::span<const Vec3d> velocities_mps) {
    for (std::size_t i = 0; i < per_line; ++i) {
        for (std::size_t line = 0; line < kLines; ++line) {
            const std::size_t at = first + line * per_line + i;
            const Thread& thread = threads[at];
            const Factors& row = factors_[at];
            double pull_Ns =
                row.stiff_kg *
                glm::dot(thread.direction, velocities_mps[thread.b] - velocities_mps[thread.a]);
            if (i > 0) pull_Ns -= row.lower * pulls_Ns_[at - 1];
            pulls_Ns_[at] = pull_Ns * row.inverse;
        }
    }
    for (std::size_t i = per_line; i-- > 1;) {
        for (std::size_t line = 0; line < kLines; ++line) {
            const std::size_t at = first + line * per_line + i;
            pulls_Ns_[at - 1] -= factors_[at - 1].upper * pulls_Ns_[at];
        }
    }
}

void StripFamily::relax(double scale_s2,
                        std::span<const double> inverse_masses,
                        std::span<Vec3d> velocities_mps) {
    for (const Strip& strip : strips) {
        const double k = strip.stiffness_Npm * scale_s2;
        const std::uint32_t n = strip.count;
        if (n < 3 || !(k > 0)) continue;
        const auto point = [&](std::uint32_t i) { return strip.first + i * strip.stride; };
        rows_.assign(n, Row{});
        // M + k D^T D with D the second differences, as L diag L^T, and forward substitution, row by row.
        for (std::uint32_t i = 0; i < n; ++i) {
            const double w = inverse_masses[point(i)];
            const double mass_kg = w > 0 ? 1 / w : kHeld_kg;
            rows_[i].diagonal += mass_kg;
            rows_[i].momentum = velocities_mps[point(i)] * mass_kg;
            if (i + 2 >= n) continue;
            const double held =
                k * clamp_factor(w, inverse_masses[point(i + 1)], inverse_masses[point(i + 2)]);
            rows_[i].diagonal += held;
            rows_[i + 1].diagonal += 4 * held;
            rows_[i + 2].diagonal += held;
            rows_[i].next -= 2 * held;
            rows_[i + 1].next -= 2 * held;
            rows_[i].second += held;
        }
        for (std::uint32_t i = 0; i < n; ++i) {
            Row& row = rows_[i];
            const double next = row.next / row.diagonal;
            const double second = row.second / row.diagonal;
            if (i + 1 < n) {
                rows_[i + 1].diagonal -= next * row.next;
                rows_[i + 1].next -= next * row.second;
                rows_[i + 1].momentum -= next * row.momentum;
            }
            if (i + 2 < n) {
                rows_[i + 2].diagonal -= second * row.second;
                rows_[i + 2].momentum -= second * row.momentum;
            }
            row.next = next;
            row.second = second;
        }
        for (std::uint32_t i = n; i-- > 0;) {
            Vec3d& velocity = velocities_mps[point(i)];
            velocity = rows_[i].momentum / rows_[i].diagonal;
            if (i + 1 < n) velocity -= rows_[i].next * velocities_mps[point(i + 1)];
            if (i + 2 < n) velocity -= rows_[i].second * velocities_mps[point(i + 2)];
        }
    }
}

}  // namespace plumbline::physics
