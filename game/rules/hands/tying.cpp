#include "game/rules/hands/tying.h"

#include "engine/physics/fracture.h"

#include <fmt/format.h>

#include <algorithm>

namespace plumbline::game {
namespace {

constexpr double kHandBreadth_m = 0.06;  // ropes are thin: this near to the line of sight is meant

/// Of a segment: how near the line of sight passes it, and where.
struct Pass {
    double away_m{0};
    double along_m{0};  ///< from the eye
    Vec3d point_m{0, 0, 0};
};

/// Both as points that move: the pair nearest to each other (Ericson, Real-Time Collision Detection, 5.1.9).
Pass pass_of(const Vec3d& eye_m, const Vec3d& forward, const Vec3d& from_m, const Vec3d& to_m) {
    const Vec3d edge = to_m - from_m;
    const Vec3d offset = eye_m - from_m;
    const double squared = glm::dot(edge, edge);
    const double level = glm::dot(forward, edge);
    const double slope = squared - level * level;
    double share = slope > 1e-9 * squared
                       ? (glm::dot(edge, offset) - level * glm::dot(forward, offset)) / slope
                       : 0.5;
    share = std::clamp(share, 0.0, 1.0);
    const Vec3d point = from_m + edge * share;
    const double along_m = std::max(glm::dot(point - eye_m, forward), 0.0);
    return {.away_m = glm::distance(point, eye_m + forward * along_m),
            .along_m = along_m,
            .point_m = point};
}

bool holds(const scene::Simulation& simulation, physics::JointId joint) {
    return simulation.physics.contains(joint) && !simulation.physics.joint(joint).state.broken;
}

/// The joint of the rope that still holds and is nearest to the point; null: none does.
physics::JointId joint_near(const scene::Simulation& simulation,
                            const scene::Rope& rope,
                            const Vec3d& point_m) {
    physics::JointId nearest{};
    double nearest_m = 0;
    for (std::size_t i = 0; i < rope.joints.size(); ++i) {
        if (!holds(simulation, rope.joints[i])) continue;
        const bool is_last = i == rope.pieces.size();
        const physics::BodyId piece = rope.pieces[is_last ? i - 1 : i];
        if (!simulation.physics.contains(piece)) continue;
        const Vec3 tip{0, static_cast<Real>(rope.piece_m / (is_last ? 2 : -2)), 0};
        const Vec3 at_m = transform_point(simulation.physics.state(piece).world_from_body, tip);
        const double away_m = glm::distance(Vec3d(at_m), point_m);
        if (nearest && away_m >= nearest_m) continue;
        nearest = rope.joints[i];
        nearest_m = away_m;
    }
    return nearest;
}

std::size_t tied_now(const scene::Simulation& simulation) {
    return static_cast<std::size_t>(
        std::ranges::count_if(simulation.ropes(), [&](const scene::Rope& rope) {
            return rope.tied && std::ranges::any_of(rope.pieces, [&](physics::BodyId piece) {
                       return simulation.physics.contains(piece);
                   });
        }));
}

}  // namespace

std::optional<RopeInSight> rope_at(const scene::Simulation& simulation, const Aim& aim) {
    const auto looked = looked_at(simulation, aim, Tying::kReach_m);
    const Vec3d eye_m(aim.eye_m);
    const Vec3d forward(aim.forward);
    double nearest_m =
        static_cast<double>(looked ? looked->distance_m : aim.reach_m(Tying::kReach_m)) +
        kHandBreadth_m;
    std::optional<RopeInSight> found;
    for (const scene::Rope& rope : simulation.ropes()) {
        for (const physics::BodyId piece : rope.pieces) {
            if (!simulation.physics.contains(piece)) continue;
            const Pose pose = simulation.physics.state(piece).world_from_body;
            const Vec3 half{0, static_cast<Real>(rope.piece_m / 2), 0};
            const Pass pass = pass_of(eye_m,
                                      forward,
                                      Vec3d(transform_point(pose, -half)),
                                      Vec3d(transform_point(pose, half)));
            if (pass.away_m > kHandBreadth_m || pass.along_m >= nearest_m) continue;
            const physics::JointId joint = joint_near(simulation, rope, pass.point_m);
            if (!joint) continue;
            nearest_m = pass.along_m;
            found = RopeInSight{.joint = joint, .point_m = Vec3(pass.point_m)};
        }
    }
    return found;
}

Tying::Place Tying::place_of(const scene::Simulation& simulation, const Looked& looked) {
    const physics::BodyState state = simulation.physics.state(looked.body);
    const bool moves = state.kind != physics::BodyKind::Static;
    if (!moves || !simulation.registry.alive(looked.entity)) return {.anchor_m = looked.point_m};
    return {.body = looked.body,
            .entity = looked.entity,
            .anchor_m = transform_point(invert(state.world_from_body), looked.point_m)};
}

std::optional<Vec3> Tying::first_end_m(const scene::Simulation& simulation) const {
    // A step may have removed the body since forget_gone().
    if (!begun_ || !first_.is_there(simulation)) return {};
    return first_.world_m(simulation);
}

Vec3 Tying::Place::world_m(const scene::Simulation& simulation) const {
    if (!body) return anchor_m;
    return transform_point(simulation.physics.state(body).world_from_body, anchor_m);
}

bool Tying::Place::is_there(const scene::Simulation& simulation) const {
    return !body || (simulation.physics.contains(body) && simulation.registry.alive(entity));
}

void Tying::forget_gone(const scene::Simulation& simulation) {
    if (begun_ && !first_.is_there(simulation)) *this = {};
}

std::string Tying::finish(scene::Simulation& simulation, const Place& second) {
    const Place first = std::exchange(*this, Tying{}).first_;
    const auto name_of = [&](const Place& place) {
        return place.body ? simulation.registry.get<scene::Name>(place.entity).text
                          : std::string("world");
    };
    const scene::RopeEnds ends{
        .names = {name_of(first), name_of(second)},
        .anchors_world_m = {first.world_m(simulation), second.world_m(simulation)}};
    if (ends.apart_m() < scene::RopeEnds::kShortest_m) return "rope put away: too close to tie";
    if (ends.apart_m() > scene::RopeEnds::kLongest_m)
        return fmt::format("rope put away: it is {} m long, not {:.1f} m",
                           scene::RopeEnds::kLongest_m,
                           ends.apart_m());
    const Result<Done> tied = simulation.tie_rope(ends);
    return tied ? "rope tied" : tied.error().message;
}

std::string Tying::press(scene::Simulation& simulation, const Aim& aim) {
    if (!begun_) {
        if (const auto rope = rope_at(simulation, aim)) {
            physics::cut_joint(simulation.physics, rope->joint);
            simulation.bursts.push_back(
                {.kind = scene::Burst::Kind::Snap, .point_world = rope->point_m});
            return "rope cut";
        }
    }
    const auto looked = looked_at(simulation, aim, kReach_m);
    if (!looked) return std::exchange(begun_, false) ? "rope put away" : "nothing to tie a rope to";
    if (!simulation.switches.is_on("rope", true)) return "ropes are switched off";
    const Place place = place_of(simulation, *looked);
    if (begun_ && place.body && place.body == first_.body)
        return "tie the other end to another object";
    if (begun_) return finish(simulation, place);
    if (tied_now(simulation) >= kMost)
        return fmt::format("no more than {} ropes at a time: remove one first", kMost);
    begun_ = true;
    first_ = place;
    return "rope fixed here: now choose where its other end goes";
}

}  // namespace plumbline::game
