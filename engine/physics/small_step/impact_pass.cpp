#include "engine/physics/small_step/impact_pass.h"

#include <algorithm>
#include <cmath>

namespace plumbline::physics {
namespace {

constexpr int kRounds = 8;        // over the pairs, for blows that blows cause
constexpr int kInnerSweeps = 12;  // over the points of one pair
/// Points nearer than this are taken as touching, m: rounding of a separation.
constexpr Real kTouching_m = 1e-6_r;

}  // namespace

void ImpactPass::begin_step(ContactSet& contacts,
                            std::span<SolverBody> bodies,
                            Real threshold_mps) {
    contacts_ = &contacts;
    bodies_ = bodies;
    threshold_mps_ = threshold_mps;
    pairs_.clear();
    if (!contacts.any_restitution()) return;
    const std::vector<ContactGroup>& groups = contacts.groups;
    for (std::uint32_t i = 0; i < groups.size();) {
        std::uint32_t end = i + 1;
        while (end < groups.size() && groups[end].a == groups[i].a && groups[end].b == groups[i].b)
            ++end;
        if (groups[i].restitution > 0) pairs_.push_back({i, end - i});
        i = end;
    }
}

/// Fills blows_ with the pair's points that meet in this sub-step; whether one of them is fast.
bool ImpactPass::gather(const Pair& pair) {
    blows_.clear();
    bool fast = false;
    const Real h = contacts_->substep_s();
    for (std::uint32_t g = pair.first_group; g < pair.first_group + pair.group_count; ++g) {
        const ContactGroup& group = contacts_->groups[g];
        contacts_->place(group);
        const SolverBody& a = bodies_[group.a];
        const SolverBody& b = bodies_[group.b];
        for (std::uint32_t i = group.first; i < group.first + group.count; ++i) {
            const ContactPoint& point = contacts_->points[i];
            const Real speed =
                glm::dot(a.velocity_at(point.arm_a) - b.velocity_at(point.arm_b), group.normal);
            const Vec3 pull =
                a.acceleration_mps2 + glm::cross(a.angular_acceleration_radps2, point.arm_a) -
                b.acceleration_mps2 - glm::cross(b.angular_acceleration_radps2, point.arm_b);
            const Real opening_mps2 = glm::dot(pull, group.normal);
            const Real reached_mps = std::min(speed, speed + opening_mps2 * h);
            if (point.separation_m + h * reached_mps > kTouching_m) continue;
            Blow blow{.point = i, .group = g};
            if (speed < -threshold_mps_) {
                fast = true;
                // Energy along the normal, from here to the surface and back.
                const Real fall = -2 * opening_mps2 * point.separation_m;
                const Real at_surface = std::max(speed * speed + fall, Real{0});
                const Real e = group.restitution;
                blow.target_mps = std::sqrt(std::max(e * e * at_surface - fall, Real{0}));
            }
            blows_.push_back(blow);
        }
    }
    return fast;
}

void ImpactPass::solve_friction(Blow& blow) {
    const ContactGroup& group = contacts_->groups[blow.group];
    const ContactPoint& point = contacts_->points[blow.point];
    SolverBody& a = bodies_[group.a];
    SolverBody& b = bodies_[group.b];
    const Vec3 slip = a.velocity_at(point.arm_a) - b.velocity_at(point.arm_b);
    Real next[2];
    for (int t = 0; t < 2; ++t) {
        next[t] = blow.tangent_Ns[t] - point.tangent_mass[t] * glm::dot(slip, group.tangent[t]);
    }
    const Real limit = group.friction * blow.normal_Ns;
    const Real length = std::hypot(next[0], next[1]);
    const Real kept = length > limit ? limit / length : Real{1};
    Vec3 rub{0, 0, 0};
    for (int t = 0; t < 2; ++t) {
        rub += group.tangent[t] * (next[t] * kept - blow.tangent_Ns[t]);
        blow.tangent_Ns[t] = next[t] * kept;
    }
    a.push(rub, point.arm_a);
    b.push(-rub, point.arm_b);
}

void ImpactPass::solve_blows() {
    const int sweeps = blows_.size() > 1 ? kInnerSweeps : 1;
    for (int sweep = 0; sweep < sweeps; ++sweep) {
        for (Blow& blow : blows_) {
            const ContactGroup& group = contacts_->groups[blow.group];
            const ContactPoint& point = contacts_->points[blow.point];
            SolverBody& a = bodies_[group.a];
            SolverBody& b = bodies_[group.b];
            const Real speed =
                glm::dot(a.velocity_at(point.arm_a) - b.velocity_at(point.arm_b), group.normal);
            const Real next =
                std::max(blow.normal_Ns + point.normal_mass * (blow.target_mps - speed), Real{0});
            const Vec3 impulse = group.normal * (next - blow.normal_Ns);
            blow.normal_Ns = next;
            a.push(impulse, point.arm_a);
            b.push(-impulse, point.arm_b);
            if (group.friction > 0) solve_friction(blow);
        }
    }
    for (const Blow& blow : blows_) contacts_->points[blow.point].total_Ns += blow.normal_Ns;
}

std::uint32_t ImpactPass::run() {
    std::uint32_t blows = 0;
    for (int round = 0; round < kRounds; ++round) {
        bool any = false;
        for (const Pair& pair : pairs_) {
            if (!gather(pair)) continue;
            any = true;
            blows += static_cast<std::uint32_t>(blows_.size());
            solve_blows();
        }
        if (!any) break;
    }
    contacts_->row_solves_ += blows;
    return blows;
}

}  // namespace plumbline::physics
