// Scenes handed over as JSON, and states there and back.
#include "engine/study/engines/neutral_scene.h"

#include "engine/study/findings/json_fields_impl.h"
#include "tests/engine/study/scenes/scene_run_fixture.h"

namespace plumbline::study {
namespace {

class NeutralSceneTest : public PlayedSceneTest {
protected:
    std::vector<physics::BodyId> moving() const {
        std::vector<physics::BodyId> bodies;
        for (const scene::MovingBody& each : scene_->simulation().moving_bodies())
            bodies.push_back(each.body);
        return bodies;
    }
};

TEST_F(NeutralSceneTest, HoldsBodiesAndJoints) {
    play(std::string(kFalling) + R"(
[[entity]]
name = "post"
[entity.body]
kind = "static"
shape = { box = [1, 2, 3] }
[[joint]]
name = "hook"
kind = "hinge"
a = "ball"
b = "post"
anchor_m = [1, 101, 0]
axis = [0, 0, 2]
limits = [-90, 90]
)");
    const NeutralScene scene =
        neutral_scene(scene_->simulation(), moving(), {"jolt", 120, {{"iterations", 7}}});
    const Json json = Json::parse(scene.text).at("scene");
    EXPECT_EQ(json.at("step_hz"), 120);
    EXPECT_EQ(json.at("knobs").at("iterations"), 7);
    ASSERT_EQ(json.at("bodies").size(), 2U);
    EXPECT_EQ(scene.places, std::vector<std::size_t>{0});
    EXPECT_EQ(json.at("bodies")[0].at("parts")[0].at("shape"), "sphere");
    EXPECT_EQ(json.at("bodies")[0].at("mass_kg"), 2);
    EXPECT_EQ(json.at("bodies")[1].at("parts")[0].at("half_m"), Json({0.5, 1.0, 1.5}));
    const Json& joint = json.at("joints").at(0);
    EXPECT_EQ(joint.at("kind"), "hinge");
    EXPECT_EQ(joint.at("b"), 1);
    EXPECT_EQ(joint.at("axis"), Json({0.0, 0.0, 1.0}));
    EXPECT_NEAR(joint.at("limits")[1].get<double>(), 1.5707963, 1e-6);
}

TEST_F(NeutralSceneTest, StatesComeBackAsTheyWere) {
    physics::PhysicsWorld& world = play(std::string(kFalling)).simulation().physics;
    const std::vector<physics::BodyId> bodies = moving();
    const std::vector<double> wanted{1, 2, 3, 0, 0.6, 0, 0.8, 4, 5, 6, 7, 8, 9};
    set_states(world, bodies, wanted);
    const std::vector<double> found = states_of(world, bodies);
    ASSERT_EQ(found.size(), wanted.size());
    for (std::size_t i = 0; i < wanted.size(); ++i) EXPECT_NEAR(found[i], wanted[i], 1e-5) << i;
}

TEST_F(NeutralSceneTest, BodiesThatAreLedAreNotHandedOver) {
    const std::string name = "[[entity]]\nname = \"table\"\nposition_m = [0, 1, 0]\n";
    const std::string motion = "motion = { points_m = [], spin_degps = [0, 90, 0] }\n";
    const std::string body = "[entity.body]\nkind = \"kinematic\"\nshape = { box = [1, 0.1, 1] }\n";
    EXPECT_TRUE(not_handed(play(std::string(kFalling) + name + body)).empty());
    EXPECT_EQ(not_handed(play(std::string(kFalling) + name + motion + body)),
              std::vector<std::string>{"a body that is led"});
}

TEST_F(NeutralSceneTest, EffectsThatPushBodiesAreNotHandedOver) {
    EXPECT_TRUE(not_handed(play(std::string(kFalling))).empty());
    EXPECT_EQ(not_handed(play(std::string(kFalling) + "drag = {}\n")),
              std::vector<std::string>{"drag"});
}

}  // namespace
}  // namespace plumbline::study
