// What the sweeps of a step need: masses, softness, and which constraints are solved at once.
#include "engine/core/time/trace_events.h"
#include "engine/physics/dynamics/contact/contact_set.h"
#include "engine/physics/dynamics/substep_choice.h"

#include <algorithm>

namespace plumbline::physics {
namespace {

constexpr Real kContactDamping = 10;  ///< ratio: far above 1, penetration in never swings back
constexpr Real kCrowd = 2;  ///< stiffness that one sweep still solves stably: of bricks in a wall

}  // namespace

void ContactSet::begin_step(std::span<SolverBody> bodies, const SweepSettings& settings) {
    const TraceSpan span("prepare contacts");
    const auto& [h, spring_s, push_mps, bounce_mps, restless_mps, restless_jointed_mps, team] =
        settings;
    team_ = team;
    bodies_ = bodies;
    h_ = h;
    push_mps_ = push_mps;
    bounce_mps_ = bounce_mps;
    restless_mps_ = restless_mps;
    restless_jointed_mps_ = restless_jointed_mps;
    const Real stiff_hz = kContactFrequency / h;
    between_movable_ = softness_of(stiff_hz, kContactDamping, h);
    against_immovable_ = softness_of(2 * stiff_hz, kContactDamping / 2, h);
    for (Softness* softness : {&between_movable_, &against_immovable_})
        softness->bias_per_s *= h / spring_s;

    order_.build(constraints, bodies_);
    measure_crowds();
    each_part([this](std::span<const SweepPlace> part) { prepare_part(part); });
}

void ContactSet::prepare_part(std::span<const SweepPlace> part) {
    for_each_pair(part, [this](std::span<ContactConstraint> pair) { prepare_pair(pair); });
}

/// How stiffly constraints press each body along each direction, against its own mass: the sum of m n n^T / own mass over
/// them, m the reduced mass of the two bodies. A cube in a tower of cubes has 1 along its axis.
void ContactSet::measure_crowds() {
    crowds_.assign(bodies_.size(), SymmetricMat3{});
    for (const ContactConstraint& constraint : constraints) {
        const Vec3& n = constraint.normal;
        const Real of_a = bodies_[constraint.a].inverse_mass;
        const Real of_b = bodies_[constraint.b].inverse_mass;
        // What never moves hands no swing on.
        const Real both = of_b > 0 ? of_a + of_b : 2 * of_a;
        for (const std::uint32_t body : {constraint.a, constraint.b}) {
            const Vec3 weighed = n * (bodies_[body].inverse_mass / both);
            SymmetricMat3& crowd = crowds_[body];
            crowd.xx += n.x * weighed.x;
            crowd.xy += n.x * weighed.y;
            crowd.xz += n.x * weighed.z;
            crowd.yy += n.y * weighed.y;
            crowd.yz += n.y * weighed.z;
            crowd.zz += n.z * weighed.z;
        }
    }
}

/// Constraints that press the same two bodies apart along one direction are as stiff together as one alone, and those of a
/// crowded body give way more: stiffer ones would swing from sweep to sweep.
void ContactSet::prepare_pair(std::span<ContactConstraint> pair) {
    for (ContactConstraint& constraint : pair) {
        Real sharing = 0;
        for (const ContactConstraint& other : pair) {
            const Real cosine = std::max(glm::dot(constraint.normal, other.normal), Real{0});
            sharing += cosine * cosine;
        }
        const SolverBody& a = bodies_[constraint.a];
        const SolverBody& b = bodies_[constraint.b];
        const bool both_move = a.movable() && b.movable();
        for (const std::uint32_t body : {constraint.a, constraint.b}) {
            if (!bodies_[body].movable()) continue;
            const Real crowd = glm::dot(constraint.normal, crowds_[body] * constraint.normal);
            sharing = std::max(sharing, crowd / kCrowd);
        }
        prepare(constraint, a, b, both_move ? between_movable_ : against_immovable_, sharing);
    }
}

}  // namespace plumbline::physics
