// Bars from anchor to anchor, blended as the bodies are, until the joint breaks.
#include "tests/engine/effects/drawn.h"

namespace plumbline::effects {
namespace {

constexpr ServedDomains kSeeingBars{.frame = true, .sound = false};

/// A ball 2 m under a point of the world at (0, 5, 0).
scene::SceneDescription hung(physics::JointKind kind, Real bar_m) {
    scene::SceneDescription scene = test::scene_of({test::box("bob", {0, 3, 0}, {1, 1, 1})});
    scene.joints.push_back({.name = "string", .kind = kind, .a = "bob", .b = "world"});
    scene::JointDescription& joint = scene.joints.back();
    const bool is_between = kind == physics::JointKind::Distance;
    joint.anchor_a_m = is_between ? Vec3{0, 3.5_r, 0} : Vec3{0, 5, 0};
    joint.anchor_b_m = {0, 5, 0};
    joint.bar_m = bar_m;
    return scene;
}

/// World space of the bar's two ends: its mesh is 1 m high about the origin.
std::vector<std::pair<Vec3f, Vec3f>> bars(test::Running& run, EffectRuntime& effects) {
    render::RenderFrame frame;
    effects.extract(*run, {}, frame);
    std::vector<std::pair<Vec3f, Vec3f>> ends;
    for (const render::DrawItem& item : frame.items)
        ends.emplace_back(Vec3f(item.world_from_body * Vec4f{0, -0.5F, 0, 1}),
                          Vec3f(item.world_from_body * Vec4f{0, 0.5F, 0, 1}));
    return ends;
}

TEST(JointBars, GoFromAnchorToAnchor) {
    test::Running run(hung(physics::JointKind::Distance, 0.01_r));
    EffectRuntime effects(*run, kSeeingBars);
    run.step(1, effects);
    const auto drawn = bars(run, effects);
    ASSERT_EQ(drawn.size(), 1U);
    EXPECT_NEAR(glm::distance(drawn[0].first, Vec3f{0, 3.5F, 0}), 0, 1e-3);
    EXPECT_NEAR(glm::distance(drawn[0].second, Vec3f{0, 5, 0}), 0, 1e-5);
}

TEST(JointBars, OfOneThatTurnsAboutAPointGoFromTheMiddleOfTheBody) {
    test::Running run(hung(physics::JointKind::BallAndSocket, 0.01_r));
    EffectRuntime effects(*run, kSeeingBars);
    run.step(1, effects);
    EXPECT_NEAR(glm::distance(bars(run, effects).at(0).first, Vec3f{0, 3, 0}), 0, 1e-3);
}

TEST(JointBars, AreNotThereWithoutARadiusOrAJoint) {
    test::Running none(hung(physics::JointKind::Distance, 0));
    EffectRuntime without(*none, kSeeingBars);
    none.step(1, without);
    EXPECT_EQ(line_of(without, "joint_bars").constructions, 0U);
    test::Running run(hung(physics::JointKind::Distance, 0.01_r));
    EffectRuntime effects(*run, kSeeingBars);
    run.step(1, effects);
    run->registry.destroy(run->find("bob"));
    run.step(1, effects);
    EXPECT_TRUE(bars(run, effects).empty());
}

}  // namespace
}  // namespace plumbline::effects
