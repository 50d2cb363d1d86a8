// The book's stages: what their comments promise.
#include "engine/physics/totals.h"
#include "engine/scene/simulation/entity_lookup.h"
#include "tests/scenarios/scene_run.h"

#include <cmath>

namespace plumbline {
namespace {

using test::SceneRun;

// SOURCES A29, A31: 8 m with 10 m/s2: sqrt(1.6) = 1.265 s, 12.65 m/s.
TEST(BookStages, TheCubeFallsInTheTimeOfTheClosedForm) {
    for (const char* stage : {"book/falling_cube.toml", "book/many_objects.toml"}) {
        for (const int hz : {60, 240}) {
            SceneRun run(stage, {.step_hz = hz});
            ASSERT_TRUE(run.simulation);
            double fastest_mps = 0;
            double landed_s = 0;
            for (int step = 1; step <= 2 * hz; ++step) {
                run.step(1);
                const physics::BodyState red = run.state("red_box");
                const double speed_mps = -static_cast<double>(red.velocity_mps.y);
                const double time_s = static_cast<double>(step) / hz;
                fastest_mps = std::max(fastest_mps, speed_mps);
                if (landed_s == 0 && speed_mps < fastest_mps - 1) landed_s = time_s;
                if (landed_s > 0) continue;
                EXPECT_NEAR(static_cast<double>(red.world_from_body.position.y),
                            10 - 5 * time_s * time_s,
                            1e-4)
                    << stage << " after " << time_s << " s";
            }
            EXPECT_NEAR(landed_s, std::sqrt(1.6), 1.0 / hz + 1e-9) << stage;
            EXPECT_NEAR(fastest_mps, std::sqrt(160.0), 10.0 / hz) << stage;
        }
    }
    SceneRun run("book/falling_cube.toml");
    ASSERT_TRUE(run.simulation);
    run.step(60 * 5);
    EXPECT_NEAR(static_cast<double>(run.state("red_box").world_from_body.position.y), 2, 0.005);
    EXPECT_FALSE(run.state("red_box").awake);
}

// SOURCES A38: the ball's middle comes to 1 m over the ground at y = 1, the cylinder stands, the
// pyramid rests on a side, the dumbbell on both balls, half a metre up.
TEST(BookStages, EveryShapeComesToRestOnTheGround) {
    SceneRun run("book/shapes.toml");
    ASSERT_TRUE(run.simulation);
    run.step(60 * 15);
    const auto height = [&](const char* name) {
        return static_cast<double>(run.state(name).world_from_body.position.y);
    };
    EXPECT_NEAR(height("ball"), 2, 0.01);
    EXPECT_NEAR(height("cylinder"), 2, 0.01);
    EXPECT_LT(height("pyramid"), 2.6);
    EXPECT_GT(height("pyramid"), 1.3);
    for (const char* name : {"ball", "cylinder", "pyramid", "dumbbell"}) {
        EXPECT_LT(static_cast<double>(glm::length(run.state(name).velocity_mps)), 0.2) << name;
        EXPECT_GT(height(name), 1.3) << name << " lies on the ground, not in it";
    }
    const physics::BodyId dumbbell =
        run.simulation->registry.get<scene::BodyRef>(run.simulation->find("dumbbell")).body;
    EXPECT_NEAR(static_cast<double>(run.simulation->physics.state(dumbbell).mass.mass_kg), 2, 1e-5);
}

// SOURCES A39.
TEST(BookStages, BoxesAndBallsPassThroughEachOtherAndBallsStayInThePlane) {
    SceneRun run("book/filters.toml");
    ASSERT_TRUE(run.simulation);
    int boxes = 0;
    int balls = 0;
    for (int step = 0; step < 60 * 5; ++step) {
        run.step(1);
        for (const physics::ContactEvent& touch : all_contacts(run.simulation->physics)) {
            const std::string a = name_of_mark(*run.simulation, touch.user_a);
            const std::string b = name_of_mark(*run.simulation, touch.user_b);
            const bool mixed = (a.starts_with("box") && b.starts_with("ball")) ||
                               (a.starts_with("ball") && b.starts_with("box"));
            ASSERT_FALSE(mixed) << a << " touches " << b << " in step " << step;
            if (a.starts_with("ball") && b.starts_with("ball")) ++balls;
            if (a.starts_with("box") && b.starts_with("box")) ++boxes;
        }
        for (int x = 0; x < 5; ++x) {
            const std::string name = "ball." + std::to_string(x) + ".4.0";
            ASSERT_EQ(run.state(name).world_from_body.position.z, 0) << name;
        }
    }
    EXPECT_GT(boxes, 0);
    EXPECT_GT(balls, 0);
    EXPECT_EQ(run.simulation->moving_bodies().size(), 50U);
}

// SOURCES A36: as the stage's file has it.
TEST(BookStages, TheRedBoxMakesTheGreenOneAppear) {
    SceneRun run("book/trigger.toml");
    ASSERT_TRUE(run.simulation);
    run.step(72);
    EXPECT_FALSE(run.simulation->registry.alive(run.simulation->find("green_box#1")));
    run.step(1);
    ASSERT_TRUE(run.simulation->registry.alive(run.simulation->find("green_box#1")));
    run.step(60 * 5);
    EXPECT_NEAR(static_cast<double>(run.state("green_box#1").world_from_body.position.y), 3, 0.01);
    EXPECT_FALSE(run.simulation->registry.alive(run.simulation->find("green_box#2")));
}

}  // namespace
}  // namespace plumbline
