#include "engine/physics/character/character_state.h"
#include "tests/engine/physics/character/character_stage.h"

namespace plumbline::physics {
namespace {

TEST(PlaneSet, LimitsAWayByTheRoomInFrontOfEachPlane) {
    PlaneSet planes;
    planes.add({.normal = {-1, 0, 0}, .room_m = 0.25_r});
    EXPECT_EQ(planes.limited({0.2_r, 1, 0}), (Vec3{0.2_r, 1, 0})) << "short of it";
    EXPECT_EQ(planes.limited({-5, 0, 0}), (Vec3{-5, 0, 0})) << "away from it";
    EXPECT_NEAR(glm::distance(planes.limited({1, 1, 0}), Vec3{0.25_r, 1, 0}), 0, 1e-6)
        << "along it";
    // A crease of two walls leaves only its own direction.
    planes.add({.normal = {0, 0, -1}, .room_m = 0});
    EXPECT_NEAR(glm::distance(planes.limited({1, 2, 1}), Vec3{0.25_r, 2, 0}), 0, 1e-6);
    // A floor and a ceiling in that corner leave nothing.
    planes.add({.normal = {0, -1, 0}, .room_m = 0});
    EXPECT_EQ(planes.limited({1, 2, 1}), (Vec3{0, 0, 0}));
}

TEST(PlaneSet, RoomIsUsedUpOnce) {
    PlaneSet planes;
    planes.add({.normal = {-1, 0, 0}, .room_m = 0.5_r});
    planes.consume({0.3_r, 4, 0});
    EXPECT_NEAR(planes.limited({1, 0, 0}).x, 0.2, 1e-6);
    planes.consume({-3, 0, 0});
    EXPECT_NEAR(planes.limited({1, 0, 0}).x, 0.2, 1e-6) << "going back gives none";
    planes.add({.normal = {-1, 0, 0}, .room_m = 0.05_r});
    EXPECT_NEAR(planes.limited({1, 0, 0}).x, 0.05, 1e-6) << "the same plane, nearer";
}

}  // namespace
}  // namespace plumbline::physics
