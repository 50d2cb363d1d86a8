// What is compared of a scene's bodies, held against two balls that can be reckoned with.
#include "engine/study/scenes/moving_samples.h"

#include "tests/engine/study/scenes/scene_run_fixture.h"

#include <cmath>

namespace plumbline::study {
namespace {

constexpr std::string_view kTwo = R"([[entity]]
name = "light"
position_m = [0, 2, 0]
[entity.body]
kind = "dynamic"
shape = { sphere = 0.5 }
mass_kg = 1
[[entity]]
name = "heavy"
position_m = [4, 6, 0]
[entity.body]
kind = "dynamic"
shape = { sphere = 0.5 }
mass_kg = 3
[[entity]]
name = "post"
[entity.body]
kind = "static"
shape = { box = [1, 1, 1] }
)";

class MovingSamplesTest : public PlayedSceneTest {
protected:
    MovingSamples samples() { return MovingSamples(play(kTwo).simulation()); }
};

TEST_F(MovingSamplesTest, OnlyWhatMovesByItselfCounts) {
    const MovingSamples both = samples();
    EXPECT_EQ(both.bodies().size(), 2U);
    EXPECT_TRUE(both.has_others());
    SceneAnswer answer;
    both.describe(answer);
    EXPECT_EQ(answer.bodies, 2U);
    EXPECT_DOUBLE_EQ(answer.mass_kg, 4);
    EXPECT_NEAR(answer.gravity_mps2, 9.81, 1e-6);
    EXPECT_NEAR(answer.body_size_m, std::sqrt(3.0), 0.1);
}

TEST_F(MovingSamplesTest, ALayoutIsTheirCentreOfMassAndHowFarTheyLieFromIt) {
    const Layout layout = samples().moment().layout;
    EXPECT_NEAR(layout.center_m.x, 3, 1e-6);
    EXPECT_NEAR(layout.center_m.y, 5, 1e-6);
    // 3 m and 1 m to the side.
    EXPECT_NEAR(layout.spread_m, std::sqrt((9.0 + 1.0) / 2), 1e-6);
}

TEST_F(MovingSamplesTest, AShiftIsSmallAndTheSameForASeed) {
    MovingSamples first = samples();
    const Moment start = first.moment();
    first.shift(7, 1e-3);
    const Moment shifted = first.moment();
    const double away_m = glm::distance(start.bodies[0].position_m, shifted.bodies[0].position_m);
    EXPECT_GT(away_m, 1e-5);
    EXPECT_LT(away_m, 1e-3 * std::sqrt(3.0) + 1e-6);
    MovingSamples again = samples();
    again.shift(7, 1e-3);
    EXPECT_EQ(again.moment().bodies[1].position_m, shifted.bodies[1].position_m);
    MovingSamples other = samples();
    other.shift(8, 1e-3);
    EXPECT_NE(other.moment().bodies[1].position_m, shifted.bodies[1].position_m);
}

TEST(Turnover, KeepsTheLargest) {
    Trace trace;
    note_turnover(trace, {.potential_J = 10}, {.kinetic_J = 3, .potential_J = 8});
    EXPECT_DOUBLE_EQ(trace.energy_turnover_J, 3);
    note_turnover(trace, {.potential_J = 10}, {.kinetic_J = 1, .potential_J = 5});
    EXPECT_DOUBLE_EQ(trace.energy_turnover_J, 5);
    note_turnover(trace, {.potential_J = 10}, {.kinetic_J = 0, .potential_J = 10});
    EXPECT_DOUBLE_EQ(trace.energy_turnover_J, 5);
}

}  // namespace
}  // namespace plumbline::study
