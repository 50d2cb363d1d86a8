// Waters of a scene: boxes, and what meshes hold; their surfaces, and what is refused.
#include "engine/scene/simulation/scene_water.h"

#include "engine/assets/primitives.h"
#include "tests/support/scene_in_code.h"

#include <gtest/gtest.h>

namespace plumbline::scene {
namespace {

/// A trough of five boxes, 1 x 1 inside and 0.5 deep, seen from above twice as large by its scale.
EntityDescription trough() {
    assets::MeshData all;
    const auto add = [&all](const Vec3f& middle, const Vec3f& size) {
        assets::MeshData part = assets::box_mesh(size);
        const auto first = static_cast<std::uint32_t>(all.vertices.size());
        for (assets::Vertex& vertex : part.vertices) vertex.position_body += middle;
        all.vertices.insert(all.vertices.end(), part.vertices.begin(), part.vertices.end());
        for (const std::uint32_t index : part.indices) all.indices.push_back(first + index);
    };
    add({0, -0.1F, 0}, {1.4F, 0.2F, 1.4F});
    for (const float side : {-0.6F, 0.6F}) {
        add({side, 0.25F, 0}, {0.2F, 0.5F, 1.4F});
        add({0, 0.25F, side}, {1, 0.5F, 0.2F});
    }
    EntityDescription entity;
    entity.name = "trough";
    entity.visual = MeshVisual{
        "trough", std::make_shared<const assets::MeshData>(assets::finished(std::move(all)))};
    entity.scale = {2, 1, 2};
    entity.world_from_body.position = {5, 3, 0};
    entity.location = in_file("test.toml", 10);
    return entity;
}

WaterDescription pool(double level_m) {
    return {.name = "pool",
            .basin = "trough",
            .max_m = {0, static_cast<Real>(level_m), 0},
            .material = "glass",
            .location = in_file("test.toml", 30)};
}

std::string refusal_of(const SceneDescription& scene) {
    assets::AssetLibrary library;
    const auto built = build_simulation(scene, {}, library, test::plain_surfaces());
    return built.ok() ? "" : built.error().message;
}

TEST(SceneWater, FillsWhatAMeshHolds) {
    SceneDescription scene = test::scene_of({trough()});
    scene.forces.waters = {pool(3.4)};
    test::Running run(scene);
    ASSERT_EQ(run->waters.size(), 1U);
    const SceneWater& water = run->waters.front();
    ASSERT_TRUE(water.basin);
    EXPECT_NEAR(water.basin->volume_m3(), 2 * 2 * 0.4, 0.06);
    EXPECT_TRUE(water.basin->holds(5.9, -0.9));
    EXPECT_NEAR(water.min_m.y, 3, 1e-6);
    const auto& mesh = run->library().mesh(run->registry.get<Visual>(water.surface).mesh);
    EXPECT_GT(mesh.indices.size(), 0U);
    EXPECT_NEAR(mesh.bounds.max.y, 3.4F, 1e-6F);
    EXPECT_TRUE(run->registry.alive(run->find("pool/surface")));
}

TEST(SceneWater, RefusesWhatHoldsNone) {
    SceneDescription scene = test::scene_of({trough()});
    scene.forces.waters = {pool(3.6)};
    EXPECT_NE(refusal_of(scene).find("test.toml:30"), std::string::npos) << refusal_of(scene);
    EXPECT_NE(refusal_of(scene).find("holds no water at level_m = 3.6"), std::string::npos);
    scene.forces.waters.front().basin = "tub";
    EXPECT_NE(refusal_of(scene).find("basin tub: no entity has this name"), std::string::npos);
    scene.entities.front().visual = {};
    scene.forces.waters.front().basin = "trough";
    EXPECT_NE(refusal_of(scene).find("it has no mesh"), std::string::npos);
}

TEST(SceneWater, IsDrawnOnlyWithAMaterial) {
    SceneDescription scene = test::scene_of({});
    scene.forces.waters = {{.name = "a", .min_m = {-1, -1, -1}, .max_m = {1, 0, 1}},
                           {.name = "b",
                            .min_m = {-1, -1, -1},
                            .max_m = {1, 0, 1},
                            .surface = WaterSurface::Waves,
                            .material = "glass"}};
    test::Running run(scene);
    EXPECT_FALSE(run->registry.alive(run->waters[0].surface));
    const auto& visual = run->registry.get<Visual>(run->waters[1].surface);
    EXPECT_EQ(run->library().mesh(visual.mesh).vertices.size(), 65U * 65U);
    EXPECT_FALSE(visual.is_static);
}

}  // namespace
}  // namespace plumbline::scene
