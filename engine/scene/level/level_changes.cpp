#include "engine/scene/level/level_changes.h"

namespace plumbline::scene {

void apply_changes(Simulation& simulation) {
    for (const ChangeDescription& change : simulation.description().changes) {
        const ecs::Entity entity = simulation.find(change.of);
        const auto* ref = entity ? simulation.registry.find<BodyRef>(entity) : nullptr;
        if (ref == nullptr) continue;
        const physics::BodyId body = ref->body;
        if (change.gone) {
            simulation.registry.mark_for_destruction(entity);
            simulation.destroy_marked();
            continue;
        }
        if (change.world_from_body) {
            const Pose& pose = *change.world_from_body;
            simulation.physics.set_pose(body, pose);
            simulation.registry.get<Transform>(entity).world_from_body = pose;
            if (auto* previous = simulation.registry.find<PreviousTransform>(entity))
                previous->world_from_body = pose;
            if (auto* path = simulation.registry.find<MotionPath>(entity)) {
                for (Vec3& point : path->points_m) point += pose.position - path->start.position;
                path->start = pose;
            }
        }
        if (change.frozen) simulation.physics.set_frozen(body, *change.frozen);
    }
}

}  // namespace plumbline::scene
