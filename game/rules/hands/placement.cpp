#include "game/rules/hands/placement.h"

#include "engine/physics/query.h"

#include <algorithm>

namespace plumbline::game {

namespace {

constexpr Real kAir_m = 0.01_r;       // left around a thing that appears
constexpr Real kPullBack_m = 0.15_r;  // between two places that are tried
constexpr int kPlacesUp = 4;

/// How far a turned box reaches along a direction, from its middle.
Real reach_along(const Vec3& size_m, const Quat& turn, const Vec3& direction) {
    const Vec3 local = glm::abs(glm::conjugate(turn) * direction);
    return glm::dot(local, size_m) * 0.5_r;
}

}  // namespace

std::optional<Vec3> free_place(const physics::PhysicsWorld& world,
                               const Aim& aim,
                               const Room& room,
                               Real reach_m) {
    const Quat turn = portable_angle_axis(aim.yaw_rad, Vec3{0, 1, 0});
    const Real radius = reach_along(room.size_m, turn, aim.forward);
    const Real farthest = reach_m + radius;
    // The person's own capsule counts for the place, not for the sight.
    const physics::QueryFilter sight{.ignored = room.itself, .also_ignored = aim.own_body};
    const physics::QueryFilter others{.ignored = room.itself};
    const auto ahead = cast_ray(world, aim.eye_m, aim.eye_m + aim.forward * farthest, sight);

    const auto is_good = [&](const Vec3& place) {
        const Pose pose{.position = place, .orientation = turn};
        if (!physics::overlaps(world, room.box, pose, -kAir_m / 2, others).empty()) return false;
        return !cast_ray(world, aim.eye_m, place, sight).has_value();
    };
    Vec3 wanted = aim.eye_m + aim.forward * farthest;
    if (ahead) {
        const Real out = reach_along(room.size_m, turn, ahead->normal_world) + kAir_m;
        wanted = ahead->point_world + ahead->normal_world * out;
    }
    const Real length = glm::length(wanted - aim.eye_m);
    const Vec3 back = normalize_or(aim.eye_m - wanted, Vec3{0, 1, 0});
    for (Real distance = 0; distance < length; distance += kPullBack_m) {
        for (int up = 0; up <= kPlacesUp; ++up) {
            const Real lift = static_cast<Real>(up) * 0.25_r * room.size_m.y;
            const Vec3 place = wanted + back * distance + Vec3{0, lift, 0};
            if (is_good(place)) return place;
        }
    }
    return std::nullopt;
}

}  // namespace plumbline::game
