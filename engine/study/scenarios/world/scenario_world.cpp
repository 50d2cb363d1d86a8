#include "engine/study/scenarios/world/scenario_world.h"

#include "engine/physics/totals.h"

#include <algorithm>
#include <cmath>
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

ScenarioWorld::ScenarioWorld(const Setting& setting, const Vec3d& gravity_mps2)
    : ScenarioWorld(with_gravity(world_def(setting), gravity_mps2)) {}

BodyId ScenarioWorld::add(const physics::ShapeDef& shape, physics::BodyDef def) {
    const Result<physics::ShapeId> made = physics.create_shape(shape);
    PL_ASSERT(made.ok(), "shapes of scenarios within the limits");
    def.shape = *made;
    const BodyId id = physics.create_body(def);
    if (def.kind == BodyKind::Dynamic) movers.push_back(id);
    return id;
}

BodyId ScenarioWorld::add(BodyKind kind,
                          const physics::ShapeDef& shape,
                          const Vec3d& at_m,
                          const BodyProperties& properties) {
    return add(shape,
               {.kind = kind,
                .world_from_body = {.position = Vec3(at_m), .orientation = Quat(properties.turn)},
                .mass_kg = real(properties.mass_kg),
                .velocity_mps = Vec3(properties.velocity_mps),
                .angular_velocity_radps = Vec3(properties.spin_radps),
                .friction = real(properties.friction),
                .restitution = real(properties.restitution),
                .linear_damping_per_s = real(properties.linear_damping_per_s),
                .can_sleep = properties.can_sleep,
                .filter = {.collides_with = properties.touches ? ~0U : 0U}});
}

BodyId ScenarioWorld::box(const Vec3d& at_m,
                          const Vec3d& size_m,
                          const BodyProperties& properties) {
    return add(BodyKind::Dynamic, physics::BoxShape{.size_m = Vec3(size_m)}, at_m, properties);
}

BodyId ScenarioWorld::sphere(const Vec3d& at_m, double radius_m, const BodyProperties& properties) {
    return add(
        BodyKind::Dynamic, physics::SphereShape{.radius_m = real(radius_m)}, at_m, properties);
}

BodyId ScenarioWorld::cylinder(const Vec3d& at_m,
                               double radius_m,
                               double height_m,
                               const BodyProperties& properties) {
    return add(BodyKind::Dynamic,
               physics::CylinderShape{.radius_m = real(radius_m), .height_m = real(height_m)},
               at_m,
               properties);
}

BodyId ScenarioWorld::kinematic_box(const Vec3d& at_m,
                                    const Vec3d& size_m,
                                    const BodyProperties& properties) {
    return add(BodyKind::Kinematic, physics::BoxShape{.size_m = Vec3(size_m)}, at_m, properties);
}

BodyId ScenarioWorld::fixed_box(const Vec3d& at_m,
                                const Vec3d& size_m,
                                const BodyProperties& properties) {
    return add(BodyKind::Static, physics::BoxShape{.size_m = Vec3(size_m)}, at_m, properties);
}

BodyId ScenarioWorld::fixed_sphere(const Vec3d& at_m,
                                   double radius_m,
                                   const BodyProperties& properties) {
    return add(
        BodyKind::Static, physics::SphereShape{.radius_m = real(radius_m)}, at_m, properties);
}

BodyId ScenarioWorld::floor(double friction, double restitution) {
    return fixed_box({0, -1, 0}, {200, 2, 200}, {.friction = friction, .restitution = restitution});
}

void ScenarioWorld::room(double half_m) {
    for (int axis = 0; axis < 3; ++axis) {
        for (const double side : {-1.0, 1.0}) {
            Vec3d at{0, 0, 0};
            at[axis] = side * (half_m + 1);
            Vec3d size{2 * half_m + 4};
            size[axis] = 2;
            fixed_box(at, size, {.friction = 0, .restitution = 1});
        }
    }
}

physics::JointId ScenarioWorld::join(const physics::JointDef& def) {
    const Result<physics::JointId> made = physics.create_joint(def);
    PL_ASSERT(made.ok(), "joints of scenarios that can be made");
    return *made;
}

physics::JointId ScenarioWorld::join_at(const Vec3d& at_m, BodyId a, BodyId b) {
    return join({.kind = physics::JointKind::BallAndSocket,
                 .a = a,
                 .b = b,
                 .anchor_a_world = vec(at_m),
                 .anchor_b_world = vec(at_m)});
}

void ScenarioWorld::run(double seconds) {
    const auto steps = static_cast<int>(std::lround(seconds / step_s()));
    for (int i = 0; i < steps; ++i) physics.step();
}

physics::JointState ScenarioWorld::joint(physics::JointId id) const {
    if (physics.contains(id)) return physics.joint(id).state;
    return {.error_m = std::numeric_limits<double>::quiet_NaN(),
            .force_N = std::numeric_limits<Real>::quiet_NaN()};
}

double ScenarioWorld::energy_J() const {
    return physics::energy(physics).total_J();
}

bool ScenarioWorld::broken() const {
    return !physics.report().isolated.empty() ||
           !std::all_of(movers.begin(), movers.end(), [this](BodyId id) {
               return is_finite(at(id)) && is_finite(velocity(id)) && is_finite(spin(id));
           });
}

}  // namespace plumbline::study
