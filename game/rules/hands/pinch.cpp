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

struct Touched {
    double distance_m{0};
    std::array<std::uint32_t, 3> triangle{};
};

std::optional<Touched> touched(const physics::PointBody& body, const Aim& aim, double reach_m) {
    physics::SurfaceParts parts;
    body.list_parts(parts);
    const auto points_m = body.positions_m();
    const Vec3d eye(aim.eye_m);
    const Vec3d forward(aim.forward);
    std::optional<Touched> nearest;
    for (const auto& triangle : parts.triangles) {
        glm::dvec2 within{};
        double distance_m = 0;
        const bool is_hit = glm::intersectRayTriangle(eye,
                                                      forward,
                                                      points_m[triangle[0]],
                                                      points_m[triangle[1]],
                                                      points_m[triangle[2]],
                                                      within,
                                                      distance_m);
        if (is_hit && distance_m > 0 && distance_m < (nearest ? nearest->distance_m : reach_m))
            nearest = Touched{.distance_m = distance_m, .triangle = triangle};
    }
    return nearest;
}

/// The triangle's own, and those of the surface round it.
std::vector<std::uint32_t> fold_of(const physics::PointBody& body,
                                   const Touched& at,
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

std::span<scene::SceneDeformable> Pinch::all_of(scene::Simulation& simulation, Of of) {
    return of == Of::Cloth ? simulation.cloths() : simulation.softs();
}

physics::Deformable* Pinch::held(scene::Simulation& simulation) const {
    if (!holding()) return nullptr;
    const auto all = all_of(simulation, of_);
    return number_ < all.size() ? all[number_].body.get() : nullptr;
}

bool Pinch::take(scene::Simulation& simulation, const Aim& aim, Real reach_m) {
    release(simulation);
    double nearest_m = static_cast<double>(reach_m);
    std::optional<Touched> found;
    for (const Of of : {Of::Cloth, Of::Soft}) {
        const auto all = all_of(simulation, of);
        for (std::uint32_t i = 0; i < all.size(); ++i) {
            const auto here = touched(all[i].body->body(), aim, nearest_m);
            if (!here) continue;
            found = here;
            nearest_m = here->distance_m;
            of_ = of;
            number_ = i;
        }
    }
    if (!found) return false;
    distance_m_ = std::clamp(static_cast<Real>(nearest_m), Grab::kNearest_m, Grab::kFarthest_m);
    place_m_ = Vec3d(aim.eye_m) + Vec3d(aim.forward) * nearest_m;
    strained_s_ = 0;
    physics::Deformable& body = *held(simulation);
    body.grip(fold_of(body.body(), *found, place_m_));
    return true;
}

void Pinch::release(scene::Simulation& simulation) {
    if (physics::Deformable* body = held(simulation)) body->let_go();
    of_ = Of::Nothing;
}

void Pinch::throw_it(scene::Simulation& simulation, const Vec3& velocity_mps) {
    physics::Deformable* body = held(simulation);
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
    physics::Deformable* body = held(simulation);
    if (body == nullptr) return true;
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
    archive(of_, number_, place_m_, distance_m_, strained_s_);
    if (!archive.reads() || archive.failed()) return;
    const physics::Deformable* body = held(simulation);
    archive.expect(!holding() || (body != nullptr && body->is_gripped()),
                   "what is in the hand is not there");
    if (archive.failed()) of_ = Of::Nothing;
}

}  // namespace plumbline::game
