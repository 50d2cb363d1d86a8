#include "engine/physics/dynamics/impact/impact_pass.h"

#include "engine/core/time/trace_events.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace plumbline::physics {
namespace {

constexpr int kRounds = 8;  // over the pairs, for impacts that impacts cause
/// Over the points of one pair, unless they agree sooner: of a pair's impulses, where a sweep changes less.
constexpr int kInnerSweeps = 100;
constexpr Real kSettledShare = 4 * std::numeric_limits<Real>::epsilon();
/// Of the energy: more is a gain, not rounding.
constexpr double kGain = 1e-6;
/// Points nearer than this are taken as touching, m: rounding of a separation.
constexpr Real kTouching_m = 1e-6_r;

Vec3 pull_at(const SolverBody& body, const Vec3& arm) {
    return body.acceleration_mps2 + glm::cross(body.angular_acceleration_radps2, arm);
}

/// Two spheres collide along the line between their centres at that moment, not at the sub-step's start.
void turn_to_impact(ContactConstraint& constraint,
                    const SolverBody& a,
                    const SolverBody& b,
                    Real substep_s) {
    const Real reach_m = constraint.radius_a + constraint.radius_b;
    const Vec3 offset = constraint.normal * (reach_m + constraint.separation_m[0]);
    const Vec3 velocity =
        a.velocity_at(constraint.center_a + constraint.normal * constraint.radius_a) -
        b.velocity_at(constraint.center_b - constraint.normal * constraint.radius_b);
    const Real closing = -glm::dot(offset, velocity);
    const Real speed2 = glm::dot(velocity, velocity);
    const Real gap2 = constraint.separation_m[0] * (constraint.separation_m[0] + 2 * reach_m);
    const Real root2 = closing * closing - speed2 * gap2;
    if (!(gap2 > 0 && closing > 0 && root2 > 0)) return;
    const Real impact_s = gap2 / (closing + std::sqrt(root2));
    if (!(impact_s <= substep_s)) return;
    const Vec3 normal = glm::normalize(offset + velocity * impact_s);
    constraint.separation_m[0] = glm::dot(offset, normal) - reach_m;
    constraint.center_a += (constraint.normal - normal) * constraint.radius_a;
    constraint.center_b -= (constraint.normal - normal) * constraint.radius_b;
    turn_normal(constraint, normal);
}

/// How a point of the pair comes together, along the normal.
struct Approach {
    Real separation_m{0};
    Real speed_mps{0};     ///< negative: closing
    Real opening_mps2{0};  ///< its change by steady forces
};

/// The speed after, and for spheres where and when they collide: tau from s + v tau + a tau^2 / 2 = 0.
/// A sphere is put where the parabola of its way out begins, so that after the sub-step it is where
/// and as fast as if it had bounced at tau. Other shapes bounce here, with the energy that they
/// would have had at the surface.
void predict_impact(const ContactConstraint& constraint,
                    const Approach& approach,
                    Real substep_s,
                    bool may_shift,
                    ImpactPoint& impact) {
    const auto [separation_m, speed_mps, opening_mps2] = approach;
    const Real fall = -2 * opening_mps2 * separation_m;
    const Real at_surface = std::sqrt(std::max(speed_mps * speed_mps + fall, Real{0}));
    const Real out_mps = constraint.restitution * at_surface;
    if (!may_shift || !constraint.whole_spheres() || separation_m < 0) {
        impact.target_mps = std::sqrt(std::max(out_mps * out_mps - fall, Real{0}));
        return;
    }
    const Real tau_s = std::min(2 * separation_m / (at_surface - speed_mps), substep_s);
    impact.target_mps = out_mps - opening_mps2 * tau_s;
    impact.shift_m = opening_mps2 * tau_s * tau_s / 2 - out_mps * tau_s - separation_m;
}

void weigh_impact(ImpactPoint& impact,
                  const ContactConstraint& constraint,
                  std::span<const SolverBody> bodies) {
    const auto mass_along = [&](const Vec3& direction) {
        return 1 / (bodies[constraint.a].inverse_mass_along(impact.arm_a, direction) +
                    bodies[constraint.b].inverse_mass_along(impact.arm_b, direction));
    };
    impact.normal_mass = mass_along(constraint.normal);
    for (int t = 0; t < 2; ++t) impact.tangent_mass[t] = mass_along(constraint.tangent[t]);
}

/// Returns by how much it changed the impulse, Ns; so does solve_normal().
Real solve_friction(ImpactPoint& impact,
                    const ContactConstraint& constraint,
                    SolverBody& a,
                    SolverBody& b) {
    const Vec3 slip = a.velocity_at(impact.arm_a) - b.velocity_at(impact.arm_b) - impact.belt_mps;
    Real next[2];
    for (int t = 0; t < 2; ++t)
        next[t] =
            impact.tangent_Ns[t] - impact.tangent_mass[t] * glm::dot(slip, constraint.tangent[t]);
    const Real limit = constraint.friction * impact.normal_Ns;
    const Real length = glm::length(Vec2{next[0], next[1]});
    const Real kept = length > limit ? limit / length : Real{1};
    Vec3 change_Ns{0, 0, 0};
    for (int t = 0; t < 2; ++t) {
        change_Ns += constraint.tangent[t] * (next[t] * kept - impact.tangent_Ns[t]);
        impact.tangent_Ns[t] = next[t] * kept;
    }
    a.push(change_Ns, impact.arm_a);
    b.push(-change_Ns, impact.arm_b);
    return glm::length(change_Ns);
}

Real solve_normal(ImpactPoint& impact,
                  const ContactConstraint& constraint,
                  SolverBody& a,
                  SolverBody& b) {
    const Real speed =
        glm::dot(a.velocity_at(impact.arm_a) - b.velocity_at(impact.arm_b), constraint.normal);
    const Real next =
        std::max(impact.normal_Ns + impact.normal_mass * (impact.target_mps - speed), Real{0});
    const Real change_Ns = next - impact.normal_Ns;
    impact.normal_Ns = next;
    a.push(constraint.normal * change_Ns, impact.arm_a);
    b.push(constraint.normal * -change_Ns, impact.arm_b);
    return std::abs(change_Ns);
}

/// What came of it: into the constraint's totals and the spheres' places.
void keep_impact(const ImpactPoint& impact,
                 ContactConstraint& constraint,
                 SolverBody& a,
                 SolverBody& b) {
    const Vec3 shift = constraint.normal * (impact.shift_m / (a.inverse_mass + b.inverse_mass));
    a.delta_position_m += shift * a.inverse_mass;
    b.delta_position_m -= shift * b.inverse_mass;
    constraint.total_Ns[static_cast<std::size_t>(impact.lane)] += impact.normal_Ns;
    constraint.bounced = constraint.bounced || constraint.whole_spheres();
}

/// All points at once.
void sweep_impacts(std::span<ImpactPoint> impacts,
                   std::span<const ContactConstraint> constraints,
                   std::span<SolverBody> bodies) {
    const int most = impacts.size() > 1 ? kInnerSweeps : 1;
    bool agree = false;
    for (int sweep = 0; sweep < most && !agree; ++sweep) {
        Real changed_Ns = 0;
        Real total_Ns = 0;
        for (ImpactPoint& impact : impacts) {
            const ContactConstraint& constraint = constraints[impact.constraint];
            SolverBody& a = bodies[constraint.a];
            SolverBody& b = bodies[constraint.b];
            changed_Ns += solve_normal(impact, constraint, a, b);
            if (constraint.friction > 0) changed_Ns += solve_friction(impact, constraint, a, b);
            total_Ns += impact.normal_Ns;
        }
        agree = changed_Ns <= kSettledShare * total_Ns;
    }
}

/// Where a + b s + c s^2 passes `most` between 0 and 1, from values at 0, 1/2 and 1 of which only the last is more.
double share_within(double most, double at_0, double at_half, double at_1) {
    const double c = 2 * (at_0 + at_1) - 4 * at_half;
    const double b = at_1 - at_0 - c;
    const double left = most - at_0;
    if (!(left > 0)) return 0;
    const double root = std::sqrt(std::max(b * b + 4 * c * left, 0.0));
    return std::clamp(2 * left / (b + root), 0.0, 1.0);
}

}  // namespace

