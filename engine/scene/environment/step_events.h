// What happens in a step beside motion, for the effects that act on it.
#pragma once

#include "engine/core/math.h"
#include "engine/physics/body.h"

#include <cstdint>
#include <filesystem>

namespace plumbline::scene {

/// A push at a place that lasts no time: explosions say theirs here for what they may break.
struct Blow {
    physics::BodyId body{};
    Vec3 impulse_Ns{0, 0, 0};
    Vec3 point_world{0, 0, 0};
};

/// What goes off, breaks, parts or was come into: for who lets it be heard.
struct Burst {
    enum class Kind : std::uint8_t { Explosion, Break, Snap, Trigger };
    Kind kind{Kind::Explosion};
    Vec3 point_world{0, 0, 0};
    double strength{0};             ///< N s of an explosion; kg of what broke; unused of a rope
    std::uint16_t surface{0};       ///< of what broke
    std::filesystem::path sound{};  ///< of a trigger
};

}  // namespace plumbline::scene
