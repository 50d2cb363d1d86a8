#include "game/rules/use.h"

#include "engine/scene/extract.h"

#include <algorithm>
#include <cmath>

namespace plumbline::game {

namespace {

constexpr Real kShut_rad = radians_from_degrees(12.0_r);  // nearer than this to it
constexpr Real kWide_rad = radians_from_degrees(60.0_r);  // it opens both ways: shut is between
constexpr Real kBeforeLimit_rad = radians_from_degrees(4.0_r);
constexpr Real kSwing_radps = 1.8_r;
constexpr Real kApproach_per_s = 5;  // speed for each rad that is left
constexpr Real kThere_rad = 0.02_r;
constexpr Real kSwing_s = 4;
constexpr Real kBulb_m = 0.3_r;  // how far beside the line of sight a bulb may be
constexpr Real kGlow_m = 2.5_r;  // how far a lamp's glow may be from it

/// A hinge of the leaf that a hand can turn.
std::optional<physics::JointId> hinge_of(const scene::Simulation& simulation,
                                         physics::BodyId leaf) {
    const physics::PhysicsWorld& world = simulation.physics;
    for (const scene::SceneJoint& known : simulation.joints()) {
        if (!world.contains(known.joint)) continue;
        const auto [def, state] = world.joint(known.joint);
        if (state.broken) continue;
        const bool stands = !def.b || world.state(def.b).kind == physics::BodyKind::Static;
        const bool is_driven = def.motor && def.motor->target != 0;
        if (def.kind == physics::JointKind::Hinge && def.a == leaf && def.limits && stands &&
            !is_driven)
            return known.joint;
    }
    return {};
}

/// From the hinge to the leaf's middle, at a right angle to its axis.
Vec3 arm_of(const physics::PhysicsWorld& world, const physics::JointDef& def, const Vec3& axis) {
    const Vec3 arm = world.state(def.a).center_of_mass_world() - def.anchor_b_world;
    return arm - axis * glm::dot(arm, axis);
}

Real inertia_about(const physics::PhysicsWorld& world,
                   const physics::JointDef& def,
                   const Vec3& axis) {
    const physics::BodyState leaf = world.state(def.a);
    const Vec3 axis_body = glm::conjugate(leaf.world_from_body.orientation) * axis;
    const Vec3 arm = arm_of(world, def, axis);
    return glm::dot(axis_body * axis_body, leaf.mass.inertia_kgm2) +
           leaf.mass.mass_kg * glm::dot(arm, arm);
}

bool is_visible(const scene::Simulation& simulation, ecs::Entity lamp) {
    return simulation.registry.has<scene::Visual>(lamp);
}

}  // namespace

std::optional<Swing> door_at(const scene::Simulation& simulation,
                             const Looked& looked,
                             const Vec3& eye_m) {
    const auto hinge = hinge_of(simulation, looked.body);
    if (!hinge) return {};
    const physics::PhysicsWorld& world = simulation.physics;
    const physics::JointDef& def = world.joint(*hinge).def;
    const auto [low, high] = *def.limits;
    const bool both_ways = low < -kWide_rad && high > kWide_rad;
    // Shut is where it was made, or at the limit next to that.
    const Real nearer = std::abs(low) < std::abs(high) ? low : high;
    const Real shut = both_ways ? Real{0} : nearer;
    const Real now = world.joint(*hinge).state.position;
    if (std::abs(now - shut) > kShut_rad)
        return Swing{.hinge = *hinge, .angle_rad = shut, .left_s = kSwing_s, .opens = false};
    const Vec3 axis = glm::normalize(def.axis_world);
    const Vec3 opening = glm::cross(axis, arm_of(world, def, axis));
    const bool away = glm::dot(opening, world.state(def.a).center_of_mass_world() - eye_m) > 0;
    const bool up = both_ways ? away : high - shut > shut - low;
    return Swing{.hinge = *hinge,
                 .angle_rad = up ? high - kBeforeLimit_rad : low + kBeforeLimit_rad,
                 .left_s = kSwing_s};
}

void Doors::swing(const Swing& swing) {
    std::erase_if(swings_, [&](const Swing& known) { return known.hinge == swing.hinge; });
    swings_.push_back(swing);
}

void Doors::push(scene::Simulation& simulation, physics::BodyId held) {
    physics::PhysicsWorld& world = simulation.physics;
    const Real dt = static_cast<Real>(simulation.step_s());
    for (Swing& swing : swings_) {
        const physics::JointDef& def = world.joint(swing.hinge).def;
        const Real left = swing.angle_rad - world.joint(swing.hinge).state.position;
        swing.left_s -= dt;
        if (std::abs(left) < kThere_rad || def.a == held) swing.left_s = 0;
        if (swing.left_s <= 0) continue;
        const Vec3 axis = glm::normalize(def.axis_world);
        const Real speed = glm::dot(world.state(def.a).angular_velocity_radps, axis);
        const Real wanted = std::clamp(left * kApproach_per_s, -kSwing_radps, kSwing_radps);
        // A motor that holds the leaf where it was left is overcome by its own strength.
        const Real friction = def.motor ? std::copysign(def.motor->max, wanted) : Real{0};
        const Real torque = inertia_about(world, def, axis) * (wanted - speed) / dt + friction;
        world.wake(def.a);
        world.apply_torque(def.a, axis * std::clamp(torque, -kMostTorque_Nm, kMostTorque_Nm));
    }
    std::erase_if(swings_, [](const Swing& swing) { return swing.left_s <= 0; });
}

void Doors::forget_gone(const scene::Simulation& simulation) {
    const physics::PhysicsWorld& world = simulation.physics;
    std::erase_if(swings_, [&](const Swing& swing) {
        return !world.contains(swing.hinge) || world.joint(swing.hinge).state.broken ||
               !world.joint(swing.hinge).def.limits;
    });
}

ecs::Entity lamp_at(const scene::Simulation& simulation,
                    const Aim& aim,
                    const std::optional<Looked>& looked) {
    if (looked && simulation.registry.has<scene::PointLight>(looked->entity) &&
        is_visible(simulation, looked->entity))
        return looked->entity;
    const Real farthest_m = sight_m(looked, aim, Grab::kReach_m) + kBulb_m;
    ecs::Entity nearest{};
    Real least_m = kBulb_m;
    for (auto [entity, light, transform, visual] :
         simulation.registry
             .view<const scene::PointLight, const scene::Transform, const scene::Visual>()) {
        if (simulation.registry.has<scene::BodyRef>(entity)) continue;
        const Vec3 way = transform.world_from_body.position - aim.eye_m;
        const Real along = glm::dot(way, aim.forward);
        const Real beside_m = glm::length(way - aim.forward * along);
        if (along < 0 || along > farthest_m || beside_m > least_m) continue;
        nearest = entity;
        least_m = beside_m;
    }
    return nearest;
}

bool is_lit(const scene::Simulation& simulation, ecs::Entity lamp) {
    return scene::is_lit(simulation, simulation.registry.get<scene::PointLight>(lamp));
}

void switch_lamp(scene::Simulation& simulation, ecs::Entity lamp, bool on) {
    struct Place {
        ecs::Entity entity;
        Vec3 at_m;
    };
    std::vector<Place> lamps;
    std::vector<Place> glows;
    for (auto [entity, light, transform] :
         simulation.registry.view<const scene::PointLight, const scene::Transform>())
        (is_visible(simulation, entity) ? lamps : glows)
            .push_back({entity, transform.world_from_body.position});
    const auto switch_one = [&](ecs::Entity entity) {
        simulation.registry.get<scene::PointLight>(entity).on =
            on ? scene::LampOn::Always : scene::LampOn::Never;
    };
    switch_one(lamp);
    for (const Place& glow : glows) {
        const auto nearer = [&](const Place& a, const Place& b) {
            return glm::distance(a.at_m, glow.at_m) < glm::distance(b.at_m, glow.at_m);
        };
        const auto owner = std::ranges::min_element(lamps, nearer);
        if (owner->entity == lamp && glm::distance(owner->at_m, glow.at_m) < kGlow_m)
            switch_one(glow.entity);
    }
}

}  // namespace plumbline::game
