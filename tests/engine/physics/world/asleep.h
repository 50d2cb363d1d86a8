// A tower that sleeps.
#pragma once

#include "engine/physics/totals.h"
#include "tests/engine/physics/test_world.h"

#include <vector>

namespace plumbline::physics {

/// A tower of boxes on the ground, run until it sleeps.
struct Asleep {
    TestWorld test{in_small_steps()};
    BodyId ground;
    std::vector<BodyId> tower;

    explicit Asleep(int height = 3, const BodyDef& def = {.kind = BodyKind::Dynamic})
        : ground(test.ground()) {
        for (int i = 0; i < height; ++i) {
            tower.push_back(test.add(BoxShape{}, {0, 0.5_r + static_cast<Real>(i), 0}, def));
        }
        test.run(2.0);
        EXPECT_EQ(awake_count(test.world), 0U);
    }
    std::size_t awake_after_a_step() {
        test.world.step();
        return awake_count(test.world);
    }
};

}  // namespace plumbline::physics
