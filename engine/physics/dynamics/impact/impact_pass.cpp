#include "engine/physics/dynamics/impact/impact_pass.h"

#include <algorithm>
#include <cmath>

namespace plumbline::physics {
namespace {

constexpr int kRounds = 8;        // over the pairs, for impacts that impacts cause
constexpr int kInnerSweeps = 12;  // over the points of one pair
/// Points nearer than this are taken as touching, m: rounding of a separation.
constexpr Real kTouching_m = 1e-6_r;

Real mass_along(const SolverBody& body, const Vec3& arm, const Vec3& direction) {
    const Vec3 turn = glm::cross(arm, direction);
    return body.inverse_mass + glm::dot(turn, body.inverse_inertia * turn);
}

Vec3 pull_at(const SolverBody& body, const Vec3& arm) {
    return body.acceleration_mps2 + glm::cross(body.angular_acceleration_radps2, arm);
}

}  // namespace

void ImpactPass::begin_step(ContactSet& contacts,
                            std::span<SolverBody> bodies,
                            Real threshold_mps) {
    contacts_ = &contacts;
    bodies_ = bodies;
    threshold_mps_ = threshold_mps;
    pairs_.clear();
    const std::vector<ContactConstraint>& constraints = contacts.constraints;
    for (std::uint32_t i = 0; i < constraints.size();) {
        std::uint32_t end = i + 1;
        while (end < constraints.size() && constraints[end].a == constraints[i].a &&
               constraints[end].b == constraints[i].b)
            ++end;
        if (constraints[i].restitution > 0) pairs_.push_back({i, end - i});
        i = end;
    }
}

/// Two spheres meet along the line between their centres at that moment, not at the sub-step's start.
void ImpactPass::turn_to_meeting(ContactConstraint& constraint) const {
    const SolverBody& a = bodies_[constraint.a];
    const SolverBody& b = bodies_[constraint.b];
    const Real reach_m = constraint.radius_a + constraint.radius_b;
    const Vec3 apart = constraint.normal * (reach_m + constraint.separation_m[0]);
    const Vec3 velocity =
        a.velocity_at(constraint.center_a + constraint.normal * constraint.radius_a) -
        b.velocity_at(constraint.center_b - constraint.normal * constraint.radius_b);
    const Real closing = -glm::dot(apart, velocity);
    const Real speed2 = glm::dot(velocity, velocity);
    const Real gap2 = constraint.separation_m[0] * (constraint.separation_m[0] + 2 * reach_m);
    const Real root2 = closing * closing - speed2 * gap2;
    if (!(gap2 > 0 && closing > 0 && root2 > 0)) return;
    const Real meeting_s = gap2 / (closing + std::sqrt(root2));
    if (!(meeting_s <= contacts_->substep_s())) return;
    const Vec3 normal = glm::normalize(apart + velocity * meeting_s);
    constraint.separation_m[0] = glm::dot(apart, normal) - reach_m;
    constraint.center_a += (constraint.normal - normal) * constraint.radius_a;
    constraint.center_b -= (constraint.normal - normal) * constraint.radius_b;
    constraint.normal = normal;
}

/// Fills impacts_ with the pair's points that meet in this sub-step; whether one of them is fast.
bool ImpactPass::gather(const Pair& pair) {
    impacts_.clear();
    bool fast = false;
    const Real h = contacts_->substep_s();
    for (std::uint32_t at = pair.first_constraint; at < pair.first_constraint + pair.block_count;
         ++at) {
        ContactConstraint& constraint = contacts_->constraints[at];
        contacts_->update_separations(constraint);
        if (constraint.spheres()) turn_to_meeting(constraint);
        const SolverBody& a = bodies_[constraint.a];
        const SolverBody& b = bodies_[constraint.b];
        const Vec3 moved =
            constraint.shift_of(a.delta_position_m - b.delta_position_m);  // 0 unless rounded
        for (int i = 0; i < constraint.count; ++i) {
            Impact impact{.constraint = at,
                          .lane = i,
                          .arm_a = constraint.arm_a(i),
                          .arm_b = constraint.arm_b(i)};
            if (constraint.spheres()) {
                // Where update_separations() just found them.
                impact.arm_a = constraint.center_a;
                impact.arm_b = constraint.center_b;
            } else {
                (constraint.radius_a > 0 ? impact.arm_b : impact.arm_a) +=
                    constraint.radius_a > 0 ? moved : -moved;
            }
            const Real speed = glm::dot(a.velocity_at(impact.arm_a) - b.velocity_at(impact.arm_b),
                                        constraint.normal);
            const Real opening_mps2 =
                glm::dot(pull_at(a, impact.arm_a) - pull_at(b, impact.arm_b), constraint.normal);
            const Real separation = constraint.separation_m[static_cast<std::size_t>(i)];
            const Real reached_mps = std::min(speed, speed + opening_mps2 * h);
            if (separation + h * reached_mps > kTouching_m) continue;
            if (speed < -threshold_mps_) {
                fast = true;
                aim(constraint, separation, speed, opening_mps2, impact);
            }
            impacts_.push_back(impact);
        }
    }
    return fast;
}

/// The speed after, and for spheres where and when they meet: tau from s + v tau + a tau^2 / 2 = 0.
/// A sphere is put where the parabola of its way out begins, so that after the sub-step it is where
/// and as fast as if it had bounced at tau. Other shapes bounce here, with the energy that they
/// would have had at the surface.
void ImpactPass::aim(const ContactConstraint& constraint,
                     Real separation_m,
                     Real speed_mps,
                     Real opening_mps2,
                     Impact& impact) const {
    const Real fall = -2 * opening_mps2 * separation_m;
    const Real at_surface = std::sqrt(std::max(speed_mps * speed_mps + fall, Real{0}));
    const Real out_mps = constraint.restitution * at_surface;
    if (!constraint.whole_spheres() || separation_m < 0) {
        impact.target_mps = std::sqrt(std::max(out_mps * out_mps - fall, Real{0}));
        return;
    }
    const Real tau_s =
        std::min(2 * separation_m / (at_surface - speed_mps), contacts_->substep_s());
    impact.target_mps = out_mps - opening_mps2 * tau_s;
    impact.shift_m = opening_mps2 * tau_s * tau_s / 2 - out_mps * tau_s - separation_m;
}

void ImpactPass::weigh_impacts() {
    for (Impact& impact : impacts_) {
        const ContactConstraint& constraint = contacts_->constraints[impact.constraint];
        const SolverBody& a = bodies_[constraint.a];
        const SolverBody& b = bodies_[constraint.b];
        const auto mass = [&](const Vec3& direction) {
            return 1 / (mass_along(a, impact.arm_a, direction) +
                        mass_along(b, impact.arm_b, direction));
        };
        impact.normal_mass = mass(constraint.normal);
        for (int t = 0; t < 2; ++t) impact.tangent_mass[t] = mass(constraint.tangent[t]);
    }
}

void ImpactPass::solve_friction(Impact& impact) {
    const ContactConstraint& constraint = contacts_->constraints[impact.constraint];
    SolverBody& a = bodies_[constraint.a];
    SolverBody& b = bodies_[constraint.b];
    const Vec3 slip = a.velocity_at(impact.arm_a) - b.velocity_at(impact.arm_b);
    Real next[2];
    for (int t = 0; t < 2; ++t)
        next[t] =
            impact.tangent_Ns[t] - impact.tangent_mass[t] * glm::dot(slip, constraint.tangent[t]);
    const Real limit = constraint.friction * impact.normal_Ns;
    const Real length = std::hypot(next[0], next[1]);
    const Real kept = length > limit ? limit / length : Real{1};
    Vec3 change_Ns{0, 0, 0};
    for (int t = 0; t < 2; ++t) {
        change_Ns += constraint.tangent[t] * (next[t] * kept - impact.tangent_Ns[t]);
        impact.tangent_Ns[t] = next[t] * kept;
    }
    a.push(change_Ns, impact.arm_a);
    b.push(-change_Ns, impact.arm_b);
}

void ImpactPass::solve_impacts() {
    weigh_impacts();
    const int sweeps = impacts_.size() > 1 ? kInnerSweeps : 1;
    for (int sweep = 0; sweep < sweeps; ++sweep) {
        for (Impact& impact : impacts_) {
            const ContactConstraint& constraint = contacts_->constraints[impact.constraint];
            SolverBody& a = bodies_[constraint.a];
            SolverBody& b = bodies_[constraint.b];
            const Real speed = glm::dot(a.velocity_at(impact.arm_a) - b.velocity_at(impact.arm_b),
                                        constraint.normal);
            const Real next = std::max(
                impact.normal_Ns + impact.normal_mass * (impact.target_mps - speed), Real{0});
            const Vec3 impulse = constraint.normal * (next - impact.normal_Ns);
            impact.normal_Ns = next;
            a.push(impulse, impact.arm_a);
            b.push(-impulse, impact.arm_b);
            if (constraint.friction > 0) solve_friction(impact);
        }
    }
    for (const Impact& impact : impacts_) {
        ContactConstraint& constraint = contacts_->constraints[impact.constraint];
        SolverBody& a = bodies_[constraint.a];
        SolverBody& b = bodies_[constraint.b];
        const Vec3 shift = constraint.normal * (impact.shift_m / (a.inverse_mass + b.inverse_mass));
        a.delta_position_m += shift * a.inverse_mass;
        b.delta_position_m -= shift * b.inverse_mass;
        constraint.total_Ns[static_cast<std::size_t>(impact.lane)] += impact.normal_Ns;
        constraint.bounced = constraint.bounced || constraint.whole_spheres();
    }
}

std::uint32_t ImpactPass::run() {
    std::uint32_t impacts = 0;
    for (int round = 0; round < kRounds; ++round) {
        bool any = false;
        for (const Pair& pair : pairs_) {
            if (!gather(pair)) continue;
            any = true;
            impacts += static_cast<std::uint32_t>(impacts_.size());
            solve_impacts();
        }
        if (!any) break;
    }
    contacts_->row_solves += impacts;
    return impacts;
}

}  // namespace plumbline::physics
