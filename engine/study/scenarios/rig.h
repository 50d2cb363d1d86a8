// Worlds for scenarios in few lines: bodies and joints by double numbers, read back as such.
#pragma once

#include "engine/physics/physics_world.h"
#include "engine/study/setting.h"

#include <numbers>
#include <vector>

namespace plumbline::study {

inline constexpr double kG_mps2 = 9.81;
inline constexpr double kPi_d = std::numbers::pi;

inline Real real(double value) {
    return static_cast<Real>(value);
}

/// What a body is beyond its shape and place. Bodies of scenarios never sleep.
struct Stuff {
    double mass_kg{1};
    double friction{0.5};
    double restitution{0};
    double linear_damping_per_s{0};
    Vec3d velocity_mps{0, 0, 0};
    Vec3d spin_radps{0, 0, 0};
    Quatd turn{1, 0, 0, 0};
    bool touches{true};  ///< false: nothing collides with it
};

/// A world without anything in it, at a setting.
class Rig {
public:
    explicit Rig(const physics::WorldDef& def) : world(def) {}
    explicit Rig(const Setting& setting, const Vec3d& gravity_mps2 = {0, -kG_mps2, 0});

    physics::BodyId add(physics::BodyKind kind,
                        const physics::ShapeDef& shape,
                        const Vec3d& at_m,
                        const Stuff& stuff = {});
    physics::BodyId box(const Vec3d& at_m, const Vec3d& size_m, const Stuff& stuff = {});
    physics::BodyId ball(const Vec3d& at_m, double radius_m, const Stuff& stuff = {});
    /// Its axis is the body's own y.
    physics::BodyId cylinder(const Vec3d& at_m,
                             double radius_m,
                             double height_m,
                             const Stuff& stuff = {});
    physics::BodyId fixed_box(const Vec3d& at_m, const Vec3d& size_m, const Stuff& stuff = {});
    physics::BodyId fixed_ball(const Vec3d& at_m, double radius_m, const Stuff& stuff = {});
    /// 200 m square, top at y = 0.
    physics::BodyId floor(double friction = 0.5, double restitution = 0);
    physics::JointId join(const physics::JointDef& def);

    Vec3d at(physics::BodyId id) const { return Vec3d{world.state(id).world_from_body.position}; }
    Vec3d velocity(physics::BodyId id) const { return Vec3d{world.state(id).velocity_mps}; }
    Vec3d spin(physics::BodyId id) const { return Vec3d{world.state(id).angular_velocity_radps}; }
    Quatd turn(physics::BodyId id) const {
        return Quatd{world.state(id).world_from_body.orientation};
    }
    double step_s() const { return world.def().step_s; }
    double energy_J() const;
    /// As it is now; a joint that went with a body that is no number any more has no error or force.
    physics::JointState joint(physics::JointId id) const;
    /// Something is no number any more.
    bool broken() const;

    physics::PhysicsWorld world;
    std::vector<physics::BodyId> movers;  ///< dynamic bodies in the order they were added
};

inline Vec3 vec(const Vec3d& v) {
    return Vec3(v);
}

}  // namespace plumbline::study
