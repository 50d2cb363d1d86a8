#include "engine/study/scene_start.h"

#include "engine/core/io/archive.h"
#include "engine/core/io/files.h"
#include "engine/core/io/pose_archive.h"
#include "engine/core/io/saved_file.h"
#include "engine/scene/build/entity_builder.h"
#include "engine/scene/components.h"
#include "engine/scene/level/shipped_things.h"
#include "engine/scene/simulation/simulation_archive.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace plumbline::study {
namespace {

/// Something that play made of a prefab, as it is now.
struct StartThing {
    std::string prefab{};
    std::string name{};
    bool is_dropped{false};  ///< by a person, whose things all move
    bool is_frozen{false};
    Pose world_from_body{};
    Vec3 velocity_mps{0, 0, 0};
    Vec3 angular_velocity_radps{0, 0, 0};
};

void serialize(Archive& archive, StartThing& thing) {
    archive(thing.prefab,
            thing.name,
            thing.is_dropped,
            thing.is_frozen,
            thing.world_from_body,
            thing.velocity_mps,
            thing.angular_velocity_radps);
}

std::vector<StartThing> things_in(const scene::Simulation& simulation) {
    std::vector<StartThing> things;
    const ecs::Registry& registry = simulation.registry;
    for (const scene::MovingBody& moving : things_made_in_play(simulation)) {
        const physics::BodyState state = simulation.physics.state(moving.body);
        things.push_back({.prefab = registry.get<scene::Spawned>(moving.entity).description,
                          .name = registry.get<scene::Name>(moving.entity).text,
                          .is_dropped = registry.find<scene::Dropped>(moving.entity) != nullptr,
                          .is_frozen = state.frozen,
                          .world_from_body = state.world_from_body,
                          .velocity_mps = state.velocity_mps,
                          .angular_velocity_radps = state.angular_velocity_radps});
    }
    return things;
}

/// Puts things back. Those of no prefab that is known are left out.
void put_back(const std::vector<StartThing>& things, scene::Simulation& simulation) {
    scene::SceneDescription shipped;
    const auto& own = simulation.description().prefabs;
    const bool all_own = std::ranges::all_of(
        things, [&own](const StartThing& thing) { return own.contains(thing.prefab); });
    if (const Result<DataFolders> folders = find_data_folders(); folders && !all_own)
        shipped = scene::shipped_things(folders->assets);
    simulation.builder().lend_materials(shipped.materials);
    for (const StartThing& thing : things) {
        const auto& prefabs = own.contains(thing.prefab) ? own : shipped.prefabs;
        const auto prefab = prefabs.find(thing.prefab);
        if (prefab == prefabs.end()) continue;
        const ecs::Entity entity = simulation.respawn(
            thing.is_dropped ? scene::thing_of(prefab->second, thing.prefab) : prefab->second,
            thing.name);
        const auto* ref = entity ? simulation.registry.find<scene::BodyRef>(entity) : nullptr;
        if (ref == nullptr) continue;
        simulation.physics.set_pose(ref->body, thing.world_from_body);
        simulation.physics.set_velocity(
            ref->body, thing.velocity_mps, thing.angular_velocity_radps);
        if (thing.is_frozen) simulation.physics.set_frozen(ref->body, true);
    }
}

}  // namespace

SceneStart scene_start_of(scene::Simulation& simulation) {
    Archive archive;
    serialize_bodies_of_scene(simulation, archive);
    std::vector<StartThing> things = things_in(simulation);
    archive(things);
    return {.time_s = simulation.time_s(), .state = archive.take()};
}

Result<Done> take_up(const SceneStart& start, PlayedScene& scene) {
    scene::Simulation& simulation = scene.simulation();
    physics::WorldDef own = simulation.physics.def();
    Archive archive(start.state);
    serialize_bodies_of_scene(simulation, archive);
    std::vector<StartThing> things;
    archive(things);
    if (archive.failed()) return Error{.message = "its state: " + archive.fault()};
    put_back(things, simulation);
    own.gravity_mps2 = simulation.physics.def().gravity_mps2;
    simulation.set_accuracy(own);
    simulation.set_time(start.time_s);
    return Done{};
}

Result<Done> write_start(const std::filesystem::path& file, SceneStart start) {
    Archive archive;
    archive(start.time_s, start.state);
    return write_file_atomically(file, archive.written());
}

Result<SceneStart> read_start(const std::filesystem::path& file) {
    const Result<std::string> bytes = read_file(file, kSavedFileBytes);
    if (!bytes) return bytes.error();
    SceneStart start;
    Archive archive(*bytes);
    archive(start.time_s, start.state);
    if (archive.failed())
        return Error{.message = fmt::format("{}: {}", file.string(), archive.fault())};
    return start;
}

}  // namespace plumbline::study
