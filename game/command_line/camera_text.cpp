#include "game/command_line/camera_text.h"

#include <array>
#include <cmath>
#include <sstream>

namespace plumbline::game {
namespace {

constexpr Real kEyeHeight_m = 1.65_r;

scene::ViewPoint view_of(const Vec3& eye_m, const Quat& orientation, Real fov_y_rad) {
    scene::ViewPoint view;
    view.world_from_camera = {.position = eye_m, .orientation = orientation};
    const Vec3 hand_offset{0.25_r, -0.3_r, -0.2_r};
    view.world_from_hand = {.position = eye_m + orientation * hand_offset,
                            .orientation = orientation};
    view.fov_y_rad = fov_y_rad;
    return view;
}

Quat looking(Real yaw_rad, Real pitch_rad) {
    return glm::angleAxis(yaw_rad, Vec3{0, 1, 0}) * glm::angleAxis(pitch_rad, Vec3{1, 0, 0});
}

}  // namespace

std::optional<scene::ViewPoint> parse_camera(const std::string& text, Real fov_y_rad) {
    std::istringstream stream(text);
    stream.imbue(std::locale::classic());
    std::array<double, 5> numbers{};
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        char comma = ',';
        if (i > 0) stream >> comma;
        if (!(stream >> numbers[i]) || comma != ',' || !std::isfinite(numbers[i]))
            return std::nullopt;
    }
    if (stream.peek() != std::istringstream::traits_type::eof()) return std::nullopt;
    const auto real = [&](std::size_t i) { return static_cast<Real>(numbers[i]); };
    return view_of(Vec3{real(0), real(1), real(2)},
                   looking(radians_from_degrees(real(3)), radians_from_degrees(real(4))),
                   fov_y_rad);
}

scene::ViewPoint view_at(const Pose& world_from_camera, Real fov_y_rad) {
    return view_of(world_from_camera.position, world_from_camera.orientation, fov_y_rad);
}

scene::ViewPoint view_from(const Vec3& eye_m, const Vec3& target_m, Real fov_y_rad) {
    const Vec3 ahead = normalize_or(target_m - eye_m, Vec3{0, 0, -1});
    const Real yaw_rad = std::atan2(-ahead.x, -ahead.z);
    const Real pitch_rad = std::asin(glm::clamp(ahead.y, Real{-1}, Real{1}));
    return view_of(eye_m, looking(yaw_rad, pitch_rad), fov_y_rad);
}

scene::ViewPoint first_view(const scene::SceneDescription& scene) {
    if (scene.viewer) {
        const Pose camera = scene::camera_pose(scene.camera);
        return view_of(camera.position, camera.orientation, scene.camera.fov_y_rad);
    }
    if (scene.has_camera || !scene.player) {
        return view_from(scene.camera.position_m, scene.camera.target_m, scene.camera.fov_y_rad);
    }
    const scene::PlayerDescription& player = *scene.player;
    return view_of(player.feet_position_m + Vec3{0, kEyeHeight_m, 0},
                   looking(player.yaw_rad, player.pitch_rad),
                   radians_from_degrees(70.0_r));
}

}  // namespace plumbline::game
