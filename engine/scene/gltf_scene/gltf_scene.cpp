// glTF files with physics as scenes: their bodies, joints and triggers, on a stage of their own or with the
// surroundings that our exporter wrote.
#include "engine/assets/model_import.h"
#include "engine/core/hash.h"
#include "engine/core/io/files.h"
#include "engine/core/limits.h"
#include "engine/scene/build/shape_factory.h"
#include "engine/scene/gltf_scene/gltf_scene_impl.h"
#include "engine/scene/sections/scene_parts.h"

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

namespace plumbline::scene {
namespace fs = std::filesystem;
namespace {

/// What is seen and what collides.
Aabb bounds_of_scene(const GltfScene& gltf) {
    Aabb bounds = gltf.model.mesh.bounds;
    for (const EntityDescription& entity : gltf.scene.entities) {
        const auto* shape =
            entity.body ? std::get_if<physics::ShapeDef>(&entity.body->shape) : nullptr;
        if (shape == nullptr) continue;
        for (const Vec3& point : points_of(*shape)) {
            const Vec3 at = transform_point(entity.world_from_body, point);
            bounds.include(Vec3f(at));
        }
    }
    return bounds;
}

/// Whether something falls and the file has nothing that it could fall on.
bool needs_floor(const std::vector<EntityDescription>& things) {
    bool falls = false;
    for (const EntityDescription& entity : things) {
        if (!entity.body) continue;
        if (entity.body->kind == physics::BodyKind::Static) return false;
        falls |=
            entity.body->kind == physics::BodyKind::Dynamic && entity.body->gravity_factor != 0;
    }
    return falls;
}

/// Light, air and camera, as for a model by itself. What a file stands on is its own, or else the stage's floor.
void set_stage(SceneDescription& scene, const Aabb& bounds, const EntityDescription& floor) {
    std::vector<EntityDescription> things = std::exchange(scene.entities, {});
    if (needs_floor(things)) scene.entities.push_back(floor);
    place_on_stage(scene, bounds);
    scene.model_radius_m = 0;
    scene.has_camera = true;
    scene.entities.insert(scene.entities.begin(),
                          std::make_move_iterator(things.begin()),
                          std::make_move_iterator(things.end()));
}

void read_surroundings(const GltfScene& gltf, const fs::path& assets_folder) {
    const auto tables = table_of_extras(gltf.model.extras, gltf.location, gltf.faults);
    if (!tables) return;
    gltf.scene.sun.reset();
    gltf.scene.ambient = {};
    gltf.scene.controls.clear();
    LoadContext context{.assets_folder = assets_folder, .faults = gltf.faults};
    context.scene_location = gltf.location;
    context.entity_locations.assign(gltf.scene.entities.size(), gltf.location);
    TableReader root(*tables, "extras.plumbline", gltf.faults);
    read_sections(root, gltf.scene, context);
    root.finish();
}

}  // namespace

std::optional<SceneDescription> read_gltf_scene(const fs::path& file,
                                                const fs::path& root,
                                                const fs::path& assets_folder,
                                                FaultList& faults) {
    const SourceLocation location = in_file(file.string());
    const Result<std::string> bytes = read_file(file, limits::kModelFileBytes);
    // A look at the text spares the import of a model by itself.
    if (!bytes || bytes->find("_rigid_bodies\"") == std::string::npos)
        return scene_of_model(file, root);
    const Result<assets::ModelData> model = assets::import_model(file, root);
    if (!model) {
        faults.error(location, {}, model.error().message);
        return {};
    }
    SceneDescription scene = scene_of_model(file, root);
    if (model->physics.is_empty()) return scene;
    scene.shows_model = false;
    scene.description = "a glTF file with physics";
    const VisualDescription whole = scene.entities.back().visual;
    scene.entities.pop_back();
    GltfScene gltf{.model = *model,
                   .location = location,
                   .faults = faults,
                   .scene = scene,
                   .places = assets::node_places(*model),
                   .bodies = assets::bodies_of_nodes(*model)};
    if (!model->animations.empty())
        faults.warning(location, {}, "its animations are not played beside its physics");
    const EntityDescription ground = std::exchange(scene.entities, {}).front();
    add_gltf_bodies(gltf, whole);
    add_gltf_joints(gltf);
    if (model->extras.empty()) {
        set_stage(scene, bounds_of_scene(gltf), ground);
    } else {
        read_surroundings(gltf, assets_folder);
    }
    Hasher hasher;
    hasher.add(bytes->data(), bytes->size());
    scene.content_hash = hasher.digest();
    if (faults.any_error()) return {};
    return scene;
}

}  // namespace plumbline::scene
