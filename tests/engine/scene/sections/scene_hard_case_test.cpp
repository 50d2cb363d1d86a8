// [hard_case]: what is read, and what is refused with the place and the nearest name.
#include "tests/engine/scene/sections/scene_file_fixture.h"

namespace plumbline::scene {
namespace {

constexpr const char* kBodies = R"(
[[entity]]
name = "box_1"
primitive = { box = [1, 1, 1] }
[entity.body]
[[entity]]
name = "look"
primitive = { box = [1, 1, 1] }
[[joint]]
name = "pin"
kind = "ball_and_socket"
a = "box_1"
b = "world"
anchor_m = [0, 0, 0]
)";

class HardCaseTest : public SceneFileTest {
protected:
    Outcome load_case(const std::string& text) const { return load(kBodies + text); }
    std::string fault_of(const std::string& rest) const {
        const Outcome outcome =
            load_case("[hard_case]\nid = \"H1\"\nshows = \"it stands\"\n" + rest);
        EXPECT_FALSE(outcome.scene.ok());
        return outcome.faults.empty() ? "" : outcome.faults.front();
    }
};

TEST_F(HardCaseTest, SaysWhatPassesAndWhatHappens) {
    const Outcome outcome = load_case(R"(
[hard_case]
id = "H05"
shows = "A box stands."
known_to_fail = "one"
seconds = 60
tier = "nightly"
settled_s = 7
unsettled = "they interpenetrate"
penetration_m = 0.25
energy_gain = 0.5
energy_scale_J = 8
energy_from = "a motor"
non_finite = 1
removed = 2
[[hard_case.pass]]
measure = "sag_m"
of = ["box_*"]
from_s = 1
to_s = 2
below = 0.125
[[hard_case.pass]]
measure = "joint_error_m"
of = ["pin"]
relative_to = "box_1"
near = 4
within = 0.5
[[hard_case.known_red]]
rule = "sag_m of box_* at most 0.125"
reached = 0.25
why = "two"
[[hard_case.event]]
do = "force"
of = "box_1"
at_s = 3
value = [1, 2, 4]
point_m = [0, 1, 0]
duration_s = 0.5
[[hard_case.event]]
do = "gravity"
at_s = 2
value = [0, 1, 0]
)");
    ASSERT_TRUE(outcome.scene.ok()) << outcome.faults.front();
    EXPECT_TRUE(outcome.faults.empty());
    const HardCase& hard = *outcome.scene->hard_case;
    EXPECT_EQ(hard.id, "H05");
    EXPECT_EQ(hard.shows, "A box stands.");
    EXPECT_EQ(hard.known_to_fail, "one");
    ASSERT_EQ(hard.known_red.size(), 1U);
    EXPECT_EQ(hard.known_red[0].rule, "sag_m of box_* at most 0.125");
    EXPECT_EQ(hard.known_red[0].reached, 0.25);
    EXPECT_EQ(hard.known_red[0].why, "two");
    EXPECT_EQ(hard.seconds, 60);
    EXPECT_TRUE(hard.nightly);
    EXPECT_EQ(hard.settled_s, 7);
    EXPECT_EQ(hard.unsettled, "they interpenetrate");
    EXPECT_EQ(hard.penetration_m, 0.25);
    EXPECT_EQ(hard.energy_gain, 0.5);
    EXPECT_EQ(hard.energy_scale_J, 8);
    EXPECT_EQ(hard.energy_from, "a motor");
    EXPECT_EQ(hard.non_finite, 1);
    EXPECT_EQ(hard.removed, 2);
    ASSERT_EQ(hard.rules.size(), 2U);
    EXPECT_EQ(hard.rules[0].of, std::vector<std::string>{"box_*"});
    EXPECT_EQ(hard.rules[0].from_s, 1);
    EXPECT_EQ(hard.rules[0].to_s, 2);
    EXPECT_EQ(hard.rules[0].below, 0.125);
    EXPECT_FALSE(hard.rules[0].above || hard.rules[0].near);
    EXPECT_EQ(hard.rules[1].relative_to, "box_1");
    EXPECT_EQ(hard.rules[1].near, 4);
    EXPECT_EQ(hard.rules[1].within, 0.5);
    ASSERT_EQ(hard.events.size(), 2U);
    EXPECT_EQ(hard.events[0].kind, CaseEventKind::Gravity) << "in the order of time";
    EXPECT_EQ(hard.events[1].kind, CaseEventKind::Force);
    EXPECT_EQ(hard.events[1].value, (Vec3{1, 2, 4}));
    EXPECT_EQ(hard.events[1].point_m, (Vec3{0, 1, 0}));
    EXPECT_EQ(hard.events[1].duration_s, 0.5);
}

TEST_F(HardCaseTest, DefaultsAreThoseOfThePage) {
    const Outcome outcome = load_case("[hard_case]\nid = \"H1\"\nshows = \"it\"\nseconds = 8\n");
    ASSERT_TRUE(outcome.scene.ok());
    const HardCase& hard = *outcome.scene->hard_case;
    EXPECT_FALSE(hard.nightly);
    EXPECT_EQ(hard.settled_s, 0) << "the whole time";
    EXPECT_NEAR(hard.penetration_m, 0.02, 1e-8);
    EXPECT_NEAR(hard.energy_gain, 0.01, 1e-8);
    EXPECT_TRUE(hard.energy_from.empty());
}

TEST_F(HardCaseTest, ASceneWithoutOneHasNone) {
    EXPECT_FALSE(load_case("").scene->hard_case);
}

TEST_F(HardCaseTest, RefusalsNameKeyAndNearest) {
    const std::string pass = "[[hard_case.pass]]\nmeasure = \"sag_m\"\n";
    const std::string event = "[[hard_case.event]]\nof = \"box_1\"\n";
    const std::pair<std::string, std::string> cases[] = {
        {"secnds = 3\n", "did you mean \"seconds\"?"},
        {"seconds = 0\n", "seconds from 0.1 to 3600"},
        {"tier = \"nighty\"\n", "nightly"},
        {"settled_s = 2\n", "settled_s: expected `unsettled`, which says why"},
        {"[[hard_case.known_red]]\nrule = \"x\"\nreached = 1\n", "why: missing"},
        {"[[hard_case.known_red]]\nrule = \"x\"\nwhy = \"y\"\n", "reached: expected either"},
        {"[[hard_case.known_red]]\nrule = \"x\"\nwhy = \"y\"\ngone = true\nreached = 1\n",
         "reached: expected either the worst value or gone = true"},
        {pass + "below = 1\nabove = 0\n", "expected one of below, above, and near with within"},
        {pass, "expected one of below, above, and near with within"},
        {pass + "near = 1\n", "within: missing"},
        {pass + "below = 1\nfrom_s = 3\nto_s = 2\n", "to_s: lies before from_s"},
        {pass + "below = 1\nof = [\"box_2\"]\n", "did you mean \"box_1\"?"},
        {pass + "below = 1\nrelative_to = \"bax_1\"\n", "did you mean \"box_1\"?"},
        {"[[hard_case.pass]]\nbelow = 1\n", "measure: missing"},
        {event, "do: missing"},
        {event + "do = \"telport\"\nvalue = [0, 0, 0]\n", "teleport"},
        {event + "do = \"force\"\n", "value: missing"},
        {event + "do = \"motor_off\"\n", "expected the name of a joint"},
        {"[[hard_case.event]]\ndo = \"remove\"\n", "expected the name of an entity with a body"},
        {"[[hard_case.event]]\ndo = \"remove\"\nof = \"look\"\n",
         "expected the name of an entity with a body"},
    };
    for (const auto& [text, wanted] : cases) {
        const std::string fault = fault_of(text);
        EXPECT_NE(fault.find(wanted), std::string::npos) << text << "\nsaid: " << fault;
        EXPECT_NE(fault.find("scene.toml:"), std::string::npos) << fault;
    }
    const Outcome nameless = load_case("[hard_case]\nshows = \"it\"\n");
    ASSERT_FALSE(nameless.faults.empty());
    EXPECT_NE(nameless.faults.front().find("hard_case.id: missing"), std::string::npos);
}

}  // namespace
}  // namespace plumbline::scene
