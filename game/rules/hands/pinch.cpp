#include "game/rules/hands/pinch.h"

#include "engine/core/io/archive.h"
#include "engine/physics/deformable.h"
#include "engine/physics/query.h"
#include "game/rules/hands/grab.h"

#include <glm/gtx/intersect.hpp>

#include <algorithm>
#include <array>

namespace plumbline::game {
namespace {

/// How much is taken between the fingers, at least, and of the side of a cell.
constexpr double kFold_m = 0.05;
constexpr double kOfCell = 0.75;
constexpr Real kFollows_per_s = 12;
constexpr Real kFastestHand_mps = 10;
constexpr Real kStrained_s = 0.4_r;
constexpr Real kFromWall_m = 0.1_r;

/// Whether the line of sight comes near the box round the points at all.
bool may_be_seen(std::span<const Vec3d> points_m, const Aim& aim) {
    const auto [low, high] = physics::bounds_of(points_m);
    const Vec3d to_middle = (low + high) / 2.0 - Vec3d(aim.eye_m);
    const Vec3d forward(aim.forward);
    const Vec3d beside = to_middle - forward * std::max(glm::dot(to_middle, forward), 0.0);
    return glm::length(beside) <= glm::distance(low, high) / 2;
}

void find_nearest(const scene::SceneDeformable& each,
                  const Aim& aim,
                  std::optional<SoftLooked>& nearest,
                  double reach_m) {
    const physics::PointBody& body = each.body->body();
    const auto points_m = body.positions_m();
    if (!may_be_seen(points_m, aim)) return;
    physics::SurfaceParts parts;
    body.list_parts(parts);
    for (const auto& triangle : parts.triangles) {
        glm::dvec2 within{};
        double distance_m = 0;
        const bool is_hit = glm::intersectRayTriangle(Vec3d(aim.eye_m),
                                                      Vec3d(aim.forward),
                                                      points_m[triangle[0]],
                                                      points_m[triangle[1]],
                                                      points_m[triangle[2]],
                                                      within,
                                                      distance_m);
        if (is_hit && distance_m > 0 && distance_m < (nearest ? nearest->distance_m : reach_m))
            nearest = {.entity = each.entity,
                       .distance_m = distance_m,
                       .mass_kg = body.mass_kg(),
                       .triangle = triangle};
    }
}

/// The triangle's own, and those of the surface round it.
std::vector<std::uint32_t> fold_of(const physics::PointBody& body,
                                   const SoftLooked& at,
                                   const Vec3d& middle_m) {
    const double radius_m = std::max(kFold_m, kOfCell * body.longest_side_m());
    std::vector<std::uint32_t> points(at.triangle.begin(), at.triangle.end());
    physics::SurfaceParts parts;
    body.list_parts(parts);
    for (const auto& triangle : parts.triangles) {
        for (const std::uint32_t point : triangle) {
            if (glm::distance(body.positions_m()[point], middle_m) < radius_m)
                points.push_back(point);
        }
    }
    std::ranges::sort(points);
    points.erase(std::unique(points.begin(), points.end()), points.end());
    return points;
}

}  // namespace

std::optional<SoftLooked> soft_looked_at(const scene::Simulation& simulation,
                                         const Aim& aim,
                                         double reach_m) {
    std::optional<SoftLooked> nearest;
    for (const auto& list : {simulation.cloths(), simulation.softs()}) {
        for (const scene::SceneDeformable& each : list) find_nearest(each, aim, nearest, reach_m);
    }
    return nearest;
}

physics::Deformable* deformable_of(scene::Simulation& simulation, ecs::Entity entity) {
    for (const auto& list : {simulation.cloths(), simulation.softs()}) {
        const auto found = std::ranges::find(list, entity, &scene::SceneDeformable::entity);
        if (found != list.end()) return found->body.get();
    }
    return nullptr;
}

bool Pinch::take(scene::Simulation& simulation, const Aim& aim, Real reach_m) {
    release(simulation);
    const auto looked = soft_looked_at(simulation, aim, static_cast<double>(reach_m));
    if (!looked) return false;
    entity_ = looked->entity;
    distance_m_ =
        std::clamp(static_cast<Real>(looked->distance_m), Grab::kNearest_m, Grab::kFarthest_m);
    place_m_ = Vec3d(aim.eye_m) + Vec3d(aim.forward) * looked->distance_m;
    strained_s_ = 0;
    physics::Deformable& body = *deformable_of(simulation, entity_);
    body.grip(fold_of(body.body(), *looked, place_m_));
    return true;
}

void Pinch::release(scene::Simulation& simulation) {
    if (physics::Deformable* body = deformable_of(simulation, entity_)) body->let_go();
    entity_ = {};
}

void Pinch::throw_it(scene::Simulation& simulation, const Vec3& velocity_mps) {
    physics::Deformable* body = deformable_of(simulation, entity_);
    release(simulation);
    if (body == nullptr) return;
    for (std::size_t i = 0; i < body->body().positions_m().size(); ++i) {
        const Vec3d change = Vec3d(velocity_mps) - body->body().velocities_mps()[i];
        body->strike(i, change * body->body().mass_kg(i));
    }
}

void Pinch::change_distance(Real by_m) {
    distance_m_ = std::clamp(distance_m_ + by_m, Grab::kNearest_m, Grab::kFarthest_m);
}

bool Pinch::pull(scene::Simulation& simulation, const Aim& aim) {
    physics::Deformable* body = deformable_of(simulation, entity_);
    if (body == nullptr) {
        entity_ = {};
        return true;
    }
    const Real dt = static_cast<Real>(simulation.step_s());
    const bool is_strained =
        glm::length(body->grip_Ns()) > static_cast<double>(Grab::kMostForce_N * dt);
    strained_s_ = is_strained ? strained_s_ + dt : Real{0};
    if (strained_s_ > kStrained_s) {
        release(simulation);
        return false;
    }
    const auto wall = cast_ray(simulation.physics,
                               aim.eye_m,
                               aim.eye_m + aim.forward * (distance_m_ + kFromWall_m),
                               {.ignored = aim.own_body});
    const Real room_m = wall ? std::max(wall->distance_m - kFromWall_m, Real{0}) : distance_m_;
    const Vec3d target = Vec3d(aim.eye_m) + Vec3d(aim.forward * std::min(room_m, distance_m_));
    const double share = static_cast<double>(kFollows_per_s * dt / (1 + kFollows_per_s * dt));
    Vec3d by_m = (target - place_m_) * share;
    const double farthest_m = static_cast<double>(kFastestHand_mps * dt);
    if (glm::length(by_m) > farthest_m) by_m *= farthest_m / glm::length(by_m);
    place_m_ += by_m;
    body->lead_grip(by_m);
    return true;
}

void Pinch::serialize(Archive& archive, scene::Simulation& simulation) {
    archive(entity_, place_m_, distance_m_, strained_s_);
    if (!archive.reads() || archive.failed()) return;
    const physics::Deformable* body = deformable_of(simulation, entity_);
    archive.expect(!holding() || (body != nullptr && body->is_gripped()),
                   "what is in the hand is not there");
    if (archive.failed()) entity_ = {};
}

}  // namespace plumbline::game