void ImpactPass::begin_step(ContactSet& contacts,
                            std::span<SolverBody> bodies,
                            const ImpactSettings& settings) {
    contacts_ = &contacts;
    bodies_ = bodies;
    settings_ = settings;
    pairs_.clear();
    const std::vector<ContactConstraint>& constraints = contacts.constraints;
    for (std::uint32_t i = 0; i < constraints.size();) {
        std::uint32_t end = i + 1;
        while (end < constraints.size() && constraints[end].a == constraints[i].a &&
               constraints[end].b == constraints[i].b)
            ++end;
        if (settings.inelastic_too || constraints[i].restitution > 0)
            pairs_.push_back({i, end - i});
        i = end;
    }
    group_by_pieces();
}

/// Bodies that joints hold together meet others as one: their pairs come to be one group.
void ImpactPass::group_by_pieces() {
    groups_.clear();
    const auto pieces_of = [this](const Pair& pair) {
        if (settings_.joints == nullptr)
            return std::array{JointGroup::kNoPiece, JointGroup::kNoPiece};
        const ContactConstraint& constraint = contacts_->constraints[pair.first_constraint];
        return std::array{settings_.joints->piece_of(constraint.a),
                          settings_.joints->piece_of(constraint.b)};
    };
    // What meets: two pieces or, of no piece, bodies.
    const auto key_of = [&](const Pair& pair) {
        const ContactConstraint& constraint = contacts_->constraints[pair.first_constraint];
        const auto [of_a, of_b] = pieces_of(pair);
        std::array sides{std::pair(of_a, of_a == JointGroup::kNoPiece ? constraint.a : 0),
                         std::pair(of_b, of_b == JointGroup::kNoPiece ? constraint.b : 0)};
        std::ranges::sort(sides);
        return sides;
    };
    if (settings_.joints != nullptr) std::ranges::stable_sort(pairs_, {}, key_of);
    for (std::uint32_t i = 0; i < pairs_.size(); ++i) {
        const bool joins =
            settings_.joints != nullptr && i > 0 && key_of(pairs_[i]) == key_of(pairs_[i - 1]);
        if (!joins) groups_.push_back({.first_pair = i, .pieces = pieces_of(pairs_[i])});
        ++groups_.back().pair_count;
    }
}

