// A physics world for scenarios in few lines: bodies and joints by double numbers, read back as such.
#pragma once

#include "engine/physics/physics_world.h"
#include "engine/study/setting.h"

#include <memory>
#include <numbers>
#include <vector>

namespace plumbline::study {

inline constexpr double kG_mps2 = 9.81;
inline constexpr double kPi_d = std::numbers::pi;

inline Real real(double value) {
    return static_cast<Real>(value);
}

/// What a body is beyond its shape and place.
struct BodyProperties {
    double mass_kg{1};
    double friction{0.5};
    double restitution{0};
    double linear_damping_per_s{0};
    Vec3d velocity_mps{0, 0, 0};
    Vec3d spin_radps{0, 0, 0};
    Quatd turn{1, 0, 0, 0};
    bool touches{true};  ///< false: nothing collides with it
    bool can_sleep{false};
};

/// A world without anything in it, at a setting.
class ScenarioWorld {
public:
    explicit ScenarioWorld(const physics::WorldDef& def)
        : own_(std::make_unique<physics::PhysicsWorld>(def)), physics(*own_) {}
    explicit ScenarioWorld(const Setting& setting, const Vec3d& gravity_mps2 = {0, -kG_mps2, 0});
    /// A world that was made elsewhere and outlives this one.
    ScenarioWorld(physics::PhysicsWorld& made, std::vector<physics::BodyId> dynamic_bodies)
        : physics(made), movers(std::move(dynamic_bodies)) {}

    /// The shape of `def` is set here.
    physics::BodyId add(const physics::ShapeDef& shape, physics::BodyDef def);
    physics::BodyId add(physics::BodyKind kind,
                        const physics::ShapeDef& shape,
                        const Vec3d& at_m,
                        const BodyProperties& properties = {});
    physics::BodyId box(const Vec3d& at_m,
                        const Vec3d& size_m,
                        const BodyProperties& properties = {});
    physics::BodyId sphere(const Vec3d& at_m,
                           double radius_m,
                           const BodyProperties& properties = {});
    /// Its axis is the body's own y.
    physics::BodyId cylinder(const Vec3d& at_m,
                             double radius_m,
                             double height_m,
                             const BodyProperties& properties = {});
    /// Moved by nothing but its own velocity.
    physics::BodyId kinematic_box(const Vec3d& at_m,
                                  const Vec3d& size_m,
                                  const BodyProperties& properties = {});
    physics::BodyId fixed_box(const Vec3d& at_m,
                              const Vec3d& size_m,
                              const BodyProperties& properties = {});
    physics::BodyId fixed_sphere(const Vec3d& at_m,
                                 double radius_m,
                                 const BodyProperties& properties = {});
    /// 200 m square, top at y = 0.
    physics::BodyId floor(double friction = 0.5, double restitution = 0);
    /// Smooth elastic walls of 2 m about the origin, `half_m` away from it.
    void room(double half_m);
    physics::JointId join(const physics::JointDef& def);
    /// A ball-and-socket joint where `a` is off `b` by now, or off the world.
    physics::JointId join_at(const Vec3d& at_m, physics::BodyId a, physics::BodyId b = {});
    /// Whole steps, rounded.
    void run(double seconds);

    Vec3d at(physics::BodyId id) const { return Vec3d{physics.state(id).world_from_body.position}; }
    Vec3d velocity(physics::BodyId id) const { return Vec3d{physics.state(id).velocity_mps}; }
    Vec3d spin(physics::BodyId id) const { return Vec3d{physics.state(id).angular_velocity_radps}; }
    Quatd turn(physics::BodyId id) const {
        return Quatd{physics.state(id).world_from_body.orientation};
    }
    double step_s() const { return physics.def().step_s; }
    double energy_J() const;
    /// As it is now; a joint that went with a body that is no number any more has no error or force.
    physics::JointState joint(physics::JointId id) const;
    /// Something is no number any more.
    bool broken() const;

private:
    std::unique_ptr<physics::PhysicsWorld> own_;  ///< none: made elsewhere

public:
    physics::PhysicsWorld& physics;
    std::vector<physics::BodyId> movers;  ///< dynamic bodies in the order they were added
};

inline Vec3 vec(const Vec3d& v) {
    return Vec3(v);
}
inline Vec3 vec(double x, double y, double z) {
    return {real(x), real(y), real(z)};
}

}  // namespace plumbline::study
