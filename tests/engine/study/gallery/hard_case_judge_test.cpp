// The judge of a hard case against motions that are known in closed form.
#include "engine/study/gallery/hard_case_judge.h"

#include "engine/core/io/files.h"
#include "engine/study/gallery/case_events.h"
#include "tests/support/scene_in_code.h"

#include <gtest/gtest.h>

#include <cmath>

namespace plumbline::study {
namespace {

using scene::HardCaseRule;
using test::cube;
using test::Running;
using test::scene_of;

constexpr double kG = 9.81;

/// A cube at (0, 5, 0) and the case's rules.
scene::SceneDescription falling(std::vector<HardCaseRule> rules, double seconds = 0.9) {
    scene::SceneDescription scene = scene_of({cube("cube", {0, 5, 0}), cube("other", {20, 5, 0})});
    scene.hard_case =
        scene::HardCase{.id = "H1", .seconds = seconds, .settled_s = 0, .rules = std::move(rules)};
    return scene;
}

struct Judged {
    Running run;
    HardCaseJudge judge;

    explicit Judged(const scene::SceneDescription& scene)
        : run(scene), judge(made(*run.simulation)) {
        play_case_events(*run.simulation);
    }
    static HardCaseJudge made(const scene::Simulation& simulation) {
        Result<HardCaseJudge> judge = HardCaseJudge::create(simulation);
        EXPECT_TRUE(judge.ok()) << (judge.ok() ? "" : judge.error().message);
        return std::move(*judge);
    }
    void step(int count) {
        for (int i = 0; i < count; ++i) {
            run.step(1);
            judge.after_step(*run.simulation);
        }
    }
    const RuleState& rule(std::size_t i) const { return judge.rules()[i]; }
};

std::string refusal(const scene::SceneDescription& scene) {
    Running run(scene);
    const Result<HardCaseJudge> judge = HardCaseJudge::create(*run.simulation);
    EXPECT_FALSE(judge.ok());
    return judge ? "" : judge.error().message;
}

TEST(Allowed, MarginsAreSharesOfTheLimit) {
    const Allowed below{Allowed::Kind::Below, 4, 0};
    EXPECT_EQ(below.margin(1), 0.75);
    EXPECT_EQ(below.margin(4), 0);
    EXPECT_EQ(below.margin(12), -2);
    const Allowed above{Allowed::Kind::Above, -2, 0};
    EXPECT_EQ(above.margin(-1), 0.5);
    EXPECT_EQ(above.margin(-4), -1);
    const Allowed near{Allowed::Kind::Near, 10, 0.5};
    EXPECT_EQ(near.margin(10.25), 0.5);
    EXPECT_EQ(near.margin(9), -1);
    const Allowed none{Allowed::Kind::Below, 0, 0};
    EXPECT_EQ(none.margin(0), 1);
    EXPECT_EQ(none.margin(3), -3);
    EXPECT_EQ(below.margin(std::nan("")), -std::numeric_limits<double>::infinity());
}

TEST(HardCaseJudge, FailsInTheStepThatBreaksARule) {
    // Falls 1 m in sqrt(2 / g) = 0.4515 s: in the 28th step of 1/60 s.
    Judged judged(falling({{.measure = "sag_m", .of = {"cube"}, .below = 1}}));
    judged.step(27);
    EXPECT_EQ(judged.judge.verdict(), Verdict::Undecided);
    EXPECT_NEAR(judged.rule(0).value, 0.5 * kG * 0.45 * 0.45, 1e-5);
    judged.step(1);
    EXPECT_EQ(judged.judge.verdict(), Verdict::Fail);
    EXPECT_EQ(judged.rule(0).worst_of, "cube");
    EXPECT_NEAR(judged.rule(0).worst_at_s, 28.0 / 60, 1e-9);
    EXPECT_EQ(judged.judge.worst(), &judged.judge.rules()[0]);
}

TEST(HardCaseJudge, PassesWhenItsTimeIsOver) {
    Judged judged(falling({{.measure = "sag_m", .below = 4}}));
    judged.step(53);
    EXPECT_EQ(judged.judge.verdict(), Verdict::Undecided);
    EXPECT_FALSE(judged.judge.over());
    judged.step(1);
    EXPECT_EQ(judged.judge.verdict(), Verdict::Pass);
    EXPECT_TRUE(judged.judge.over());
    const double value = judged.rule(0).value;
    judged.step(20);  // falls on, and nobody asks
    EXPECT_EQ(judged.rule(0).value, value);
}

TEST(HardCaseJudge, LooksOnlyFromItsTimeToItsTime) {
    // v = g t.
    Judged judged(
        falling({{.measure = "speed_mps", .from_s = 0.2, .to_s = 0.5, .below = kG * 0.51},
                 {.measure = "speed_mps", .from_s = 0.9, .near = kG * 0.9, .within = 0.01},
                 {.measure = "speed_mps", .from_s = 0.2, .above = kG * 0.19}}));
    judged.step(11);
    EXPECT_FALSE(judged.rule(0).seen);
    judged.step(43);
    EXPECT_NEAR(judged.rule(0).value, kG * 0.5, 1e-4);
    EXPECT_NEAR(judged.rule(1).value, kG * 0.9, 1e-4);
    EXPECT_NEAR(judged.rule(2).value, kG * 0.2, 1e-4);
    EXPECT_EQ(judged.judge.verdict(), Verdict::Pass);
}

TEST(HardCaseJudge, EveryCaseIsHeldToTheGeneralRules) {
    scene::SceneDescription scene = falling({});
    scene.hard_case->events = {
        {.kind = scene::CaseEventKind::NotFinite, .of = "cube", .at_s = 0.1}};
    Judged strict(scene);
    strict.step(54);
    EXPECT_EQ(strict.judge.verdict(), Verdict::Fail);
    EXPECT_EQ(strict.judge.worst()->text, "non_finite at most 0");
    scene.hard_case->non_finite = 1;
    scene.hard_case->energy_from = "a body that is taken out";
    Judged lenient(scene);
    lenient.step(54);
    EXPECT_EQ(lenient.judge.verdict(), Verdict::Pass);
    EXPECT_EQ(lenient.judge.rules().size(), strict.judge.rules().size() - 1);
}

TEST(HardCaseJudge, EnergyOfEventsIsNoGain) {
    scene::SceneDescription scene = falling({});
    scene.hard_case->events = {{.kind = scene::CaseEventKind::Impulse,
                                .of = "cube",
                                .at_s = 0.1,
                                .value = {50'000, 0, 0}}};
    Judged judged(scene);
    judged.step(54);
    EXPECT_EQ(judged.judge.verdict(), Verdict::Pass);
}

TEST(HardCaseJudge, ABodyThatIsGoneFails) {
    scene::SceneDescription scene =
        falling({{.measure = "height_m", .of = {"cube"}, .above = -100}});
    scene.hard_case->events = {{.kind = scene::CaseEventKind::Remove, .of = "cube", .at_s = 0.1}};
    Judged judged(scene);
    judged.step(10);
    EXPECT_EQ(judged.judge.verdict(), Verdict::Fail);
    EXPECT_TRUE(std::isnan(judged.rule(0).value));
    EXPECT_EQ(margin_text(judged.rule(0).margin()), "gone");
}

TEST(HardCaseJudge, RefusesWhatIsNotThere) {
    EXPECT_NE(refusal(falling({{.measure = "sag", .below = 1}})).find("did you mean \"sag_m\"?"),
              std::string::npos);
    EXPECT_NE(refusal(falling({{.measure = "sag_m", .of = {"crate*"}, .below = 1}})).find("crate*"),
              std::string::npos);
    EXPECT_NE(refusal(falling({{.measure = "joint_error_m", .below = 1}})).find("no joint"),
              std::string::npos);
    scene::SceneDescription struck = falling({{.measure = "sag_m", .below = 1}});
    struck.hard_case->known_red = {{.rule = "sag_m at most 1", .reached = 2, .why = "a reason"}};
    EXPECT_TRUE(HardCaseJudge::create(*Running(struck).simulation).ok());
    struck.hard_case->known_red[0].rule = "sag_m at most";
    EXPECT_NE(
        refusal(struck).find("no rule is called \"sag_m at most\"; there are: sag_m at most 1 |"),
        std::string::npos);
    scene::SceneDescription plain = falling({});
    plain.hard_case.reset();
    EXPECT_NE(refusal(plain).find("no [hard_case]"), std::string::npos);
}

/// A measure of a cube on a known path, after half a second.
double measured(const std::string& measure, const scene::SceneDescription& like) {
    scene::SceneDescription scene = like;
    scene.hard_case = scene::HardCase{
        .id = "H1",
        .seconds = 0.5,
        .rules = {{.measure = measure, .of = {"cube"}, .from_s = 0.5, .below = 1e9}}};
    Judged judged(scene);
    judged.step(30);
    return judged.rule(0).value;
}

TEST(Measures, OfAThrownCube) {
    scene::SceneDescription scene = scene_of({cube("cube", {0, 5, 0})});
    scene.entities[0].body->velocity_mps = {3, 4, 0};
    scene.entities[0].body->angular_velocity_radps = {0, 0, 1};
    const double up = 4 - kG * 0.5;
    const double rise = 4 * 0.5 - 0.5 * kG * 0.25;
    EXPECT_NEAR(measured("drift_m", scene), 1.5, 1e-5);
    EXPECT_NEAR(measured("displacement_m", scene), std::hypot(1.5, rise), 1e-5);
    EXPECT_NEAR(measured("sag_m", scene), -rise, 1e-5);
    EXPECT_NEAR(measured("height_m", scene), 5 + rise, 1e-5);
    EXPECT_NEAR(measured("x_m", scene), 1.5, 1e-5);
    EXPECT_NEAR(measured("from_axis_m", scene), 1.5, 1e-5);
    EXPECT_NEAR(measured("speed_mps", scene), std::hypot(3, up), 1e-5);
    EXPECT_NEAR(measured("up_speed_mps", scene), up, 1e-5);
    EXPECT_NEAR(measured("horizontal_speed_mps", scene), 3, 1e-5);
    EXPECT_NEAR(measured("speed_change", scene), std::abs(std::hypot(3, up) - 5) / 5, 1e-5);
    EXPECT_NEAR(measured("heading_deg", scene), 0, 1e-3);
    EXPECT_NEAR(measured("reach_m", scene), 5 + 16 / (2 * kG), 1e-4);
    EXPECT_NEAR(measured("spin_radps", scene), 1, 1e-5);
    EXPECT_NEAR(measured("tilt_deg", scene), 0.5 * 180 / 3.14159265358979, 1e-2);
    EXPECT_EQ(measured("awake", scene), 1);
    EXPECT_EQ(measured("impulse_Ns", scene), 0);
    EXPECT_NEAR(measured("mean_displacement_m", scene), std::hypot(1.5, rise), 1e-5);
    EXPECT_NEAR(measured("mean_height_m", scene), 5 + rise, 1e-5);
    EXPECT_NEAR(measured("energy_gain", scene), 0, 1e-5);
    EXPECT_NEAR(measured("kinetic_J", scene), 500 * (9 + up * up) + 0.5 * 1000 / 6, 0.1);
    EXPECT_NEAR(measured("momentum_change", scene), kG * 0.5 / 5, 1e-5);
    EXPECT_EQ(measured("penetration_m", scene), 0);
    EXPECT_EQ(measured("removed", scene), 0);
}

TEST(Measures, ImpulseOfACubeAtRestIsItsWeight) {
    scene::SceneDescription scene = scene_of({test::ground(), cube("cube", {0, 0.5_r, 0})});
    scene.entities[1].body->can_sleep = false;
    EXPECT_NEAR(measured("impulse_Ns", scene), 1000 * kG / 60, 2);
}

TEST(Measures, RelativeToAnotherBody) {
    scene::SceneDescription scene = scene_of({cube("cube", {2, 5, 0}), cube("lift", {0, 5, 0})});
    for (scene::EntityDescription& entity : scene.entities) entity.body->velocity_mps = {0, 0, 7};
    scene.hard_case = scene::HardCase{
        .id = "H1",
        .seconds = 0.5,
        .rules = {
            {.measure = "displacement_m", .of = {"cube"}, .relative_to = "lift", .below = 1e-5},
            {.measure = "from_axis_m",
             .of = {"cube"},
             .relative_to = "lift",
             .near = 2,
             .within = 1e-5}}};
    Judged judged(scene);
    judged.step(30);
    EXPECT_EQ(judged.judge.verdict(), Verdict::Pass);
}

TEST(Measures, NamesAreOnTheirPage) {
    const Result<std::string> page = read_file(PL_SOURCE_DIR "/docs/SCENE-FORMAT.md", 1 << 20);
    ASSERT_TRUE(page.ok());
    for (const Measure& measure : measures())
        EXPECT_NE(page->find("`" + std::string(measure.name) + "`"), std::string::npos)
            << measure.name;
}

}  // namespace
}  // namespace plumbline::study
