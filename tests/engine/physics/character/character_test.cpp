#include "engine/physics/character.h"

#include "tests/engine/physics/character/character_stage.h"

namespace plumbline::physics {
namespace {

TEST(Character, CrouchesSmoothlyAndStandsUpAgain) {
    Stage stage;
    stage.ground();
    stage.enter({0, 0, 0});
    stage.rest(0.2_r);
    Real eye = stage.person->state().eye_position_m.y;
    EXPECT_NEAR(eye, 1.65, 1e-3);
    for (int i = 0; i < 60; ++i) {
        stage.step({.crouch = i < 30});
        const Real now = stage.person->state().eye_position_m.y;
        ASSERT_LT(std::abs(now - eye), 0.7_r / 0.18_r * stage.dt + 1e-4_r);
        eye = now;
        if (i == 29) {
            EXPECT_NEAR(eye, 0.95, 1e-3);
        }
    }
    EXPECT_NEAR(eye, 1.65, 1e-3);
    EXPECT_FALSE(stage.person->state().crouched);
}

}  // namespace
}  // namespace plumbline::physics
