// Bodies and joints moved by a plain integrator, without contacts and without Bullet.
#pragma once

#include "engine/physics/dynamics/joint/joint_geometry.h"
#include "engine/physics/dynamics/joint/joint_system.h"
#include "engine/physics/dynamics/rotation.h"

#include <vector>

namespace plumbline::physics {

inline constexpr double kFrame_s = 1.0 / 60.0;

inline constexpr double kG = 9.81;
inline constexpr bool kFloat32 = sizeof(Real) == sizeof(float);

/// How a sub-step's accelerations are given to the bodies; joint_system.h names both.
enum class Kick { Halves, Steady };

struct JointRig {
    std::vector<SolverBody> bodies{1};
    std::vector<SolverJoint> joints;
    JointSystem system;
    JointMethod method{JointMethod::Direct};
    Kick kick{Kick::Halves};
    Vec3d gravity{0, -kG, 0};
    double time_s{0};

    /// `inertia` principal, body axes; zero: a point mass.
    std::uint32_t add_body(double mass_kg,
                           const Vec3d& inertia,
                           const Vec3d& position,
                           const Quatd& orientation = Quatd{1, 0, 0, 0}) {
        SolverBody body;
        body.inverse_mass = mass_kg > 0 ? static_cast<Real>(1 / mass_kg) : Real{0};
        body.inertia_kgm2 = inertia;
        body.isotropic_inertia = inertia.x == inertia.y && inertia.y == inertia.z;
        body.start_position_m = position;
        body.start_orientation = orientation;
        bodies.push_back(body);
        return static_cast<std::uint32_t>(bodies.size() - 1);
    }

    std::uint32_t add_ball_body(double mass_kg, double radius_m, const Vec3d& position) {
        return add_body(mass_kg, Vec3d(0.4 * mass_kg * radius_m * radius_m), position);
    }

    MassPose pose(std::uint32_t index) const { return {position(index), orientation(index)}; }
    Vec3d position(std::uint32_t index) const {
        return bodies[index].start_position_m + Vec3d(bodies[index].delta_position_m);
    }
    Quatd orientation(std::uint32_t index) const {
        return glm::normalize(Quatd(bodies[index].delta_rotation) *
                              bodies[index].start_orientation);
    }
    Vec3d velocity(std::uint32_t index) const { return Vec3d(bodies[index].velocity_mps); }
    Vec3d spin(std::uint32_t index) const { return Vec3d(bodies[index].spin_radps); }
    double mass(std::uint32_t index) const {
        return 1 / static_cast<double>(bodies[index].inverse_mass);
    }

    SolverJoint& add_joint(std::uint32_t a, std::uint32_t b, const JointDef& def) {
        SolverJoint joint = placed_joint(def, pose(a), pose(b));
        joint.a = a;
        joint.b = b;
        joint.key = joints.size() + 1;
        joints.push_back(joint);
        return joints.back();
    }
    SolverJoint& add_ball(std::uint32_t a, std::uint32_t b, const Vec3d& at) {
        return add_joint(a, b, {.kind = JointKind::BallAndSocket, .anchor_a_world = Vec3(at)});
    }
    /// The anchor in double precision, which a definition does not give.
    void place_anchors(SolverJoint& joint, const Vec3d& at_a, const Vec3d& at_b) const {
        const MassPose a = pose(joint.a);
        const MassPose b = pose(joint.b);
        joint.anchor_in_a = glm::conjugate(a.orientation) * (at_a - a.position_m);
        joint.anchor_in_b = glm::conjugate(b.orientation) * (at_b - b.position_m);
    }

    void step(double step_s, int substeps) {
        const double h = step_s / substeps;
        for (SolverBody& body : bodies) {
            if (body.movable()) body.acceleration_mps2 = Vec3(gravity);
        }
        system.start(bodies, joints, h, method);
        for (int i = 0; i < substeps; ++i) substep(h);
        system.finish();
        for (std::uint32_t i = 0; i < bodies.size(); ++i) {
            const MassPose at = pose(i);
            bodies[i].start_position_m = at.position_m;
            bodies[i].start_orientation = at.orientation;
            bodies[i].delta_position_m = {0, 0, 0};
            bodies[i].delta_rotation = kNoRotation;
        }
        time_s += step_s;
    }

    void run(double duration_s, double step_s, int substeps) {
        const int steps = static_cast<int>(duration_s / step_s + 0.5);
        for (int i = 0; i < steps; ++i) step(step_s, substeps);
    }

    double energy() const {
        double sum = 0;
        for (std::uint32_t i = 1; i < bodies.size(); ++i) {
            if (!bodies[i].movable()) continue;
            const Vec3d v = velocity(i);
            const Vec3d w = glm::conjugate(orientation(i)) * spin(i);
            sum += mass(i) * (0.5 * glm::dot(v, v) - glm::dot(gravity, position(i))) +
                   0.5 * glm::dot(w, bodies[i].inertia_kgm2 * w);
        }
        return sum;
    }

    /// The largest and the sum of the joints' errors.
    double max_error() const {
        double most = 0;
        for (const SolverJoint& joint : joints) most = std::max(most, joint.error_m);
        return most;
    }
    double sum_of_errors() const {
        double sum = 0;
        for (const SolverJoint& joint : joints) sum += joint.error_m;
        return sum;
    }
    double max_speed() const {
        double most = 0;
        for (std::uint32_t i = 1; i < bodies.size(); ++i) {
            most = std::max({most, glm::length(velocity(i)), glm::length(spin(i))});
        }
        return most;
    }

private:
    void accelerate(double duration_s) {
        for (SolverBody& body : bodies) {
            const auto t = static_cast<Real>(duration_s);
            body.velocity_mps += body.acceleration_mps2 * t;
            body.spin_radps += body.angular_acceleration_radps2 * t;
            const Real steady = kick == Kick::Halves ? Real{0} : t;
            body.velocity_increment_mps = body.acceleration_mps2 * steady;
            body.spin_increment_radps = body.angular_acceleration_radps2 * steady;
        }
    }

    void move(double h) {
        const auto t = static_cast<Real>(h);
        for (SolverBody& body : bodies) {
            body.delta_position_m +=
                (body.velocity_mps - body.velocity_increment_mps * Real{0.5}) * t;
            const Vec3 mean = body.spin_radps - body.spin_increment_radps * Real{0.5};
            if (body.isotropic_inertia || !body.movable()) {
                body.delta_rotation = glm::normalize(turn_by(mean, t) * body.delta_rotation);
                continue;
            }
            const FreeTurn end =
                turned_freely({Quatd(body.delta_rotation) * body.start_orientation, Vec3d(mean)},
                              body.inertia_kgm2,
                              h);
            body.delta_rotation = Quat(end.orientation * glm::conjugate(body.start_orientation));
            body.spin_radps = Vec3(end.spin_radps) + body.spin_increment_radps * Real{0.5};
        }
    }

    void substep(double h) {
        accelerate(kick == Kick::Halves ? h / 2 : h);
        system.push_springs(h / 2);
        if (system.solves_before_motion()) system.solve_velocities();
        system.begin_motion(false);
        move(h);
        system.correct_positions();
        system.push_springs(h / 2);
        system.refresh();
        if (kick == Kick::Halves) accelerate(h / 2);
        system.solve_velocities();
    }
};

}  // namespace plumbline::physics
