#include "engine/effects/sound/sound_obstacles.h"

#include "engine/effects/sound/acoustics.h"
#include "engine/scene/simulation/entity_lookup.h"

#include <algorithm>
#include <cmath>

namespace plumbline::effects {

namespace {

constexpr Real kUnseenAtEnds_m = 0.03_r;
constexpr Real kBeyondFace_m = 0.02_r;
constexpr Real kAtOnce_m = 5e-4_r;
constexpr int kMostRays = 24;         ///< each way; farther faces hardly count any more
constexpr float kThinnest_m = 0.01F;  ///< sheets of triangles have no thickness of their own
constexpr std::array<float, 2> kBands_hz{250.0F, 5'000.0F};
constexpr std::array<float, 2> kThroughGaps{0.1F, 0.01F};

/// A way cut into what lies in bodies, as seen from one end.
struct Crossing {
    SoundObstacle obstacle;
    int entered{0};
    int left{0};
    float entered_sum_m{0};
    float left_sum_m{0};
};

/// Calls with every body face that the ray meets from outside.
template <class Meet>
void each_face(const physics::PhysicsWorld& world,
               Vec3 from,
               const Vec3& to,
               const physics::QueryFilter& filter,
               Meet meet) {
    const Vec3 direction = normalize_or(to - from, Vec3{0, 0, 0});
    for (int i = 0; i < kMostRays; ++i) {
        const auto hit = cast_ray(world, from, to, filter);
        if (!hit) return;
        // What begins within a body's margin is met at once: that face was counted before.
        if (hit->distance_m > kAtOnce_m) meet(*hit);
        from = hit->point_world + direction * kBeyondFace_m;
        if (glm::dot(to - from, direction) <= 0) return;
    }
}

/// How much longer the way over each open side of a box is: left, right, above.
std::array<float, 3> detours_m(
    const Vec3& source, const Vec3& ear, float at_m, const Vec3& low, const Vec3& high) {
    const Vec3 path = ear - source;
    const Real whole_m = glm::length(path);
    const auto length_m = static_cast<float>(whole_m);
    const Vec3 along = path / whole_m;
    const Vec3 side = normalize_or(glm::cross(along, Vec3{0, 1, 0}), Vec3{1, 0, 0});
    const Vec3 above = glm::cross(side, along);
    const Vec3 crossed = source + along * Real{at_m};
    const Vec3 half = (high - low) / Real{2};
    const Vec3 from_crossed = (low + high) / Real{2} - crossed;
    std::array<float, 3> detours{};
    const std::array<Vec3, 3> directions{side, -side, above};
    for (std::size_t i = 0; i < directions.size(); ++i) {
        const Real edge =
            glm::dot(from_crossed, directions[i]) + glm::dot(half, glm::abs(directions[i]));
        const float clear_m = std::max(static_cast<float>(edge), 0.0F);
        detours[i] = std::hypot(at_m, clear_m) + std::hypot(length_m - at_m, clear_m) - length_m;
    }
    return detours;
}

bool lies_within(const Vec3& point, const Vec3& low, const Vec3& high) {
    return glm::all(glm::greaterThan(point, low)) && glm::all(glm::lessThan(point, high));
}

}  // namespace

physics::QueryFilter rays_from_ear(const scene::Simulation& simulation, const Vec3& ear_world) {
    // A round body is met at once by rays that begin in it and go deeper, and the eye stands high in
    // a person: most often the first finds it.
    constexpr std::array<Vec3, 6> kDirections{Vec3{0, -1, 0},
                                              Vec3{0, 1, 0},
                                              Vec3{1, 0, 0},
                                              Vec3{-1, 0, 0},
                                              Vec3{0, 0, 1},
                                              Vec3{0, 0, -1}};
    for (const Vec3& direction : kDirections) {
        const auto hit = cast_ray(simulation.physics, ear_world, ear_world + direction);
        if (hit && hit->distance_m <= kAtOnce_m &&
            !simulation.registry.alive(entity_of_mark(simulation, hit->user)))
            return {.ignored = hit->body};
    }
    return {};
}

std::vector<SoundObstacle> obstacles_between(const scene::Simulation& simulation,
                                             const Vec3& source_world,
                                             const Vec3& ear_world,
                                             const audio::SoundMakers& made_by) {
    const Real length_m = glm::distance(source_world, ear_world);
    if (!(length_m > 4 * kUnseenAtEnds_m)) return {};
    const Vec3 along = (ear_world - source_world) / length_m;
    const Vec3 from = source_world + along * kUnseenAtEnds_m;
    const Vec3 to = ear_world - along * kUnseenAtEnds_m;
    std::vector<Crossing> crossings;
    const auto crossing_of = [&](const physics::RayHit& hit) -> Crossing* {
        const auto known = std::ranges::find_if(
            crossings, [&](const Crossing& c) { return c.obstacle.body == hit.body; });
        if (known != crossings.end()) return &*known;
        const bool is_maker = std::ranges::find(made_by, hit.user) != made_by.end();
        if (is_maker || !simulation.registry.alive(entity_of_mark(simulation, hit.user)))
            return nullptr;
        crossings.push_back({.obstacle = {.body = hit.body, .user = hit.user}});
        return &crossings.back();
    };
    const auto along_m = [&](const physics::RayHit& hit) {
        const Real so_far = glm::dot(hit.point_world - source_world, along);
        return static_cast<float>(so_far);
    };
    const physics::QueryFilter filter = rays_from_ear(simulation, ear_world);
    each_face(simulation.physics, from, to, filter, [&](const physics::RayHit& hit) {
        if (Crossing* crossing = crossing_of(hit)) {
            ++crossing->entered;
            crossing->entered_sum_m += along_m(hit);
        }
    });
    each_face(simulation.physics, to, from, filter, [&](const physics::RayHit& hit) {
        if (Crossing* crossing = crossing_of(hit)) {
            ++crossing->left;
            crossing->left_sum_m += along_m(hit);
        }
    });
    std::vector<SoundObstacle> obstacles;
    const auto to_ear_m = static_cast<float>(length_m);
    for (Crossing& crossing : crossings) {
        // What has no entry begins at the source, what has no exit ends at the ear; pieces are
        // convex, so which exit belongs to which entry makes no difference to the sum.
        const int unpaired = crossing.entered - crossing.left;
        const float beyond_m = unpaired > 0 ? static_cast<float>(unpaired) * to_ear_m : 0.0F;
        const float sum_m = crossing.left_sum_m + beyond_m - crossing.entered_sum_m;
        crossing.obstacle.thickness_m = std::clamp(sum_m, kThinnest_m, to_ear_m);
        crossing.obstacle.at_m = (crossing.left_sum_m + crossing.entered_sum_m) /
                                 static_cast<float>(crossing.left + crossing.entered);
        obstacles.push_back(crossing.obstacle);
    }
    std::ranges::sort(obstacles, {}, &SoundObstacle::at_m);
    return obstacles;
}

SoundPath path_between(const scene::Simulation& simulation,
                       const Vec3& source_world,
                       const Vec3& ear_world,
                       const audio::SoundMakers& made_by) {
    std::array<float, 2> arrives{1.0F, 1.0F};
    for (const SoundObstacle& obstacle :
         obstacles_between(simulation, source_world, ear_world, made_by)) {
        const auto index = surface_of_mark(simulation, obstacle.user);
        const auto density = static_cast<float>(simulation.surfaces().get(index).density_kgpm3);
        Vec3 low{0};
        Vec3 high{0};
        physics::bounds(simulation.physics, obstacle.body, low, high);
        // Who is within its bounds is not beside it: in a house, under a table.
        const bool is_beside =
            !lies_within(source_world, low, high) && !lies_within(ear_world, low, high);
        const auto detours = detours_m(source_world, ear_world, obstacle.at_m, low, high);
        for (std::size_t i = 0; i < kBands_hz.size(); ++i) {
            float share = std::max(share_through_wall(density * obstacle.thickness_m, kBands_hz[i]),
                                   kThroughGaps[i]);
            if (is_beside)
                for (const float detour_m : detours)
                    share += share_round_edge(detour_m, kBands_hz[i]);
            arrives[i] *= std::min(share, 1.0F);
        }
    }
    return {.low = arrives[0], .high = std::min(arrives[0], arrives[1])};
}

}  // namespace plumbline::effects
