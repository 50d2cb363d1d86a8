#include "engine/study/scenes/moving_samples.h"

#include "engine/core/random.h"
#include "engine/physics/query.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace plumbline::study {
namespace {

Vec3d up_of(const scene::Simulation& simulation) {
    return normalize_or(-Vec3d(simulation.description().gravity_mps2), Vec3d{0, 1, 0});
}

/// Value below which a share of them lies. Reorders.
double quantile(std::vector<double>& values, double share) {
    if (values.empty()) return 0.0;
    const auto place = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), values.begin() + place, values.end());
    return values[static_cast<std::size_t>(place)];
}

}  // namespace

MovingSamples::MovingSamples(scene::Simulation& simulation) : simulation_(simulation) {
    // They count where nothing else moves.
    const std::set<physics::BodyId> pieces = rope_pieces(simulation_);
    std::size_t others = 0;
    for (const scene::MovingBody& moving : simulation_.moving_bodies())
        others += moving.kind == physics::BodyKind::Dynamic && !pieces.contains(moving.body);
    has_others_ = others > 0;
    for (const scene::MovingBody& moving : simulation_.moving_bodies()) {
        if (moving.kind != physics::BodyKind::Dynamic ||
            (has_others_ && pieces.contains(moving.body)))
            continue;
        bodies_.push_back(moving.body);
        masses_kg_.push_back(
            static_cast<double>(simulation_.physics.state(moving.body).mass.mass_kg));
        poses_.push_back({});
    }
}

void MovingSamples::describe(SceneAnswer& answer) const {
    answer.bodies = bodies_.size();
    answer.joints = simulation_.joints().size();
    answer.mass_kg = 0;
    for (const double each : masses_kg_) answer.mass_kg += each;
    answer.gravity_mps2 = glm::length(Vec3d(simulation_.description().gravity_mps2));
    std::vector<double> sizes_m;
    for (const physics::BodyId body : bodies_) {
        Vec3 min_world{};
        Vec3 max_world{};
        physics::bounds(simulation_.physics, body, min_world, max_world);
        sizes_m.push_back(glm::length(Vec3d(max_world) - Vec3d(min_world)));
    }
    answer.body_size_m = quantile(sizes_m, 0.5);
}

void MovingSamples::shift(std::uint64_t seed, double shift_m) {
    Random random(seed);
    const auto within = [&] {
        return static_cast<Real>(shift_m) * (2.0_r * Real{random.uniform()} - 1.0_r);
    };
    for (const physics::BodyId body : bodies_) {
        const physics::BodyState state = simulation_.physics.state(body);
        Pose pose = state.world_from_body;
        pose.position += Vec3{within(), within(), within()};
        simulation_.physics.set_pose(body, pose);
        simulation_.physics.set_velocity(body,
                                         state.velocity_mps + Vec3{within(), within(), within()},
                                         state.angular_velocity_radps);
    }
}

Moment MovingSamples::moment() {
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        poses_[i].there = simulation_.physics.contains(bodies_[i]);
        if (!poses_[i].there) continue;
        const Pose pose = simulation_.physics.state(bodies_[i]).world_from_body;
        poses_[i].position_m = Vec3d(pose.position);
        poses_[i].orientation = Quatd(pose.orientation);
    }
    Moment moment{.time_s = simulation_.time_s(), .layout = layout()};
    moment.energy_J = physics::energy(simulation_.physics).total_J();
    const std::size_t every = bodies_.size() / kMostBodiesSampled + 1;
    for (std::size_t i = 0; i < bodies_.size(); i += every) moment.bodies.push_back(poses_[i]);
    return moment;
}

Layout MovingSamples::layout() const {
    const Vec3d up = up_of(simulation_);
    Layout layout;
    double mass_kg = 0;
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        if (!poses_[i].there) continue;
        layout.center_m += masses_kg_[i] * poses_[i].position_m;
        mass_kg += masses_kg_[i];
    }
    if (mass_kg > 0) layout.center_m /= mass_kg;
    std::vector<double> heights_m;
    std::vector<double> distances_m;
    double sum_m2 = 0;
    for (const BodyPose& pose : poses_) {
        if (!pose.there) continue;
        const Vec3d away = pose.position_m - layout.center_m;
        const double level_m = glm::length(away - glm::dot(away, up) * up);
        heights_m.push_back(glm::dot(pose.position_m, up));
        distances_m.push_back(level_m);
        sum_m2 += level_m * level_m;
    }
    if (distances_m.empty()) return layout;
    layout.spread_m = std::sqrt(sum_m2 / static_cast<double>(distances_m.size()));
    layout.top_m = quantile(heights_m, 0.95);
    layout.reach_m = quantile(distances_m, 0.95);
    return layout;
}

void note_turnover(Trace& trace, const physics::Energy& start, const physics::Energy& now) {
    trace.energy_turnover_J =
        std::max({trace.energy_turnover_J,
                  now.kinetic_J,
                  std::abs((now.total_J() - now.kinetic_J) - (start.total_J() - start.kinetic_J))});
}

}  // namespace plumbline::study
