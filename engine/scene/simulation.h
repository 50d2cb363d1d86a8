// One running scene: entities, their bodies, and the order of one fixed step. Headless: tests,
// `simulate`, replays and the game all step this.
#pragma once

#include "engine/assets/asset_library.h"
#include "engine/core/io/pose_archive.h"
#include "engine/core/random.h"
#include "engine/core/result.h"
#include "engine/ecs/registry.h"
#include "engine/physics/deformables.h"
#include "engine/physics/physics_world.h"
#include "engine/scene/accuracy.h"
#include "engine/scene/components.h"
#include "engine/scene/environment/rope.h"
#include "engine/scene/environment/step_events.h"
#include "engine/scene/environment/vehicle.h"
#include "engine/scene/environment/water.h"
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

namespace plumbline::assets {
constexpr Shading last_of(Shading) {
    return Shading::Unlit;
}
}  // namespace plumbline::assets

namespace plumbline::scene {

class EntityBuilder;
struct FragileWhole;
struct RopeLayout;
struct SavedRope;

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
    bool awake{true};        ///< after the latest step
};

/// A joint of the scene file.
struct SceneJoint {
    std::string name;
    physics::JointId joint{};
    physics::BodyId a{};
    Vec3 anchor_a_body{0, 0, 0};    ///< where it holds a, in a's frame
    Vec3 anchor_b_body{0, 0, 0};    ///< where it holds b, in b's frame; of the world, world
    Quat world_from_a{1, 0, 0, 0};  ///< when it was made
    Quat world_from_b{1, 0, 0, 0};  ///< of the world: none
    float creak{0.0F};              ///< how loudly it creaks; 0: not at all
    Real bar_m{0};                  ///< radius of the bar that is drawn; 0: none
    SourceLocation location{};
};

/// A cloth or a soft body of the scene file.
struct SceneDeformable {
    std::string name;
    ecs::Entity entity{};  ///< what is drawn of it
    std::unique_ptr<physics::Deformable> body;
    std::vector<Vec3d> before_m;  ///< its points at the beginning of the latest step
    Displaced displaced{};
    /// Gives what is drawn the shape that it has when its points are there.
    std::function<void(std::span<const Vec3d> points_m, assets::MeshData& mesh)> shape_mesh;
};

/// Who asks for contact events: they are made while somebody does.
class ContactListeners {
public:
    /// "effect impact_sounds"
    void add(const std::string& who) {
        names_.push_back(who);
        ++revision_;
    }
    void remove(const std::string& who) {
        std::erase(names_, who);
        ++revision_;
    }
    const std::vector<std::string>& names() const { return names_; }
    /// Changes with each of the above.
    std::uint64_t revision() const { return revision_; }

private:
    std::vector<std::string> names_;
    std::uint64_t revision_{0};
};

/// The force fields that steps ask, by their names.
class ForceFields {
public:
    /// The field outlives its place here. Whoever adds one that is there already removes it once more.
    void add(std::string_view name, physics::ForceField& field) {
        ++fields_.try_emplace(std::string(name), Added{&field}).first->second.times;
        list();
    }
    void remove(std::string_view name) {
        const auto found = fields_.find(name);
        if (--found->second.times == 0) fields_.erase(found);
        list();
    }
    std::span<physics::ForceField* const> all() const { return list_; }
    /// Of the one with this name; 0 where there is none.
    double energy_J(std::string_view name) const {
        const auto found = fields_.find(name);
        return found == fields_.end() ? 0 : found->second.field->energy_J();
    }

private:
    struct Added {
        physics::ForceField* field{nullptr};
        int times{0};
    };
    void list() {
        list_.clear();
        for (const auto& [name, added] : fields_) list_.push_back(added.field);
    }
    std::map<std::string, Added, std::less<>> fields_;
    std::vector<physics::ForceField*> list_;
};

/// So many fields because effects, game and study each keep beside the world what they tell each other.
class Simulation {
public:
    struct Tally {
        std::uint32_t removed{0};  ///< bodies below kill_below_m, or too far out
        std::size_t quarantined_reported{0};
    };

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
    void step();            ///< kinematic paths, physics, new transforms
    void destroy_marked();  ///< marked entities, bodies below kill_below_m

    /// Called at the beginning of every step, when entities that went are forgotten: what is done to the
    /// world from outside. Not saved: who builds a simulation sets it again.
    std::function<void(Simulation&)> before_step;
    /// Called in place of the physics' own step: another engine moves the bodies. Not saved either.
    std::function<void()> stepped_elsewhere;
    /// What before_step added to the energy so far; saved.
    double added_energy_J{0};

