// The judge of a hard case against motions that are known in closed form.
#include "engine/study/gallery/hard_case_judge.h"

#include "tests/engine/study/gallery/judged.h"

#include <gtest/gtest.h>

#include <cmath>

namespace plumbline::study {
namespace {

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
    EXPECT_FALSE(judged.judge.has_ended());
    judged.step(1);
    EXPECT_EQ(judged.judge.verdict(), Verdict::Pass);
    EXPECT_TRUE(judged.judge.has_ended());
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

}  // namespace
}  // namespace plumbline::study
