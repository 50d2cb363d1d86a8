// The contacts of one island as rows of the small-step solver. Knows nothing of Bullet.
//
// A sub-step sweeps them with bias, which pushes penetrating bodies apart and keeps approaching ones from overlapping,
// once and again where that changed much; and once after the bodies moved ("relax"), without bias, which takes the pushing
// speed out again and solves friction with impulses that only load, not push.
#pragma once

#include "engine/core/threads/team.h"
#include "engine/physics/body.h"
#include "engine/physics/dynamics/contact/contact_constraint.h"
#include "engine/physics/dynamics/contact/sweep_order.h"
#include "engine/physics/dynamics/joint/softness.h"

#include <cstdint>
#include <span>
#include <vector>

namespace plumbline::physics {

struct SweepSettings {
    Real h{1.0_r / 240};         ///< the sub-step, s
    Real spring_s{1.0_r / 240};  ///< the sub-step that contacts are made for
    Real push_mps{3};            ///< the fastest that penetration pushes bodies apart
    Real bounce_mps{1e-3_r};     ///< the slowest impact that restitution acts on
    Real restless_mps{1e-3_r};   ///< what a sweep changes a speed by at least for another to follow
    Real restless_jointed_mps{1e-5_r};  ///< the same of contacts of jointed bodies
    Team* team{nullptr};                ///< none: the caller alone solves
};

/// What a solution of one constraint's friction did.
struct FrictionChange {
    Real changed_mps{0};  ///< of the slip
    bool is_much{false};  ///< of what sticks
};

class ContactSet {
public:
    std::vector<ContactConstraint> constraints;
    std::vector<SurfaceMotion> belts;

    /// Of b's surface against b where a has gone to since the step's start. `arm`: from b's centre of mass, at the start.
    Vec3 belt_velocity_at(const ContactConstraint& constraint, const Vec3& arm) const {
        if (constraint.belt == 0) return {0, 0, 0};
        const SolverBody& a = bodies_[constraint.a];
        const SolverBody& b = bodies_[constraint.b];
        const Vec3 moved = a.delta_position_m - b.delta_position_m +
                           (a.velocity_mps - b.velocity_mps) * belt_ahead_s_;
        const SurfaceMotion& belt = belts[constraint.belt - 1];
        return belt.velocity_mps + glm::cross(belt.spin_radps, arm + moved);
    }

    /// Masses and the order of the sweeps.
    void begin_step(std::span<SolverBody> bodies, const SweepSettings& settings);
    /// Calls `work` with each body once, on all threads where there are many.
    template <typename Work>
    void each_body(const Work& work) const {
        share(team_, order_.cells(), 1, [&](int, std::size_t begin, std::size_t end) {
            for (std::size_t cell = begin; cell < end; ++cell) {
                for (const std::uint32_t i : order_.bodies_of(cell)) work(bodies_[i]);
            }
        });
    }
    /// Adds the impulses that the constraints hold to the bodies' steady change.
    void warm_start();
    /// A sub-step's first sweeps are of all constraints; others of those that meet a body whose velocity the sweep before
    /// changed by much, and of those of jointed bodies, whose velocities the joints' solution changed since.
    enum class Sweep : std::uint8_t { All, Restless };
    /// Whether it changed a velocity by much.
    bool sweep_with_bias(Sweep sweep);
    /// The same of a jointed body's: others are relaxed once.
    bool relax(Sweep sweep);
    /// Adds what the constraints hold to their totals.
    void end_substep();
    /// Separations now; where a sphere touches, its arms follow it.
    void update_separations(ContactConstraint& constraint) const;

    std::uint64_t row_solves() const;  ///< since begin_step()
    Real substep_s() const { return h_; }

private:
    void update_sphere_separations(ContactConstraint& constraint) const;
    void measure_crowds();
    void prepare_pair(std::span<ContactConstraint> pair);
    /// Calls `work` with parts of the order, stage after stage; with those of one stage at once.
    template <typename Work>
    void each_part_in_order(const Work& work) const {
        for (std::size_t stage = 0; stage < order_.stages(); ++stage) {
            const auto parts = order_.parts(stage);
            share(team_, parts.size(), 1, [&](int, std::size_t begin, std::size_t end) {
                for (const auto& part : parts.subspan(begin, end - begin)) work(part);
            });
        }
    }
    /// Calls `work` with parts of the order, each once, at the thread that solves its cell.
    template <typename Work>
    void each_part(const Work& work) const {
        share(team_, order_.cells(), 1, [&](int, std::size_t begin, std::size_t end) {
            for (std::size_t cell = begin; cell < end; ++cell) order_.each_part_of(cell, work);
        });
    }
    /// Calls `work` with the constraints of each two bodies: in a part as in all they are one after the other.
    template <typename Work>
    void for_each_pair(std::span<const SweepPlace> part, const Work& work) {
        for (std::size_t first = 0; first < part.size();) {
            std::size_t end = first + 1;
            while (end < part.size() && part[end].a == part[first].a &&
                   part[end].b == part[first].b)
                ++end;
            work(std::span(constraints).subspan(part[first].constraint, end - first));
            first = end;
        }
    }
    void prepare_part(std::span<const SweepPlace> part);
    bool is_much(Real changed_mps, const ContactConstraint& constraint) const;
    template <typename Solve>
    bool sweep(Sweep which, Solve solve);
    template <typename Solve>
    bool sweep_part(std::span<const SweepPlace> part, Sweep which, Solve solve);
    void warm_start(const ContactConstraint& constraint);
    void follow_motion(ContactConstraint& constraint);
    Real solve_with_bias(ContactConstraint& constraint, Sweep which);
    Real relax(ContactConstraint& constraint);
    bool relax_normal(ContactConstraint& constraint, Real& changed_mps);
    FrictionChange solve_friction(ContactConstraint& constraint);
    bool resist_rolling(ContactConstraint& constraint);

    std::span<SolverBody> bodies_;
    Team* team_{nullptr};
    SweepOrder order_;
    std::vector<SymmetricMat3> crowds_;  ///< of each body
    std::vector<std::uint8_t>
        is_restless_;  ///< 1: bodies whose velocity the latest sweep changed by much
    std::vector<std::uint8_t> was_restless_;
    Softness between_movable_{};
    Softness against_immovable_{};
    Real belt_ahead_s_{
        0};  ///< the middle of the motion that the sweeps prepare: a chord of the circle on a turntable
    Real h_{0};
    Real push_mps_{3};
    Real bounce_mps_{0};
    Real restless_mps_{0};
    Real restless_jointed_mps_{0};
};

}  // namespace plumbline::physics