    // --- what is there
    ecs::Registry registry;
    physics::PhysicsWorld physics;
    LiveSwitches switches;
    Random random;
    std::vector<std::string> warnings;
    std::vector<std::string> messages;     ///< for the player, since the game took them
    std::vector<Blow> blows;               ///< until the end of the step
    std::vector<Burst> bursts;             ///< until the end of the step
    std::vector<std::string> charges_lit;  ///< names of explosions that go off in the next step
    int counted{0};                        ///< by triggers that count; saved
    ForceFields force_fields;              ///< of the effects there are
    physics::Deformables deformables{physics};  ///< those that effects enter for the coming step
    std::vector<SceneWater> waters;             ///< as the description has them
    ContactListeners contact_listeners;         ///< contact events are made while there are any

    const SceneDescription& description() const { return description_; }
    const SurfaceTable& surfaces() const { return surfaces_; }
    assets::AssetLibrary& library() { return library_; }
    const assets::AssetLibrary& library() const { return library_; }

    double step_s() const { return clock_.step_s; }
    std::uint64_t steps() const { return clock_.steps; }
    double time_s() const { return time_at(clock_.steps); }
    /// The first step that begins at `time_s` or later, to rounding; not before the last change of
    /// the step's length.
    std::uint64_t step_at(double time_s) const;
    /// Another solver, rate or gravity from the next step on (PhysicsWorld::reconfigure). Time goes on.
    void set_accuracy(const physics::WorldDef& def);
    /// Says that the state is that of another time: what moves along paths goes on from there.
    void set_time(double time_s);
    /// What was counted since the start.
    const Tally& tally() const { return tally_; }
    /// Dynamic and kinematic bodies in file order, then in the order in which play made them. Those
    /// destroyed since the latest step may still be listed: ask physics.contains().
    std::span<const MovingBody> moving_bodies() const { return bodies_.moving; }

    /// In file order. Those whose bodies went are still listed: ask physics.contains().
    std::span<const SceneJoint> joints() const { return bodies_.joints; }
    /// Joins bodies as the file says. Refused: bodies that are not there, and what
    /// PhysicsWorld::create_joint() refuses; the message names file and line.
    Result<Done> add_joint(const JointDescription& description);

    std::span<const Rope> ropes() const { return bodies_.ropes; }
    /// Makes its pieces and what holds them; as add_joint().
    Result<Done> add_rope(const RopeDescription& description);
    /// Ties a rope in play, a little longer than its ends are apart, under a numbered name: "rope#1". Its description joins
    /// those of the file. Refused: as add_rope(); then nothing is left of it.
    Result<Done> tie_rope(const RopeEnds& ends);
    /// Both ends and where its pieces meet, from a to b.
    std::vector<Vec3d> points_of(const Rope& rope) const;

    std::span<Vehicle> vehicles() { return bodies_.vehicles; }
    std::span<const Vehicle> vehicles() const { return bodies_.vehicles; }
    /// Makes its wheels and what holds them; as add_joint().
    Result<Done> add_vehicle(const VehicleDescription& description);
    /// Against its hub; forward positive.
    double spin_radps(const Wheel& wheel) const;

    std::span<SceneDeformable> cloths() { return bodies_.cloths; }
    std::span<const SceneDeformable> cloths() const { return bodies_.cloths; }
    std::span<SceneDeformable> softs() { return bodies_.softs; }
    std::span<const SceneDeformable> softs() const { return bodies_.softs; }
    /// As add_joint().
    Result<Done> add_cloth(const ClothDescription& description);
    Result<Done> add_soft(const SoftDescription& description);

    /// Bodies that can break or did, gone ones too; Fragile names them by their number.
    std::span<const std::unique_ptr<FragileWhole>> wholes() const;
    /// The entity falls into these parts of its pieces, as they move with it: it goes, and its parts are made. What held it
    /// holds the nearest of them. `cracked`: as Fragile.
    void break_up(ecs::Entity entity,
                  std::span<const std::vector<std::uint32_t>> parts,
                  const std::vector<std::uint32_t>& cracked);

    /// Makes an entity as a scene file would; dropped things come this way. Its name is numbered:
    /// "crate#1". Null on refusal, with a warning in warnings().
    ecs::Entity spawn(const EntityDescription& description);
    /// Makes again what a saved game says was spawned, under its old name.
    ecs::Entity respawn(const EntityDescription& description, const std::string& name);
    ecs::Entity find(std::string_view name) const;

