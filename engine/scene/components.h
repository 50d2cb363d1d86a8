// Every engine component, on one page: plain data, no behaviour, no pointers to other modules'
// objects, only ids. What only the game attaches is in game/components.h; Drag and Magnet, which are as a
// scene file says, in field_description.h.
#pragma once

#include "engine/assets/asset_library.h"
#include "engine/core/pose.h"
#include "engine/core/text/source_location.h"
#include "engine/ecs/registry.h"
#include "engine/physics/body.h"
#include "engine/scene/environment/field_description.h"
#include "engine/scene/environment/live_light.h"
#include "engine/scene/environment/plaque.h"
#include "engine/scene/environment/trigger_description.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace plumbline::scene {

/// As in the scene file; copies made in play are numbered: "crate#3".
struct Name {
    std::string text;
    std::string label;  ///< what a person reads: "oak crate"; empty: the text stands for it
};

/// Where the scene file describes it; absent on what play made.
using DescribedAt = SourceLocation;

/// Where the entity is now: world_from_body after the latest step.
struct Transform {
    Pose world_from_body{};
    Vec3 scale{1, 1, 1};
};

/// world_from_body before the latest step; drawing blends the two. Only on things that can move.
struct PreviousTransform {
    Pose world_from_body{};
};

/// The rigid body behind the entity. Destroying the entity destroys the body.
struct BodyRef {
    physics::BodyId body{};
};

struct Visual {
    assets::MeshId mesh{};
    std::vector<assets::MaterialId> materials;  ///< one per sub-mesh material of the mesh
    Vec3f tint{1.0F};
    bool casts_shadow{true};
    bool is_static{false};
};

/// A model with animations: drawn part by part in place of the Visual's mesh.
struct PlayingModel {
    assets::ModelId model{};
    std::uint32_t animation{0};  ///< of the file's
    double time_s{0};            ///< since the animation's start; it repeats
    double latest_step_s{0};     ///< what the latest step added to it: frames lie in between
    bool paused{false};
};

/// The bodies of a playing model's parts, each an entity of its own: kinematic, and where the
/// animation has the part.
struct PartBodies {
    struct Part {
        std::uint32_t node{0};  ///< of the model
        ecs::Entity entity{};
    };
    std::vector<Part> parts;
};

/// Its surface moves along itself; the physics knows how.
struct Belt {};

/// A piece of a rope, a wheel or its hub: the whole stands for it in reports.
struct PartOf {
    enum class Whole : std::uint8_t { Rope, Vehicle };
    Whole whole{Whole::Rope};
    std::uint32_t index{0};  ///< in Simulation::ropes() or vehicles()
    bool stopped{false};     ///< frozen while their effect is switched off
};

/// It can break, or is what is left of something that did.
struct Fragile {
    std::uint32_t whole{0};             ///< in Simulation::wholes()
    std::vector<std::uint32_t> pieces;  ///< of the whole's pattern; ascending
    std::vector<std::uint32_t>
        cracked;  ///< of the pattern's bonds: those that carry nothing any more
};

/// What it is made of: index into SurfaceTable. Sound and friction defaults hang on it.
struct SurfaceRef {
    std::uint16_t surface{0};
};

struct PointLight {
    LampOn on{LampOn::Always};
    Vec3f intensity{1.0F};
    float radius_m{8.0F};
    bool is_spot{false};
    Vec3f direction_body{0.0F, -1.0F, 0.0F};
    float inner_rad{0.3F};
    float outer_rad{0.5F};
    Vec3f offset_body{0.0F};
    bool casts_shadow{false};
};

/// What a lamp looks like while it is off: its Visual's materials without what they emit.
struct LampAppearance {
    std::vector<assets::MaterialId> off;
};

/// A sound that loops at the entity's place. Kept as a file: it is decoded by the effect that plays
/// it, so a run without sound reads none.
struct AmbientSound {
    std::filesystem::path file;
    float gain{1.0F};
    float radius_m{12.0F};
    bool loop{true};
    bool by_wind{false};  ///< as loud as the wind is strong there; `gain` in the mean wind
    bool by_flow{false};  ///< as loud as the fountains within its radius; `gain` at 5 W of water
};

/// Worn in place of the Visual's own materials while the body touches another.
struct ContactAppearance {
    assets::MaterialId material{};
    std::vector<assets::MaterialId> own;  ///< kept while it is worn
    bool touches{false};
};

/// A volume in which something happens when a body comes in.
struct TriggerVolume {
    physics::ShapeId shape{};
    double radius_m{0};    ///< of a ball round it, about the entity's origin
    double thinnest_m{0};  ///< what moves farther in a step may pass through
    TriggerDescription says;
    int times_left{1};
    std::vector<physics::BodyId> inside;  ///< after the latest step; sorted
};

/// It tells what is measured of another entity.
struct Plaque {
    PlaqueDescription says;
    PlaqueMeter meter{};
};

/// A kinematic body that travels along its points and back for ever, resting for an instant at each.
struct MotionPath {
    std::vector<Vec3> points_m;  ///< world; where the body's origin passes; none: it stays at start
    Real period_s{8};            ///< for the whole tour there and back
    Vec3 spin_radps{0, 0, 0};    ///< world axes
    Pose start{};
};

/// Made in play from the description of this name: saved games make it anew from there.
struct Spawned {
    std::string description;
};

/// Made in play: what undo_drop takes away and what the drop limit counts.
struct Dropped {
    std::uint64_t serial{0};
};

}  // namespace plumbline::scene
