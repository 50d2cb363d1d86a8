#include "engine/physics/dynamics/impact/jointed_impact.h"

#include <algorithm>
#include <cmath>

namespace plumbline::physics {
namespace {

constexpr int kAgreeSweeps = 100;
/// Of the impulses: a sweep that changes less changes nothing.
constexpr double kSweepShare = 1e-5;
/// Over all, for limits and motors that let go: then what was measured misses more of the speeds that it changes.
constexpr int kHoldRounds = 8;
constexpr double kMissedShare = 1e-3;
constexpr double kRounding_mps = 1e-5;  // of a speed
/// Of what the bodies answer alone: joints that leave less let them move no way along the line.
constexpr double kHeldFast = 1e-5;

double distance_of(std::span<const double> a, std::span<const double> b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += std::abs(a[i] - b[i]);
    return sum;
}

}  // namespace

void JointedImpact::solve(JointSystem& joints,
                          const std::array<std::uint32_t, 2>& pieces,
                          std::span<ImpactPoint> impacts,
                          std::span<const ContactConstraint> constraints,
                          std::span<SolverBody> bodies) {
    const auto hold = [&] {
        if (pieces[0] != JointGroup::kNoPiece) joints.solve_piece(pieces[0]);
        if (pieces[1] != JointGroup::kNoPiece && pieces[1] != pieces[0])
            joints.solve_piece(pieces[1]);
    };
    list_lines(impacts, constraints);
    hold();
    measure(joints, bodies);
    read_speeds(impacts, bodies);
    for (int round = 0; round < kHoldRounds; ++round) {
        const std::vector<double> before_mps = speeds_;
        agree(impacts, constraints);
        const std::vector<double> expected_mps = speeds_;
        push(impacts, bodies);
        hold();
        read_speeds(impacts, bodies);
        const double changed_mps = distance_of(expected_mps, before_mps);
        const double rounding_mps = kRounding_mps * static_cast<double>(speeds_.size());
        if (distance_of(speeds_, expected_mps) <= kMissedShare * changed_mps + rounding_mps) return;
        measure(joints, bodies);
    }
}

void JointedImpact::list_lines(std::span<const ImpactPoint> impacts,
                               std::span<const ContactConstraint> constraints) {
    lines_.clear();
    points_.clear();
    impulses_.clear();
    for (const ImpactPoint& impact : impacts) {
        const ContactConstraint& constraint = constraints[impact.constraint];
        const std::size_t first = lines_.size();
        const auto add = [&](const Vec3& direction, Real impulse_Ns) {
            lines_.push_back({constraint.a, constraint.b, impact.arm_a, impact.arm_b, direction});
            impulses_.push_back(static_cast<double>(impulse_Ns));
        };
        add(constraint.normal, impact.normal_Ns);
        for (int t = 0; t < 2 && constraint.friction > 0; ++t)
            add(constraint.tangent[t], impact.tangent_Ns[t]);
        points_.push_back({.first = first, .end = lines_.size()});
    }
    changes_.resize(lines_.size() * lines_.size());
}

void JointedImpact::measure(JointSystem& joints, std::span<const SolverBody> bodies) {
    const std::size_t size = lines_.size();
    moves_.clear();
    for (std::size_t i = 0; i < size; ++i) {
        const ImpulseLine& line = lines_[i];
        joints.respond(line, lines_, std::span(changes_).subspan(i * size, size));
        const Real alone = bodies[line.a].inverse_mass_along(line.arm_a, line.direction) +
                           bodies[line.b].inverse_mass_along(line.arm_b, line.direction);
        moves_.push_back(inverse_mass(i) > kHeldFast * static_cast<double>(alone));
    }
}

void JointedImpact::read_speeds(std::span<const ImpactPoint> impacts,
                                std::span<const SolverBody> bodies) {
    speeds_.clear();
    for (std::size_t i = 0; i < impacts.size(); ++i) {
        for (std::size_t at = points_[i].first; at < points_[i].end; ++at) {
            const ImpulseLine& line = lines_[at];
            Vec3 velocity =
                bodies[line.a].velocity_at(line.arm_a) - bodies[line.b].velocity_at(line.arm_b);
            if (at > points_[i].first) velocity -= impacts[i].belt_mps;
            speeds_.push_back(static_cast<double>(glm::dot(velocity, line.direction)));
        }
    }
}

void JointedImpact::agree(std::span<const ImpactPoint> impacts,
                          std::span<const ContactConstraint> constraints) {
    for (int sweep = 0; sweep < kAgreeSweeps; ++sweep) {
        double changed_Ns = 0;
        double total_Ns = 0;
        for (std::size_t i = 0; i < impacts.size(); ++i) {
            const PointLines& point = points_[i];
            changed_Ns += change_normal(impacts[i], point);
            if (point.rubs())
                changed_Ns += change_friction(constraints[impacts[i].constraint], point);
            total_Ns += impulses_[point.first];
        }
        if (changed_Ns <= kSweepShare * total_Ns) return;
    }
}

/// Returns by how much it changed, Ns; so does change_friction().
double JointedImpact::change_normal(const ImpactPoint& impact, const PointLines& lines) {
    const std::size_t at = lines.first;
    if (!moves_[at]) return 0;
    const double wanted_mps = static_cast<double>(impact.target_mps) - speeds_[at];
    const double more_Ns = std::max(wanted_mps / inverse_mass(at), -impulses_[at]);
    change(at, more_Ns);
    return std::abs(more_Ns);
}

double JointedImpact::change_friction(const ContactConstraint& constraint,
                                      const PointLines& lines) {
    const std::size_t at[2]{lines.first + 1, lines.first + 2};
    double next_Ns[2];
    for (int t = 0; t < 2; ++t) {
        const double more_Ns = moves_[at[t]] ? -speeds_[at[t]] / inverse_mass(at[t]) : 0;
        next_Ns[t] = impulses_[at[t]] + more_Ns;
    }
    const double limit_Ns = static_cast<double>(constraint.friction) * impulses_[lines.first];
    const double length_Ns = std::sqrt(next_Ns[0] * next_Ns[0] + next_Ns[1] * next_Ns[1]);
    const double kept = length_Ns > limit_Ns ? limit_Ns / length_Ns : 1;
    double changed_Ns = 0;
    for (int t = 0; t < 2; ++t) {
        const double more_Ns = next_Ns[t] * kept - impulses_[at[t]];
        change(at[t], more_Ns);
        changed_Ns += std::abs(more_Ns);
    }
    return changed_Ns;
}

void JointedImpact::change(std::size_t line, double impulse_Ns) {
    if (impulse_Ns == 0) return;
    impulses_[line] += impulse_Ns;
    const std::size_t size = lines_.size();
    for (std::size_t i = 0; i < size; ++i) speeds_[i] += changes_[line * size + i] * impulse_Ns;
}

void JointedImpact::push(std::span<ImpactPoint> impacts, std::span<SolverBody> bodies) const {
    for (std::size_t i = 0; i < impacts.size(); ++i) {
        const std::size_t first = points_[i].first;
        const auto give = [&](std::size_t at, Real& given_Ns) {
            const ImpulseLine& line = lines_[at];
            const Vec3 more_Ns = line.direction * (static_cast<Real>(impulses_[at]) - given_Ns);
            given_Ns = static_cast<Real>(impulses_[at]);
            bodies[line.a].push(more_Ns, line.arm_a);
            bodies[line.b].push(-more_Ns, line.arm_b);
        };
        give(first, impacts[i].normal_Ns);
        for (std::size_t at = first + 1; at < points_[i].end; ++at)
            give(at, impacts[i].tangent_Ns[at - first - 1]);
    }
}

}  // namespace plumbline::physics
