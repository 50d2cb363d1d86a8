// Bodies of the moving parts of models.
#include "tests/engine/scene/build/moving_model.h"

namespace plumbline::scene {
namespace {

TEST(ModelBodies, AreNotThereForModelsThatOnlyShow) {
    const TempFolder folder;
    EntityDescription shown = moving_model(folder, sled());
    shown.body.reset();
    test::Running run(test::scene_of({shown}));
    EXPECT_TRUE(run->moving_bodies().empty());
    shown.body = BodyDescription{.kind = physics::BodyKind::Static};
    test::Running still(test::scene_of({shown}));
    EXPECT_TRUE(still->moving_bodies().empty());
}

TEST(EntityParts, HaveTheSurfaceAndTheNamesOfTheWhole) {
    const TempFolder folder;
    SurfaceTable surfaces = test::plain_surfaces();
    surfaces.surfaces.push_back({.name = "ice"});
    TriangleFile file;
    file.json["nodes"] = {{{"mesh", 0}, {"name", "plate"}}};
    file.json["materials"] = {{{"name", "frozen"}}};
    file.primitive()["material"] = 0;
    file.slide(0);
    const EntityDescription model = moving_model(folder, file.glb());
    SceneDescription scene = test::scene_of({model});
    scene.materials["frozen"] = {.name = "frozen", .surface = "ice"};
    test::Running run(scene, surfaces);
    const ecs::Entity whole = run->find("model");
    const ecs::Entity part = run->find("model/plate");
    EXPECT_FALSE(run->registry.has<BodyRef>(whole));
    EXPECT_EQ(run->registry.get<SurfaceRef>(part).surface, 1);
    EXPECT_FALSE(run->registry.has<Visual>(part)) << "the whole is drawn";
    const auto& bodies = run->registry.get<PartBodies>(whole);
    ASSERT_EQ(bodies.parts.size(), 1U);
    EXPECT_EQ(bodies.parts[0].entity, part);
}

}  // namespace
}  // namespace plumbline::scene
