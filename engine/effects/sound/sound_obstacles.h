// What stands between a source of sound and an ear, by the bodies that the straight way crosses.
#pragma once

#include "engine/audio/sound_cue.h"
#include "engine/physics/query.h"
#include "engine/scene/simulation.h"

#include <vector>

namespace plumbline::effects {

/// For rays from an ear: leaves out the body that stands round it and is no entity's, a person's own.
physics::QueryFilter rays_from_ear(const scene::Simulation& simulation, const Vec3& ear_world);

/// A body on the way.
struct SoundObstacle {
    physics::BodyId body{};
    std::uint64_t user{0};
    float thickness_m{0};  ///< of it along the way, all its pieces together
    float at_m{0};         ///< from the source, the middle of the crossing
};

/// Nearest first. Bodies of `made_by`, and those that are no entity's, are not seen; nor what lies
/// within 3 cm of either end: a thing that sounds touches others. Pieces thinner than 2 cm may be missed.
std::vector<SoundObstacle> obstacles_between(const scene::Simulation& simulation,
                                             const Vec3& source_world,
                                             const Vec3& ear_world,
                                             const audio::SoundMakers& made_by);

/// Share of the pressure that arrives, 0…1, beside what distance takes.
struct SoundPath {
    float low{1.0F};   ///< at 250 Hz
    float high{1.0F};  ///< at 5 kHz
};

/// Through each of them by its mass, round it by the shortest detours over the edges of its bounds,
/// and through the gaps that every building has: 20 dB less at 250 Hz, 40 dB at 5 kHz.
SoundPath path_between(const scene::Simulation& simulation,
                       const Vec3& source_world,
                       const Vec3& ear_world,
                       const audio::SoundMakers& made_by);

}  // namespace plumbline::effects
