#include "engine/scene/environment/wind_field.h"

#include <cmath>

namespace plumbline::scene {

std::array<GustWave, 2> waves_at(const WindDescription& wind, double time_s) {
    // Numbers along and across the mean, in units of the gusts' size: none stands still in it, and
    // their sum repeats late.
    struct Shape {
        double along;
        double across;
        double share;
    };
    constexpr std::array<Shape, 2> kShapes{{{0.62, 0.78, 0.6}, {0.47, -1.31, 0.4}}};
    const Vec2 along{wind.direction.x, wind.direction.z};
    const Vec2 across{-along.y, along.x};
    const double turn_rad = 2.0 * glm::pi<double>();
    std::array<GustWave, 2> waves;
    for (std::size_t i = 0; i < waves.size(); ++i) {
        const double unit_radpm = turn_rad / static_cast<double>(wind.gust_size_m);
        const double along_radpm = kShapes[i].along * unit_radpm;
        const double across_radpm = kShapes[i].across * unit_radpm;
        const double passed = along_radpm * static_cast<double>(wind.speed_mps) * time_s / turn_rad;
        const double phase_rad = turn_rad * (std::ceil(passed) - passed);
        const double share = kShapes[i].share;
        waves[i] = {.number_radpm = along * static_cast<Real>(along_radpm) +
                                    across * static_cast<Real>(across_radpm),
                    .phase_rad = static_cast<Real>(phase_rad),
                    .speed_mps = wind.speed_mps * wind.gusts * static_cast<Real>(share)};
    }
    return waves;
}

Vec3 wind_at(const WindDescription& wind, const Vec3& place_world, double time_s) {
    Vec3 velocity = wind.direction * wind.speed_mps;
    for (const GustWave& wave : waves_at(wind, time_s)) {
        const Vec2 number = wave.number_radpm;
        const Real sine =
            portable_sin(number.x * place_world.x + number.y * place_world.z + wave.phase_rad);
        const Real strength = wave.speed_mps * sine / glm::length(number);
        velocity += Vec3{-number.y, 0, number.x} * strength;
    }
    return velocity;
}

}  // namespace plumbline::scene
