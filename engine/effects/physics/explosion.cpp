// Charges that go off: impulses along the rays that strike, and nothing behind what stands between.
#include "engine/effects/callers.h"
#include "engine/effects/effect_table.h"
#include "engine/physics/medium.h"
#include "engine/physics/query.h"

#include <algorithm>
#include <cmath>

namespace plumbline::effects {
namespace {

using physics::BodyId;

constexpr double kRayTurn_rad = 2.39996322972865332;
constexpr double kSphere_sr = 4 * 3.14159265358979323846;
/// Rays to one body, and to all of them: what looks small gets fewer.
constexpr std::array kRaysOfOne{64, 512, 4096};
constexpr std::array kRaysOfAll{20'000, 60'000, 200'000};
constexpr int kLeastRays = 8;
constexpr double kPoint_m = 1e-3;
/// Of a step: an instant so little before its begin is its begin.
constexpr double kRounding = 1e-6;

/// A body as the charge sees it: a ball round it.
struct Target {
    BodyId body{};
    Vec3d towards{0, 0, 1};  ///< unit
    double away_m{0};
    double radius_m{0};
    double cosine{-1};  ///< of the cone's half angle; -1: the charge is within the ball

    double angle_sr() const { return kSphere_sr / 2 * (1 - cosine); }
};

/// The solid angle of a triangle, below 0 where it is seen counter-clockwise: van Oosterom and Strackee, The solid angle of a plane
/// triangle (1983).
double seen_sr(const std::array<Vec3d, 3>& arms) {
    const auto [a, b, c] = arms;
    const double la = glm::length(a);
    const double lb = glm::length(b);
    const double lc = glm::length(c);
    return 2 * portable_atan2(
                   glm::dot(a, glm::cross(b, c)),
                   la * lb * lc + glm::dot(a, b) * lc + glm::dot(a, c) * lb + glm::dot(b, c) * la);
}

/// The impulse of one ray.
struct Strike {
    Vec3 impulse_Ns{0, 0, 0};
    Vec3 point_world{0, 0, 0};
};

class Explosion final : public Effect {
public:
    void before_step(scene::Simulation& simulation) override {
        const double step_s = simulation.step_s();
        const double now_s = simulation.time_s() - kRounding * step_s;
        for (const scene::ExplosionDescription& charge :
             simulation.description().forces.explosions) {
            const bool is_time =
                charge.at_s && *charge.at_s >= now_s && *charge.at_s < now_s + step_s;
            if (is_time || std::ranges::find(simulation.charges_lit, charge.name) !=
                               simulation.charges_lit.end())
                go_off(simulation, charge);
        }
    }

private:
    void go_off(scene::Simulation& simulation, const scene::ExplosionDescription& charge) {
        const std::vector<Target> targets = targets_of(simulation, charge);
        double all_sr = 0;
        for (const Target& target : targets) all_sr += target.angle_sr();
        const scene::Fidelity fidelity = simulation.description().forces.fidelity.explosion;
        std::vector<std::pair<BodyId, Strike>> strikes;
        for (const Target& target : targets) {
            const double share = by_fidelity(fidelity, kRaysOfAll) * target.angle_sr() / all_sr;
            const int rays =
                std::clamp(static_cast<int>(share), kLeastRays, by_fidelity(fidelity, kRaysOfOne));
            for (const Strike& strike : strikes_on(simulation, charge, target, rays))
                strikes.emplace_back(target.body, strike);
        }
        for (const auto& [body, strike] : strikes) {
            simulation.physics.apply_impulse(body, strike.impulse_Ns, strike.point_world);
            simulation.blows.push_back({body, strike.impulse_Ns, strike.point_world});
        }
        strike_all(simulation, charge, simulation.cloths());
        strike_all(simulation, charge, simulation.softs());
        simulation.bursts.push_back({.kind = scene::Burst::Kind::Explosion,
                                     .point_world = charge.position_m,
                                     .strength = static_cast<double>(charge.impulse_Ns)});
        work_.calls += targets.size();
    }

    /// A ray to the middle of each triangle of a surface, with what its solid angle gets. What is closed is struck from outside.
    static void strike_all(const scene::Simulation& simulation,
                           const scene::ExplosionDescription& charge,
                           std::span<scene::SceneDeformable> all) {
        for (const scene::SceneDeformable& each : all) {
            physics::SurfaceParts parts;
            each.body->body().list_parts(parts);
            for (const auto& triangle : parts.triangles)
                strike_triangle(simulation, charge, triangle, parts.encloses, *each.body);
        }
    }

    static void strike_triangle(const scene::Simulation& simulation,
                                const scene::ExplosionDescription& charge,
                                const std::array<std::uint32_t, 3>& triangle,
                                bool from_outside,
                                physics::Deformable& body) {
        const auto points_m = body.body().positions_m();
        const Vec3d from(charge.position_m);
        const std::array arms{points_m[triangle[0]] - from,
                              points_m[triangle[1]] - from,
                              points_m[triangle[2]] - from};
        const double angle_sr = seen_sr(arms);
        const Vec3d middle = (arms[0] + arms[1] + arms[2]) / 3.0;
        const double away_m = glm::length(middle);
        if (!(away_m > kPoint_m) || away_m > static_cast<double>(charge.reach_m) ||
            (from_outside && angle_sr > 0))
            return;
        const Vec3 end = charge.position_m + Vec3(middle * (1 - kPoint_m / away_m));
        if (physics::cast_ray(simulation.physics, charge.position_m, end)) return;
        const Vec3d impulse_Ns =
            middle / away_m *
            (static_cast<double>(charge.impulse_Ns) * std::abs(angle_sr) / kSphere_sr);
        for (const std::uint32_t point : triangle) body.strike(point, impulse_Ns / 3.0);
    }

    static std::vector<Target> targets_of(const scene::Simulation& simulation,
                                          const scene::ExplosionDescription& charge) {
        std::vector<Target> targets;
        const Vec3d from(charge.position_m);
        for (const scene::MovingBody& moving : simulation.moving_bodies()) {
            if (!simulation.physics.contains(moving.body)) continue;
            const physics::BodyState state = simulation.physics.state(moving.body);
            if (!state.pushable()) continue;
            const Vec3d offset = Vec3d(state.center_of_mass_world()) - from;
            Target target{.body = moving.body,
                          .away_m = glm::length(offset),
                          .radius_m = physics::radius_m(simulation.physics, moving.body)};
            if (target.away_m - target.radius_m > static_cast<double>(charge.reach_m)) continue;
            if (target.away_m > target.radius_m) {
                const double sine = target.radius_m / target.away_m;
                target.towards = offset / target.away_m;
                target.cosine = std::sqrt(1 - sine * sine);
            }
            targets.push_back(target);
        }
        return targets;
    }

    static bool holds(const scene::Simulation& simulation, BodyId body, const Vec3& point_m) {
        const physics::BodyState state = simulation.physics.state(body);
        const Vec3d at_m(point_m);
        const physics::BallSearch search(simulation.physics,
                                         body,
                                         {Vec3d(state.center_of_mass_world()),
                                          physics::world_from_mass(simulation.physics, body)},
                                         at_m - 2 * kPoint_m,
                                         at_m + 2 * kPoint_m);
        const auto touch = search.nearest(at_m, kPoint_m, kPoint_m);
        return touch && touch->distance_m < 0;
    }

    /// Rays spread evenly over the cone (a spherical Fibonacci set), each with its share of the impulse. What they meet first
    /// takes it. None where the body is out of reach.
    static std::vector<Strike> strikes_on(const scene::Simulation& simulation,
                                          const scene::ExplosionDescription& charge,
                                          const Target& target,
                                          int rays) {
        const Vec3d z = target.towards;
        const Vec3d x =
            glm::normalize(glm::cross(std::abs(z.y) < 0.9 ? Vec3d{0, 1, 0} : Vec3d{1, 0, 0}, z));
        const Vec3d y = glm::cross(z, x);
        const double each_Ns = static_cast<double>(charge.impulse_Ns) / kSphere_sr *
                               target.angle_sr() / static_cast<double>(rays);
        const double length_m = target.away_m + target.radius_m;
        std::vector<Strike> strikes;
        double nearest_m = HUGE_VAL;
        // From within, each with its opposite: what is alike all around gets no push.
        const bool is_within = holds(simulation, target.body, charge.position_m);
        const int spread = is_within ? rays / 2 : rays;
        const double widest = is_within ? 0 : target.cosine;
        const auto strike = [&](const Vec3d& direction) {
            const Vec3 end = charge.position_m + Vec3(direction * length_m);
            const auto hit = is_within
                                 ? physics::cast_ray(simulation.physics, end, charge.position_m)
                                 : physics::cast_ray(simulation.physics, charge.position_m, end);
            const bool is_met = hit && hit->body == target.body;
            if (!is_met && !is_within) return;
            nearest_m = is_within ? 0 : std::min(nearest_m, static_cast<double>(hit->distance_m));
            strikes.push_back({.impulse_Ns = Vec3(direction * each_Ns),
                               .point_world = is_met ? hit->point_world : charge.position_m});
        };
        for (int i = 0; i < spread; ++i) {
            const double along = 1 - (i + 0.5) / spread * (1 - widest);
            const double across = std::sqrt(std::max(1 - along * along, 0.0));
            const double turn_rad = kRayTurn_rad * i;
            const Vec3d direction =
                z * along + (x * portable_cos(turn_rad) + y * portable_sin(turn_rad)) * across;
            strike(direction);
            if (is_within) strike(-direction);
        }
        if (nearest_m > static_cast<double>(charge.reach_m)) strikes.clear();
        return strikes;
    }
};

Callers callers_of_explosion(const scene::Simulation& simulation) {
    if (!simulation.switches.is_on("explosion", true)) return {};
    Callers callers;
    for (const scene::ExplosionDescription& charge : simulation.description().forces.explosions)
        callers.push_back(setting("[[explosion]]", charge.location));
    return callers;
}

}  // namespace

EffectRow explosion() {
    return with_effect<Explosion>({.called_for_by = &callers_of_explosion});
}

}  // namespace plumbline::effects
