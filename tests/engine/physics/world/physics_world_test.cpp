#include "engine/physics/physics_world.h"

#include <gtest/gtest.h>

namespace plumbline::physics {
namespace {

TEST(SolverNames, UnknownIsNone) {
    EXPECT_EQ(solver_from_name("bullet_lemke"), std::nullopt);
}

}  // namespace
}  // namespace plumbline::physics
