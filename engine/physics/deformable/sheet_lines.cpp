#include "engine/physics/sheet_lines.h"

namespace plumbline::physics {
namespace {

/// Of a point that nothing moves, kg.
constexpr double kHeld_kg = 1e12;

}  // namespace

void ThreadFamily::relax(double scale_s2,
                         std::span<const double> inverse_masses,
                         std::span<Vec3d> velocities_mps,
                         std::span<Vec3d> held_Ns) {
    std::size_t first = 0;
    for (const std::uint32_t end : line_ends) {
        const std::size_t count = end - first;
        upper_.resize(count);
        pulls_Ns_.resize(count);
        double lower = 0;
        for (std::size_t i = 0; i < count; ++i) {
            const Thread& thread = threads[first + i];
            const double w_a = inverse_masses[thread.a];
            const double w_b = inverse_masses[thread.b];
            double diagonal = 1;
            double opening = 0;
            double next = 0;
            if (thread.stiffness_Npm > 0 && w_a + w_b > 0) {
                diagonal = 1 / (thread.stiffness_Npm * scale_s2) + w_a + w_b;
                opening =
                    glm::dot(thread.direction, velocities_mps[thread.b] - velocities_mps[thread.a]);
                if (i > 0) {
                    diagonal -= lower * upper_[i - 1];
                    opening -= lower * pulls_Ns_[i - 1];
                }
                if (i + 1 < count && threads[first + i + 1].stiffness_Npm > 0)
                    next = -w_b * glm::dot(thread.direction, threads[first + i + 1].direction);
            }
            upper_[i] = next / diagonal;
            pulls_Ns_[i] = opening / diagonal;
            lower = next;
        }
        for (std::size_t i = count; i-- > 0;) {
            if (i + 1 < count) pulls_Ns_[i] -= upper_[i] * pulls_Ns_[i + 1];
            const Thread& thread = threads[first + i];
            const Vec3d pull = thread.direction * pulls_Ns_[i];
            const double w_a = inverse_masses[thread.a];
            const double w_b = inverse_masses[thread.b];
            velocities_mps[thread.a] += pull * w_a;
            velocities_mps[thread.b] -= pull * w_b;
            if (!(w_a > 0)) held_Ns[thread.a] += pull;
            if (!(w_b > 0)) held_Ns[thread.b] -= pull;
        }
        first = end;
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
