// One running scene: entities, their bodies, and the order of one fixed step. Headless: tests,
// `simulate`, replays and the game all step this.
#pragma once

#include "engine/assets/asset_library.h"
#include "engine/audio/sound_cue.h"
#include "engine/core/io/pose_archive.h"
#include "engine/core/random.h"
#include "engine/core/result.h"
#include "engine/ecs/registry.h"
#include "engine/physics/physics_world.h"
#include "engine/scene/accuracy.h"
#include "engine/scene/components.h"
#include "engine/scene/scene_description.h"
#include "engine/scene/surfaces.h"

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace plumbline::scene {

class EntityBuilder;

/// What play may switch while a scene runs; effects read it.
struct LiveSwitches {
    bool grid{false};  ///< these six help to look at a model by itself
    bool axes{false};
    bool normals{false};
    bool turntable{false};
    bool ground{true};
    int background{0};                         ///< number in a list that repeats
    std::optional<assets::Shading> shading{};  ///< over every material's own
    bool textures{true};                       ///< false: base colours without their maps
    /// Effects that were switched on or off, by name. The others are as the scene says.
    std::map<std::string, bool, std::less<>> effects;
    bool is_on(std::string_view effect, bool by_scene) const {
        const auto switched = effects.find(effect);
        return switched == effects.end() ? by_scene : switched->second;
    }
    void turn(std::string_view effect, bool on) {
        effects.insert_or_assign(std::string(effect), on);
    }

    float fog_density_scale{1.0F};  ///< of what the scene says
    std::size_t fog_color{0};       ///< in kFogColors
    Vec3f sun_direction{0.0F, -1.0F, 0.0F};
    float sun_rotation_radps{
        0.0F};                ///< about +Y; with [time] about the earth's axis; by every step
    float light_scale{1.0F};  ///< of sun and sky: below 1 is dusk

    void serialize(Archive& archive) {
        archive(grid, axes, normals, turntable, ground, background, shading, textures, effects);
        archive(fog_density_scale, fog_color, sun_direction, sun_rotation_radps, light_scale);
    }
};

/// A dynamic or kinematic body as the simulation keeps track of it.
struct MovingBody {
    ecs::Entity entity{};
    physics::BodyId body{};
    physics::BodyKind kind{physics::BodyKind::Dynamic};
    physics::ShapeId shape{};
    bool convex{true};       ///< the shape may be swept and asked for overlaps
    Real inner_radius_m{0};  ///< of a ball that fits into the shape
    physics::ContinuousCollision ccd{physics::ContinuousCollision::Auto};
    bool spherical_inertia{true};
    bool awake{true};  ///< after the latest step
};

/// A joint of the scene file.
struct SceneJoint {
    std::string name;
    physics::JointId joint{};
    Vec3 anchor_a_body{0, 0, 0};  ///< where it holds a, in a's frame
    float creak{0.0F};            ///< how loudly it creaks; 0: not at all
    Origin origin{};
};

/// Bodies that need an optional part of the physics in the next step: one of each, or null.
struct MotionDemand {
    /// Asks for sweeps, or may move more than its inner radius in a substep: by its own speed, or
    /// struck by the fastest of the others.
    ecs::Entity swept{};
    ecs::Entity spinning{};  ///< turns, and its inertia is not the same about every axis

    friend bool operator==(const MotionDemand&, const MotionDemand&) = default;
};

/// A thing of the game's that a saved game had: made again under this name. Null where there is no
/// such description.
using Remake = std::function<ecs::Entity(const std::string& description, const std::string& name)>;

class Simulation {
public:
    /// An empty world with the description's settings; build_simulation() fills it.
    Simulation(SceneDescription description,
               const SimulationOverrides& overrides,
               assets::AssetLibrary& library,
               SurfaceTable surfaces);
    ~Simulation();
    Simulation(const Simulation&) = delete;
    Simulation& operator=(const Simulation&) = delete;

    // --- the parts of one fixed step, in this order; effects/advance.h calls them
    void remember_poses();  ///< so that drawing can blend
    void step();            ///< kinematic paths, physics, new placements
    void destroy_marked();  ///< marked entities, bodies below kill_below_m

    /// Called at the beginning of every step, when entities that went are forgotten: what is done to the
    /// world from outside. Not saved: who builds a simulation sets it again.
    std::function<void(Simulation&)> before_step;
    /// What before_step added to the energy so far; saved.
    double added_energy_J{0};

    // --- what is there
    ecs::Registry registry;
    physics::PhysicsWorld physics;
    LiveSwitches switches;
    Random random;
    std::vector<audio::SoundCue> cues;  ///< asked for since the last frame took them

    const SceneDescription& description() const { return description_; }
    void set_camera(const CameraDescription& camera) { description_.camera = camera; }
    const SurfaceTable& surfaces() const { return surfaces_; }
    assets::AssetLibrary& library() { return library_; }
    const assets::AssetLibrary& library() const { return library_; }

    double step_s() const { return step_s_; }
    std::uint64_t steps() const { return steps_; }
    double time_s() const { return time_at(steps_); }
    /// Of the beginning of a step, at the present step's length.
    double time_at(std::uint64_t step) const {
        return since_s_ + static_cast<double>(step - since_step_) * step_s_;
    }
    /// The first step that begins at `time_s` or later, to rounding; not before the last change of
    /// the step's length.
    std::uint64_t step_at(double time_s) const;
    /// Another solver, rate or gravity from the next step on (PhysicsWorld::reconfigure). Time goes on.
    void set_accuracy(const physics::WorldDef& def);
    /// Says that the state is that of another time: what moves along paths goes on from there.
    void set_time(double time_s);
    /// With [time], the sun stands as at that hour, 0 to 24; else nothing happens.
    void set_hour(double hour);
    /// By where the sun stands; none without [time].
    std::optional<double> hour() const;
    std::uint32_t removed_count() const { return removed_; }
    /// Dynamic and kinematic bodies in file order, then in the order in which play made them. Those
    /// destroyed since the latest step may still be listed: ask physics.contains().
    std::span<const MovingBody> moving_bodies() const { return moving_; }

    /// In file order. Those whose bodies went are still listed: ask physics.contains().
    std::span<const SceneJoint> joints() const { return joints_; }
    /// Joins bodies as the file says. Refused: bodies that are not there, and what
    /// PhysicsWorld::create_joint() refuses; the message names file and line.
    Result<Done> add_joint(const JointDescription& description);

    const std::vector<std::string>& warnings() const { return warnings_; }
    void add_warning(std::string text) { warnings_.push_back(std::move(text)); }

    /// Makes an entity as a scene file would; dropped things come this way. Its name is numbered:
    /// "crate#1". Null on refusal, with a warning in warnings().
    ecs::Entity spawn(const EntityDescription& description);
    /// Makes again what a saved game says was spawned, under its old name.
    ecs::Entity respawn(const EntityDescription& description, const std::string& name);
    /// Entity of a body, or null.
    ecs::Entity entity_of(physics::BodyId body) const;
    /// As entity_of, from the mark that hits and contact events carry.
    ecs::Entity entity_of_mark(std::uint64_t user) const;
    ecs::Entity find(std::string_view name) const;
    /// "cube", or "player" for a body that is no entity's.
    std::string name_of_mark(std::uint64_t user) const;
    /// "entity fountain (garden.toml:120)"; things made in play have no place in a file.
    std::string describe(ecs::Entity entity) const;

    /// Over every dynamic and kinematic body's pose and velocity bits, in file order.
    std::uint64_t state_hash() const;

    // --- for saved games (saved_game.h), in this order
    /// Which entities there are. When read: those of the scene that were gone go, and what play had made
    /// of the scene's prefabs, or `remake` of others, is made again, all under their old ids.
    void serialize_entities(Archive& archive, const Remake& remake);
    /// Everything else that decides how the world goes on. When read: into a world with the same
    /// entities; what fails leaves it fit only to be thrown away.
    void serialize_state(Archive& archive);

    /// Where the scene's own bodies are and what they carry, without what play made: for a ghost. When
    /// read: into a freshly built world; its definition becomes that of the archive.
    void serialize_bodies_of_scene(Archive& archive);

    // --- for effects
    /// Whether things of that surface sound when they hit. The default surface does not: a scene
    /// whose materials name no surface has asked for no sound.
    bool is_heard(std::uint16_t surface) const {
        return surface != 0 && !surfaces_.get(surface).impact_sounds.empty();
    }
    /// Changes whenever an entity comes or goes, and with the requests below.
    std::uint64_t revision() const { return revision_; }
    /// Optional parts of the physics; all on until an EffectRuntime takes them over.
    const physics::WorldFeatures& features() const { return features_; }
    void set_features(const physics::WorldFeatures& features);
    /// Looks which bodies need continuous collision or gyroscopic torque in the next step. A
    /// function of the state alone.
    void update_motion_demand();
    const MotionDemand& motion_demand() const { return demand_; }
    /// Contact events are made while somebody asks: "effect impact_sounds".
    void request_contact_events(const std::string& who);
    void release_contact_events(const std::string& who);
    const std::vector<std::string>& contact_listeners() const { return contact_listeners_; }

    /// Used by build_simulation(); in play use spawn().
    EntityBuilder& builder() { return *builder_; }

private:
    friend class EntityBuilder;

    std::vector<ecs::Entity> entities_of_scene() const;
    void serialize_entities_of_scene(Archive& archive);
    void serialize_components(Archive& archive);
    void serialize_moving(Archive& archive);
    void serialize_joints(Archive& archive);
    ecs::Entity remake_one(Archive& archive, const Remake& remake);
    void move_along_paths();
    void play_models();
    void move_parts(const PartBodies& bodies, const PlayingModel& playing, const Placement& whole);
    void sync_placements();
    void report_quarantined();
    void report_broken_joints();
    void warn_of_mass_ratio();
    Result<physics::BodyId> end_of_joint(const std::string& name) const;
    void forget_destroyed();

    SceneDescription description_;
    assets::AssetLibrary& library_;
    SurfaceTable surfaces_;
    double step_s_;
    std::uint64_t steps_{0};
    double since_s_{0};            ///< time at the last change of the step's length
    std::uint64_t since_step_{0};  ///< ... and the step
    std::uint32_t removed_{0};
    std::uint64_t revision_{0};
    std::size_t quarantined_reported_{0};
    bool bodies_destroyed_{false};
    std::uint64_t weighed_revision_{~std::uint64_t{0}};  ///< when masses were last compared
    bool masses_differ_widely_{false};
    bool mass_ratio_named_{false};
    std::vector<MovingBody> moving_;
    std::vector<SceneJoint> joints_;
    MotionDemand demand_{};
    physics::WorldFeatures features_{};
    std::vector<std::string> warnings_;
    std::vector<std::string> contact_listeners_;
    std::map<std::string, ecs::Entity, std::less<>> entities_by_name_;
    std::map<std::string, std::uint32_t> spawned_by_name_;
    std::unique_ptr<EntityBuilder> builder_;
    std::shared_ptr<bool> open_;  ///< false once the destructor runs: listeners then stay silent
};

/// The mark that a body carries for its entity (BodyDef::user).
constexpr std::uint64_t mark_of(ecs::Entity entity) {
    return (std::uint64_t{entity.generation} << 32U) | entity.index;
}

/// Where a body on a path is at a time since the start. Exact in its points at the times of rest.
Pose pose_on_path(const MotionPath& path, double time_s);

/// Loads models, makes shapes, entities and bodies. Missing or refused models: the body keeps its
/// shape, a box is drawn, and warnings() lists it. Refused (exit code 4): too many bodies, too many
/// groups, shapes that the physics cannot hold; the message names file and line.
Result<std::unique_ptr<Simulation>> build_simulation(const SceneDescription& description,
                                                     const SimulationOverrides& overrides,
                                                     assets::AssetLibrary& library,
                                                     const SurfaceTable& surfaces);

}  // namespace plumbline::scene
