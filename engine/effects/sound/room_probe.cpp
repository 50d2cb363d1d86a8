#include "engine/effects/sound/room_probe.h"

#include "engine/effects/sound/acoustics.h"
#include "engine/effects/sound/sound_obstacles.h"
#include "engine/scene/simulation/entity_lookup.h"

#include <algorithm>
#include <cmath>

namespace plumbline::effects {

namespace {

constexpr float kHeardFrom_m = 1.5F;   ///< what was met from farther off may be another room's
constexpr float kLeastCosine = 0.02F;  ///< a wall seen along its face
constexpr std::size_t kLeastSamples = 64;
constexpr float kRoomBelow = 0.12F;  ///< openness of a room with door and windows open
constexpr float kOpenAbove = 0.3F;   ///< that of a place beside a wall

/// Evenly over the sphere (a Fibonacci spiral), and any few in a row too.
Vec3 direction_of(std::size_t index) {
    constexpr std::size_t kStride = 197;  // has no divisor with the count
    constexpr double kGoldenAngle_rad = 2.399963229728653;
    const auto i = static_cast<double>(index * kStride % RoomProbe::kDirections);
    const double y = 1.0 - 2.0 * (i + 0.5) / static_cast<double>(RoomProbe::kDirections);
    const double r = std::sqrt(1.0 - y * y);
    return Vec3(Vec3d{r * std::cos(kGoldenAngle_rad * i), y, r * std::sin(kGoldenAngle_rad * i)});
}

float absorption_of(const scene::Simulation& simulation, std::uint64_t user) {
    return simulation.surfaces().get(surface_of_mark(simulation, user)).absorption;
}

}  // namespace

void RoomProbe::cast(const scene::Simulation& simulation, const Vec3& ear_world, std::size_t rays) {
    samples_.reserve(kDirections);
    const physics::QueryFilter filter = rays_from_ear(simulation, ear_world);
    for (std::size_t i = 0; i < rays; ++i, next_ = (next_ + 1) % kDirections) {
        const Vec3 direction = direction_of(next_);
        Sample sample{.from_world = Vec3f(ear_world)};
        const auto hit =
            cast_ray(simulation.physics, ear_world, ear_world + direction * Real{kReach_m}, filter);
        if (hit) {
            const Real facing = std::abs(glm::dot(hit->normal_world, direction));
            const auto cosine = static_cast<float>(facing);
            sample.distance_m = static_cast<float>(hit->distance_m);
            sample.area_m2 = sample.distance_m * sample.distance_m / std::max(cosine, kLeastCosine);
            sample.absorption = absorption_of(simulation, hit->user);
        }
        if (next_ < samples_.size())
            samples_[next_] = sample;
        else
            samples_.push_back(sample);
    }
}

float RoomProbe::farthest_wall_m(const Vec3& ear_world) const {
    constexpr float kTimes =
        3.5F;  // of what four fifths are nearer than: in a corner most are near
    std::vector<float> distances_m;
    for (const Sample& sample : samples_) {
        const bool is_here = glm::distance(sample.from_world, Vec3f(ear_world)) <= kHeardFrom_m;
        if (is_here && sample.distance_m > 0.0F) distances_m.push_back(sample.distance_m);
    }
    if (distances_m.empty()) return 0.0F;
    const auto fifth = distances_m.end() - 1 - static_cast<std::ptrdiff_t>(distances_m.size() / 5);
    std::nth_element(distances_m.begin(), fifth, distances_m.end());
    return kTimes * *fifth;
}

RoomEstimate RoomProbe::estimate(const Vec3& ear_world) const {
    const float farthest_m = farthest_wall_m(ear_world);
    double volume = 0;
    double surface = 0;
    double absorption = 0;
    std::size_t met = 0;
    std::size_t all = 0;
    for (const Sample& sample : samples_) {
        if (glm::distance(sample.from_world, Vec3f(ear_world)) > kHeardFrom_m) continue;
        ++all;
        if (sample.distance_m <= 0.0F || sample.distance_m > farthest_m) continue;
        ++met;
        const auto distance_m = static_cast<double>(sample.distance_m);
        volume += distance_m * distance_m * distance_m / 3.0;
        surface += static_cast<double>(sample.area_m2);
        absorption += static_cast<double>(sample.area_m2 * sample.absorption);
    }
    if (all < kLeastSamples || met == 0) return {};
    const double each = 4.0 * static_cast<double>(kPi) / static_cast<double>(met);
    const double open = 1.0 - static_cast<double>(met) / static_cast<double>(all);
    return {
        .volume_m3 = static_cast<float>(each * volume),
        .surface_m2 = static_cast<float>(each * surface),
        .absorption_m2 = static_cast<float>(each * ((1.0 - open) * absorption + open * surface)),
        .openness = static_cast<float>(open)};
}

audio::Room room_of(const RoomEstimate& estimate) {
    const float share = (kOpenAbove - estimate.openness) / (kOpenAbove - kRoomBelow);
    const float enclosed = std::clamp(share, 0.0F, 1.0F);
    if (enclosed <= 0.0F || !(estimate.surface_m2 > 0.0F)) return {};
    constexpr float kLongest_s = 20.0F;
    return {.gain = enclosed * std::min(reverberant_share(estimate.absorption_m2), 1.0F),
            .decay_s = std::clamp(
                reverberation_s(estimate.volume_m3, estimate.absorption_m2), 0.1F, kLongest_s),
            .size_m = 4.0F * estimate.volume_m3 / estimate.surface_m2};
}

}  // namespace plumbline::effects
