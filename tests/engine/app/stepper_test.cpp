#include "engine/app/stepper.h"

#include "engine/core/io/files.h"
#include "tests/engine/app/session_fixture.h"

#include <fmt/format.h>

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
    ASSERT_TRUE(session->reset().ok());
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
    ASSERT_TRUE(session->reset().ok());
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

    ASSERT_TRUE(session->reset().ok());
    Result<Stepper> replay = Stepper::create(*session, {.replay = tape()});
    ASSERT_TRUE(replay.ok()) << replay.error().message;
    replay->run(1000, kAnyTime_s, latch_, report_);
    EXPECT_EQ(replay->steps(), 90U);
    EXPECT_EQ(replay->divergence(), "");
    EXPECT_EQ(session->simulation->state_hash(), hash);
}

}  // namespace
}  // namespace plumbline::app
