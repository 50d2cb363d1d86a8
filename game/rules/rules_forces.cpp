// What pushes things without a hand: a shot, a lift, an explosion.
#include "engine/physics/query.h"
#include "game/rules/rules.h"

#include <algorithm>
#include <map>

namespace plumbline::game {
namespace {

constexpr Real kShot_mps = 25;
constexpr Real kLift_N = 20;
constexpr Real kArm_m = 12;  // what an eye aims at; a free pointer reaches on
constexpr Real kExplosion_m = 3;
constexpr Real kExplosion_Nsm = 50;  // N s at 1 m, the less the farther
constexpr Real kNearestBlast_m = 0.25_r;

bool is_loose(const physics::PhysicsWorld& world, physics::BodyId body) {
    return world.contains(body) && world.state(body).pushable();
}

}  // namespace

void PlaygroundGame::shoot(scene::Simulation& simulation, const Actions& actions) {
    for (int i = 0; i < actions.presses(Action::Shoot); ++i) {
        const Aim now = aim();
        const auto made = things_.put_shot(simulation, now, now.forward * kShot_mps);
        if (!made) say(made.error().message);
        things_.keep_limit(simulation);
    }
}

/// What is pointed at when the key goes down is lifted until it goes up. Beside everything, a free
/// pointer lifts the scene's first body: stages of a lesson have one that matters.
void PlaygroundGame::lift(scene::Simulation& simulation, const Actions& actions) {
    const physics::PhysicsWorld& world = simulation.physics;
    if (actions.presses(Action::Lift) > 0) {
        const auto looked = looked_at(simulation, aim(), kArm_m);
        keys_.lifted = looked ? looked->body : physics::BodyId{};
        const auto first = std::ranges::find_if(
            simulation.moving_bodies(),
            [&](const scene::MovingBody& moving) { return is_loose(world, moving.body); });
        if (!is_loose(world, keys_.lifted) && pointer_ && first != simulation.moving_bodies().end())
            keys_.lifted = first->body;
        if (!is_loose(world, keys_.lifted)) say("nothing to lift");
    }
    if (actions.is_held(Action::Lift) && is_loose(world, keys_.lifted))
        simulation.physics.apply_force(keys_.lifted, {0, kLift_N, 0});
}

void PlaygroundGame::explode(scene::Simulation& simulation, const Actions& actions) {
    if (actions.presses(Action::Explode) == 0) return;
    physics::PhysicsWorld& world = simulation.physics;
    const auto looked = looked_at(simulation, aim(), kArm_m);
    if (!looked) return say("nothing to explode there");
    if (!explosion_) {
        const auto made = world.create_shape(physics::SphereShape{kExplosion_m});
        if (made) explosion_ = *made;
    }
    simulation.bursts.push_back({.kind = scene::Burst::Kind::Explosion,
                                 .point_world = looked->point_m,
                                 .strength = static_cast<double>(kExplosion_Nsm)});
    std::map<physics::BodyId, Vec3> reached;  // and where it is struck
    for (const physics::OverlapHit& hit :
         physics::overlaps(world, explosion_, Pose{.position = looked->point_m}, Real{0})) {
        if (is_loose(world, hit.body)) reached.emplace(hit.body, hit.point_world);
    }
    for (const auto& [body, struck_m] : reached) {
        const Vec3 offset = world.state(body).center_of_mass_world() - looked->point_m;
        const Real distance_m = std::max(glm::length(offset), kNearestBlast_m);
        const Vec3 out = normalize_or(offset, Vec3{0, 1, 0});
        const Vec3 impulse_Ns = out * (kExplosion_Nsm / distance_m);
        world.apply_impulse(body, impulse_Ns);
        simulation.blows.push_back({body, impulse_Ns, struck_m});
    }
}

}  // namespace plumbline::game
