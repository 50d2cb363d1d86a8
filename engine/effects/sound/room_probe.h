// What room a point is in, by rays in all directions.
#pragma once

#include "engine/audio/sound_cue.h"
#include "engine/scene/simulation.h"

#include <cstddef>
#include <vector>

namespace plumbline::effects {

/// Of the walls seen from a point. In a closed convex room volume and surface are the true ones as
/// rays grow many, wherever the point is.
struct RoomEstimate {
    float volume_m3{0};
    float surface_m2{0};
    float absorption_m2{0};  ///< an opening is as large as walls on average there would be
    float openness{
        1};  ///< 0…1: share of directions in which nothing is met, or what is far outside
};

/// Takes few rays at a time and keeps what they met: the estimate gets better while one stays.
class RoomProbe {
public:
    static constexpr std::size_t kDirections = 512;
    static constexpr float kReach_m = 40.0F;

    void cast(const scene::Simulation& simulation, const Vec3& ear_world, std::size_t rays);
    RoomEstimate estimate(const Vec3& ear_world) const;
    std::size_t bytes() const { return samples_.capacity() * sizeof(Sample); }

private:
    struct Sample {
        Vec3f from_world{0.0F};
        float distance_m{0};  ///< 0: nothing was met
        float area_m2{0};     ///< of wall for each steradian
        float absorption{0};
    };
    /// What is met farther off is outside, through a door or a window.
    float farthest_wall_m(const Vec3& ear_world) const;

    std::vector<Sample> samples_;  ///< by direction, as many as were cast so far
    std::size_t next_{0};
};

/// How the room sounds; gain 0 in the open.
audio::Room room_of(const RoomEstimate& estimate);

}  // namespace plumbline::effects
