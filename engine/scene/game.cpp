#include "engine/scene/game.h"

namespace plumbline::scene {

Pose camera_pose(const CameraDescription& camera) {
    const Vec3 direction =
        normalize_or(camera.target_m - camera.position_m, Vec3{Real{0}, Real{0}, Real{-1}});
    // Straight up or down, any direction may serve as the image's top.
    const bool is_steep = std::abs(glm::dot(direction, camera.up)) > kSteepUp;
    const Vec3 up = is_steep ? Vec3{0, 0, -1} : camera.up;
    return {.position = camera.position_m, .orientation = glm::quatLookAt(direction, up)};
}

NoGame::NoGame(const CameraDescription& camera) {
    view_.world_from_camera = camera_pose(camera);
    const Pose camera_from_hand{.position = {0.25_r, -0.3_r, -0.2_r}};
    view_.world_from_hand = compose(view_.world_from_camera, camera_from_hand);
    view_.fov_y_rad = camera.fov_y_rad;
}

ViewPoint NoGame::view(const Simulation&, Real blend, float, float) const {
    ViewPoint view = view_;
    view.blend = blend;
    return view;
}

}  // namespace plumbline::scene
