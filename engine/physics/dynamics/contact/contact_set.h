// The contacts of one island as rows of the small-step solver. Knows nothing of Bullet.
//
// A sub-step sweeps them with bias, which pushes penetrating bodies apart and keeps approaching ones from overlapping,
// once and again where that changed much; and once after the bodies moved ("relax"), without bias, which takes the pushing
// speed out again and solves friction with impulses that only load, not push.
#pragma once

#include "engine/physics/dynamics/contact/contact_constraint.h"
#include "engine/physics/dynamics/softness.h"

#include <cstdint>
#include <span>
#include <vector>

namespace plumbline::physics {

class ContactSet {
public:
    std::vector<ContactConstraint> constraints;

    /// Masses and the order of the sweeps. `h` is the sub-step; `push_mps` the fastest that penetration
    /// pushes bodies apart, `bounce_mps` the slowest impact that restitution acts on.
    void begin_step(std::span<SolverBody> bodies, Real h, Real push_mps, Real bounce_mps) {
        begin_step(bodies, h, push_mps, bounce_mps, h);
    }
    /// Penetration is pushed out as in sub-steps of `spring_s`: in far shorter ones it would be so fast that one sweep
    /// does not take the speed back again.
    void begin_step(
        std::span<SolverBody> bodies, Real h, Real push_mps, Real bounce_mps, Real spring_s);
    /// Adds the impulses that the constraints hold to the bodies' steady change.
    void warm_start();
    /// Of all constraints, or of those that meet a body whose velocity the sweep before changed by much. Whether it changed one by
    /// much.
    bool sweep_with_bias(bool all);
    void relax();
    /// Adds what the constraints hold to their totals.
    void end_substep();
    /// Separations now; where a sphere touches, its arms follow it.
    void update_separations(ContactConstraint& constraint) const;

    std::uint64_t row_solves{0};  ///< since begin_step()
    Real substep_s() const { return h_; }

private:
    void update_sphere_separations(ContactConstraint& constraint) const;
    void measure_crowds();
    void prepare_pair(std::span<ContactConstraint> pair);
    bool is_much(Real changed_mps, const ContactConstraint& constraint) const;
    Real solve_with_bias(ContactConstraint& constraint);
    void relax(ContactConstraint& constraint);
    bool relax_normal(ContactConstraint& constraint);
    bool solve_friction(ContactConstraint& constraint);
    bool resist_rolling(ContactConstraint& constraint);

    std::span<SolverBody> bodies_;
    std::vector<std::uint32_t> order_;   ///< of constraints in a sweep
    std::vector<SymmetricMat3> crowds_;  ///< of each body
    std::vector<bool> is_restless_;      ///< bodies whose velocity the latest sweep changed by much
    std::vector<bool> was_restless_;
    Softness between_movable_{};
    Softness against_immovable_{};
    Real h_{0};
    Real push_mps_{3};
    Real bounce_mps_{0};
};

}  // namespace plumbline::physics
