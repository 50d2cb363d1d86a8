// Contacts follow their bodies through the step: points are found once, at its start.
//
// A point turns with its body. On a side that is round about an axis it stays where that side faces the other body, however it rolls; a
// sphere stays a sphere. A flat face takes along the normal of what rolls on it.
#include "engine/physics/dynamics/contact/contact_constraint.h"

#include <algorithm>
#include <cmath>

namespace plumbline::physics {
namespace {

/// A side whose axis leans less than this from the normal, as the square of the sine, faces the other body all round.
constexpr Real kUpright = 4e-4_r;

/// Takes one unit vector to another by the shortest way.
Quat shortest_turn(const Vec3& from, const Vec3& to) {
    const Vec3 axis = glm::cross(from, to);
    const Real w = 1 + glm::dot(from, to);
    const Real length2 = w * w + glm::dot(axis, axis);
    if (!(length2 > 0)) return kNoRotation;
    const Real scale = 1 / std::sqrt(length2);
    return Quat(w * scale, axis.x * scale, axis.y * scale, axis.z * scale);
}

/// How the points of a side have turned where the body turned by `turned`: `axis` and the direction across it that looks most along the
/// normal went on to where those are now.
Quat turn_of_points(const Quat& turned, const Vec3& axis, const Vec3& normal) {
    if (axis == Vec3{0, 0, 0}) return turned;
    const Vec3 now = turned * axis;
    const Vec3 across = normal - axis * glm::dot(normal, axis);
    const Vec3 across_now = normal - now * glm::dot(normal, now);
    const Quat tilt = shortest_turn(axis, now);
    if (std::min(glm::dot(across, across), glm::dot(across_now, across_now)) < kUpright)
        return turned;
    return shortest_turn(glm::normalize(tilt * across), glm::normalize(across_now)) * tilt;
}

/// R(q)^T v - v without the cancellation of the two terms.
[[gnu::always_inline]] inline Vec3 turned_back_change(const Quat& q, const Vec3& v) {
    const Vec3 axis{-q.x, -q.y, -q.z};
    const Vec3 t = Real{2} * glm::cross(axis, v);
    return q.w * t + glm::cross(axis, t);
}

/// How the points of both sides have turned.
struct Turns {
    Quat a;
    Quat b;

