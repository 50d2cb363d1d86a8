// The contact points of one island as rows of the small-step solver. Knows nothing of Bullet.
//
// A sub-step sweeps them twice: once with bias, which pushes overlapping bodies apart and keeps
// approaching ones from overlapping, and once after the bodies moved ("relax"), without bias, which
// takes the pushing speed out again and solves friction with impulses that only load, not push.
#pragma once

#include "engine/physics/small_step/softness.h"
#include "engine/physics/small_step/solver_body.h"

#include <cstdint>
#include <span>
#include <vector>

namespace plumbline::physics {

/// One contact point. `a` and `b` are the bodies of its group; the normal points from b to a.
struct ContactPoint {
    // Geometry at the step's start, world axes. A rounded side (ball, capsule) is the ball that
    // touches: its centre is `offset`, its surface `radius` nearer; other sides have radius 0.
    Vec3 offset_a{0, 0, 0};  ///< centre of mass to the point
    Vec3 offset_b{0, 0, 0};
    Real radius_a{0};
    Real radius_b{0};
    Real start_separation_m{0};  ///< negative: overlap

    // Arms of the present sub-step and what follows from them.
    Vec3 arm_a{0, 0, 0};
    Vec3 arm_b{0, 0, 0};
    Real normal_mass{0};  ///< kg
    Real tangent_mass[2]{0, 0};
    Real rolling_mass{0};  ///< kg m2, about any axis
    Real separation_m{0};

    // Impulses of the present sub-step, N s.
    Real normal_Ns{0};
    Real tangent_Ns[2]{0, 0};
    Vec3 rolling_Nms{0, 0, 0};
    Real total_Ns{0};  ///< normal, summed over the step
};

/// Points of one pair of bodies that share a normal.
struct ContactGroup {
    std::uint32_t a{kWorldBody};
    std::uint32_t b{kWorldBody};
    std::uint32_t first{0};  ///< in the list of points
    std::uint32_t count{0};
    Vec3 normal{0, 1, 0};
    Vec3 tangent[2]{};
    Real friction{0};
    Real restitution{0};
    Real rolling_m{0};    ///< torque against rolling per newton pressed
    Real spinning_m{0};   ///< ... against spinning about the normal
    bool rounded{false};  ///< a side of some point has a radius
    bool bounded{false};  ///< one body is immovable
};

/// Work done since begin_step().
struct ContactWork {
    std::uint64_t row_solves{0};
};

class ContactSet {
public:
    std::vector<ContactGroup> groups;
    std::vector<ContactPoint> points;

    void clear() {
        groups.clear();
        points.clear();
    }
    /// Masses, order of the sweeps. `h` is the sub-step; `push_mps` the fastest that overlap
    /// pushes bodies apart.
    void begin_step(std::span<SolverBody> bodies, Real h, Real push_mps);
    /// Applies the impulses that the points hold and adds them to the bodies' steady change.
    void warm_start();
    void solve_with_bias();
    void relax();
    /// Adds what the points hold to their totals.
    void end_substep();

    std::uint64_t row_solves() const { return row_solves_; }
    bool any_restitution() const { return any_restitution_; }
    Real substep_s() const { return h_; }

private:
    friend class ImpactPass;

    enum class Pass : std::uint8_t { Bias, Relax };
    template <Pass pass>
    void sweep();
    template <Pass pass>
    void solve(ContactGroup& group);
    void place(const ContactGroup& group);
    void solve_rolling(const ContactGroup& group,
                       ContactPoint& point,
                       SolverBody& a,
                       SolverBody& b);

    std::span<SolverBody> bodies_;
    std::vector<std::uint32_t> order_;  ///< of groups in a sweep
    Softness between_movable_{};
    Softness against_immovable_{};
    Real h_{0};
    Real push_mps_{3};
    std::uint64_t row_solves_{0};
    bool any_restitution_{false};
};

}  // namespace plumbline::physics
