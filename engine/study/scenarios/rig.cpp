#include "engine/study/scenarios/rig.h"

#include <algorithm>
#include <limits>

namespace plumbline::study {

using physics::BodyId;
using physics::BodyKind;

namespace {

physics::WorldDef with_gravity(physics::WorldDef def, const Vec3d& gravity_mps2) {
    def.gravity_mps2 = Vec3(gravity_mps2);
    return def;
}

}  // namespace

Rig::Rig(const Setting& setting, const Vec3d& gravity_mps2)
    : world(with_gravity(world_def(setting), gravity_mps2)) {}

BodyId Rig::add(BodyKind kind,
                const physics::ShapeDef& shape,
                const Vec3d& at_m,
                const Stuff& stuff) {
    const Result<physics::ShapeId> made = world.create_shape(shape);
    PL_ASSERT(made.ok(), "shapes of scenarios within the limits");
    const BodyId id = world.create_body(
        {.kind = kind,
         .shape = *made,
         .world_from_body = {.position = Vec3(at_m), .orientation = Quat(stuff.turn)},
         .mass_kg = real(stuff.mass_kg),
         .velocity_mps = Vec3(stuff.velocity_mps),
         .angular_velocity_radps = Vec3(stuff.spin_radps),
         .friction = real(stuff.friction),
         .restitution = real(stuff.restitution),
         .linear_damping_per_s = real(stuff.linear_damping_per_s),
         .can_sleep = false,
         .collides_with = stuff.touches ? ~0U : 0U});
    if (kind == BodyKind::Dynamic) movers.push_back(id);
    return id;
}

BodyId Rig::box(const Vec3d& at_m, const Vec3d& size_m, const Stuff& stuff) {
    return add(BodyKind::Dynamic, physics::BoxShape{.size_m = Vec3(size_m)}, at_m, stuff);
}

BodyId Rig::ball(const Vec3d& at_m, double radius_m, const Stuff& stuff) {
    return add(BodyKind::Dynamic, physics::SphereShape{.radius_m = real(radius_m)}, at_m, stuff);
}

BodyId Rig::cylinder(const Vec3d& at_m, double radius_m, double height_m, const Stuff& stuff) {
    return add(BodyKind::Dynamic,
               physics::CylinderShape{.radius_m = real(radius_m), .height_m = real(height_m)},
               at_m,
               stuff);
}

BodyId Rig::fixed_box(const Vec3d& at_m, const Vec3d& size_m, const Stuff& stuff) {
    return add(BodyKind::Static, physics::BoxShape{.size_m = Vec3(size_m)}, at_m, stuff);
}

BodyId Rig::fixed_ball(const Vec3d& at_m, double radius_m, const Stuff& stuff) {
    return add(BodyKind::Static, physics::SphereShape{.radius_m = real(radius_m)}, at_m, stuff);
}

BodyId Rig::floor(double friction, double restitution) {
    return fixed_box({0, -1, 0}, {200, 2, 200}, {.friction = friction, .restitution = restitution});
}

physics::JointId Rig::join(const physics::JointDef& def) {
    const Result<physics::JointId> made = world.create_joint(def);
    PL_ASSERT(made.ok(), "joints of scenarios that can be made");
    return *made;
}

physics::JointState Rig::joint(physics::JointId id) const {
    if (world.contains(id)) return world.joint_state(id);
    return {.error_m = std::numeric_limits<double>::quiet_NaN(),
            .force_N = std::numeric_limits<Real>::quiet_NaN()};
}

double Rig::energy_J() const {
    const physics::Energy energy = world.energy();
    return energy.kinetic_J + energy.potential_J;
}

bool Rig::broken() const {
    return !world.quarantined().empty() ||
           !std::all_of(movers.begin(), movers.end(), [this](BodyId id) {
               return is_finite(at(id)) && is_finite(velocity(id)) && is_finite(spin(id));
           });
}

}  // namespace plumbline::study
