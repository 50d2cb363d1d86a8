// What the book's stages do with its keys: a camera that goes by steps, a pointer that shoots, drags,
// deletes, lifts and explodes.
#include "engine/physics/query.h"
#include "tests/game/book_stage.h"

#include <cmath>

namespace plumbline::game {
namespace {

/// In degrees and metres, as the book counts them: yaw from the side of -Z.
struct OrbitPlace {
    Real yaw_deg;
    Real pitch_deg;
    Real distance_m;
};
OrbitPlace orbit_place(const Playground& play) {
    const Vec3 away = camera(play).position;
    const Real distance_m = glm::length(away);
    return {degrees_from_radians(std::atan2(-away.x, -away.z)),
            degrees_from_radians(std::asin(away.y / distance_m)),
            distance_m};
}

// SOURCES A25, A26.
TEST(Book, TurnsAboutTheObjectFromTheFirstFrameByFiveDegreesAndFiveMetres) {
    Playground play(stage());
    EXPECT_EQ(play.game->mode(), MoveMode::Orbit);
    EXPECT_NEAR(orbit_place(play).yaw_deg, 0, 1e-3);
    EXPECT_NEAR(orbit_place(play).pitch_deg, 20, 1e-3);
    EXPECT_NEAR(orbit_place(play).distance_m, 15, 1e-4);
    const auto after = [&](Action action) {
        play.step(press({action}));
        play.step();
        return orbit_place(play);
    };
    EXPECT_NEAR(after(Action::Forward).pitch_deg, 25, 1e-3) << "up";
    EXPECT_NEAR(after(Action::Back).pitch_deg, 20, 1e-3) << "down";
    EXPECT_NEAR(std::abs(after(Action::RotateLeft).yaw_deg), 5, 1e-3);
    EXPECT_NEAR(after(Action::RotateRight).yaw_deg, 0, 1e-3);
    EXPECT_NEAR(after(Action::ZoomOut).distance_m, 20, 1e-4);
    for (const Real distance_m : {15.0_r, 10.0_r, 5.0_r, 0.1_r, 0.1_r})
        EXPECT_NEAR(after(Action::ZoomIn).distance_m, distance_m, 1e-4);
    EXPECT_NEAR(after(Action::ZoomOut).distance_m, 5.1, 1e-4);
    for (int i = 0; i < 72; ++i) after(Action::RotateRight);
    EXPECT_NEAR(orbit_place(play).yaw_deg, 0, 1e-2) << "once round";
}

// SOURCES A24: what is held goes on.
TEST(Book, AHeldArrowGoesOnTenTimesASecond) {
    Playground play(stage());
    play.step(press({Action::RotateRight}));
    for (int i = 0; i < 23; ++i) play.step(hold({Action::RotateRight}));
    EXPECT_NEAR(std::abs(orbit_place(play).yaw_deg), 5, 1e-3)
        << "one press, until 0.4 s have passed";
    for (int i = 0; i < 60; ++i) play.step(hold({Action::RotateRight}));
    EXPECT_NEAR(std::abs(orbit_place(play).yaw_deg), 55, 1e-2);
}

// SOURCES A8: the up vector stands upright in the image.
TEST(Book, TheUpVectorIsUpInTheImage) {
    for (const Vec3 up :
         {Vec3{0, 1, 0}, Vec3{0, 0, 1}, Vec3{0, -1, 0}, glm::normalize(Vec3{1, 2, 3})}) {
        scene::SceneDescription scene;
        scene.camera.position_m = {10, 5, 0};
        scene.camera.target_m = {0, 0, 0};
        scene.camera.up = up;
        for (const bool orbits : {false, true}) {
            if (orbits) scene.camera.orbit.emplace();
            Playground play(scene);
            const Pose seen = camera(play);
            EXPECT_NEAR(glm::distance(seen.position, scene.camera.position_m), 0, 1e-4);
            const Vec3 forward = seen.orientation * Vec3{0, 0, -1};
            EXPECT_NEAR(glm::distance(forward, glm::normalize(Vec3{-10, -5, 0})), 0, 1e-5);
            const Vec3 right = seen.orientation * Vec3{1, 0, 0};
            EXPECT_NEAR(glm::dot(right, up), 0, 1e-5) << "no roll";
            EXPECT_GT(glm::dot(seen.orientation * Vec3{0, 1, 0}, up), 0);
        }
    }
}

// SOURCES A33.
TEST(Book, DeletesTheBodyUnderThePointerHoweverFar) {
    Playground play(stage_with({floor_at(0), loose("a", {-3, 1, 0}), loose("b", {3, 1, 40})}));
    play.step(at(play, {3, 1, 40}, press({Action::Remove})));
    EXPECT_TRUE(play.simulation->registry.alive(play.simulation->find("a")));
    EXPECT_FALSE(play.simulation->registry.alive(play.simulation->find("b")));
    play.step(at(play, {20, 0, 0}, press({Action::Remove})));
    EXPECT_TRUE(play.simulation->registry.alive(play.simulation->find("ground")));
    EXPECT_EQ(play.messages().back(), "nothing to delete");
}

// SOURCES A34: what is dragged stays as far from the eye as it was, and keeps its turn.
TEST(Book, DragsWhatIsUnderThePointerAtItsOwnDistance) {
    scene::EntityDescription far = loose("box", {0, 1, 10});
    Playground play(stage_with({floor_at(0), far}));
    const Vec3 eye = camera(play).position;
    const Vec3 corner = Vec3{0.5_r, 1.2_r, 9};  // on the face that looks at the camera
    play.step(at(play, corner, press({Action::Grab})));
    ASSERT_TRUE(play.game->holds());
    const Real distance_m = glm::distance(eye, corner);
    Vec3 point = corner;
    for (int i = 0; i < 60; ++i) {
        point += Vec3{0.05_r, 0.05_r, 0};
        play.step(at(play, point, hold({Action::Grab})));
    }
    for (int i = 0; i < 60; ++i) play.step(at(play, point, hold({Action::Grab})));
    const Vec3 wanted = eye + glm::normalize(point - eye) * distance_m - (corner - Vec3{0, 1, 10});
    EXPECT_NEAR(glm::distance(play.state("box").world_from_body.position, wanted), 0, 0.05);
    EXPECT_NEAR(std::abs(play.state("box").world_from_body.orientation.w), 1, 1e-3);
    play.step(at(play, point));
    EXPECT_FALSE(play.game->holds());
}

}  // namespace
}  // namespace plumbline::game
