// The wind in the ear, as strong as it blows there, less in the lee of what stands upwind.
#include "engine/effects/callers.h"
#include "engine/effects/effect_table.h"
#include "engine/effects/sound/sound_bank.h"
#include "engine/effects/sound/sound_obstacles.h"
#include "engine/scene/environment/wind_field.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace plumbline::effects {

namespace {

constexpr double kShelterEvery_s = 0.2;
constexpr double kShelterSmoothing_s = 0.5;
constexpr Real kShelterReach_m = 12;
constexpr float kShelteredShare = 0.15F;  ///< of the loudness, where every way is shut
constexpr float kLoudestWind = 4.0F;      ///< times the mean's
constexpr std::uint64_t kWindKey = (std::uint64_t{1} << 63U) | 0x77696E64U;

class WindSound final : public Effect {
public:
    explicit WindSound(scene::Simulation& simulation)
        : sound_(bank_.get(simulation, simulation.description().wind->sound)) {}

    void sound(const scene::Simulation& simulation,
               const scene::ViewPoint& view,
               SoundFrame& frame) override {
        const scene::WindDescription& wind = *simulation.description().wind;
        const Vec3& ear = view.world_from_camera.position;
        follow_shelter(simulation, wind, ear);
        if (sound_ == assets::SoundId{} || wind.speed_mps <= 0) return;
        const Vec3 air = scene::wind_at(wind, ear, simulation.time_s());
        const Real strength = glm::length(air) / wind.speed_mps;
        const auto share = static_cast<float>(strength);
        // It comes from where it blows from, and from above: it is round the head.
        constexpr Real kBeside_m = 0.4_r;
        constexpr Real kAbove_m = 0.7_r;
        const Vec3 upwind = -normalize_or(air, wind.direction);
        const Vec3 from = ear + upwind * kBeside_m + Vec3{0, kAbove_m, 0};
        frame.loops.push_back(
            {.key = kWindKey,
             .sound = sound_,
             .position_world = Vec3f(from),
             .gain = wind.sound_gain * std::min(share * share, kLoudestWind) * exposed_,
             .pitch = std::clamp(0.85F + 0.15F * share, 0.85F, 1.3F),
             .radius_m = 20.0F});
        ++work_.calls;
    }

    std::uint64_t bytes_held() const override { return bank_.bytes(); }

private:
    void follow_shelter(const scene::Simulation& simulation,
                        const scene::WindDescription& wind,
                        const Vec3& ear) {
        const double now_s = simulation.time_s();
        const double elapsed_s = std::clamp(now_s - latest_s_, 0.0, 1.0);
        latest_s_ = now_s;
        if (!is_looked_ || std::abs(now_s - looked_s_) >= kShelterEvery_s) {
            looked_s_ = now_s;
            const Vec3 upwind = -wind.direction;
            const Vec3 side = glm::cross(upwind, Vec3{0, 1, 0});
            // Past what stands beside one, and over it.
            const std::array<Vec3, 4> directions{upwind,
                                                 glm::normalize(upwind + side * 0.6_r),
                                                 glm::normalize(upwind - side * 0.6_r),
                                                 glm::normalize(upwind + Vec3{0, 1, 0})};
            const physics::QueryFilter filter = rays_from_ear(simulation, ear);
            const auto open = std::ranges::count_if(directions, [&](const Vec3& direction) {
                return !cast_ray(
                    simulation.physics, ear, ear + direction * kShelterReach_m, filter);
            });
            const float free = static_cast<float>(open) / static_cast<float>(directions.size());
            wanted_ = kShelteredShare + (1.0F - kShelteredShare) * free;
            if (!std::exchange(is_looked_, true)) exposed_ = wanted_;
        }
        const auto share = static_cast<float>(1.0 - std::exp(-elapsed_s / kShelterSmoothing_s));
        exposed_ += share * (wanted_ - exposed_);
    }

    SoundBank bank_;
    assets::SoundId sound_;
    float exposed_{1.0F};
    float wanted_{1.0F};
    bool is_looked_{false};
    double looked_s_{0};
    double latest_s_{0};
};

Callers callers_of_wind_sound(const scene::Simulation& simulation) {
    const auto& wind = simulation.description().wind;
    if (!wind || wind->sound.empty() || !simulation.switches.is_on("wind_sound", true)) return {};
    return {setting("[wind] sound", wind->location)};
}

}  // namespace

EffectRow wind_sound() {
    return with_effect<WindSound>({.called_for_by = &callers_of_wind_sound});
}

}  // namespace plumbline::effects
