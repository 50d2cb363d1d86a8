#include "engine/physics/sheet_lines.h"

namespace plumbline::physics {
namespace {

/// Of a point that nothing moves, kg.
constexpr double kHeld_kg = 1e12;
/// Shorter threads have no direction.
constexpr double kNoLength_m = 1e-9;

}  // namespace

void ThreadFamily::measure(std::span<const Vec3d> positions_m) {
    for (Thread& thread : threads) {
        const Vec3d along = positions_m[thread.b] - positions_m[thread.a];
        thread.length_m = glm::length(along);
        thread.direction = thread.length_m > kNoLength_m ? along / thread.length_m : Vec3d{0};
    }
}

void ThreadFamily::relax(double scale_s2,
                         std::span<const double> inverse_masses,
                         std::span<Vec3d> velocities_mps,
                         std::span<Vec3d> held_Ns) {
    std::size_t first = 0;
    for (const std::uint32_t end : line_ends) {
        const std::span<const Thread> line{threads.data() + first, end - first};
        find_pulls(line, scale_s2, inverse_masses, velocities_mps);
        for (std::size_t i = 0; i < line.size(); ++i) {
            const Vec3d pull = line[i].direction * pulls_Ns_[i];
            const double w_a = inverse_masses[line[i].a];
            const double w_b = inverse_masses[line[i].b];
            velocities_mps[line[i].a] += pull * w_a;
            velocities_mps[line[i].b] -= pull * w_b;
            if (!(w_a > 0)) held_Ns[line[i].a] += pull;
            if (!(w_b > 0)) held_Ns[line[i].b] -= pull;
        }
        first = end;
    }
}

/// Thomas's algorithm.
void ThreadFamily::find_pulls(std::span<const Thread> line,
                              double scale_s2,
                              std::span<const double> inverse_masses,
                              std::span<const Vec3d> velocities_mps) {
    upper_.assign(line.size(), 0);
    pulls_Ns_.assign(line.size(), 0);
    double lower = 0;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const Thread& thread = line[i];
        const double w_b = inverse_masses[thread.b];
        const double weight = inverse_masses[thread.a] + w_b;
        if (!(thread.stiffness_Npm > 0 && weight > 0)) {
            lower = 0;
            continue;
        }
        double diagonal = 1 / (thread.stiffness_Npm * scale_s2) + weight;
        double opening =
            glm::dot(thread.direction, velocities_mps[thread.b] - velocities_mps[thread.a]);
        if (i > 0) {
            diagonal -= lower * upper_[i - 1];
            opening -= lower * pulls_Ns_[i - 1];
        }
        const bool goes_on = i + 1 < line.size() && line[i + 1].stiffness_Npm > 0;
        const double next = goes_on ? -w_b * glm::dot(thread.direction, line[i + 1].direction) : 0;
        upper_[i] = next / diagonal;
        pulls_Ns_[i] = opening / diagonal;
        lower = next;
    }
    for (std::size_t i = line.size(); i-- > 1;) pulls_Ns_[i - 1] -= upper_[i - 1] * pulls_Ns_[i];
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
