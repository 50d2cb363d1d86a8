// A running scene as fields of an archive, for saved games.
#include "engine/scene/simulation/simulation_archive.h"

#include "engine/scene/build/fragments.h"
#include "engine/scene/simulation/saved_thing.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace plumbline::scene {

constexpr LampOn last_of(LampOn) {
    return LampOn::Never;
}

namespace {

constexpr std::string_view kOtherThings = "its things are not those of this scene";

template <class... Components>
void serialize_orders(Archive& archive, ecs::Registry& registry) {
    (registry.serialize_order<Components>(archive), ...);
}

/// What steps and play change of each component.
void serialize_fields(Archive& archive, Transform& transform) {
    archive(transform.world_from_body, transform.scale);
}
void serialize_fields(Archive& archive, PreviousTransform& previous) {
    archive(previous.world_from_body);
}
void serialize_fields(Archive& archive, PlayingModel& playing) {
    archive(playing.animation, playing.time_s, playing.latest_step_s, playing.paused);
}
void serialize_fields(Archive& archive, PointLight& light) {
    archive(light.on, light.direction_body);
}
void serialize_fields(Archive& archive, TriggerVolume& volume) {
    archive(volume.times_left, volume.inside);
}
void serialize_fields(Archive& archive, Plaque& plaque) {
    archive(plaque.meter);
}
void serialize_fields(Archive& archive, PartOf& part) {
    archive(part.stopped);
}
void serialize_fields(Archive& archive, Fragile& fragile) {
    archive(fragile.cracked);
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

/// The archive of one world; reaches into it, so that nothing else need.
class SimulationArchive {
public:
    SimulationArchive(Simulation& simulation, Archive& archive)
        : simulation_(simulation), archive_(archive) {}

    void serialize_entities(const Remake& remake);
    void serialize_state();
    void serialize_bodies_of_scene();

private:
    ecs::Entity made_again(const Remake& remake,
                           const std::string& description,
                           const std::string& name,
                           bool is_dropped);
    std::uint32_t whole_again(const Remake& remake, const SavedThing& saved);
    ecs::Entity fragment_again(std::uint32_t number, const SavedThing& saved);
    ecs::Entity remake_one(const Remake& remake);
    std::vector<ecs::Entity> entities_of_scene() const;
    void serialize_entities_of_scene();
    void serialize_tied_ropes();
    void serialize_components();
    void serialize_moving();
    void serialize_joints();
    void serialize_deformables();
    void serialize_wholes();
    void check_restored();

    Simulation& simulation_;
    Archive& archive_;
};

ecs::Entity SimulationArchive::made_again(const Remake& remake,
                                          const std::string& description,
                                          const std::string& name,
                                          bool is_dropped) {
    if (is_dropped) return remake ? remake(description, name) : ecs::Entity{};
    const auto prefab = simulation_.description_.prefabs.find(description);
    if (prefab == simulation_.description_.prefabs.end()) return {};
    return simulation_.respawn(prefab->second, name);
}

/// A whole that play had made is made once more, for its pieces.
std::uint32_t SimulationArchive::whole_again(const Remake& remake, const SavedThing& saved) {
    const auto& wholes = simulation_.bodies_.wholes;
    const auto known = [&] {
        return std::ranges::find(wholes, saved.whole, [](const auto& each) { return each->name; });
    };
    if (known() == wholes.end()) {
        const ecs::Entity entity =
            made_again(remake, saved.description, saved.whole, saved.is_dropped);
        if (!entity) return static_cast<std::uint32_t>(wholes.size());
        simulation_.note_look(entity);
        simulation_.registry.destroy(entity);
        simulation_.forget_destroyed();
    }
    return static_cast<std::uint32_t>(known() - wholes.begin());
}

ecs::Entity SimulationArchive::fragment_again(std::uint32_t number, const SavedThing& saved) {
    if (number >= simulation_.bodies_.wholes.size()) return {};
    const FragileWhole& whole = *simulation_.bodies_.wholes[number];
    const std::size_t pieces = whole.pattern.pieces.size();
    if (saved.pieces.size() >= pieces || saved.pieces.back() >= pieces ||
        !std::ranges::is_sorted(saved.pieces, std::ranges::less_equal{}))
        return {};
    const Result<ecs::Entity> made = simulation_.make_fragment(
        fragment_of(whole, saved.pieces), saved.name, {.whole = number, .pieces = saved.pieces});
    if (!made) return {};
    if (saved.is_dropped) simulation_.registry.add<Dropped>(*made, Dropped{});
    return *made;
}

ecs::Entity SimulationArchive::remake_one(const Remake& remake) {
    SavedThing saved;
    archive_(saved);
    if (archive_.failed()) return {};
    const bool is_part = !saved.pieces.empty();
    const std::uint32_t whole = is_part ? whole_again(remake, saved) : 0;
    if (!archive_.expect(!saved.made.empty() && reserve(simulation_, saved.made), kOtherThings))
        return {};
    const ecs::Entity entity =
        is_part ? fragment_again(whole, saved)
                : made_again(remake, saved.description, saved.name, saved.is_dropped);
    archive_.expect(entity == saved.made.front().entity, kOtherThings);
    return entity;
}

/// By their names, without what play made.
std::vector<ecs::Entity> SimulationArchive::entities_of_scene() const {
    std::set<ecs::Entity> made_in_play;
    for (auto [entity, mark] : simulation_.registry.view<const Spawned>()) {
        for (const Made& part : all_of(simulation_.registry, entity))
            made_in_play.insert(part.entity);
    }
    std::vector<ecs::Entity> of_scene;
    for (auto [entity, name] : simulation_.registry.view<const Name>()) {
        if (!made_in_play.contains(entity) && !is_of_tied_rope(simulation_, entity))
            of_scene.push_back(entity);
    }
    std::ranges::sort(of_scene);
    return of_scene;
}

void SimulationArchive::serialize_entities_of_scene() {
    simulation_.forget_destroyed();
    const std::vector<ecs::Entity> here = entities_of_scene();
    std::vector<ecs::Entity> saved = here;
    archive_(saved);
    if (!archive_.reads() || archive_.failed()) return;
    for (const ecs::Entity entity : here) {
        if (!std::ranges::binary_search(saved, entity)) simulation_.registry.destroy(entity);
    }
    simulation_.forget_destroyed();
}

void SimulationArchive::serialize_tied_ropes() {
    std::vector<SavedRope> tied;
    for (std::size_t i = 0; i < simulation_.bodies_.ropes.size(); ++i) {
        if (simulation_.bodies_.ropes[i].tied) tied.push_back(saved_rope(simulation_, i));
    }
    archive_(tied);
    if (!archive_.reads() || archive_.failed()) return;
    archive_.expect(std::ranges::all_of(
                        tied, [&](const SavedRope& rope) { return simulation_.tie_again(rope); }),
                    kOtherThings);
}

void SimulationArchive::serialize_bodies_of_scene() {
    serialize_entities_of_scene();
    std::set<physics::BodyId> bodies;
    for (const ecs::Entity entity : entities_of_scene()) {
        if (const auto* ref = simulation_.registry.find<BodyRef>(entity)) bodies.insert(ref->body);
    }
    if (archive_.failed()) return;
    simulation_.physics.serialize(archive_,
                                  [&](physics::BodyId body) { return bodies.contains(body); });
    if (!archive_.reads() || archive_.failed()) return;
    for (MovingBody& moving : simulation_.bodies_.moving) {
        const physics::BodyState state = simulation_.physics.state(moving.body);
        moving.awake = state.awake;
        simulation_.registry.get<Transform>(moving.entity).world_from_body = state.world_from_body;
    }
}

void SimulationArchive::serialize_entities(const Remake& remake) {
    serialize_entities_of_scene();
    serialize_tied_ropes();
    std::vector<ecs::Entity> spawned;
    for (auto [entity, mark] : simulation_.registry.view<const Spawned>())
        spawned.push_back(entity);
    const std::size_t count = archive_.count(spawned.size());
    for (std::size_t i = 0; i < count && !archive_.failed(); ++i) {
        if (archive_.reads()) {
            remake_one(remake);
            continue;
        }
        SavedThing saved = saved_thing(simulation_, spawned[i]);
        archive_(saved);
    }
}

void SimulationArchive::serialize_components() {
    serialize_orders<Name,
                     DescribedAt,
                     Transform,
                     PreviousTransform,
                     BodyRef,
                     Visual,
                     PlayingModel,
                     PartBodies,
                     SurfaceRef,
                     PointLight,
                     LampAppearance,
                     AmbientSound,
                     ContactAppearance,
                     TriggerVolume,
                     Plaque,
                     MotionPath,
                     PartOf,
                     Fragile,
                     Spawned,
                     Dropped>(archive_, simulation_.registry);
    if (archive_.failed()) return;
    serialize_values<Transform,
                     PreviousTransform,
                     PlayingModel,
                     PointLight,
                     TriggerVolume,
                     Plaque,
                     PartOf,
                     Fragile,
                     Dropped>(archive_, simulation_.registry);
    simulation_.registry.serialize_slots(archive_);
}

/// In the order of the saved game.
void SimulationArchive::serialize_moving() {
    const std::size_t count = archive_.count(simulation_.bodies_.moving.size());
    if (!archive_.expect(count == simulation_.bodies_.moving.size(), kOtherThings)) return;
    std::map<ecs::Entity, MovingBody> known;
    for (const MovingBody& moving : simulation_.bodies_.moving)
        known.emplace(moving.entity, moving);
    for (MovingBody& moving : simulation_.bodies_.moving) {
        ecs::Entity entity = moving.entity;
        bool awake = moving.awake;
        archive_(entity, awake);
        const auto found = known.find(entity);
        if (!archive_.expect(found != known.end(), kOtherThings)) return;
        moving = found->second;
        moving.awake = awake;
        known.erase(found);  // each once
    }
}

void SimulationArchive::serialize_joints() {
    const std::size_t count = archive_.count(simulation_.bodies_.joints.size());
    if (!archive_.expect(count == simulation_.bodies_.joints.size(), kOtherThings)) return;
    for (SceneJoint& joint : simulation_.bodies_.joints)
        archive_(joint.joint, joint.a, joint.anchor_a_body, joint.anchor_b_body);
    for (Rope& rope : simulation_.bodies_.ropes) {
        archive_(rope.ends[0], rope.ends[1], rope.anchors_m[0], rope.anchors_m[1]);
        for (physics::JointId& joint : rope.joints) archive_(joint);
    }
    for (Vehicle& vehicle : simulation_.bodies_.vehicles) {
        VehicleControls& controls = vehicle.controls;
        archive_(vehicle.chassis, controls.throttle, controls.brake, controls.steer_rad);
        for (Wheel& wheel : vehicle.wheels)
            archive_(wheel.body, wheel.hub, wheel.strut, wheel.axle);
    }
}

void SimulationArchive::serialize_deformables() {
    std::vector<physics::Deformable*> bodies;
    for (auto* list : {&simulation_.bodies_.cloths, &simulation_.bodies_.softs}) {
        for (SceneDeformable& each : *list) {
            const std::size_t points = each.before_m.size();
            each.body->serialize(archive_);
            archive_(each.before_m, each.displaced);
            if (!archive_.expect(each.before_m.size() == points, kOtherThings)) return;
            bodies.push_back(each.body.get());
        }
    }
    simulation_.deformables.serialize(archive_, bodies);
}

/// Those whose things went altogether are not made again.
void SimulationArchive::serialize_wholes() {
    const auto& wholes = simulation_.bodies_.wholes;
    const std::size_t count = archive_.count(wholes.size());
    for (std::size_t i = 0; i < count && !archive_.failed(); ++i) {
        FragileWhole saved;
        if (!archive_.reads()) {
            saved.name = wholes[i]->name;
            saved.next_part = wholes[i]->next_part;
            saved.broke_at_s = wholes[i]->broke_at_s;
        }
        archive_(saved.name, saved.next_part, saved.broke_at_s);
        const auto known =
            std::ranges::find(wholes, saved.name, [](const auto& each) { return each->name; });
        if (!archive_.reads() || known == wholes.end()) continue;
        (*known)->next_part = saved.next_part;
        (*known)->broke_at_s = saved.broke_at_s;
    }
    for (auto [entity, fragile] : simulation_.registry.view<const Fragile>()) {
        const std::size_t bonds = wholes[fragile.whole]->pattern.bonds.size();
        archive_.expect(std::ranges::all_of(fragile.cracked,
                                            [bonds](std::uint32_t bond) { return bond < bonds; }),
                        kOtherThings);
    }
}

/// What steps and images lean on and no field by itself shows.
void SimulationArchive::check_restored() {
    const Simulation::Clock& clock = simulation_.clock_;
    constexpr std::uint64_t kMostSteps = 1ULL << 40U;
    archive_.expect(clock.since_step <= clock.steps && clock.steps < kMostSteps &&
                        clock.since_s >= 0 && clock.since_s < 1e12,
                    "its clock cannot stand there");
    archive_.expect(simulation_.switches.fog_color < kFogColors.size(), "its fog has no colour");
    const CameraDescription& camera = simulation_.description_.camera;
    archive_.expect(camera.fov_y_rad > 0 && camera.fov_y_rad < kPi &&
                        glm::length(camera.up) > 1e-6_r &&
                        glm::length(camera.target_m - camera.position_m) > 1e-6_r,
                    "its camera sees nothing");
    for (auto [entity, at] : simulation_.registry.view<const Transform>()) {
        const Real turn = glm::length(at.world_from_body.orientation);
        archive_.expect(std::abs(turn - 1) < 0.01_r, "a thing is not turned by a rotation");
    }
}

void SimulationArchive::serialize_state() {
    serialize_components();
    serialize_moving();
    serialize_joints();
    if (archive_.failed()) return;
    simulation_.physics.serialize(archive_);
    simulation_.clock_.step_s = simulation_.physics.def().step_s;
    archive_(simulation_.clock_.steps,
             simulation_.clock_.since_s,
             simulation_.clock_.since_step,
             simulation_.tally_.removed,
             simulation_.tally_.quarantined_reported,
             simulation_.mass_ratio_.named,
             simulation_.added_energy_J,
             simulation_.charges_lit,
             simulation_.counted,
             simulation_.names_.spawned,
             simulation_.random,
             simulation_.switches,
             simulation_.description_.camera.position_m,
             simulation_.description_.camera.target_m,
             simulation_.description_.camera.up,
             simulation_.description_.camera.fov_y_rad);
    serialize_deformables();
    serialize_wholes();
    if (archive_.reads()) check_restored();
    ++simulation_.revision_;
}

void serialize_entities(Simulation& simulation, Archive& archive, const Remake& remake) {
    SimulationArchive(simulation, archive).serialize_entities(remake);
}

void serialize_state(Simulation& simulation, Archive& archive) {
    SimulationArchive(simulation, archive).serialize_state();
}

void serialize_bodies_of_scene(Simulation& simulation, Archive& archive) {
    SimulationArchive(simulation, archive).serialize_bodies_of_scene();
}

}  // namespace plumbline::scene
