// What is seen of a scene as glTF, and what is not in the file.
#include "tests/engine/scene/gltf_scene/gltf_round_trip.h"

#include <cmath>

namespace plumbline::scene::gltf {
namespace {

using physics::BodyKind;
using test::ball;
using test::box;
using test::cube;
using test::ground;
using test::Running;
using test::scene_of;

TEST(GltfExport, SaysWhatTheFileLacks) {
    SceneDescription scene = scene_of({ball("a", {0, 5, 0}, 0.5_r)});
    scene.wind = WindDescription{};
    scene.entities[0].light = LightDescription{};
    const RoundTrip trip(scene);
    EXPECT_EQ(trip.exported.notes,
              (std::vector<std::string>{"wind is left out", "lamps are left out"}));
}

TEST(GltfExport, KeepsWhatIsSeenAndItsMaterials) {
    SceneDescription scene = scene_of({ball("a", {0, 5, 0}, 0.5_r)});
    scene.materials["red"] = {.name = "red", .base_color = {1, 0, 0}, .roughness = 0.25F};
    scene.entities[0].material = "red";
    scene.entities[0].scale = {2, 2, 2};
    RoundTrip trip(scene);
    ASSERT_NE(trip.after, nullptr);
    const Running& after = *trip.after;
    const auto& visual = after.simulation->registry.get<Visual>(after.simulation->find("a"));
    const assets::MaterialData& worn = after.library.material(visual.materials.front());
    EXPECT_EQ(worn.name, "red");
    EXPECT_EQ(worn.base_color, Vec3f(1, 0, 0));
    EXPECT_EQ(worn.roughness, 0.25F);
    EXPECT_NEAR(after.library.mesh(visual.mesh).bounds.max.y, 1.0F, 1e-3F) << "twice 0.5 m";
}

}  // namespace
}  // namespace plumbline::scene::gltf
