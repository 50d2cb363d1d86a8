#include "engine/scene/wind_field.h"

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
    const double turn = 2.0 * glm::pi<double>();
    std::array<GustWave, 2> waves;
    for (std::size_t i = 0; i < waves.size(); ++i) {
        const double unit = turn / static_cast<double>(wind.gust_size_m);
        const double phase =
            -kShapes[i].along * unit * static_cast<double>(wind.speed_mps) * time_s;
        waves[i] = {.number_radpm = along * static_cast<Real>(kShapes[i].along * unit) +
                                    across * static_cast<Real>(kShapes[i].across * unit),
                    .phase_rad = static_cast<Real>(phase - turn * std::floor(phase / turn)),
                    .speed_mps = wind.speed_mps * wind.gusts * static_cast<Real>(kShapes[i].share)};
    }
    return waves;
}

Vec3 wind_at(const WindDescription& wind, const Vec3& place_world, double time_s) {
    Vec3 velocity = wind.direction * wind.speed_mps;
    for (const GustWave& wave : waves_at(wind, time_s)) {
        const Vec2 number = wave.number_radpm;
        const Real sine =
            std::sin(number.x * place_world.x + number.y * place_world.z + wave.phase_rad);
        const Real strength = wave.speed_mps * sine / glm::length(number);
        velocity += Vec3{-number.y, 0, number.x} * strength;
    }
    return velocity;
}

}  // namespace plumbline::scene
