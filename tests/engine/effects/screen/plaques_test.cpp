// What plaques measure of a moving box.
#include "tests/engine/effects/drawn.h"

namespace plumbline::effects {
namespace {

using scene::PlaqueQuantity;

/// A box that flies at (3, 4, 0) m/s and turns at 90 degrees a second, measured from a post under where it starts.
scene::SceneDescription flight(PlaqueQuantity quantity) {
    scene::EntityDescription post =
        test::box("post", {0, 0, 0}, {1, 1, 1}, physics::BodyKind::Static);
    post.plaque = scene::PlaqueDescription{
        .title = "", .formula = "", .of = "box", .from = "post", .quantity = quantity};
    scene::EntityDescription box = test::box("box", {0, 10, 0}, {1, 1, 1});
    box.body->velocity_mps = {3, 4, 0};
    box.body->angular_velocity_radps = {0, kPi / 2, 0};
    scene::SceneDescription scene = test::scene_of({post, box});
    scene.gravity_mps2 = {0, 0, 0};
    return scene;
}

std::optional<double> measured(PlaqueQuantity quantity) {
    test::Running run(flight(quantity));
    EffectRuntime effects(*run, {});
    run.step(1, effects);
    return run->registry.get<scene::Plaque>(run->find("post")).meter.measured();
}

TEST(Plaques, MeasureWhatTheySay) {
    const Vec3d there{3.0 / 60, 10 + 4.0 / 60, 0};
    EXPECT_NEAR(*measured(PlaqueQuantity::Height), there.y, 1e-5);
    EXPECT_NEAR(*measured(PlaqueQuantity::Speed), 5, 1e-5);
    EXPECT_NEAR(*measured(PlaqueQuantity::Spin), 90, 1e-3);
    EXPECT_NEAR(*measured(PlaqueQuantity::Distance), glm::length(there), 1e-5);
    EXPECT_NEAR(*measured(PlaqueQuantity::Lean),
                std::atan2(there.x, there.y) * 180 / static_cast<double>(kPi),
                1e-4);
    EXPECT_FALSE(measured(PlaqueQuantity::Period)) << "it does not come back";
}

TEST(Plaques, KeepTheirLastValueWhenWhatTheyMeasureWent) {
    test::Running run(flight(PlaqueQuantity::Speed));
    EffectRuntime effects(*run, {});
    run.step(5, effects);
    run->registry.destroy(run->find("box"));
    run.step(5, effects);
    EXPECT_NEAR(*run->registry.get<scene::Plaque>(run->find("post")).meter.measured(), 5, 1e-5);
    EXPECT_EQ(line_of(effects, "plaques").calls, 5U);
}

TEST(Plaques, AreNotThereWithoutOne) {
    test::Running run(test::scene_of({test::box("box", {0, 10, 0}, {1, 1, 1})}));
    EffectRuntime effects(*run, {});
    run.step(5, effects);
    EXPECT_EQ(line_of(effects, "plaques").constructions, 0U);
}

}  // namespace
}  // namespace plumbline::effects
