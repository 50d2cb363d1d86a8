// SOURCES B36: what [goal] says is what the description holds; what it gets wrong is named.
#include "tests/engine/scene/sections/scene_file_fixture.h"

namespace plumbline::scene {
namespace {

constexpr std::string_view kCans = R"([[prefab]]
name = "ball"
primitive = { sphere = 0.1 }
body = {}
[[prefab]]
name = "tin"
primitive = { cylinder = [0.1, 0.2] }
body = {}
[[array]]
name = "can"
prefab = "tin"
count = [3, 2, 1]
[[entity]]
name = "can.top"
prefab = "tin"
[[entity]]
name = "post"
primitive = { box = [1, 1, 1] }
[goal]
)";

TEST_F(SceneFileTest, AGoalOfTriggersHasACountAndNoThings) {
    const Outcome outcome = load("[goal]\ntext = \"Ring it\"\ntriggers = true\ncount = 3\n");
    ASSERT_TRUE(outcome.scene.ok()) << outcome.scene.error().message;
    EXPECT_TRUE(outcome.scene->goal->triggers);
    EXPECT_EQ(outcome.scene->goal->count, 3);
    EXPECT_FALSE(load("[goal]\ntext = \"Ring it\"\ntriggers = true\n").scene.ok());
    EXPECT_FALSE(
        load("[goal]\ntext = \"Ring it\"\ntriggers = true\ncount = 1\nbelow_m = 1\n").scene.ok());
}

TEST_F(SceneFileTest, AGoalIsRead) {
    const Outcome outcome = load(fmt::format("{}{}", kCans, R"(text = "Knock them off"
things = ["can.*"]
below_m = 0.5
count = 7
within_s = 60
throws = 9
with = "ball"
hands_off = true
)"));
    ASSERT_TRUE(outcome.scene.ok()) << outcome.scene.error().message;
    EXPECT_TRUE(outcome.faults.empty());
    const GoalDescription& goal = *outcome.scene->goal;
    EXPECT_EQ(goal.text, "Knock them off");
    EXPECT_EQ(goal.things, std::vector<std::string>{"can.*"});
    EXPECT_EQ(goal.below_m, 0.5_r);
    EXPECT_FALSE(goal.inside || goal.outside);
    EXPECT_EQ(goal.count, 7);
    EXPECT_EQ(goal.within_s, 60.0);
    EXPECT_EQ(goal.throws, 9);
    EXPECT_EQ(goal.with, "ball");
    EXPECT_TRUE(goal.hands_off);
}

TEST_F(SceneFileTest, FaultsOfAGoalAreNamed) {
    const auto faults = [&](const std::string& keys) {
        const Outcome outcome = load(fmt::format("{}{}", kCans, keys));
        EXPECT_FALSE(outcome.scene.ok()) << keys;
        return outcome.faults.size() == 1 ? outcome.faults.front()
                                          : fmt::format("{}", fmt::join(outcome.faults, "\n"));
    };
    EXPECT_EQ(faults("things = [\"can.*\"]\nbelow_m = 1\n"),
              "scene.toml:19:1: error: goal.text: expected 1 to 200 letters: what is to be done");
    EXPECT_EQ(faults("text = \"x\"\nthings = [\"cans.*\"]\nbelow_m = 1\n"),
              "scene.toml:21:10: error: goal.things: no body is called \"cans.*\"");
    EXPECT_EQ(faults("text = \"x\"\nthings = [\"post\"]\nbelow_m = 1\n"),
              "scene.toml:21:10: error: goal.things: \"post\" has no body");
    EXPECT_EQ(faults("text = \"x\"\nthings = [\"can.*\"]\nbelow_m = 1\ncount = 8\n"),
              "scene.toml:23:9: error: goal.count: 8 of 7 things; expected no more than there are");
    EXPECT_EQ(faults("text = \"x\"\nthings = [\"can.*\"]\n"),
              "scene.toml:19:1: error: goal.below_m: expected one of below_m, inside, outside and "
              "triggers");
    EXPECT_EQ(faults("text = \"x\"\nthings = [\"can.*\"]\ninside = { min_m = [0, 0, 0], max_m = "
                     "[1, -1, 1] }\n"),
              "scene.toml:22:39: error: goal.inside.max_m: is less than min_m; expected the corner "
              "with the larger numbers");
    EXPECT_EQ(faults("text = \"x\"\nthings = [\"can.*\"]\nbelow_m = 1\nwith = \"bal\"\n"),
              "scene.toml:23:8: error: goal.with: no prefab is called \"bal\"; did you mean "
              "\"ball\"?");
}

}  // namespace
}  // namespace plumbline::scene
