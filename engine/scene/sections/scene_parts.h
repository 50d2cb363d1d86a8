// The parts of a scene file, one function each; scene_file.cpp calls them in order. Internal to the
// scene module.
#pragma once

#include "engine/assets/asset_library.h"
#include "engine/core/limits.h"
#include "engine/core/result.h"
#include "engine/scene/formats/scene_reader.h"
#include "engine/scene/paths/scene_paths.h"
#include "engine/scene/scene_description.h"

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace plumbline::scene {

/// A group that no body can be in: `collides_with = []`.
inline constexpr std::string_view kNoGroup{};

inline constexpr std::array<std::string_view, 5> kSoundExtensions{
    ".ogg", ".wav", ".flac", ".opus", ".mp3"};

/// A [[prefab]] table as found; the node outlives the load.
struct PrefabSource {
    const TomlNode* node{nullptr};
    std::string path;
};

inline constexpr Range kSpeed_mps{
    -limits::kSpeed_mps, limits::kSpeed_mps, "m/s from -1000 to 1000"};

/// Each item of an array of tables; none where there are more than `most`.
template <class T>
void read_listed(TableReader& table,
                 std::string_view key,
                 std::vector<T>& values,
                 void (*read)(TableReader&, T&),
                 std::size_t most) {
    const std::size_t count = table.tables(key).size();
    if (count > most) return table.error(key, "{} of them; at most {} are kept", count, most);
    table.read_tables(key, values, read);
}

/// What is true for one load, whichever file a part stands in.
struct LoadContext {
    std::filesystem::path assets_folder;
    FaultList& faults;
    std::map<std::string, PrefabSource> prefabs{};               ///< by name
    std::map<std::string, SourceLocation> material_locations{};  ///< by name
    std::vector<SourceLocation> entity_locations{};  ///< of their names, in the scene's order
    std::vector<SourceLocation> array_locations{};
    SourceLocation scene_location{};  ///< the file as a whole
    /// By naming file and name: many entities name the same, and finding out asks the disk often.
    mutable std::map<std::pair<std::string, std::string>, Result<Reference>> references{};

    /// find_reference() of what stands at `node`, a text.
    const Result<Reference>& reference(const TomlNode& node) const;
};

/// Reads a key that names a file with one of `extensions` (lower case, with the dot). Refused and
/// wrong kinds are errors; a missing file is a warning that ends in `instead`, and is returned with
/// exists == false.
std::optional<Reference> read_file_reference(TableReader& table,
                                             std::string_view key,
                                             std::span<const std::string_view> extensions,
                                             std::string_view instead,
                                             const LoadContext& context);
/// The file that `key` names, which the table needs; empty where there is no such file.
std::filesystem::path read_sound_file(TableReader& table,
                                      const char* key,
                                      const LoadContext& context);

// --- scene_sections.cpp: [scene] … [effects.*] but for the entities
void read_sections(TableReader& root, SceneDescription& scene, LoadContext& context);

// --- scene_lights.cpp
void read_lights_and_air(TableReader& root, SceneDescription& scene, LoadContext& context);
void read_light(TableReader& table, LightDescription& light);

// --- scene_plaques.cpp
void read_plaque(TableReader& table, PlaqueDescription& plaque);

// --- scene_screen_effects.cpp
void read_occlusion(TableReader& table, OcclusionDescription& occlusion);
void read_indirect(TableReader& table, IndirectLightDescription& indirect);
void read_shafts(TableReader& table, ShaftsDescription& shafts);
void read_focus(TableReader& table, FocusDescription& focus);
std::optional<ShutterDescription> read_shutter(TableReader& post);

// --- scene_materials.cpp
/// The name is checked for doubles by the caller.
assets::MaterialData read_material(TableReader& table, const LoadContext& context);

// --- scene_entities.cpp
enum class EntityUse {
    Prefab,  ///< may leave open what an entity must have
    Entity,
};
/// `table`: the entity's over its prefab's, over that one's prefab … The caller sets the name.
EntityDescription read_entity(TableReader& table, EntityUse use, LoadContext& context);
/// The table over the prefabs it starts from; `chain` names those that lead to it. Unknown prefabs and cycles are errors; what was found
/// until then is used.
struct Layered {
    TableReader table;
    bool complete{true};  ///< every prefab was found
};
Layered layered(const TomlNode& table,
                const std::string& path,
                LoadContext& context,
                std::vector<std::string> chain = {});
void read_prefabs(SceneDescription& scene, LoadContext& context);
void read_entities(TableReader& root, SceneDescription& scene, LoadContext& context);
void read_arrays(TableReader& root, SceneDescription& scene, LoadContext& context);

/// Fit to stand in messages and to be found by: no control characters, not endless.
bool is_good_name(std::string_view name);
/// Of one line; faults say what is wrong with another.
std::string read_short_text(TableReader& table, const char* key);
/// The key `name`; empty when absent or not good.
std::string read_name(TableReader& table);

// --- scene_bodies.cpp
void read_body(TableReader& table,
               BodyDescription& body,
               const VisualDescription& visual,
               EntityUse use);

/// Friction, restitution, and how they are combined.
void read_body_surface(TableReader& table, BodyDescription& body);
/// What of it has no place in glTF's physics.
void read_body_traits(TableReader& table, BodyDescription& body);

// --- fields/scene_fields.cpp
void read_body_fields(TableReader& table, BodyDescription& body);
void read_fields(TableReader& root, SceneDescription& scene);

// --- scene_shapes.cpp
/// One of box, sphere, cylinder, capsule, cone, plane in `table`; none of them: nothing.
std::optional<Primitive> read_primitive(TableReader& table);
/// The key `primitive`.
std::optional<Primitive> read_entity_primitive(TableReader& entity);
/// The key `shape`: a table or "fit".
BodyShapeDescription read_body_shape(TableReader& body, const VisualDescription& visual);

// --- scene_poses.cpp
Pose read_pose(TableReader& table);
/// rotation_deg or orientation; nothing where there is neither.
std::optional<Quat> read_turn(TableReader& table);

// --- scene_changes.cpp
void read_changes(TableReader& root, SceneDescription& scene, LoadContext& context);

// --- scene_joints.cpp
/// What of it has no place in glTF's physics.
void read_joint_traits(TableReader& table, JointDescription& joint);
void read_joints(TableReader& root, SceneDescription& scene, LoadContext& context);

// --- fields/scene_ropes.cpp
void read_ropes(TableReader& root, SceneDescription& scene, LoadContext& context);

// --- fields/scene_cloths.cpp
void read_cloths(TableReader& root, SceneDescription& scene, LoadContext& context);

// --- fields/scene_softs.cpp
void read_softs(TableReader& root, SceneDescription& scene, LoadContext& context);

// --- fields/scene_vehicles.cpp
void read_vehicles(TableReader& root, SceneDescription& scene, LoadContext& context);

// --- scene_views.cpp
void read_views(TableReader& root, SceneDescription& scene);

// --- scene_hard_case.cpp
void read_hard_case(TableReader& root, SceneDescription& scene, LoadContext& context);

// --- scene_checks.cpp: what only the whole scene can tell
void check_whole_scene(SceneDescription& scene, LoadContext& context);

// --- scene_goal.cpp
void read_goal(TableReader& root, SceneDescription& scene, LoadContext& context);

// --- scene_nature.cpp
void read_nature(TableReader& root, SceneDescription& scene, const LoadContext& context);
/// The key `fidelity` of [effects.NAME].
void read_fidelity(TableReader& table, Fidelity& fidelity);

// --- json_scene.cpp
/// A JSON scene of meshes and a camera (docs/SCENE-FORMAT.md, "JSON scenes"), with all that it names.
/// Nothing when there is an error among the faults.
std::optional<SceneDescription> read_json_scene(const std::filesystem::path& file,
                                                const std::filesystem::path& assets_folder,
                                                Diagnostics& faults);

// --- scene_file.cpp
/// The tables of a .toml, over those of the scene that it starts from. The error is its first fault.
Result<TomlNode> tables_of_scene(const std::filesystem::path& file,
                                 const std::filesystem::path& assets_folder);

// --- gltf_scene/gltf_scene.cpp
/// A .glb or .gltf with its bodies, joints and triggers; without any, as scene_of_model(). Nothing when a fault is an
/// error.
std::optional<SceneDescription> read_gltf_scene(const std::filesystem::path& file,
                                                const std::filesystem::path& root,
                                                const std::filesystem::path& assets_folder,
                                                FaultList& faults);

// --- scene_model_file.cpp
/// A model by itself: on a ground plane, in sunlight. fit_stage() gives them their sizes.
SceneDescription scene_of_model(const std::filesystem::path& file,
                                const std::filesystem::path& root);
/// Imports the model of such a scene, and sets it: see place_on_stage. The error is the model's.
Result<Done> fit_stage(SceneDescription& scene, assets::AssetLibrary& library);
/// Ground under the bounds and as wide as suits them, a camera from the front right, a little above,
/// that sees all of them, shadows as far as they reach: from a millimetre to ten kilometres.
void place_on_stage(SceneDescription& scene, const Aabb& bounds);

}  // namespace plumbline::scene
