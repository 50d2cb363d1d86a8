#include "engine/physics/dynamics/joint/joint_direct.h"

#include <algorithm>
#include <cmath>

namespace plumbline::physics {
namespace {

/// Added to the diagonal, of its mean: redundant rows and closed loops still factor.
constexpr double kRegularisation = 1e-9;
/// Rounds of the active set of bounds.
constexpr int kMostRounds = 16;
constexpr int kPositionIterations = 2;
constexpr int kMostPositionIterations = 8;
/// More than two iterations are made for errors above it.
constexpr double kGoodError = 1e-7;
/// ... and rows are made anew when an iteration leaves more than this of the error before it.
constexpr double kConverging = 0.2;
/// Errors above it, m or rad, that all iterations leave are not corrected within the sub-step.
constexpr double kBadError = 1e-4;
/// A step leads away that leaves so many times the error before it: the next may mend less.
constexpr double kMostGrowth = 3;
/// A step that leads away is halved so often, then given up.
constexpr int kMostCuts = 5;
/// Errors below it, m or rad, are rounding.
constexpr double kNoError = 1e-10;

/// Positions do not follow limits whose push was eased, as along a lever that would be a leap, nor motors that give way.
bool leaves_positions(const JointBound& bound) {
    return bound.eased || bound.is_soft();
}

void bound_corrections(std::uint8_t rows, double substep_s, Vec3d& deviation) {
    for (int i = 0; i < 3; ++i) {
        if (((rows >> i) & 1) != 0) {
            deviation[i] = JointBound::bounded_correction(deviation[i], substep_s);
        }
    }
}

}  // namespace

void DirectJoints::start(JointGroup& group) {
    matrix_.fit(group.topology->pattern);
    stiffness_.start(group);
    const std::size_t count = group.rows.size();
    floor_.resize(count);
    x_.resize(count);
    wanted_.assign(count, Vec3d{0, 0, 0});
    held_.assign(count, Vec3d{0, 0, 0});
    factor(group);
}

void DirectJoints::factor(const JointGroup& group, BlockLdlt& matrix) {
    for (const JointComponent& component : group.topology->components) {
        assemble(group, component, matrix);
        matrix.factor(component.first_node, component.last_node, floor_);
    }
}

void DirectJoints::assemble(const JointGroup& group,
                            const JointComponent& component,
                            BlockLdlt& matrix) {
    const JointTopology& topology = *group.topology;
    for (std::uint32_t i = component.first_node; i < component.last_node; ++i) {
        const JointRows& rows = group.rows[i];
        Symmetric3& own = matrix.diagonal[i];
        own = own_coupling(rows, group.bodies);
        const double more = kRegularisation / 3 * (own.xx + own.yy + own.zz);
        floor_[i] = more > 0 ? more / 2 : 1;
        own.xx += more;
        own.yy += more;
        own.zz += more;
        if (&matrix == &spring_matrix_) {
            own.xx += compliance_[i];
            own.yy += compliance_[i];
            own.zz += compliance_[i];
        }
        if (rows.active != 0b111) mask(own, rows.active);
    }
    for (const JointBound& bound : group.bounds_of(component)) {
        if (bound.is_soft() && !rigid_motors_)
            diagonal(matrix.diagonal[bound.node], bound.row) += bound.slope;
    }
    matrix.clear_below(component.first_node, component.last_node);
    for (std::uint32_t t = component.first_term; t < component.last_term; ++t) {
        const JointTerm& term = topology.terms[t];
        const JointRows& row = group.rows[term.row];
        const JointRows& column = group.rows[term.column];
        const JointBody& body = group.bodies[term.row_is_b ? row.b : row.a];
        Block3 block = coupling(row, term.row_is_b, column, term.column_is_b, body.inverse_mass);
        if ((row.active & column.active) != 0b111) mask(block, row.active, column.active);
        add(matrix.below[term.block], block);
    }
}

void DirectJoints::solve_velocities(JointGroup& group) {
    for (const JointComponent& component : group.topology->components) {
        solve_component(group, component);
    }
}

void DirectJoints::solve_component(JointGroup& group, const JointComponent& component) {
    const std::span<JointBound> bounds = group.bounds_of(component);
    for (int round = 0; round < kMostRounds; ++round) {
        group.push_constant_bounds(bounds);
        for (const JointBound& bound : bounds) {
            const double given = bound.is_soft() ? bound.slope * bound.impulse : 0;
            wanted_[bound.node][bound.row] = bound.at_bound() ? bound.wanted_speed() - given : 0;
        }
        for (std::uint32_t i = component.first_node; i < component.last_node; ++i) {
            const JointRows& rows = group.rows[i];
            x_[i] = masked(wanted_[i] - rows.speeds(group.bodies), rows.active);
        }
        matrix_.solve(component.first_node, component.last_node, x_);
        if (JointGroup::ease_pushes(bounds, x_)) continue;
        push_solution(group, component);
        if (bounds.empty()) return;
        for (JointBound& bound : bounds) bound.impulse += x_[bound.node][bound.row];
        if (!group.update_steps(bounds, round)) return;
        assemble(group, component, matrix_);
        matrix_.factor(component.first_node, component.last_node, floor_);
    }
}

void DirectJoints::push_solution(JointGroup& group, const JointComponent& component) {
    for (std::uint32_t i = component.first_node; i < component.last_node; ++i) {
        group.rows[i].push(group.bodies, x_[i]);
        group.impulses[i] += x_[i];
    }
    group.row_solves += 3 * (component.last_node - component.first_node);
}

void DirectJoints::hold_steady_changes(JointGroup& group) {
    group.with_motion(steady_change_of, [&] {
        group.push_constants();
        taken_.clear();
        for (const JointBody& body : group.bodies)
            taken_.push_back({body.velocity_mps, body.spin_radps});
        hold_all_rigidly(group);
        for (std::size_t i = 0; i < taken_.size(); ++i) {
            taken_[i].velocity_mps -= group.bodies[i].velocity_mps;
            taken_[i].spin_radps -= group.bodies[i].spin_radps;
        }
        group.keep_as_steady_changes();
    });
}

void DirectJoints::hold_all(JointGroup& group) {
    for (const JointComponent& component : group.topology->components)
        group.hold_rows(matrix_, component, x_);
    group.row_solves += 3 * group.rows.size();
}

/// Motors that give way move their bodies by the speed that they were solved for: nothing beside it is left of what acts
/// steadily.
void DirectJoints::hold_all_rigidly(JointGroup& group) {
    rigid_motors_ = std::ranges::any_of(group.bounds, &JointBound::is_soft);
    if (!rigid_motors_) return hold_all(group);
    factor(group);
    hold_all(group);
    rigid_motors_ = false;
    factor(group);
}

void DirectJoints::hold_second_half(JointGroup& group) {
    const auto taken_of = [&](const JointBody& body) {
        return taken_[static_cast<std::size_t>(&body - group.bodies.data())];
    };
    group.with_motion(taken_of, [&] {
        hold_all_rigidly(group);
        for (std::size_t i = 0; i < taken_.size(); ++i)
            taken_[i] = {group.bodies[i].velocity_mps, group.bodies[i].spin_radps};
    });
    for (std::size_t i = 0; i < taken_.size(); ++i) {
        group.bodies[i].velocity_mps += 0.5 * taken_[i].velocity_mps;
        group.bodies[i].spin_radps += 0.5 * taken_[i].spin_radps;
    }
    taken_.clear();
}

void DirectJoints::correct_positions(JointGroup& group, StiffSprings& springs) {
    for (JointBody& body : group.bodies) body.note_momentum();
    hold_positions(group);
    hold_springs(group, springs);
    const bool any_left = std::ranges::any_of(group.bounds, leaves_positions);
    if (any_left) leave_positions(group);
    converge(group);
    if (group.any_residual) {
        // No speed comes of this: it would be given back at another pose, as energy.
        for (std::size_t i = 0; i < group.rows.size(); ++i) {
            const Vec3d residual = JointGroup::reduced_residual(group.residual[i], group.substep_s);
            held_[i] += residual - group.residual[i];
            group.residual[i] = residual;
        }
        gather_errors(group);
        solve_all(group, position_matrix());
        displace(group, 1, false);
    }
    release_springs(group, springs);
    for (const JointBound& bound : group.bounds) {
        if (leaves_positions(bound)) group.set_active(bound);
    }
    for (JointBody& body : group.bodies) {
        body.update_inertia();
        body.set_spin(group.substep_s);
    }
    stiffness_.lower(group);
}

/// Two iterations with rows and factor of before the motion, further ones where errors are large;
/// where that does not help, with rows at the poses reached.
void DirectJoints::converge(JointGroup& group) {
    double before = 0;
    double error = gather_errors(group);
    for (int i = 0; i < kMostPositionIterations; ++i) {
        if (error < kNoError || (i >= kPositionIterations && error < kGoodError)) return;
        if (i >= kPositionIterations && error > kConverging * before) {
            group.collect_totals();
            for (JointRows& rows : group.rows) rows.refresh(group.bodies);
            factor_positions(group);
        }
        solve_all(group, position_matrix());
        if (i == 0 && stiffness_.raise(group, x_)) {
            factor_positions(group);
            gather_errors(group);
            solve_all(group, position_matrix());
        }
        before = error;
        error = step_towards(group, before);
    }
    if (error > kBadError) keep_as_residual(group);
}

/// Makes the step in x_, or as much of it as does not lead away: rows in closed loops that are
/// nearly redundant ask for far more than they stay straight for. Leaves what is still to be put
/// right in x_; the largest of it.
double DirectJoints::step_towards(JointGroup& group, double error) {
    step_.assign(x_.begin(), x_.begin() + static_cast<std::ptrdiff_t>(group.rows.size()));
    displace(group, 1, true);
    double next = gather_errors(group);
    double made = 1;
    for (int cut = 0; cut <= kMostCuts && !(next < kMostGrowth * std::max(error, kGoodError));
         ++cut) {
        const double back = cut < kMostCuts ? made / 2 : made;
        x_ = step_;
        displace(group, -back, true);
        made -= back;
        next = gather_errors(group);
    }
    return next;
}

/// What no iteration puts right is come back from slowly, without speed.
void DirectJoints::keep_as_residual(JointGroup& group) {
    for (std::size_t i = 0; i < group.rows.size(); ++i) {
        const JointRows& rows = group.rows[i];
        Vec3d error = masked(rows.errors(group.bodies), rows.active);
        for (int k = 0; k < 3; ++k) {
            if (((rows.bounded >> k) & 1) != 0) error[k] = 0;
        }
        if (holds_springs_ && compliance_[i] > 0) error = {0, 0, 0};
        held_[i] += error - group.residual[i];
        group.residual[i] = error;
    }
    group.any_residual = true;
}

void DirectJoints::hold_positions(JointGroup& group) {
    if (group.any_residual) held_ = group.residual;
    for (const JointBound& bound : group.bounds) {
        held_[bound.node][bound.row] =
            bound.at_bound() ? bound.wanted_position(group.substep_s) : 0;
    }
}

void DirectJoints::leave_positions(JointGroup& group) {
    for (const JointBound& bound : group.bounds) {
        std::uint8_t& active = group.rows[bound.node].active;
        if (leaves_positions(bound))
            active = static_cast<std::uint8_t>(active & ~(1U << bound.row));
    }
    factor_positions(group);
}

BlockLdlt& DirectJoints::position_matrix() {
    return holds_springs_ ? spring_matrix_ : matrix_;
}

/// Leaves the correction in x_; the largest of it.
double DirectJoints::gather_errors(const JointGroup& group) {
    double largest = 0;
    for (std::size_t i = 0; i < group.rows.size(); ++i) {
        const JointRows& rows = group.rows[i];
        x_[i] = masked(held_[i] - rows.errors(group.bodies), rows.active);
        if (rows.bounded != 0) bound_corrections(rows.bounded, group.substep_s, x_[i]);
        largest =
            std::max(largest, std::max({std::abs(x_[i].x), std::abs(x_[i].y), std::abs(x_[i].z)}));
    }
    return largest;
}

void DirectJoints::solve_all(JointGroup& group, const BlockLdlt& matrix) {
    matrix.solve(0, static_cast<std::uint32_t>(group.rows.size()), x_);
    group.row_solves += 3 * group.rows.size();
}

/// Moves the bodies by `share` of the step in x_.
void DirectJoints::displace(JointGroup& group, double share, bool with_velocities) {
    const double per_substep = 1 / group.substep_s;
    for (std::size_t i = 0; i < group.rows.size(); ++i) {
        x_[i] *= share;
        group.rows[i].displace(group.bodies, x_[i]);
        if (!with_velocities) continue;
        group.impulses[i] += x_[i] * per_substep;
        if (holds_springs_) held_[i] -= compliance_[i] * x_[i];
    }
    for (JointBody& body : group.bodies) {
        if (body.movable) {
            body.displace();
            if (with_velocities) {
                body.velocity_mps += body.pushed_kgm * (body.inverse_mass * per_substep);
                body.twisted_in_all_kgm2 += body.twisted_kgm2;
            }
        }
        body.pushed_kgm = {0, 0, 0};
        body.twisted_kgm2 = {0, 0, 0};
    }
    if (!with_velocities) return;
    for (JointBound& bound : group.bounds) {
        bound.impulse += x_[bound.node][bound.row] * per_substep;
    }
}

}  // namespace plumbline::physics
