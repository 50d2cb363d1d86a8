// [scene] [world] [accuracy] [player] [camera] [effects.*] and the calls for the rest.
#include "engine/core/limits.h"
#include "engine/scene/accuracy.h"
#include "engine/scene/sections/scene_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace plumbline::scene {
namespace {

// Names of effects that may carry a table of settings.
constexpr std::array<std::string_view, 19> kEffects{"sun_shadow",
                                                    "flashlight",
                                                    "fog",
                                                    "skybox",
                                                    "post",
                                                    "light_cubes",
                                                    "impact_sounds",
                                                    "rolling_sounds",
                                                    "ambient_sounds",
                                                    "footsteps",
                                                    "creak_sounds",
                                                    "wind_sound",
                                                    "sound_paths",
                                                    "room_reverb",
                                                    "continuous_collision",
                                                    "gyroscopic_torque",
                                                    "contact_events",
                                                    "grass",
                                                    "flock"};

void read_world(TableReader& root, SceneDescription& scene) {
    auto table = root.table("world");
    if (!table) return;
    table->read("gravity_mps2", scene.gravity_mps2, {-1e30, 1e30, "a finite number"});
    const Vec3d gravity(scene.gravity_mps2);
    if (glm::length(gravity) > limits::kGravity_mps2) {
        constexpr double kMost = limits::kGravity_mps2;
        table->warning("gravity_mps2", "stronger than {} m/s2; {} is used", kMost, kMost);
        scene.gravity_mps2 = Vec3(glm::normalize(gravity) * kMost);
    }
    table->read("kill_below_m", scene.kill_below_m, kCoordinate_m);
    table->read(
        "air_density_kgpm3", scene.forces.air_density_kgpm3, {0, 1e4, "kg/m3 from 0 to 10000"});
    table->read(
        "magnetic_field_T", scene.forces.magnetic_field_T, {-100, 100, "T from -100 to 100"});
    table->finish();
}

void read_player(TableReader& table, PlayerDescription& player) {
    table.read("position_m", player.feet_position_m, kCoordinate_m);
    table.read_degrees("yaw_deg", player.yaw_rad, kTurn_deg);
    table.read_degrees("pitch_deg", player.pitch_rad, {-90, 90, "degrees from -90 to 90"});
}

/// `orbit` also says where the camera stands, as seen from the target: yaw_deg about +Y from the side
/// of -Z, pitch_deg above the horizon. What it leaves open is as position_m says.
void read_orbit(TableReader& table, OrbitDescription& orbit, CameraDescription& camera) {
    table.read_degrees("step_deg", orbit.step_rad, {0.1, 90, "degrees from 0.1 to 90"});
    table.read("step_m", orbit.step_m, {1e-3, 100, "a length from 0.001 to 100 m"});
    if (!table.has("distance_m") && !table.has("pitch_deg") && !table.has("yaw_deg")) return;
    const Quat world_from_upright = upright(camera.up);
    const Vec3 away = glm::conjugate(world_from_upright) * (camera.position_m - camera.target_m);
    Real distance_m = glm::length(away);
    const Real height = distance_m > 0 ? std::clamp(away.y / distance_m, Real{-1}, Real{1}) : 0;
    Real pitch_rad = portable_asin(height);
    Real yaw_rad = portable_atan2(-away.x, -away.z);
    table.read("distance_m", distance_m, {0.1, 500, "a length from 0.1 to 500 m"});
    table.read_degrees("pitch_deg", pitch_rad, {-89, 89, "degrees from -89 to 89"});
    table.read_degrees("yaw_deg", yaw_rad, kTurn_deg);
    const Vec3 direction{-portable_sin(yaw_rad) * portable_cos(pitch_rad),
                         portable_sin(pitch_rad),
                         -portable_cos(yaw_rad) * portable_cos(pitch_rad)};
    camera.position_m = camera.target_m + world_from_upright * direction * distance_m;
}

void read_camera(TableReader& root, SceneDescription& scene) {
    auto table = root.table("camera");
    if (!table) return;
    constexpr Range kPlane_m{1e-3, 1e6, "a length from 0.001 to 1000000 m"};
    CameraDescription& camera = scene.camera;
    table->read_color("clear_color", scene.camera.clear_color);
    // [camera] with nothing but a clear colour places no camera.
    scene.has_camera = table->has("position_m") || table->has("target_m") || table->has("orbit");
    table->read("position_m", camera.position_m, kCoordinate_m);
    table->read("target_m", camera.target_m, kCoordinate_m);
    table->read_direction("up", camera.up);
    table->read_table("orbit", camera.orbit, read_orbit, camera);
    table->read_table("focus", camera.focus, read_focus);
    table->read_degrees("fov_deg", camera.fov_y_rad, {1, 170, "degrees from 1 to 170"});
    table->read("near_m", camera.near_m, kPlane_m);
    table->read("far_m", camera.far_m, kPlane_m);
    if (camera.near_m >= camera.far_m)
        table->error("near_m", "{} m is not before far_m, {} m", camera.near_m, camera.far_m);
    if (glm::distance(camera.position_m, camera.target_m) < 1e-6_r)
        table->error("target_m", "is where the camera is; expected another point");
    const Vec3 forward = normalize_or(camera.target_m - camera.position_m, Vec3{0, 0, -1});
    if (table->has("up") && std::abs(glm::dot(forward, camera.up)) > kSteepUp)
        table->error("up", "lies along the line of sight; expected another direction");
    table->finish();
}

void read_acoustics(TableReader& table, AcousticsDescription& acoustics) {
    table.read("paths", acoustics.paths);
    table.read("reverb", acoustics.reverb);
}

void read_effects(TableReader& root, SceneDescription& scene) {
    auto table = root.table("effects");
    if (!table) return;
    for (const std::string_view name : kEffects) {
        auto settings = table->table(name);
        if (!settings) continue;
        settings->finish();  // none of them has settings so far
        scene.effect_settings.emplace(name, settings->location());
    }
    for (const std::string_view name : effects_with_fidelity()) {
        auto settings = table->table(name);
        if (!settings) continue;
        read_fidelity(*settings, *fidelity_of(scene, name));
        settings->finish();
        scene.effect_settings.emplace(name, settings->location());
    }
    table->finish();
}

/// A number of threads, or "auto".
std::optional<int> read_threads(TableReader& table) {
    const TomlNode* node = table.find("threads");
    if (node == nullptr) return {};
    if (const std::string* text = node->text(); text != nullptr && *text == "auto")
        return kAutoThreads;
    if (!std::holds_alternative<std::int64_t>(node->value)) {
        table.error("threads",
                    "{}; expected \"auto\" or a whole number from 1 to {}",
                    found(*node),
                    kMostThreads);
        return {};
    }
    int threads = 1;
    table.read("threads", threads, 1, kMostThreads);
    return threads;
}

Accuracy read_accuracy(TableReader& table) {
    std::vector<std::string_view> names;
    for (const Preset& preset : presets()) names.push_back(preset.name);
    std::size_t chosen = 1;  // balanced
    table.read_choice("preset", chosen, names);
    const Preset& preset = presets()[chosen];

    Accuracy accuracy;
    accuracy.preset = preset.name;
    accuracy.step_hz = preset.step_hz;
    table.read("step_hz", accuracy.step_hz, limits::kStepHzMin, limits::kStepHzMax);
    table.read("substeps", accuracy.substeps, 1, kMostSubsteps);
    table.read("substeps_max", accuracy.substeps_max, 1, kMostSubsteps);
    table.read("iterations", accuracy.iterations, 1, kMostIterations);
    table.read("tolerance", accuracy.tolerance, {1e-9, 1, "a relative error above 0, up to 1"});
    table.read("budget_ms", accuracy.budget_ms, {1e-6, 1e6, "a time above 0 ms, up to 1000000 ms"});
    if (accuracy.tolerance && accuracy.budget_ms)
        table.error("budget_ms", "is a second wish beside tolerance; expected one of the two");
    accuracy.step_hz_given = table.has("step_hz");
    accuracy.solver_given = table.has("solver");

    std::array<std::string_view, physics::kSolvers.size()> solver_names{};
    std::ranges::transform(physics::kSolvers, solver_names.begin(), physics::solver_name);
    std::size_t solver = 0;
    table.read_choice("solver", solver, solver_names);
    accuracy.solver = physics::kSolvers[solver];
    table.read_choice("joints", accuracy.joints, {"direct", "iterative"});
    accuracy.threads = read_threads(table);
    if (accuracy.substeps && accuracy.substeps_max && *accuracy.substeps > *accuracy.substeps_max) {
        table.error("substeps_max",
                    "{} is below substeps = {}; expected at least as many",
                    *accuracy.substeps_max,
                    *accuracy.substeps);
    }
    return accuracy;
}

}  // namespace

const Result<Reference>& LoadContext::reference(const TomlNode& node) const {
    const std::pair<std::string, std::string> key(file_of(node.location), *node.text());
    const auto known = references.find(key);
    if (known != references.end()) return known->second;
    return references.emplace(key, find_reference(key.first, assets_folder, key.second))
        .first->second;
}

void read_sections(TableReader& root, SceneDescription& scene, LoadContext& context) {
    if (auto table = root.table("scene")) {
        table->read("title", scene.title);
        table->read("description", scene.description);
        table->read("controls", scene.controls);
        for (const char* followed_before : {"include", "base", "without"})
            table->find(followed_before);
        table->finish();
    }
    read_world(root, scene);
    if (auto table = root.table("accuracy")) {
        scene.accuracy = read_accuracy(*table);
        table->finish();
    }
    root.read_table("player", scene.player, read_player);
    read_camera(root, scene);
    read_lights_and_air(root, scene, context);
    root.read_table("sound", scene.acoustics, read_acoustics);
    read_effects(root, scene);
    read_fields(root, scene);
}

}  // namespace plumbline::scene
