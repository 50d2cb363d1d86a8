// Spheres and boxes on a floor and against each other, without Bullet: contacts are written by hand.
#pragma once

#include "engine/physics/dynamics/island_loop.h"
#include "engine/physics/dynamics/substep_choice.h"

#include <vector>

namespace plumbline::physics {

inline constexpr double kStep_s = 1.0 / 60.0;

inline constexpr double kFall_mps2 = 9.81;
inline constexpr bool kSingle = sizeof(Real) == sizeof(float);

/// A tolerance at Real's precision.
inline constexpr double by_precision(double of_float, double of_double) {
    return kSingle ? of_float : of_double;
}
inline Real real(double value) {
    return static_cast<Real>(value);
}
inline double wide(Real value) {
    return static_cast<double>(value);
}

struct RigSurface {
    double friction{0};
    double restitution{0};
    double rolling_m{0};
    double spinning_m{0};
};

/// One point, `a` on top of `b`.
inline ContactConstraint level_contact(std::uint32_t a, std::uint32_t b, Real separation_m) {
    ContactConstraint constraint;
    constraint.a = a;
    constraint.b = b;
    constraint.tangent[0] = {1, 0, 0};
    constraint.tangent[1] = {0, 0, 1};
    constraint.count = 1;
    constraint.start_separation_m[0] = separation_m;
    return constraint;
}

/// Steps an IslandLoop as its caller does: contacts found anew in every step, impulses kept.
class ContactRig {
public:
    IslandLoop loop;
    LoopSettings settings{.gravity_mps2 = real(kFall_mps2)};
    Vec3d gravity_mps2{0, -kFall_mps2, 0};

    ContactRig() { loop.clear(); }

    std::uint32_t add_ball(double mass_kg, double radius_m, const Vec3d& position_m) {
        return add(mass_kg, Vec3d(0.4 * mass_kg * radius_m * radius_m), position_m, {}, radius_m);
    }
    std::uint32_t add_box(double mass_kg, const Vec3d& half_m, const Vec3d& position_m) {
        const Vec3d squared = half_m * half_m;
        const Vec3d inertia =
            Vec3d(squared.y + squared.z, squared.x + squared.z, squared.x + squared.y) *
            (mass_kg / 3);
        return add(mass_kg, inertia, position_m, half_m, 0);
    }
    /// The floor is y = 0; a box meets it with its lower four corners.
    void put_on_floor(std::uint32_t body, const RigSurface& surface) {
        add_contact(body, kWorldBody, surface);
    }
    void let_balls_meet(std::uint32_t a, std::uint32_t b, const RigSurface& surface) {
        add_contact(a, b, surface);
    }

    void set_velocity(std::uint32_t body, const Vec3d& velocity_mps, const Vec3d& spin_radps = {}) {
        loop.bodies[body].velocity_mps = Vec3(velocity_mps);
        loop.bodies[body].spin_radps = Vec3(spin_radps);
    }
    /// Besides gravity, in every step from now on.
    void set_force(std::uint32_t body, const Vec3d& force_N) { forces_N_[body] = force_N; }
    Vec3d position(std::uint32_t body) const {
        return loop.bodies[body].start_position_m + Vec3d(loop.bodies[body].delta_position_m);
    }
    Vec3d velocity(std::uint32_t body) const { return Vec3d(loop.bodies[body].velocity_mps); }
    Vec3d spin(std::uint32_t body) const { return Vec3d(loop.bodies[body].spin_radps); }
    double mass(std::uint32_t body) const { return 1 / wide(loop.bodies[body].inverse_mass); }
    /// Of motion and, with the floor at 0, of height.
    double energy(std::uint32_t body) const {
        const Vec3d momentum = inertia_times_spin(body);
        return mass(body) * (glm::dot(velocity(body), velocity(body)) / 2 -
                             glm::dot(gravity_mps2, position(body))) +
               glm::dot(spin(body), momentum) / 2;
    }
    Vec3d inertia_times_spin(std::uint32_t body) const {
        const SolverBody& of = loop.bodies[body];
        const Quatd q = glm::normalize(Quatd(of.delta_rotation) * of.start_orientation);
        return q * (of.inertia_kgm2 * (glm::conjugate(q) * spin(body)));
    }
    const ContactConstraint& constraint(std::size_t at) const {
        return loop.contacts.constraints[at];
    }
    double pressed_Ns(std::size_t at) const { return wide(sum_of(constraint(at).total_Ns)); }

    LoopReport step() {
        for (std::size_t i = 0; i < loop.bodies.size(); ++i) {
            SolverBody& body = loop.bodies[i];
            rebase(body);
            if (body.movable())
                body.acceleration_mps2 =
                    Vec3(gravity_mps2 + forces_N_[i] * wide(body.inverse_mass));
        }
        for (std::size_t i = 0; i < loop.contacts.constraints.size(); ++i) find(i);
        return loop.run(settings);
    }
    void steps(int count) {
        for (int i = 0; i < count; ++i) step();
    }

private:
    struct Outline {
        Vec3d half_m{0, 0, 0};
        double radius_m{0};
    };

