#include "engine/scene/build/entity_builder.h"

#include "tests/support/scene_in_code.h"

#include <algorithm>
#include <iterator>

namespace plumbline::scene {
namespace {

TEST(EntityBuilder, LeavesNothingOfWhatItCannotBuild) {
    test::Running run(test::scene_of({}));
    EntityBuilder builder(*run);
    const std::uint64_t before = run->revision();
    EntityDescription shapeless = test::cube("thing", {0, 0, 0});
    shapeless.visual = {};
    const auto made = builder.build(shapeless, "thing");
    ASSERT_FALSE(made.ok());
    EXPECT_EQ(made.error().message,
              "test.toml:10: entity thing: a body without a shape needs a model or a primitive to "
              "fit one to");
    EXPECT_EQ(run->find("thing"), ecs::Entity{});
    EXPECT_EQ(run->revision(), before);
    EXPECT_TRUE(run->moving_bodies().empty());
}

TEST(EntityBuilder, WeighsBySizeAndDensityButNeverNothing) {
    EntityDescription heavy = test::box("heavy", {0, 0, 0}, {1, 2, 3});
    EntityDescription own = test::box("own", {0, 9, 0}, {1, 2, 3});
    own.body->density_kgpm3 = 50;
    EntityDescription tiny = test::box("tiny", {0, 20, 0}, {0.001_r, 0.001_r, 0.001_r});
    test::Running run(test::scene_of({heavy, own, tiny}));
    EXPECT_NEAR(run->physics.state(run.body("heavy")).mass.mass_kg, 6000, 1e-2) << "the surface's";
    EXPECT_NEAR(run->physics.state(run.body("own")).mass.mass_kg, 300, 1e-3);
    EXPECT_NEAR(run->physics.state(run.body("tiny")).mass.mass_kg, 0.001, 1e-9);
    ASSERT_FALSE(run->warnings.empty());
    EXPECT_NE(run->warnings.back().find("kg; 0.001 kg is used"), std::string::npos);
}

TEST(EntityBuilder, ToursBeginWhereTheBodyStands) {
    EntityDescription lift = test::box("lift", {1, 2, 3}, {1, 1, 1}, physics::BodyKind::Kinematic);
    lift.motion = MotionDescription{.points_m = {{4, 0, 0}, {4, 5, 0}}, .period_s = 7};
    EntityDescription same = lift;
    same.name = "same";
    same.motion->points_m.insert(same.motion->points_m.begin(), Vec3{0, 0, 0});
    test::Running run(test::scene_of({lift, same}));
    const std::vector<Vec3> wanted{{1, 2, 3}, {5, 2, 3}, {5, 7, 3}};
    EXPECT_EQ(run->registry.get<MotionPath>(run->find("lift")).points_m, wanted);
    EXPECT_EQ(run->registry.get<MotionPath>(run->find("same")).points_m, wanted);
}

TEST(EntityBuilder, ABoxStandsInForAModelThatIsNotThere) {
    EntityDescription model = test::cube("model", {0, 0, 0});
    model.visual = ModelVisual{.file = "none.glb", .root = "."};
    model.body->shape = physics::ShapeDef{physics::SphereShape{.radius_m = 2}};
    EntityDescription again = model;
    again.name = "again";
    test::Running run(test::scene_of({model, again}));
    std::vector<std::string> told;
    std::copy_if(run->warnings.begin(),
                 run->warnings.end(),
                 std::back_inserter(told),
                 [](const std::string& text) { return text.find("stands") != text.npos; });
    ASSERT_EQ(told.size(), 1U) << "once for all that name it";
    EXPECT_TRUE(told[0].starts_with("test.toml:10: entity model: a box stands for its model: "));
    const auto& visual = run->registry.get<Visual>(run->find("again"));
    EXPECT_EQ(run->library().mesh(visual.mesh).bounds.max, Vec3f{2.0F}) << "as large as its shape";
}

}  // namespace
}  // namespace plumbline::scene
