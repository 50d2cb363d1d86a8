// Ropes of a running scene.
#pragma once

#include "engine/core/math.h"
#include "engine/physics/body.h"
#include "engine/physics/joint.h"

#include <array>
#include <string>
#include <vector>

namespace plumbline::scene {

/// A rope: pieces from a to b, and what holds them.
struct Rope {
    std::string name;
    double piece_m{0};                      ///< unstretched
    std::array<physics::BodyId, 2> ends{};  ///< null: the world, or nothing
    std::array<Vec3, 2> anchors_m{};        ///< in these bodies' frames; of the world, world
    std::vector<physics::BodyId> pieces;
    /// One before each piece, and one after the last where b is tied to something.
    std::vector<physics::JointId> joints;
    bool tied{false};  ///< in play, not by the scene's file
};

/// What a rope is tied between in play.
struct RopeEnds {
    static constexpr double kShortest_m = 0.2;
    static constexpr double kLongest_m = 20;

    std::array<std::string, 2> names{};  ///< of entities; "world": what stands still
    std::array<Vec3, 2> anchors_world_m{};

    double apart_m() const {
        return glm::distance(Vec3d(anchors_world_m[0]), Vec3d(anchors_world_m[1]));
    }
    void serialize(auto& archive) { archive(names, anchors_world_m); }
};

}  // namespace plumbline::scene