    std::uint32_t add(double mass_kg,
                      const Vec3d& inertia_kgm2,
                      const Vec3d& position_m,
                      const Vec3d& half_m,
                      double radius_m) {
        SolverBody body;
        body.inverse_mass = real(1 / mass_kg);
        body.inertia_kgm2 = inertia_kgm2;
        body.isotropic_inertia =
            inertia_kgm2.x == inertia_kgm2.y && inertia_kgm2.y == inertia_kgm2.z;
        body.start_position_m = position_m;
        loop.bodies.push_back(body);
        outlines_.push_back({half_m, radius_m});
        forces_N_.emplace_back(0.0);
        rebase(loop.bodies.back());
        return static_cast<std::uint32_t>(loop.bodies.size() - 1);
    }

    void add_contact(std::uint32_t a, std::uint32_t b, const RigSurface& surface) {
        ContactConstraint constraint;
        constraint.a = a;
        constraint.b = b;
        constraint.friction = real(surface.friction);
        constraint.restitution = real(surface.restitution);
        constraint.rolling_m = real(surface.rolling_m);
        constraint.spinning_m = real(surface.spinning_m);
        loop.contacts.constraints.push_back(constraint);
        find(loop.contacts.constraints.size() - 1);
    }

    static void rebase(SolverBody& body) {
        body.start_position_m += Vec3d(body.delta_position_m);
        body.start_orientation =
            glm::normalize(Quatd(body.delta_rotation) * body.start_orientation);
        body.turned = {};
        body.delta_position_m = Vec3{0, 0, 0};
        body.delta_rotation = kNoRotation;
        if (!body.movable()) return;
        const glm::dmat3 axes = glm::mat3_cast(body.start_orientation);
        glm::dmat3 world{0.0};
        for (int i = 0; i < 3; ++i)
            world += glm::outerProduct(axes[i], axes[i]) / body.inertia_kgm2[i];
        body.inverse_inertia = {.xx = real(world[0][0]),
                                .xy = real(world[0][1]),
                                .xz = real(world[0][2]),
                                .yy = real(world[1][1]),
                                .yz = real(world[1][2]),
                                .zz = real(world[2][2])};
    }

    /// Where the bodies of a constraint touch now.
    void find(std::size_t at) {
        ContactConstraint& constraint = loop.contacts.constraints[at];
        const SolverBody& a = loop.bodies[constraint.a];
        const Outline& shape = outlines_[constraint.a];
        constraint.total_Ns = Lanes{};
        constraint.start_separation_m = splat(kNoPoint_m);
        if (constraint.b != kWorldBody) {
            const Vec3d apart = a.start_position_m - loop.bodies[constraint.b].start_position_m;
            constraint.radius_a = real(shape.radius_m);
            constraint.radius_b = real(outlines_[constraint.b].radius_m);
            set_normal(constraint, Vec3(glm::normalize(apart)));
            constraint.count = 1;
            constraint.start_separation_m[0] =
                real(glm::length(apart) - shape.radius_m - outlines_[constraint.b].radius_m);
            return;
        }
        set_normal(constraint, Vec3{0, 1, 0});
        if (shape.radius_m > 0) {
            constraint.count = 1;
            constraint.radius_a = real(shape.radius_m);
            set_lane(constraint.offset_a, 0, Vec3{0, 0, 0});
            set_lane(constraint.offset_b, 0, Vec3(a.start_position_m * Vec3d(1, 0, 1)));
            constraint.start_separation_m[0] = real(a.start_position_m.y - shape.radius_m);
            return;
        }
        constraint.count = kLanes;
        for (int i = 0; i < kLanes; ++i) {
            const Vec3d corner = Vec3d((i & 1) != 0 ? 1 : -1, -1, (i & 2) != 0 ? 1 : -1);
            const Vec3d arm = a.start_orientation * (corner * shape.half_m);
            const Vec3d point = a.start_position_m + arm;
            set_lane(constraint.offset_a, i, Vec3(arm));
            set_lane(constraint.offset_b, i, Vec3(point));
            constraint.start_separation_m[static_cast<std::size_t>(i)] = real(point.y);
        }
    }

    static void set_normal(ContactConstraint& constraint, const Vec3& normal) {
        constraint.normal = normal;
        const Vec3 beside = std::abs(normal.x) < 0.9_r ? Vec3{1, 0, 0} : Vec3{0, 0, 1};
        constraint.tangent[0] = glm::normalize(beside - normal * glm::dot(beside, normal));
        constraint.tangent[1] = glm::cross(normal, constraint.tangent[0]);
    }

    std::vector<Outline> outlines_{1};
    std::vector<Vec3d> forces_N_{Vec3d{0, 0, 0}};
};

/// Sag of a contact that carries `accel_mps2` of its (reduced) mass, by the spring it is.
inline double sag_of(double accel_mps2, double substep_s, bool against_immovable) {
    const double omega =
        2 * wide(kPi) * wide(kContactFrequency) * (against_immovable ? 2 : 1) / substep_s;
    return accel_mps2 / (omega * omega);
}

}  // namespace plumbline::physics
