#include "engine/app/stepper.h"

#include "engine/core/io/files.h"
#include "engine/scene/simulation/sun_hour.h"
#include "tests/engine/app/session_fixture.h"
#include "tests/engine/assets/fixture.h"

#include <fmt/format.h>

#include <stdexcept>
#include <utility>
#include <vector>

namespace plumbline::app {
namespace {

constexpr double kAnyTime_s = 1e9;

class StepperTest : public SessionTest {
protected:
    void record(Session& session, int steps) {
        Result<Stepper> stepper = Stepper::create(session, {});
        ASSERT_TRUE(stepper.ok());
        stepper->run(steps, kAnyTime_s, latch_, report_);
        ASSERT_TRUE(stepper->save_recording(tape()).ok());
    }
    std::filesystem::path tape() const { return folder_.path() / "a.tape"; }

    input::ActionLatch latch_{input::Bindings{}};
    FrameReport report_;
};

TEST_F(StepperTest, RunsAllThatIsDueWithinItsTimeAndOneStepWithoutAny) {
    const auto session = open();
    ASSERT_TRUE(session);
    Result<Stepper> stepper = Stepper::create(*session, {});
    ASSERT_TRUE(stepper.ok());
    EXPECT_EQ(stepper->run(7, kAnyTime_s, latch_, report_), 7);
    EXPECT_EQ(stepper->run(7, 0.0, latch_, report_), 1);
    EXPECT_EQ(stepper->run(0, 0.0, latch_, report_), 0);
    EXPECT_EQ(stepper->steps(), 8U);
    EXPECT_EQ(session->simulation->steps(), 8U);
}

TEST_F(StepperTest, ARecordingReplaysBitForBit) {
    const auto session = open();
    ASSERT_TRUE(session);
    record(*session, 200);
    const std::uint64_t hash = session->simulation->state_hash();
    ASSERT_TRUE(session->apply(StartAgain{}).ok());
    Result<Stepper> replay = Stepper::create(*session, {.replay = tape()});
    ASSERT_TRUE(replay.ok()) << replay.error().message;
    replay->run(1000, kAnyTime_s, latch_, report_);
    EXPECT_EQ(replay->steps(), 200U);
    EXPECT_EQ(replay->divergence(), "");
    EXPECT_EQ(session->simulation->state_hash(), hash);
}

// EXPERIENCE E9
TEST_F(StepperTest, ADivergenceNamesItsFirstStepAndTheBody) {
    const auto session = open();
    ASSERT_TRUE(session);
    record(*session, 200);
    ASSERT_TRUE(session->apply(StartAgain{}).ok());
    Result<Stepper> replay = Stepper::create(*session, {.replay = tape()});
    ASSERT_TRUE(replay.ok());
    replay->run(82, kAnyTime_s, latch_, report_);
    scene::Simulation& simulation = *session->simulation;
    const physics::BodyId body =
        simulation.registry.get<scene::BodyRef>(simulation.find("two")).body;
    simulation.physics.set_velocity(body, {1e-3_r, 0, 0}, {});
    replay->run(118, kAnyTime_s, latch_, report_);
    EXPECT_NE(replay->divergence().find("differs from its recording first after step 83: state "),
              std::string::npos)
        << replay->divergence();
    EXPECT_NE(replay->divergence().find("here; entity two (scene.toml:9) is elsewhere"),
              std::string::npos)
        << replay->divergence();
}

// A reload makes another scene of it: what was recorded before does not lead here.
TEST_F(StepperTest, AfterAReloadTheRecordingBeginsAnew) {
    const auto session = open();
    ASSERT_TRUE(session);
    Result<Stepper> stepper = Stepper::create(*session, {});
    ASSERT_TRUE(stepper.ok());
    stepper->run(50, kAnyTime_s, latch_, report_);
    folder_.write("scene.toml", kTwoCubes + "# another\n");
    ASSERT_TRUE(session->reload().ok());
    stepper->begin_anew();
    stepper->run(90, kAnyTime_s, latch_, report_);
    ASSERT_TRUE(stepper->save_recording(tape()).ok());
    const std::uint64_t hash = session->simulation->state_hash();

    ASSERT_TRUE(session->apply(StartAgain{}).ok());
    Result<Stepper> replay = Stepper::create(*session, {.replay = tape()});
    ASSERT_TRUE(replay.ok()) << replay.error().message;
    replay->run(1000, kAnyTime_s, latch_, report_);
    EXPECT_EQ(replay->steps(), 90U);
    EXPECT_EQ(replay->divergence(), "");
    EXPECT_EQ(session->simulation->state_hash(), hash);
}

/// The file's first model.
scene::PlayingModel& playing_in(const Session& session) {
    for (auto [entity, playing] : session.simulation->registry.view<scene::PlayingModel>())
        return playing;
    throw std::logic_error("a scene with a model that plays");
}

// What is done in the menu, in the accuracy panel and with the bar of an animation, between the steps.
TEST_F(StepperTest, ARecordingKeepsWhatTheMenuAndThePanelsChange) {
    assets::test::TriangleFile sled;
    sled.json["nodes"] = {{{"mesh", 0}, {"name", "plate"}}};
    sled.slide(0);
    folder_.write("sled.glb", sled.glb());
    folder_.write("scene.toml",
                  "[sun]\n[time]\nhour = 9\n" + kTwoCubes +
                      "[[entity]]\nname = \"sled\"\nmodel = \"sled.glb\"\n"
                      "[entity.body]\nkind = \"kinematic\"\n");
    const study::Setting other{.solver = physics::Solver::BulletSi,
                               .step_hz = 120,
                               .substeps = 1,
                               .substeps_max = 1,
                               .iterations = 20};
    const std::vector<std::pair<int, WorldRequest>> asked{
        {20, SwitchEffect{"lamps", true}},
        {20, SetHour{21.5}},
        {35, SetFog{.density_scale = 2, .color = 3}},
        {50, SetAccuracy{other}},
        {80, SetAnimation{.time_s = 0.5}},
        {100, StartAgain{}},
        {100, SetLight{0.5F}},
        {120, SetAnimation{.time_s = 0.75, .paused = true}},
        {130, SwitchEffect{"fog", true}}};
    const auto play = [&](Session& session, Stepper& stepper) {
        for (const auto& [step, request] : asked) {
            stepper.run(step - static_cast<int>(stepper.steps()), kAnyTime_s, latch_, report_);
            EXPECT_TRUE(stepper.apply(request).ok());
        }
        EXPECT_EQ(session.accuracy(), other) << "which starting again keeps";
        return session.simulation->state_hash();
    };
    const auto session = open();
    ASSERT_TRUE(session);
    Result<Stepper> stepper = Stepper::create(*session, {});
    ASSERT_TRUE(stepper.ok());
    const std::uint64_t hash = play(*session, *stepper);
    ASSERT_TRUE(stepper->save_recording(tape()).ok());

    const auto again = open();
    ASSERT_TRUE(again);
    Result<Stepper> replay = Stepper::create(*again, {.replay = tape()});
    ASSERT_TRUE(replay.ok()) << replay.error().message;
    EXPECT_FALSE(replay->apply(SetHour{3}).ok()) << "the scene stays as it was recorded";
    replay->run(1000, kAnyTime_s, latch_, report_);
    EXPECT_EQ(replay->steps(), 130U);
    EXPECT_EQ(replay->divergence(), "");
    EXPECT_EQ(again->simulation->state_hash(), hash);
    EXPECT_EQ(again->accuracy(), other);
    EXPECT_EQ(again->simulation->switches.light_scale, 0.5F);
    EXPECT_TRUE(again->simulation->switches.is_on("fog", false)) << "after the last step";
    EXPECT_EQ(playing_in(*again).time_s, 0.75);
    EXPECT_EQ(hour_of(*again->simulation), hour_of(*session->simulation));
}

}  // namespace
}  // namespace plumbline::app
