// Vehicles against closed forms: braking distance, acceleration, the circle they steer, and standing on a slope.
#include "engine/effects/effect_runtime.h"
#include "tests/engine/effects/drawn.h"
#include "tests/support/cart.h"

#include <cmath>

namespace plumbline::effects {
namespace {

constexpr double kGravity_mps2 = 9.81;

scene::VehicleControls& controls(scene::SceneDescription& scene) {
    return scene.forces.vehicles.front().controls;
}

TEST(Vehicles, LockedWheelsStopWithinTheBrakingDistance) {
    scene::SceneDescription scene = test::cart_at(10);
    controls(scene).brake = 1;
    test::Running run(scene);
    EffectRuntime effects(*run, {});
    run.step(120, effects);
    const double asked_m = 100 / (2 * 0.9 * kGravity_mps2);
    EXPECT_NEAR(static_cast<double>(-run.state("chassis").world_from_body.position.z),
                asked_m,
                0.005 * asked_m);
}

TEST(Vehicles, ThrottleGivesItsTorqueAtAnySpeed) {
    scene::SceneDescription scene = test::cart_at(0);
    controls(scene).throttle = 1;
    test::Running run(scene);
    EffectRuntime effects(*run, {});
    run.step(120, effects);
    // Half of a wheel's mass turns with it.
    const double asked_mps = 2 * (300 / 0.35) / (test::kCart_kg + 4 * 5);
    EXPECT_NEAR(
        static_cast<double>(-run.state("chassis").velocity_mps.z), asked_mps, 0.005 * asked_mps);
}

TEST(Vehicles, SteerTheCircleOfTheirWheelbase) {
    scene::SceneDescription scene = test::cart_at(2);
    controls(scene).steer_rad = 0.2;
    test::Running run(scene);
    EffectRuntime effects(*run, {});
    run.step(60, effects);
    const physics::BodyState state = run.state("chassis");
    const Vec3d rear = Vec3d(state.world_from_body.orientation * Vec3{0, 0, 1.2_r});
    const Vec3d speed_mps =
        Vec3d(state.velocity_mps) + glm::cross(Vec3d(state.angular_velocity_radps), rear);
    const double radius_m =
        glm::length(speed_mps) / static_cast<double>(state.angular_velocity_radps.y);
    const double asked_m = test::kWheelbase_m / std::tan(0.2);
    EXPECT_NEAR(radius_m, asked_m, 0.005 * asked_m);
}

TEST(Vehicles, StandOnASlopeAndFallAsleep) {
    scene::SceneDescription scene = test::cart_at(0);
    const Real slope_rad = 0.1745329_r;
    scene.gravity_mps2 =
        Vec3{0, -std::cos(slope_rad), std::sin(slope_rad)} * static_cast<Real>(kGravity_mps2);
    controls(scene).brake = 1;
    test::Running run(scene);
    EffectRuntime effects(*run, {});
    run.step(120, effects);
    const Vec3 settled = run.state("chassis").world_from_body.position;
    run.step(600, effects);
    EXPECT_LT(glm::distance(run.state("chassis").world_from_body.position, settled), 1e-3);
    EXPECT_FALSE(run.state("chassis").awake);
}

TEST(Vehicles, WheelsTurnToTheSideNoFasterThanTheySteer) {
    test::Running run(test::cart_at(0));
    EffectRuntime effects(*run, {});
    run->vehicles().front().controls.steer_rad = 0.5;
    const auto turn_rad = [&run] {
        return run->physics.joint(run->vehicles().front().wheels[0].strut).def.motor->turn_rad;
    };
    run.step(1, effects);
    EXPECT_NEAR(static_cast<double>(turn_rad()), 1.2 / 60, 1e-5);
    run.step(60, effects);
    EXPECT_GT(static_cast<double>(turn_rad()), 0.5) << "the inner wheel";
}

TEST(Vehicles, StandStillWhileTheyAreCalledOff) {
    test::Running run(test::cart_at(3));
    EffectRuntime effects(*run, {});
    run.step(10, effects);
    run->switches.turn("vehicles", false);
    run.step(30, effects);
    const double stopped_m = static_cast<double>(run.state("chassis").world_from_body.position.z);
    run.step(60, effects);
    EXPECT_NEAR(
        static_cast<double>(run.state("chassis").world_from_body.position.z), stopped_m, 1e-3);
}

}  // namespace
}  // namespace plumbline::effects