    Turns(const ContactConstraint& constraint, const SolverBody& of_a, const SolverBody& of_b)
        : a(of_a.delta_rotation), b(of_b.delta_rotation) {
        if (!constraint.rolls) return;
        a = turn_of_points(a, constraint.axis_a, -constraint.normal);
        b = turn_of_points(b, constraint.axis_b, constraint.normal);
    }
};

void follow_points(ContactConstraint& constraint, const SolverBody& a, const SolverBody& b) {
    const Vec3& normal = constraint.normal;
    const Turns turns(constraint, a, b);
    const Real along = glm::dot(normal, a.delta_position_m - b.delta_position_m);
    const Lanes of_a = dot_lanes(turned_back_change(turns.a, normal), constraint.offset_a);
    const Lanes of_b = dot_lanes(turned_back_change(turns.b, normal), constraint.offset_b);
    constraint.separation_m = constraint.start_separation_m + splat(along) + of_a - of_b;
    if (a.has_turned()) {
        constraint.angular_a = cross_lanes(turned(turns.a, constraint.offset_a), normal);
        constraint.center_a = turns.a * constraint.center_offset_a;
    }
    if (b.has_turned()) {
        constraint.angular_b = cross_lanes(turned(turns.b, constraint.offset_b), normal);
        constraint.center_b = turns.b * constraint.center_offset_b;
    }
}

/// Where a sphere touches the other side now: it moved over that. Offsets and separation: of the step's start.
PointArms round_arms(const ContactConstraint& constraint,
                     const SolverBody& a,
                     const SolverBody& b,
                     const PointArms& offsets,
                     Real separation_m) {
    const Vec3& normal = constraint.normal;
    const auto at = [](const SolverBody& body, const Vec3& offset) {
        return body.has_turned() ? body.delta_rotation * offset : offset;
    };
    const Vec3 at_a = at(a, offsets.a);
    const Vec3 at_b = at(b, offsets.b);
    const Real reach_m = constraint.radius_a + constraint.radius_b;
    const Vec3 apart = constraint.start_normal * (reach_m + separation_m) +
                       (a.delta_position_m - b.delta_position_m) + (at_a - offsets.a) -
                       (at_b - offsets.b);
    const Vec3 aside = constraint.shift_of(apart - normal * glm::dot(normal, apart));
    PointArms arms{at_a - normal * constraint.radius_a, at_b + normal * constraint.radius_b};
    if (constraint.radius_a > 0)
        arms.b += aside;
    else
        arms.a -= aside;
    return arms;
}

void follow_round(ContactConstraint& constraint, const SolverBody& a, const SolverBody& b) {
    if (constraint.face_turns) {
        const Quat& face = constraint.radius_a > 0 ? b.delta_rotation : a.delta_rotation;
        turn_normal(constraint, glm::normalize(face * constraint.start_normal));
    }
    const Vec3& normal = constraint.normal;
    // Without the cancellation of the distance between the centres and the radii.
    const Vec3 tilt = normal - constraint.start_normal;
    const Lanes reach_m =
        constraint.start_separation_m + splat(constraint.radius_a + constraint.radius_b);
    constraint.separation_m =
        constraint.start_separation_m +
        splat(glm::dot(normal, a.delta_position_m - b.delta_position_m)) +
        dot_lanes(turned_back_change(a.delta_rotation, normal), constraint.offset_a) -
        dot_lanes(turned_back_change(b.delta_rotation, normal), constraint.offset_b) -
        reach_m * splat(glm::dot(tilt, tilt) / 2);
    for (int i = 0; i < constraint.count; ++i) {
        const PointArms arms = arms_of(constraint, a, b, i);
        set_lane(constraint.angular_a, i, glm::cross(arms.a, normal));
        set_lane(constraint.angular_b, i, glm::cross(arms.b, normal));
    }
    if (!(constraint.friction > 0)) return;
    const PointArms center = round_arms(constraint,
                                        a,
                                        b,
                                        {constraint.center_offset_a, constraint.center_offset_b},
                                        constraint.start_separation_m[0]);
    constraint.center_a = center.a;
    constraint.center_b = center.b;
}

}  // namespace

void turn_normal(ContactConstraint& constraint, const Vec3& normal) {
    constraint.normal = normal;
    const Vec3 along = constraint.tangent[0] - normal * glm::dot(normal, constraint.tangent[0]);
    constraint.tangent[0] = normalize_or(along, constraint.tangent[1]);
    constraint.tangent[1] = glm::cross(normal, constraint.tangent[0]);
}

PointArms arms_of(const ContactConstraint& constraint,
                  const SolverBody& a,
                  const SolverBody& b,
                  int i) {
    const PointArms offsets{lane(constraint.offset_a, i), lane(constraint.offset_b, i)};
    if (constraint.rounded())
        return round_arms(constraint, a, b, offsets, constraint.start_separation_m[i]);
    const Turns turns(constraint, a, b);
    return {a.has_turned() ? turns.a * offsets.a : offsets.a,
            b.has_turned() ? turns.b * offsets.b : offsets.b};
}

bool arms_turn(const ContactConstraint& constraint, const SolverBody& a, const SolverBody& b) {
    return constraint.rounded() || a.has_turned() || b.has_turned();
}

void follow(ContactConstraint& constraint, const SolverBody& a, const SolverBody& b) {
    if (constraint.rounded())
        follow_round(constraint, a, b);
    else
        follow_points(constraint, a, b);
}

}  // namespace plumbline::physics
