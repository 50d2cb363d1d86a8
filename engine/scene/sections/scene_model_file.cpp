#include "engine/assets/model_import.h"
#include "engine/core/limits.h"
#include "engine/scene/scene_file.h"
#include "engine/scene/sections/scene_parts.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace plumbline::scene {
namespace {

constexpr std::string_view kGroundName = "ground";
// Of the radius of the sphere round the model. A depth buffer of 24 bits bears their quotients.
constexpr Real kNearShare = 0.002_r;
constexpr Real kFarShare = 100;
constexpr Real kGroundShare = 20;
constexpr Real kShadowShare = 10;
constexpr std::size_t kMostSolidTriangles = 200'000;
constexpr Real kLeastRadius_m = 1e-5_r;

}  // namespace

SceneDescription scene_of_model(const std::filesystem::path& file,
                                const std::filesystem::path& root) {
    const SourceLocation location = in_file(file.filename().string());
    SceneDescription scene;
    scene.shows_model = true;
    scene.file = file;
    scene.source_files.push_back(file);
    scene.title = file.stem().string();
    scene.description = "a model on a ground plane";
    scene.controls = "viewer";
    // Together they make white that faces the sun just white, not more.
    scene.ambient.color = Vec3f{0.2F, 0.215F, 0.24F};
    scene.sun = SunDescription{.direction = glm::normalize(Vec3{-0.4_r, Real{-1}, -0.3_r}),
                               .intensity = 2.4F,
                               .shadow = ShadowDescription{.location = location},
                               .location = location};

    assets::MaterialData floor;
    floor.name = "plumbline.floor";
    floor.base_color = Vec3f{0.35F, 0.36F, 0.34F};
    floor.roughness = 0.95F;
    scene.materials.emplace(floor.name, floor);

    EntityDescription ground;
    ground.name = kGroundName;
    ground.visual = Primitive{physics::PlaneShape{.size_m = Vec2{200, 200}}};
    ground.material = floor.name;
    ground.body = BodyDescription{.kind = physics::BodyKind::Static};
    ground.location = location;
    scene.entities.push_back(std::move(ground));

    EntityDescription model;
    model.name = "model";
    model.visual = ModelVisual{.file = file, .root = root};
    model.body = BodyDescription{.kind = physics::BodyKind::Static, .shape = ModelMeshShape{}};
    model.location = location;
    scene.entities.push_back(std::move(model));
    return scene;
}

void place_on_stage(SceneDescription& scene, const Aabb& bounds) {
    const Sphere sphere = sphere_around(bounds);
    const Real radius_m = std::max(static_cast<Real>(sphere.radius), kLeastRadius_m);
    scene.model_radius_m = radius_m;
    CameraDescription& camera = scene.camera;
    const Real distance_m = radius_m / portable_sin(camera.fov_y_rad / 2);
    camera.target_m = Vec3{sphere.center};
    camera.position_m = camera.target_m + glm::normalize(Vec3{1.0_r, 0.6_r, 1.6_r}) * distance_m;
    camera.near_m = radius_m * kNearShare;
    camera.far_m = radius_m * kFarShare;
    if (scene.sun && scene.sun->shadow) scene.sun->shadow->distance_m = radius_m * kShadowShare;
    for (EntityDescription& entity : scene.entities) {
        auto* primitive = std::get_if<Primitive>(&entity.visual);
        if (primitive == nullptr || entity.name != kGroundName) continue;
        const auto allowed_m = [](Real size_m) {
            return std::clamp(size_m,
                              static_cast<Real>(limits::kSizeMin_m),
                              static_cast<Real>(limits::kSizeMax_m));
        };
        const Real side_m = allowed_m(radius_m * kGroundShare);
        *primitive =
            physics::PlaneShape{.size_m = {side_m, side_m}, .thickness_m = allowed_m(radius_m)};
        entity.world_from_body.position = {
            camera.target_m.x, Real{bounds.min.y}, camera.target_m.z};
    }
}

Result<Done> fit_stage(SceneDescription& scene, assets::AssetLibrary& library) {
    for (EntityDescription& entity : scene.entities) {
        const auto* visual = std::get_if<ModelVisual>(&entity.visual);
        if (visual == nullptr) continue;
        const Result<assets::Model> model = library.model(visual->file, visual->root);
        if (!model) return model.error();
        // A collision tree for more takes longer than reading them: such a model is only looked at.
        if (library.mesh(model->mesh).indices.size() / 3 > kMostSolidTriangles) entity.body.reset();
        const assets::MovingModel* moving = library.moving(model->id);
        // Fitted to all that an animation reaches, one that walks far away would be a speck.
        const auto start = [&] {
            return assets::pose_at(moving->data, moving->data.animations.front(), 0.0F);
        };
        place_on_stage(scene,
                       moving == nullptr ? library.mesh(model->mesh).bounds
                                         : assets::bounds_of(moving->data, start()));
        return Done{};
    }
    return Done{};
}

void check_models(const SceneDescription& scene, Diagnostics& faults) {
    std::set<std::filesystem::path> checked;
    const auto check = [&](const EntityDescription& entity) {
        const auto* visual = std::get_if<ModelVisual>(&entity.visual);
        if (visual == nullptr || !checked.insert(visual->file).second) return;
        const Result<assets::ModelData> model = assets::import_model(visual->file, visual->root);
        if (model) return;
        faults.add({Severity::Error,
                    file_of(entity.location),
                    entity.location.line,
                    0,
                    scene.shows_model ? "" : "model",
                    model.error().message});
    };
    for (const EntityDescription& entity : scene.entities) check(entity);
    for (const auto& [name, prefab] : scene.prefabs) check(prefab);
    for (const ArrayDescription& array : scene.arrays) check(array.prefab);
}

}  // namespace plumbline::scene
