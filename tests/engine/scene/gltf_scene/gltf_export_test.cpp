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
    scene.grass = GrassDescription{};
    const RoundTrip trip(scene);
    EXPECT_EQ(trip.exported.notes,
              (std::vector<std::string>{"grass and flocks are left out", "wind is left out"}));
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

// A lamp goes with its body, or stands by itself.
TEST(GltfExport, KeepsLamps) {
    SceneDescription scene = scene_of({ball("carried", {0, 5, 0}, 0.5_r), ground()});
    scene.entities[0].light = LightDescription{.color = {1, 0.5F, 0},
                                               .intensity = 30,
                                               .radius_m = 6,
                                               .offset_m = {0, 1, 0},
                                               .is_spot = true,
                                               .direction = {1, 0, 0},
                                               .outer_deg = 40};
    EntityDescription lamp;
    lamp.name = "lamp";
    lamp.world_from_body.position = {3, 4, 5};
    lamp.light = LightDescription{.on = LampOn::Dark};
    scene.entities.push_back(lamp);
    const RoundTrip trip(scene);
    ASSERT_TRUE(trip.description.ok());
    const auto light_of = [&](const char* name) {
        const auto& entities = trip.description->entities;
        const auto found = std::ranges::find(entities, name, &EntityDescription::name);
        EXPECT_NE(found, entities.end()) << name;
        EXPECT_TRUE(found != entities.end() && found->light) << name;
        return found != entities.end() ? found->light.value_or(LightDescription{})
                                       : LightDescription{};
    };
    const LightDescription carried = light_of("carried");
    EXPECT_TRUE(carried.is_spot);
    EXPECT_NEAR(carried.intensity, 30.0F, 1e-4F);
    EXPECT_NEAR(carried.color.y, 0.5F, 1e-5F);
    EXPECT_NEAR(carried.outer_deg, 40.0F, 1e-4F);
    EXPECT_EQ(carried.offset_m, Vec3(0, 1, 0));
    EXPECT_EQ(light_of("lamp").on, LampOn::Dark);
    EXPECT_TRUE(trip.exported.notes.empty());
}

}  // namespace
}  // namespace plumbline::scene::gltf
