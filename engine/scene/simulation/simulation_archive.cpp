// A running scene as fields of an archive, for saved games.
#include "engine/scene/simulation.h"

#include <algorithm>
#include <set>

namespace plumbline::scene {
namespace {

constexpr std::string_view kOtherThings = "its things are not those of this scene";

/// What a part of a playing model, or the whole, was: its entity and its body.
struct Made {
    ecs::Entity entity{};
    physics::BodyId body{};

    void serialize(Archive& archive) { archive(entity, body); }
};

Made made_of(const ecs::Registry& registry, ecs::Entity entity) {
    const auto* ref = registry.find<BodyRef>(entity);
    return {.entity = entity, .body = ref != nullptr ? ref->body : physics::BodyId{}};
}

/// The whole first, as the builder makes them.
std::vector<Made> all_of(const ecs::Registry& registry, ecs::Entity entity) {
    std::vector<Made> made{made_of(registry, entity)};
    const auto* bodies = registry.find<PartBodies>(entity);
    if (bodies == nullptr) return made;
    for (const PartBodies::Part& part : bodies->parts) {
        if (registry.alive(part.entity)) made.push_back(made_of(registry, part.entity));
    }
    return made;
}

bool reserve(Simulation& simulation, const std::vector<Made>& made) {
    return std::all_of(made.rbegin(), made.rend(), [&](const Made& one) {
        return simulation.registry.reserve(one.entity) &&
               (!one.body || simulation.physics.reserve_body(one.body));
    });
}

template <class... Components>
void serialize_orders(Archive& archive, ecs::Registry& registry) {
    (registry.serialize_order<Components>(archive), ...);
}

/// What steps and play change of each component.
void serialize_fields(Archive& archive, Placement& placement) {
    archive(placement.world_from_body, placement.scale);
}
void serialize_fields(Archive& archive, PreviousPlacement& previous) {
    archive(previous.world_from_body);
}
void serialize_fields(Archive& archive, PlayingModel& playing) {
    archive(playing.animation, playing.time_s, playing.latest_step_s, playing.paused);
}
void serialize_fields(Archive& archive, PointLight& light) {
    archive(light.direction_body);
}
void serialize_fields(Archive& archive, TriggerVolume& volume) {
    archive(volume.times_left, volume.inside);
}
void serialize_fields(Archive& archive, Dropped& dropped) {
    archive(dropped.serial);
}

template <class... Components>
void serialize_values(Archive& archive, ecs::Registry& registry) {
    const auto all = [&]<class T>(T*) {
        for (auto [entity, component] : registry.view<T>()) serialize_fields(archive, component);
    };
    (all(static_cast<Components*>(nullptr)), ...);
}

}  // namespace

ecs::Entity Simulation::remake_one(Archive& archive, const Remake& remake) {
    std::vector<Made> made;
    std::string description;
    std::string name;
    bool is_dropped = false;
    archive(made, description, name, is_dropped);
    if (archive.failed() || !archive.expect(!made.empty() && reserve(*this, made), kOtherThings))
        return {};
    ecs::Entity entity{};
    if (is_dropped) {
        if (remake) entity = remake(description, name);
    } else if (const auto prefab = description_.prefabs.find(description);
               prefab != description_.prefabs.end()) {
        entity = respawn(prefab->second, name);
    }
    archive.expect(entity == made.front().entity, kOtherThings);
    return entity;
}

/// By their names, without what play made.
std::vector<ecs::Entity> Simulation::entities_of_scene() const {
    std::set<ecs::Entity> made_in_play;
    for (auto [entity, mark] : registry.view<const Spawned>()) {
        for (const Made& part : all_of(registry, entity)) made_in_play.insert(part.entity);
    }
    std::vector<ecs::Entity> of_scene;
    for (auto [entity, name] : registry.view<const Name>()) {
        if (!made_in_play.contains(entity)) of_scene.push_back(entity);
    }
    std::ranges::sort(of_scene);
    return of_scene;
}

void Simulation::serialize_entities_of_scene(Archive& archive) {
    forget_destroyed();
    const std::vector<ecs::Entity> here = entities_of_scene();
    std::vector<ecs::Entity> saved = here;
    archive(saved);
    if (!archive.reads() || archive.failed()) return;
    for (const ecs::Entity entity : here) {
        if (!std::ranges::binary_search(saved, entity)) registry.destroy(entity);
    }
    forget_destroyed();
}

void Simulation::serialize_bodies_of_scene(Archive& archive) {
    serialize_entities_of_scene(archive);
    std::set<physics::BodyId> bodies;
    for (const ecs::Entity entity : entities_of_scene()) {
        if (const auto* ref = registry.find<BodyRef>(entity)) bodies.insert(ref->body);
    }
    if (archive.failed()) return;
    physics.serialize(archive, [&](physics::BodyId body) { return bodies.contains(body); });
    if (!archive.reads() || archive.failed()) return;
    for (MovingBody& moving : moving_) {
        const physics::BodyState state = physics.state(moving.body);
        moving.awake = state.awake;
        registry.get<Placement>(moving.entity).world_from_body = state.world_from_body;
    }
}

void Simulation::serialize_entities(Archive& archive, const Remake& remake) {
    serialize_entities_of_scene(archive);
    std::vector<ecs::Entity> spawned;
    for (auto [entity, mark] : registry.view<const Spawned>()) spawned.push_back(entity);
    const std::size_t count = archive.count(spawned.size());
    for (std::size_t i = 0; i < count && !archive.failed(); ++i) {
        if (archive.reads()) {
            remake_one(archive, remake);
            continue;
        }
        std::vector<Made> made = all_of(registry, spawned[i]);
        std::string description = registry.get<Spawned>(spawned[i]).description;
        std::string name = registry.get<Name>(spawned[i]).text;
        bool is_dropped = registry.has<Dropped>(spawned[i]);
        archive(made, description, name, is_dropped);
    }
}

void Simulation::serialize_components(Archive& archive) {
    serialize_orders<Name,
                     Source,
                     Placement,
                     PreviousPlacement,
                     BodyRef,
                     Visual,
                     PlayingModel,
                     PartBodies,
                     SurfaceRef,
                     PointLight,
                     LampLook,
                     AmbientSound,
                     ContactLook,
                     TriggerVolume,
                     MotionPath,
                     Spawned,
                     Dropped>(archive, registry);
    if (archive.failed()) return;
    serialize_values<Placement,
                     PreviousPlacement,
                     PlayingModel,
                     PointLight,
                     TriggerVolume,
                     Dropped>(archive, registry);
    registry.serialize_slots(archive);
}

/// In the order of the saved game.
void Simulation::serialize_moving(Archive& archive) {
    const std::size_t count = archive.count(moving_.size());
    if (!archive.expect(count == moving_.size(), kOtherThings)) return;
    std::map<ecs::Entity, MovingBody> known;
    for (const MovingBody& moving : moving_) known.emplace(moving.entity, moving);
    for (MovingBody& moving : moving_) {
        ecs::Entity entity = moving.entity;
        bool awake = moving.awake;
        archive(entity, awake);
        const auto found = known.find(entity);
        if (!archive.expect(found != known.end(), kOtherThings)) return;
        moving = found->second;
        moving.awake = awake;
    }
}

void Simulation::serialize_joints(Archive& archive) {
    const std::size_t count = archive.count(joints_.size());
    if (!archive.expect(count == joints_.size(), kOtherThings)) return;
    for (SceneJoint& joint : joints_) archive(joint.joint);
}

void Simulation::serialize_state(Archive& archive) {
    serialize_components(archive);
    serialize_moving(archive);
    serialize_joints(archive);
    if (archive.failed()) return;
    physics.serialize(archive);
    step_s_ = physics.def().step_s;
    archive(steps_,
            since_s_,
            since_step_,
            removed_,
            quarantined_reported_,
            mass_ratio_named_,
            added_energy_J,
            demand_.swept,
            demand_.spinning,
            spawned_by_name_,
            random,
            switches,
            description_.camera.position_m,
            description_.camera.target_m,
            description_.camera.up,
            description_.camera.fov_y_rad);
    ++revision_;
}

}  // namespace plumbline::scene
