// Bouncing, before the forces of a sub-step act. Knows nothing of Bullet.
//
// Pairs about to touch with more than the threshold speed get the speed that restitution asks for,
// all points of a pair at once and with friction on the impact; pair after pair until none approaches
// (the order is Guendelman, Bridson and Fedkiw's, Nonconvex Rigid Bodies with Stacking, 2003). A step
// finds an impact a little above or below the surface; the pass computes the speeds that the bodies
// have at the surface, so a bounce with restitution 1 keeps the energy to rounding at any step.
#pragma once

#include "engine/physics/dynamics/contact/contact_set.h"
#include "engine/physics/dynamics/impact/jointed_impact.h"
#include "engine/physics/dynamics/joint/joint_group.h"
#include "engine/physics/dynamics/joint/joint_system.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace plumbline::physics {

struct ImpactSettings {
    Real threshold_mps{0};  ///< slower impacts do not bounce
    bool may_shift{
        true};  ///< no stiff spring, which a shift of a sphere would stretch, holds a body
    bool inelastic_too{false};     ///< pairs without restitution are not left to the contacts
    JointSystem* joints{nullptr};  ///< null: none hold the bodies
    std::span<const Real>
        touching_m{};  ///< of each constraint: nearer points take part; empty: those that close within the sub-step
};

class ImpactPass {
public:
    /// Finds the pairs that may bounce.
    void begin_step(ContactSet& contacts,
                    std::span<SolverBody> bodies,
                    const ImpactSettings& settings);
    bool needed() const { return !pairs_.empty(); }
    /// Returns the number of impacts solved.
    std::uint32_t run();

private:
    struct Pair {
        std::uint32_t first_constraint{0};
        std::uint32_t block_count{0};
    };

    /// Pairs that are solved at once: of two bodies, or of all bodies that joints hold together in two pieces.
    struct Group {
        std::uint32_t first_pair{0};
        std::uint32_t pair_count{0};
        std::array<std::uint32_t, 2> pieces{};  ///< of joints; equal where they are one

        bool is_jointed() const {
            return pieces[0] != JointGroup::kNoPiece || pieces[1] != JointGroup::kNoPiece;
        }
    };

    void group_by_pieces();
    bool gather(const Group& group);
    bool gather(const Pair& pair, bool may_shift);
    void solve(const Group& group);
    /// No energy comes of it.
    void solve_jointed(const Group& group);

    struct Motion {
        Vec3 velocity_mps{0, 0, 0};
        Vec3 spin_radps{0, 0, 0};
    };
    std::vector<Motion> motions() const;
    void set_motions(std::span<const Motion> motions);
    static std::vector<Motion> mixed(std::span<const Motion> from,
                                     std::span<const Motion> to,
                                     Real share);

    ContactSet* contacts_{nullptr};
    std::span<SolverBody> bodies_;
    ImpactSettings settings_{};
    std::vector<Pair> pairs_;
    std::vector<Group> groups_;
    std::vector<ImpactPoint> impacts_;  ///< of the group at hand
    JointedImpact jointed_;
};

}  // namespace plumbline::physics