    /// Over every dynamic and kinematic body's pose and velocity bits, in file order.
    std::uint64_t state_hash() const;

    // --- for effects
    /// Changes whenever an entity comes or goes, and with the contact listeners.
    std::uint64_t revision() const { return revision_ + contact_listeners.revision(); }
    /// Optional parts of the physics; all on until an EffectRuntime takes them over.
    const physics::WorldFeatures& features() const { return features_; }
    void set_features(const physics::WorldFeatures& features);

    /// Used by build_simulation(); in play use spawn().
    EntityBuilder& builder() { return *builder_; }

private:
    friend class EntityBuilder;
    friend class SimulationArchive;

    /// Time as steps: since the last change of their length, and before.
    struct Clock {
        double step_s{0};
        std::uint64_t steps{0};
        double since_s{0};            ///< time at the last change of the step's length
        std::uint64_t since_step{0};  ///< ... and the step
    };
    struct Names {
        std::map<std::string, ecs::Entity, std::less<>> entities;
        std::map<std::string, std::uint32_t> spawned;  ///< how many of each description
    };
    struct Bodies {
        std::vector<MovingBody> moving;
        std::vector<SceneJoint> joints;
        std::vector<Rope> ropes;
        std::vector<SceneDeformable> cloths;
        std::vector<SceneDeformable> softs;
        std::vector<Vehicle> vehicles;
        std::vector<std::unique_ptr<FragileWhole>> wholes;
        bool any_destroyed{false};  ///< since `moving` was cleared of them
    };
    struct MassRatio {
        std::uint64_t weighed_revision{~std::uint64_t{0}};  ///< when masses were last compared
        bool differ_widely{false};
        bool named{false};
    };
    /// Of the beginning of a step, at the present step's length.
    double time_at(std::uint64_t step) const {
        return clock_.since_s + static_cast<double>(step - clock_.since_step) * clock_.step_s;
    }
    void move_along_paths();
    void play_models();
    void move_parts(const PartBodies& bodies, const PlayingModel& playing, const Transform& whole);
    void sync_transforms();
    void report_quarantined();
    bool tie_again(const SavedRope& saved);
    Result<physics::BodyId> make_piece(const EntityDescription& piece, const Rope& rope);
    Result<Done> join_rope(const RopeDescription& description,
                           const RopeLayout& layout,
                           Rope& rope);
    Result<Done> join_wheel(const WheelDescription& description,
                            double load_N,
                            physics::BodyId chassis,
                            Wheel& wheel);
    void add_whole(const EntityDescription& description,
                   const std::string& name,
                   ecs::Entity entity);
    /// What is left of it will be made of the same, and look so.
    void note_look(ecs::Entity entity);
    Result<ecs::Entity> make_fragment(EntityDescription description,
                                      const std::string& name,
                                      Fragile fragile);
    void hand_over(physics::BodyId body, std::span<const ecs::Entity> parts);
    Vec3 anchor_in(physics::BodyId end, const Vec3& anchor_world) const;
    std::string name_of_joint(physics::JointId joint) const;
    void report_broken_joints();
    void warn_of_mass_ratio();
    void warn_of_crowd();
    Result<physics::BodyId> end_of_joint(const std::string& name) const;
    /// Null where the name is empty: the world.
    Result<physics::BodyId> holder_of(const std::string& name,
                                      const std::string& held,
                                      const SourceLocation& location) const;
    void forget_destroyed();

    SceneDescription description_;
    assets::AssetLibrary& library_;
    SurfaceTable surfaces_;
    Clock clock_;
    std::uint64_t revision_{0};
    Bodies bodies_;
    Names names_;
    MassRatio mass_ratio_;
    bool crowd_named_{false};
    Tally tally_;
    physics::WorldFeatures features_{};
    std::unique_ptr<EntityBuilder> builder_;
    std::shared_ptr<bool> open_;  ///< false once the destructor runs: listeners then stay silent
};

/// The mark that a body carries for its entity (BodyDef::user).
constexpr std::uint64_t mark_of(ecs::Entity entity) {
    return (std::uint64_t{entity.generation} << 32U) | entity.index;
}

/// The mark that its joints carry (JointDef::user).
constexpr std::uint64_t mark_of_rope(std::size_t rope) {
    return (std::uint64_t{1} << 40U) + rope;
}
constexpr std::uint64_t mark_of_vehicle(std::size_t vehicle) {
    return (std::uint64_t{1} << 41U) + vehicle;
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