/// Fills impacts_ with the group's points that close in this sub-step; whether one of them is fast.
bool ImpactPass::gather(const Group& group) {
    impacts_.clear();
    // Joints would have to follow a shift.
    const bool may_shift = settings_.may_shift && !group.is_jointed();
    bool fast = false;
    for (std::uint32_t i = 0; i < group.pair_count; ++i)
        fast = gather(pairs_[group.first_pair + i], may_shift) || fast;
    return fast;
}

bool ImpactPass::gather(const Pair& pair, bool may_shift) {
    bool fast = false;
    const Real h = contacts_->substep_s();
    for (std::uint32_t at = pair.first_constraint; at < pair.first_constraint + pair.block_count;
         ++at) {
        ContactConstraint& constraint = contacts_->constraints[at];
        const Real touching_m = settings_.touching_m.empty()
                                    ? kTouching_m
                                    : std::max(settings_.touching_m[at], kTouching_m);
        contacts_->update_separations(constraint);
        const SolverBody& a = bodies_[constraint.a];
        const SolverBody& b = bodies_[constraint.b];
        if (constraint.spheres()) turn_to_impact(constraint, a, b, h);
        for (int i = 0; i < constraint.count; ++i) {
            // Of spheres where update_separations() just found them.
            const PointArms arms = constraint.spheres()
                                       ? PointArms{constraint.center_a, constraint.center_b}
                                       : arms_of(constraint, a, b, i);
            ImpactPoint impact{.constraint = at, .lane = i, .arm_a = arms.a, .arm_b = arms.b};
            impact.belt_mps = contacts_->belt_velocity_at(constraint, impact.arm_b);
            const Real speed = glm::dot(a.velocity_at(impact.arm_a) - b.velocity_at(impact.arm_b),
                                        constraint.normal);
            const Real opening_mps2 =
                glm::dot(pull_at(a, impact.arm_a) - pull_at(b, impact.arm_b), constraint.normal);
            const Real separation = constraint.separation_m[static_cast<std::size_t>(i)];
            const Real reached_mps = std::min(speed, speed + opening_mps2 * h);
            if (separation + h * reached_mps > touching_m) continue;
            if (speed < -settings_.threshold_mps) {
                fast = true;
                predict_impact(constraint, {separation, speed, opening_mps2}, h, may_shift, impact);
            }
            impacts_.push_back(impact);
        }
    }
    return fast;
}

