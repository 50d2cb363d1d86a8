// Models with animations: their time, and where the bodies of their parts go.
#include "engine/scene/build/model_bodies.h"
#include "engine/scene/simulation.h"

#include <algorithm>
#include <cmath>

namespace plumbline::scene {
namespace {

const assets::ModelAnimation& animation_of(const assets::MovingModel& model,
                                           const PlayingModel& playing) {
    return model.data.animations[playing.animation % model.data.animations.size()];
}

/// Above 0, so that times can be taken modulo it.
double animation_s(const assets::MovingModel& model, const PlayingModel& playing) {
    return std::max(1e-6, static_cast<double>(animation_of(model, playing).duration_s));
}

/// Further than a part is taken within a step.
bool is_a_jump(const Pose& from, const Pose& to) {
    constexpr Real kJump_m = 0.2_r;
    constexpr Real kWide_rad = 0.35_r;
    const Real cosine = std::abs(glm::dot(from.orientation, to.orientation));
    return glm::distance(from.position, to.position) > kJump_m ||
           2 * portable_acos(std::min(cosine, Real{1})) > kWide_rad;
}

}  // namespace

void Simulation::set_time(double time_s) {
    clock_.since_s = time_s;
    clock_.since_step = clock_.steps;
    for (auto [entity, playing] : registry.view<PlayingModel>()) {
        const assets::MovingModel* model = library_.moving(playing.model);
        if (model != nullptr) playing.time_s = std::fmod(time_s, animation_s(*model, playing));
    }
}

void Simulation::play_models() {
    for (auto [entity, playing] : registry.view<PlayingModel>()) {
        const assets::MovingModel* model = library_.moving(playing.model);
        playing.latest_step_s = 0;
        if (model == nullptr) continue;
        if (!playing.paused) {
            playing.latest_step_s = clock_.step_s;
            playing.time_s =
                std::fmod(playing.time_s + clock_.step_s, animation_s(*model, playing));
        }
        const auto* bodies = registry.find<PartBodies>(entity);
        if (bodies == nullptr) continue;
        Transform whole = registry.get<Transform>(entity);
        if (const auto* path = registry.find<MotionPath>(entity))
            whole.world_from_body = pose_on_path(*path, time_at(clock_.steps + 1));
        move_parts(*bodies, playing, whole);
    }
}

void Simulation::move_parts(const PartBodies& bodies,
                            const PlayingModel& playing,
                            const Transform& whole) {
    const assets::MovingModel& model = *library_.moving(playing.model);
    const assets::ModelPose pose = assets::pose_at(
        model.data, animation_of(model, playing), static_cast<float>(playing.time_s));
    // Where an animation that does not close begins anew, its parts are elsewhere: nothing is struck.
    const bool begins_anew = playing.time_s <= clock_.step_s;
    for (const PartBodies::Part& part : bodies.parts) {
        if (!registry.alive(part.entity)) continue;
        const physics::BodyId body = registry.get<BodyRef>(part.entity).body;
        if (!physics.contains(body)) continue;
        const Pose target =
            part_pose(pose.model_from_node[part.node], whole.scale, whole.world_from_body);
        const Pose now = physics.state(body).world_from_body;
        if (begins_anew && is_a_jump(now, target)) {
            physics.set_pose(body, target);
            physics.set_velocity(body, {0, 0, 0}, {0, 0, 0});
        }
        physics.move_kinematic(body, target);
    }
}

}  // namespace plumbline::scene
