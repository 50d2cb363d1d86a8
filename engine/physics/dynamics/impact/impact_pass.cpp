#include "engine/physics/dynamics/impact/impact_pass.h"

#include <algorithm>
#include <cmath>

namespace plumbline::physics {
namespace {

constexpr int kRounds = 8;        // over the pairs, for blows that blows cause
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
    const std::vector<ContactBlock>& blocks = contacts.blocks;
    for (std::uint32_t i = 0; i < blocks.size();) {
        std::uint32_t end = i + 1;
        while (end < blocks.size() && blocks[end].a == blocks[i].a && blocks[end].b == blocks[i].b)
            ++end;
        if (blocks[i].restitution > 0) pairs_.push_back({i, end - i});
        i = end;
    }
}

/// Two balls meet along the line between their centres at that moment, not at the sub-step's start.
void ImpactPass::turn_to_meeting(ContactBlock& block) const {
    const SolverBody& a = bodies_[block.a];
    const SolverBody& b = bodies_[block.b];
    const Real reach_m = block.radius_a + block.radius_b;
    const Vec3 apart = block.normal * (reach_m + block.separation_m[0]);
    const Vec3 velocity = a.velocity_at(block.center_a + block.normal * block.radius_a) -
                          b.velocity_at(block.center_b - block.normal * block.radius_b);
    const Real closing = -glm::dot(apart, velocity);
    const Real speed2 = glm::dot(velocity, velocity);
    const Real gap2 = block.separation_m[0] * (block.separation_m[0] + 2 * reach_m);
    const Real root2 = closing * closing - speed2 * gap2;
    if (!(gap2 > 0 && closing > 0 && root2 > 0)) return;
    const Real meeting_s = gap2 / (closing + std::sqrt(root2));
    if (!(meeting_s <= contacts_->substep_s())) return;
    const Vec3 normal = glm::normalize(apart + velocity * meeting_s);
    block.separation_m[0] = glm::dot(apart, normal) - reach_m;
    block.center_a += (block.normal - normal) * block.radius_a;
    block.center_b -= (block.normal - normal) * block.radius_b;
    block.normal = normal;
}

/// Fills blows_ with the pair's points that meet in this sub-step; whether one of them is fast.
bool ImpactPass::gather(const Pair& pair) {
    blows_.clear();
    bool fast = false;
    const Real h = contacts_->substep_s();
    for (std::uint32_t at = pair.first_block; at < pair.first_block + pair.block_count; ++at) {
        ContactBlock& block = contacts_->blocks[at];
        contacts_->place(block);
        if (block.balls()) turn_to_meeting(block);
        const SolverBody& a = bodies_[block.a];
        const SolverBody& b = bodies_[block.b];
        const Vec3 moved = block.shift_of(a.moved_m - b.moved_m);  // 0 unless rounded
        for (int i = 0; i < block.count; ++i) {
            Blow blow{.block = at, .lane = i, .arm_a = block.arm_a(i), .arm_b = block.arm_b(i)};
            if (block.balls()) {
                // Where place() just found them.
                blow.arm_a = block.center_a;
                blow.arm_b = block.center_b;
            } else {
                (block.radius_a > 0 ? blow.arm_b : blow.arm_a) +=
                    block.radius_a > 0 ? moved : -moved;
            }
            const Real speed =
                glm::dot(a.velocity_at(blow.arm_a) - b.velocity_at(blow.arm_b), block.normal);
            const Real opening_mps2 =
                glm::dot(pull_at(a, blow.arm_a) - pull_at(b, blow.arm_b), block.normal);
            const Real separation = block.separation_m[static_cast<std::size_t>(i)];
            const Real reached_mps = std::min(speed, speed + opening_mps2 * h);
            if (separation + h * reached_mps > kTouching_m) continue;
            if (speed < -threshold_mps_) {
                fast = true;
                aim(block, separation, speed, opening_mps2, blow);
            }
            blows_.push_back(blow);
        }
    }
    return fast;
}

/// The speed after, and for balls where and when they meet: tau from s + v tau + a tau^2 / 2 = 0.
/// A ball is put where the parabola of its way out begins, so that after the sub-step it is where
/// and as fast as if it had bounced at tau. Other shapes bounce here, with the energy that they
/// would have had at the surface.
void ImpactPass::aim(const ContactBlock& block,
                     Real separation_m,
                     Real speed_mps,
                     Real opening_mps2,
                     Blow& blow) const {
    const Real fall = -2 * opening_mps2 * separation_m;
    const Real at_surface = std::sqrt(std::max(speed_mps * speed_mps + fall, Real{0}));
    const Real out_mps = block.restitution * at_surface;
    if (!block.whole_balls() || separation_m < 0) {
        blow.target_mps = std::sqrt(std::max(out_mps * out_mps - fall, Real{0}));
        return;
    }
    const Real tau_s =
        std::min(2 * separation_m / (at_surface - speed_mps), contacts_->substep_s());
    blow.target_mps = out_mps - opening_mps2 * tau_s;
    blow.shift_m = opening_mps2 * tau_s * tau_s / 2 - out_mps * tau_s - separation_m;
}

void ImpactPass::weigh_blows() {
    for (Blow& blow : blows_) {
        const ContactBlock& block = contacts_->blocks[blow.block];
        const SolverBody& a = bodies_[block.a];
        const SolverBody& b = bodies_[block.b];
        const auto mass = [&](const Vec3& direction) {
            return 1 /
                   (mass_along(a, blow.arm_a, direction) + mass_along(b, blow.arm_b, direction));
        };
        blow.normal_mass = mass(block.normal);
        for (int t = 0; t < 2; ++t) blow.tangent_mass[t] = mass(block.tangent[t]);
    }
}

void ImpactPass::solve_friction(Blow& blow) {
    const ContactBlock& block = contacts_->blocks[blow.block];
    SolverBody& a = bodies_[block.a];
    SolverBody& b = bodies_[block.b];
    const Vec3 slip = a.velocity_at(blow.arm_a) - b.velocity_at(blow.arm_b);
    Real next[2];
    for (int t = 0; t < 2; ++t)
        next[t] = blow.tangent_Ns[t] - blow.tangent_mass[t] * glm::dot(slip, block.tangent[t]);
    const Real limit = block.friction * blow.normal_Ns;
    const Real length = std::hypot(next[0], next[1]);
    const Real kept = length > limit ? limit / length : Real{1};
    Vec3 rub{0, 0, 0};
    for (int t = 0; t < 2; ++t) {
        rub += block.tangent[t] * (next[t] * kept - blow.tangent_Ns[t]);
        blow.tangent_Ns[t] = next[t] * kept;
    }
    a.push(rub, blow.arm_a);
    b.push(-rub, blow.arm_b);
}

void ImpactPass::solve_blows() {
    weigh_blows();
    const int sweeps = blows_.size() > 1 ? kInnerSweeps : 1;
    for (int sweep = 0; sweep < sweeps; ++sweep) {
        for (Blow& blow : blows_) {
            const ContactBlock& block = contacts_->blocks[blow.block];
            SolverBody& a = bodies_[block.a];
            SolverBody& b = bodies_[block.b];
            const Real speed =
                glm::dot(a.velocity_at(blow.arm_a) - b.velocity_at(blow.arm_b), block.normal);
            const Real next =
                std::max(blow.normal_Ns + blow.normal_mass * (blow.target_mps - speed), Real{0});
            const Vec3 impulse = block.normal * (next - blow.normal_Ns);
            blow.normal_Ns = next;
            a.push(impulse, blow.arm_a);
            b.push(-impulse, blow.arm_b);
            if (block.friction > 0) solve_friction(blow);
        }
    }
    for (const Blow& blow : blows_) {
        ContactBlock& block = contacts_->blocks[blow.block];
        SolverBody& a = bodies_[block.a];
        SolverBody& b = bodies_[block.b];
        const Vec3 shift = block.normal * (blow.shift_m / (a.inverse_mass + b.inverse_mass));
        a.moved_m += shift * a.inverse_mass;
        b.moved_m -= shift * b.inverse_mass;
        block.total_Ns[static_cast<std::size_t>(blow.lane)] += blow.normal_Ns;
        block.bounced = block.bounced || block.whole_balls();
    }
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
    contacts_->row_solves += blows;
    return blows;
}

}  // namespace plumbline::physics