void ImpactPass::solve(const Group& group) {
    if (group.is_jointed()) {
        solve_jointed(group);
    } else {
        for (ImpactPoint& impact : impacts_)
            weigh_impact(impact, contacts_->constraints[impact.constraint], bodies_);
        sweep_impacts(impacts_, contacts_->constraints, bodies_);
    }
    for (const ImpactPoint& impact : impacts_) {
        ContactConstraint& constraint = contacts_->constraints[impact.constraint];
        keep_impact(impact, constraint, bodies_[constraint.a], bodies_[constraint.b]);
    }
}

void ImpactPass::solve_jointed(const Group& group) {
    const auto agree = [&] {
        jointed_.solve(*settings_.joints, group.pieces, impacts_, contacts_->constraints, bodies_);
    };
    const std::vector<ImpactPoint> start = impacts_;
    const std::vector<Motion> before = motions();
    const double before_J = kinetic_J(bodies_, {0, 0, 0});
    settings_.joints->note_impulses();
    agree();
    const double elastic_J = kinetic_J(bodies_, {0, 0, 0});
    if (!(elastic_J > before_J * (1 + kGain))) return;
    // With friction, speeds that are all turned round may be more than there was (Kane and Levinson, Dynamics, 1985): as
    // much of the way from the plastic impact to this one is gone as gives nothing.
    const std::vector<ImpactPoint> elastic = std::exchange(impacts_, start);
    const std::vector<Motion> elastic_motions = motions();
    set_motions(before);
    settings_.joints->return_impulses();
    for (ImpactPoint& impact : impacts_) impact.target_mps = impact.shift_m = 0;
    agree();
    const std::vector<Motion> plastic_motions = motions();
    const double plastic_J = kinetic_J(bodies_, {0, 0, 0});
    set_motions(mixed(plastic_motions, elastic_motions, 0.5_r));
    const double half_J = kinetic_J(bodies_, {0, 0, 0});
    const auto share = static_cast<Real>(share_within(before_J, plastic_J, half_J, elastic_J));
    set_motions(mixed(plastic_motions, elastic_motions, share));
    for (std::size_t i = 0; i < impacts_.size(); ++i)
        impacts_[i].normal_Ns += share * (elastic[i].normal_Ns - impacts_[i].normal_Ns);
}

std::vector<ImpactPass::Motion> ImpactPass::motions() const {
    std::vector<Motion> all;
    for (const SolverBody& body : bodies_) all.push_back({body.velocity_mps, body.spin_radps});
    return all;
}

void ImpactPass::set_motions(std::span<const Motion> motions) {
    for (std::size_t i = 0; i < motions.size(); ++i) {
        bodies_[i].velocity_mps = motions[i].velocity_mps;
        bodies_[i].spin_radps = motions[i].spin_radps;
    }
}

std::vector<ImpactPass::Motion> ImpactPass::mixed(std::span<const Motion> from,
                                                  std::span<const Motion> to,
                                                  Real share) {
    std::vector<Motion> all;
    for (std::size_t i = 0; i < from.size(); ++i) {
        all.push_back({from[i].velocity_mps + share * (to[i].velocity_mps - from[i].velocity_mps),
                       from[i].spin_radps + share * (to[i].spin_radps - from[i].spin_radps)});
    }
    return all;
}

std::uint32_t ImpactPass::run() {
    const TraceSpan span("impacts");
    std::uint32_t impacts = 0;
    for (int round = 0; round < kRounds; ++round) {
        bool any = false;
        for (const Group& group : groups_) {
            if (!gather(group)) continue;
            any = true;
            impacts += static_cast<std::uint32_t>(impacts_.size());
            solve(group);
        }
        if (!any) break;
    }
    return impacts;
}

}  // namespace plumbline::physics
