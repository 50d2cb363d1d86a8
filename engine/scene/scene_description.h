// What a scene file says, as plain data in SI units and radians: defaults filled in, prefabs and
// includes resolved, arrays kept as arrays. Where it came from is kept for messages and `explain`.
#pragma once

#include "engine/assets/material_data.h"
#include "engine/assets/mesh_data.h"
#include "engine/core/math.h"
#include "engine/core/pose.h"
#include "engine/core/text/source_location.h"
#include "engine/physics/body.h"
#include "engine/physics/joint.h"
#include "engine/physics/physics_world.h"
#include "engine/physics/shape.h"
#include "engine/scene/environment/field_description.h"
#include "engine/scene/environment/live_light.h"
#include "engine/scene/environment/plaque.h"
#include "engine/scene/environment/trigger_description.h"
#include "engine/scene/hard_case_description.h"
#include "engine/scene/nature_description.h"
#include "engine/scene/screen_effects_description.h"

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace plumbline::scene {

struct Accuracy {
    std::string preset{"balanced"};  ///< draft | balanced | precise | reference | auto
    int step_hz{60};
    // What the file says itself; the rest is the preset's (accuracy.h).
    std::optional<int> substeps{};      ///< alone: exactly so many
    std::optional<int> substeps_max{};  ///< small_step: an island gets from `substeps` to these
    std::optional<int> iterations{};
    physics::Solver solver{physics::Solver::SmallStep};
    physics::JointMethod joints{physics::JointMethod::Direct};
    std::optional<int> threads{};  ///< of small_step; kAutoThreads: by the machine
    // Preset "auto": what it is to keep to; at most one of them.
    std::optional<double> tolerance{};  ///< relative error to stay under
    std::optional<double> budget_ms{};  ///< CPU ms for 1/60 s of simulated time
    bool step_hz_given{false};          ///< by the file, not by the preset
    bool solver_given{false};
    /// What a study chose for effects whose fidelity the file leaves open.
    std::vector<EffectFidelity> fidelity{};
};

struct PlayerDescription {
    Vec3 feet_position_m{0, 0, 0};
    Real yaw_rad{0};
    Real pitch_rad{0};
    SourceLocation location{};
};

/// `[camera] orbit`: play begins by turning about the target, a step a press of a key.
struct OrbitDescription {
    Real step_rad{radians_from_degrees(5.0_r)};
    Real step_m{5};  ///< nearer and farther
};

struct CameraDescription {
    Vec3 position_m{4, 3, 6};
    Vec3 target_m{0, 0.5_r, 0};
    Vec3 up{0, 1, 0};  ///< unit
    Real fov_y_rad{radians_from_degrees(60.0_r)};
    Real near_m{0.05_r};
    Real far_m{500};
    std::optional<OrbitDescription> orbit{};
    std::optional<FocusDescription> focus{};
    Vec3f clear_color{0.6F, 0.65F, 0.85F};
};

/// Views whose cosine with the camera's up is above this leave the image's top open.
inline constexpr Real kSteepUp = 0.9999_r;
/// The shortest turn that takes +Y to `up`, which is unit.
Quat upright(const Vec3& up);

struct ShadowDescription {
    int cascades{1};
    int size_px{2048};
    Real distance_m{80};
    float angular_size_deg{0.0F};  ///< of the sun; 0: edges as soft as the map's filter makes them
    SourceLocation location{};
};

struct SunDescription {
    Vec3 direction{-0.4_r, Real{-1}, -0.3_r};  ///< unit, the way the light travels
    Vec3f color{1.0F, 0.96F, 0.9F};
    float intensity{3.0F};
    std::optional<ShadowDescription> shadow{};
    std::optional<ShaftsDescription> shafts{};
    Real rotation_radps{0};
    float cube_m{0.0F};  ///< edge of the cube that shows where the light comes from; 0: none
    float cube_distance_m{20.0F};  ///< of that from the world's origin
    SourceLocation location{};
};

/// `model = "atmosphere"`: computed from where the sun stands.
struct SkyModelDescription {
    float haze{1.0F};
    float clouds{1.0F};
    float visibility_m{0.0F};  ///< where contrast is down to a fiftieth; 0: none is lost
};

struct SkyDescription {
    std::filesystem::path folder;  ///< of a model: its clouds; empty: none
    std::optional<SkyModelDescription> model{};
    SourceLocation location{};
};

/// `[time]`: the sun stands as at that hour, and turns about the earth's axis.
struct TimeDescription {
    double hour{12};  ///< solar, 0 to 24
    double latitude_rad{radians_from_degrees(48.0)};
    int day_of_year{172};
    double north_rad{0};  ///< where north is: so far about +Y from -Z
    SourceLocation location{};
};

struct FogDescription {
    Vec3f color{0.486F, 0.737F, 0.8F};
    float density_per_m{0.02F};
    bool on{true};  ///< at the start
    SourceLocation location{};
};

struct FlashlightDescription {
    float intensity{30.0F};
    Vec3f color{1.0F, 0.95F, 0.85F};
    float radius_m{30.0F};
    float inner_deg{12.0F};
    float outer_deg{22.0F};
    bool on{false};  ///< at the start
    bool at_eye{
        false};  ///< instead of in the hand: its shadows fall where the eye does not see them
    float cube_m{0.0F};  ///< edge of the cube that shows where the light is; 0: none
    SourceLocation location{};
};

struct PostDescription {
    float bloom{0.0F};
    float exposure{1.0F};
    bool adapts{false};  ///< exposure goes by how bright the image is
    std::optional<ShutterDescription> shutter{};
    SourceLocation location{};
};

// What an entity looks like.
struct ModelVisual {
    std::filesystem::path file;
    std::filesystem::path root;         ///< confinement for what the file names
    std::optional<std::size_t> body{};  ///< one of assets::Model::bodies; none: all of it
};
using Primitive = std::variant<physics::BoxShape,
                               physics::SphereShape,
                               physics::CylinderShape,
                               physics::CapsuleShape,
                               physics::ConeShape,
                               physics::PlaneShape>;
/// Triangles that came with the scene itself.
struct MeshVisual {
    std::string key;  ///< equal keys, equal triangles
    std::shared_ptr<const assets::MeshData> mesh;
};
using VisualDescription = std::variant<std::monostate, ModelVisual, Primitive, MeshVisual>;

/// Shapes that need the entity's own model or primitive.
struct FitShape {};        ///< from primitive; else the model's hull (moving) or mesh (static)
struct ModelHullShape {};  ///< { hull = "model" }
struct ModelMeshShape {};  ///< { mesh = "model" }
using BodyShapeDescription =
    std::variant<FitShape, ModelHullShape, ModelMeshShape, physics::ShapeDef>;

struct BodyDescription {
    physics::BodyKind kind{physics::BodyKind::Dynamic};
    BodyShapeDescription shape{FitShape{}};
    std::optional<Real> mass_kg{};        ///< none: from density and shape volume
    std::optional<Real> density_kgpm3{};  ///< none: the surface's
    std::optional<Real> friction{};       ///< none: the surface's
    std::optional<Real> restitution{};    ///< none: the surface's
    Real rolling_friction{0};
    Real spinning_friction{0};
    Real linear_damping_per_s{0};
    Real angular_damping_per_s{0};
    Vec3 velocity_mps{0, 0, 0};
    Vec3 angular_velocity_radps{0, 0, 0};
    std::optional<Vec3> center_of_mass_m{};
    std::optional<Vec3> inertia_kgm2{};
    Quat body_from_inertia{1, 0, 0, 0};  ///< the axes that inertia_kgm2 is about
    Vec3 linear_factor{1, 1, 1};         ///< 0 along world axes that it does not move along
    Real gravity_factor{1};
    physics::CombineRule friction_rule{physics::CombineRule::Usual};
    physics::CombineRule restitution_rule{physics::CombineRule::Usual};
    bool can_sleep{true};
    physics::ContinuousCollision ccd{physics::ContinuousCollision::Auto};
    std::string group{"default"};
    std::vector<std::string> collides_with;  ///< empty: everything
    bool avoids_own_group{false};            ///< ... but what is in its own
    std::vector<BodyDescription> parts{};  ///< of a compound: how each touches; empty: as the body
    std::optional<Drag> drag{};
    std::optional<Magnet> magnet{};
    std::optional<FractureDescription> fracture{};
    Vec3 surface_velocity_mps{0, 0, 0};  ///< body frame: a belt
    Vec3 surface_spin_radps{0, 0, 0};    ///< body frame, about its origin: a turntable
};

struct LightDescription {
    LampOn on{LampOn::Always};
    Vec3f color{1.0F};
    float intensity{20.0F};
    float radius_m{8.0F};
    Vec3 offset_m{0, 0, 0};  ///< from the entity's origin, turning with it
    bool is_spot{false};
    Vec3f direction{0.0F, -1.0F, 0.0F};
    float inner_deg{20.0F};
    float outer_deg{30.0F};
    bool shadow{false};
    SourceLocation location{};
};

struct SoundDescription {
    std::filesystem::path file;
    bool loop{true};
    float gain{1.0F};
    float radius_m{12.0F};
    bool by_wind{false};  ///< as loud as the wind is strong there
    bool by_flow{false};  ///< as loud as the fountains within its radius are strong
    SourceLocation location{};
};

/// `[sound]`: how what stands round source and listener changes what is heard.
struct AcousticsDescription {
    bool paths{false};   ///< walls muffle, distance delays
    bool reverb{false};  ///< rooms reverberate
    SourceLocation location{};
};

/// Extra key `motion` (kinematic bodies): { points_m = [[x,y,z], …], period_s, spin_degps = [x,y,z] }.
struct MotionDescription {
    std::vector<Vec3> points_m;  ///< offsets from position_m
    Real period_s{8};
    Vec3 spin_radps{0, 0, 0};
};

/// A volume, that of the entity's primitive, in which something happens when a body comes in.
struct EntityDescription {
    std::string name;
    std::string label;  ///< what a person reads: "clay pot"; empty: the name stands for it
    Pose world_from_body{};
    Vec3 scale{1, 1, 1};
    VisualDescription visual{};
    std::string material;          ///< name; empty: the model's own or the default
    std::string contact_material;  ///< worn while its body touches another; empty: none
    bool casts_shadow{true};
    std::optional<BodyDescription> body{};
    std::optional<LightDescription> light{};
    std::optional<SoundDescription> sound{};
    std::optional<MotionDescription> motion{};
    std::optional<TriggerDescription> trigger{};
    std::optional<PlaqueDescription> plaque{};
    SourceLocation location{};
};

struct ArrayDescription {
    std::string name;
    EntityDescription prefab;  ///< its position is ignored
    Vec3 origin_m{0, 0, 0};
    std::array<int, 3> count{1, 1, 1};
    Vec3 spacing_m{1, 1, 1};
    Vec3 turn_rad{0, 0, 0};  ///< about +Y; of each copy against the one before it along x, y, z
};
std::size_t copies_of(const ArrayDescription& array);
Pose pose_of_copy(const ArrayDescription& array, const std::array<int, 3>& index);

using physics::JointKind;

struct JointDescription {
    std::string name;
    JointKind kind{JointKind::BallAndSocket};
    std::string a;
    std::string b;             ///< "world" or an entity
    Vec3 anchor_a_m{0, 0, 0};  ///< world, at the start
    Vec3 anchor_b_m{0, 0, 0};
    Vec3 axis{0, 1, 0};
    std::optional<std::array<Real, 2>> limits{};  ///< rad or m
    std::optional<std::array<Real, 2>> twist{};   ///< rad
    std::optional<physics::JointMotor> motor{};
    Real stiffness_Npm{0};
    Real damping_Nspm{0};
    std::optional<Real> rest_length_m{};
    bool collide{false};
    Real break_N{0};
    float creak{0.0F};  ///< how loudly it creaks as it turns; 0: not at all
    Real bar_m{0};      ///< radius of the bar that is drawn for it; 0: none
    SourceLocation location{};
};

/// `[[change]]`: an entity, a copy of an array perhaps, that begins otherwise than described. The later of two for one thing counts.
struct ChangeDescription {
    std::string of;
    std::optional<Pose> world_from_body{};
    std::optional<bool> frozen{};
    bool gone{false};
    SourceLocation location{};
};

/// Extra table `[[view]]`: a place worth an image; the tour stops there.
struct ViewDescription {
    std::string name;
    Vec3 position_m{0, 0, 0};
    Vec3 target_m{0, 0, -1};
    Real wait_s{0};  ///< simulated before the image, after the stop before
    bool flashlight{false};
    float light_scale{1.0F};       ///< of sun and sky: below 1 is dusk
    std::optional<double> hour{};  ///< with [time]; none: the scene's own
};

/// A box along the world's axes.
struct Region {
    Vec3 min_m{0, 0, 0};
    Vec3 max_m{0, 0, 0};
};

/// `[goal]`: a small game. Things count while one condition holds for them: the one that is given.
struct GoalDescription {
    std::string text;                  ///< what is to be done, for a person
    std::vector<std::string> things;   ///< bodies; "can.*" is all that begin so
    bool triggers{false};              ///< what triggers counted, in place of things
    std::optional<Real> below_m{};     ///< their origin is lower, or they are gone
    std::optional<Region> inside{};    ///< their origin is in it
    std::optional<Region> outside{};   ///< it is not, or they are gone
    int count{0};                      ///< so many at once win; 0: all
    double holds_s{0.5};               ///< they must count for so long
    std::optional<double> within_s{};  ///< from the first thing thrown, dropped, taken or counted
    std::optional<int> throws{};       ///< things that may be thrown or dropped
    std::string with;                  ///< the prefab that they are; empty: anyone's choice
    bool hands_off{false};             ///< the goal's things cannot be taken, frozen or removed
    SourceLocation location{};
};

/// What a JSON scene is: only looked at, unlit and as large as it says, flown through relative to
/// its own camera. Textures, light and shadows are there when asked for.
struct ViewerDescription {
    int width_px{0};
    int height_px{0};
    Vec3 center_m{0, 0, 0};
    Real radius_m{1};  ///< of the sphere round everything
    Vec3 up{0, 1, 0};  ///< unit; as the file has it, if not the camera's own
};

/// All that a scene file may say. So many fields because each table of the file is one, and most are absent.
struct SceneDescription {
    std::filesystem::path file;
    std::string title;
    std::string description;
    std::string controls;  ///< profile of config/controls that it asks for; empty: none
    std::vector<std::filesystem::path> source_files;  ///< the file and its includes, as read
    std::uint64_t content_hash{0};  ///< of the file and its includes: recordings name it
    Vec3 gravity_mps2{0, -9.81_r, 0};
    std::optional<Real> kill_below_m{};
    Accuracy accuracy{};
    std::optional<PlayerDescription> player{};
    CameraDescription camera{};
    bool has_camera{false};
    bool shows_model{false};  ///< a model file by itself, on a stage fitted to it
    Real model_radius_m{0};   ///< of the sphere round that model, once it was imported
    std::optional<ViewerDescription> viewer{};
    std::optional<SunDescription> sun{};
    std::optional<SkyDescription> sky{};
    std::optional<TimeDescription> time{};
    AmbientDescription ambient{};
    std::optional<FogDescription> fog{};
    std::optional<FlashlightDescription> flashlight{};
    std::optional<PostDescription> post{};
    std::map<std::string, assets::MaterialData> materials;
    std::map<std::string, EntityDescription> prefabs;  ///< things that play may drop by name
    std::vector<EntityDescription> entities;
    std::vector<ArrayDescription> arrays;
    std::vector<JointDescription> joints;
    std::vector<ChangeDescription> changes;
    std::vector<ViewDescription> views;
    std::optional<HardCase> hard_case{};
    std::optional<GoalDescription> goal{};
    std::optional<AcousticsDescription> acoustics{};
    std::optional<WindDescription> wind{};
    std::optional<GrassDescription> grass{};
    std::vector<FlockDescription> flocks;
    std::vector<FountainDescription> fountains;
    ForceDescription forces{};
    Fidelity fountain_fidelity{Fidelity::Balanced};  ///< [effects.fountain]
    ScreenFidelity screen_fidelity{};
    std::map<std::string, SourceLocation> effect_settings;  ///< [effects.NAME] tables seen
};

}  // namespace plumbline::scene
