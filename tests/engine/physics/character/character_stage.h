// A character on a stage of boxes, for tests that predict.
#pragma once

#include "engine/physics/character.h"
#include "engine/physics/query.h"
#include "tests/engine/physics/test_world.h"

#include <algorithm>
#include <cmath>

namespace plumbline::physics {

inline constexpr Real kRadius = 0.3_r;

inline const Vec3 kForward{0, 0, -1};
inline const Vec3 kRight{1, 0, 0};

struct Stage : TestWorld {
    explicit Stage(int hz = 60) : TestWorld(at_hz(hz)), dt(Real{1} / static_cast<Real>(hz)) {}

    BodyId wall(const Vec3& size, const Vec3& position, const Quat& turn = kNoRotation) {
        return world.create_body({.shape = shape(BoxShape{size}),
                                  .world_from_body = {.position = position, .orientation = turn}});
    }
    /// Feet at `feet`; default sizes and speeds.
    Character& enter(const Vec3& feet, CharacterDef def = {}) {
        def.feet_position_m = feet;
        person = std::make_unique<Character>(world, def);
        body_outline = shape(
            CapsuleShape{.radius_m = def.radius_m, .height_m = def.height_m - 2 * def.radius_m});
        return *person;
    }
    const CharacterState& step(const CharacterInput& input = {}) {
        person->update(input);
        world.step();
        return person->state();
    }
    const CharacterState& walk(Real seconds, const Vec3& direction = kForward) {
        for (int i = 0; i < steps_in(seconds); ++i) step({.direction_world = direction});
        return person->state();
    }
    const CharacterState& rest(Real seconds) { return walk(seconds, {0, 0, 0}); }
    int steps_in(Real seconds) const { return static_cast<int>(std::lround(seconds / dt)); }
    Vec3 feet() const { return person->state().feet_position_m; }
    /// Seconds that so many steps take.
    double seconds(int steps) const { return steps * world.def().step_s; }
    /// How deep the person, standing upright, is in anything.
    Real depth() const {
        const Pose pose{.position = feet() + Vec3{0, person->def().height_m / 2, 0}};
        const auto hits = overlaps(world, body_outline, pose, 0, {.ignored = person->body()});
        return hits.empty() ? Real{0} : std::max(hits.front().depth_m, Real{0});
    }

    Real dt;
    ShapeId body_outline{};
    std::unique_ptr<Character> person;  // destroyed before the world
};

/// A kinematic body, led step by step under the person.
struct Platform {
    Stage& stage;
    BodyId body;
    Pose pose;

    Platform(Stage& on, const Vec3& size, const Vec3& position)
        : stage(on),
          body(on.add(BoxShape{size}, position, {.kind = BodyKind::Kinematic})),
          pose{.position = position} {}
    const CharacterState& step(const Pose& next, const CharacterInput& input = {}) {
        pose = next;
        stage.person->update(input);
        stage.world.move_kinematic(body, pose);
        stage.world.step();
        return stage.person->state();
    }
};

inline Quat tilt(Real angle_deg, const Vec3& axis) {
    return glm::angleAxis(radians_from_degrees(angle_deg), axis);
}

}  // namespace plumbline::physics
