// Impacts of bodies that joints hold.
#pragma once

#include "engine/physics/dynamics/contact/contact_set.h"
#include "engine/physics/dynamics/joint/joint_group.h"
#include "engine/physics/dynamics/joint/joint_system.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace plumbline::physics {

/// A point of the pairs that are being solved.
struct ImpactPoint {
    std::uint32_t constraint{0};
    int lane{0};
    Vec3 arm_a{0, 0, 0};
    Vec3 arm_b{0, 0, 0};
    Vec3 belt_mps{0, 0, 0};  ///< of b's surface against b
    Real normal_mass{0};
    Real tangent_mass[2]{0, 0};
    Real target_mps{0};  ///< along the normal, after
    Real shift_m{0};     ///< along the normal: where a bounce at the surface would have begun
    Real normal_Ns{0};
    Real tangent_Ns[2]{0, 0};
};

/// The impulses of an impact's points, where joints hold the bodies in two pieces or one. What an impulse at one point changes
/// at all others, with the joints held, is measured once; the impulses then agree on that small matrix alone, and the joints
/// are solved again after all were pushed. Where a limit or motor let go by that, it is measured anew.
class JointedImpact {
public:
    /// `pieces`: as JointGroup::piece_of(). The impulses in `impacts` and the bodies' velocities change.
    void solve(JointSystem& joints,
               const std::array<std::uint32_t, 2>& pieces,
               std::span<ImpactPoint> impacts,
               std::span<const ContactConstraint> constraints,
               std::span<SolverBody> bodies);

private:
    /// Lines of a point: along the normal and, with friction, along both tangents.
    struct PointLines {
        std::size_t first{0};
        std::size_t end{0};

        bool rubs() const { return end > first + 1; }
    };

    void list_lines(std::span<const ImpactPoint> impacts,
                    std::span<const ContactConstraint> constraints);
    void measure(JointSystem& joints, std::span<const SolverBody> bodies);
    /// Of the bodies, along the lines.
    void read_speeds(std::span<const ImpactPoint> impacts, std::span<const SolverBody> bodies);
    /// The impulses with each other, and the speeds that they are to give.
    void agree(std::span<const ImpactPoint> impacts,
               std::span<const ContactConstraint> constraints);
    double change_normal(const ImpactPoint& impact, const PointLines& lines);
    double change_friction(const ContactConstraint& constraint, const PointLines& lines);
    void change(std::size_t line, double impulse_Ns);
    /// The bodies, by what the impulses are more than the points know.
    void push(std::span<ImpactPoint> impacts, std::span<SolverBody> bodies) const;
    double inverse_mass(std::size_t line) const { return changes_[line * lines_.size() + line]; }

    std::vector<ImpulseLine> lines_;
    std::vector<PointLines> points_;
    std::vector<bool> moves_;       ///< joints let the bodies move along the line
    std::vector<double> changes_;   ///< row by row: of speeds by a unit impulse along a line, 1/kg
    std::vector<double> speeds_;    ///< m/s, by line
    std::vector<double> impulses_;  ///< Ns, by line
};

}  // namespace plumbline::physics
