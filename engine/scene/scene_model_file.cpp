#include "engine/scene/scene_parts.h"

namespace plumbline::scene {

SceneDescription scene_of_model(const std::filesystem::path& file,
                                const std::filesystem::path& root) {
    const Origin origin{.file = file.filename().string()};
    SceneDescription scene;
    scene.frames_everything = true;
    scene.file = file;
    scene.title = file.stem().string();
    scene.description = "a model on a ground plane";
    scene.ambient = Vec3f{0.25F, 0.27F, 0.3F};
    scene.sun = SunDescription{.direction = glm::normalize(Vec3{-0.4_r, Real{-1}, -0.3_r}),
                               .shadow = ShadowDescription{.origin = origin},
                               .origin = origin};

    assets::MaterialData floor;
    floor.name = "plumbline.floor";
    floor.base_color = Vec3f{0.35F, 0.36F, 0.34F};
    floor.roughness = 0.95F;
    scene.materials.emplace(floor.name, floor);

    EntityDescription ground;
    ground.name = "ground";
    ground.visual = Primitive{physics::PlaneShape{.size_m = Vec2{200, 200}}};
    ground.material = floor.name;
    ground.body = BodyDescription{.kind = physics::BodyKind::Static};
    ground.origin = origin;
    scene.entities.push_back(std::move(ground));

    EntityDescription model;
    model.name = "model";
    model.visual = ModelVisual{.file = file, .root = root};
    model.body = BodyDescription{.kind = physics::BodyKind::Static, .shape = ModelMeshShape{}};
    model.origin = origin;
    scene.entities.push_back(std::move(model));
    return scene;
}

}  // namespace plumbline::scene
