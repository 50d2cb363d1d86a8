// [scene] [world] [accuracy] [player] [camera] [effects.*] and the calls for the rest.
#include "engine/core/limits.h"
#include "engine/core/text/nearest_name.h"
#include "engine/scene/accuracy.h"
#include "engine/scene/sections/scene_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace plumbline::scene {
namespace {

constexpr Range kYaw_deg{-36'000, 36'000, "degrees from -36000 to 36000"};
constexpr Range kPitch_deg{-90, 90, "degrees from -90 to 90"};

// Names of effects that may carry a table of settings.
constexpr std::array<std::string_view, 20> kEffects{"sun_shadow",
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
                                                    "wind",
                                                    "grass",
                                                    "flock"};
constexpr std::array<std::string_view, 6> kEffectsToCome{
    "buoyancy", "drag", "magnets", "explosions", "fracture", "conveyor"};

void read_world(TableReader& root, SceneDescription& scene) {
    auto table = root.table("world");
    if (!table) return;
    constexpr Range kPart{-1e30, 1e30, "a finite number"};
    scene.gravity_mps2 = table->vector("gravity_mps2", scene.gravity_mps2, kPart);
    const Vec3d gravity(scene.gravity_mps2);
    if (glm::length(gravity) > limits::kGravity_mps2) {
        table->warning(
            "gravity_mps2",
            fmt::format(
                "stronger than {} m/s2; {} is used", limits::kGravity_mps2, limits::kGravity_mps2));
        scene.gravity_mps2 = Vec3(glm::normalize(gravity) * limits::kGravity_mps2);
    }
    scene.kill_below_m = table->optional_number("kill_below_m", kCoordinate_m);
    table->finish();
}

void read_player(TableReader& root, SceneDescription& scene) {
    auto table = root.table("player");
    if (!table) return;
    PlayerDescription player;
    player.location = table->location();
    player.feet_position_m = table->vector("position_m", player.feet_position_m, kCoordinate_m);
    player.yaw_rad = radians_from_degrees(table->number("yaw_deg", Real{0}, kYaw_deg));
    player.pitch_rad = radians_from_degrees(table->number("pitch_deg", Real{0}, kPitch_deg));
    table->finish();
    scene.player = player;
}

/// `orbit` also says where the camera stands, as seen from the target: yaw_deg about +Y from the side
/// of -Z, pitch_deg above the horizon. What it leaves open is as position_m says.
void read_orbit(TableReader& camera_table, CameraDescription& camera) {
    auto table = camera_table.table("orbit");
    if (!table) return;
    constexpr Range kDistance_m{0.1, 500, "a length from 0.1 to 500 m"};
    constexpr Range kSteepness_deg{-89, 89, "degrees from -89 to 89"};
    constexpr Range kStep_deg{0.1, 90, "degrees from 0.1 to 90"};
    constexpr Range kStep_m{1e-3, 100, "a length from 0.001 to 100 m"};
    OrbitDescription orbit;
    orbit.step_rad = radians_from_degrees(
        table->number("step_deg", degrees_from_radians(orbit.step_rad), kStep_deg));
    orbit.step_m = table->number("step_m", orbit.step_m, kStep_m);
    if (table->has("distance_m") || table->has("pitch_deg") || table->has("yaw_deg")) {
        const Quat world_from_upright = upright(camera.up);
        const Vec3 away =
            glm::conjugate(world_from_upright) * (camera.position_m - camera.target_m);
        const Real length_m = glm::length(away);
        const Real height = length_m > 0 ? std::clamp(away.y / length_m, Real{-1}, Real{1}) : 0;
        const Real distance_m = table->number("distance_m", length_m, kDistance_m);
        const Real pitch_rad = radians_from_degrees(table->number(
            "pitch_deg", degrees_from_radians(portable_asin(height)), kSteepness_deg));
        const Real yaw_rad = radians_from_degrees(table->number(
            "yaw_deg", degrees_from_radians(portable_atan2(-away.x, -away.z)), kYaw_deg));
        const Vec3 direction{-portable_sin(yaw_rad) * portable_cos(pitch_rad),
                             portable_sin(pitch_rad),
                             -portable_cos(yaw_rad) * portable_cos(pitch_rad)};
        camera.position_m = camera.target_m + world_from_upright * direction * distance_m;
    }
    table->finish();
    camera.orbit = orbit;
}

void read_camera(TableReader& root, SceneDescription& scene) {
    auto table = root.table("camera");
    if (!table) return;
    constexpr Range kFov_deg{1, 170, "degrees from 1 to 170"};
    constexpr Range kPlane_m{1e-3, 1e6, "a length from 0.001 to 1000000 m"};
    CameraDescription& camera = scene.camera;
    scene.clear_color = table->color("clear_color", scene.clear_color);
    // [camera] with nothing but a clear colour places no camera.
    scene.has_camera = table->has("position_m") || table->has("target_m") || table->has("orbit");
    camera.position_m = table->vector("position_m", camera.position_m, kCoordinate_m);
    camera.target_m = table->vector("target_m", camera.target_m, kCoordinate_m);
    camera.up = Vec3(table->direction("up", Vec3d(camera.up)));
    read_orbit(*table, camera);
    camera.focus = read_focus(*table);
    camera.fov_y_rad = radians_from_degrees(
        table->number("fov_deg", degrees_from_radians(camera.fov_y_rad), kFov_deg));
    camera.near_m = table->number("near_m", camera.near_m, kPlane_m);
    camera.far_m = table->number("far_m", camera.far_m, kPlane_m);
    if (camera.near_m >= camera.far_m) {
        table->error("near_m",
                     fmt::format("{} m is not before far_m, {} m", camera.near_m, camera.far_m));
    }
    if (glm::distance(camera.position_m, camera.target_m) < 1e-6_r)
        table->error("target_m", "is where the camera is; expected another point");
    const Vec3 forward = normalize_or(camera.target_m - camera.position_m, Vec3{0, 0, -1});
    if (table->has("up") && std::abs(glm::dot(forward, camera.up)) > kSteepUp)
        table->error("up", "lies along the line of sight; expected another direction");
    table->finish();
}

void read_acoustics(TableReader& root, SceneDescription& scene) {
    auto table = root.table("sound");
    if (!table) return;
    AcousticsDescription acoustics;
    acoustics.location = table->location();
    acoustics.paths = table->flag("paths", acoustics.paths);
    acoustics.reverb = table->flag("reverb", acoustics.reverb);
    table->finish();
    scene.acoustics = acoustics;
}

void read_effects(TableReader& root, SceneDescription& scene, LoadContext& context) {
    auto table = root.table("effects");
    if (!table) return;
    for (const std::string_view name : kEffects) {
        auto settings = table->table(name);
        if (!settings) continue;
        settings->finish();  // none of them has settings so far
        scene.effect_settings.emplace(name, settings->location());
    }
    const std::array<std::pair<std::string_view, Fidelity*>, 5> with_fidelity{
        {{"fountain", &scene.fountain_fidelity},
         {"ambient_occlusion", &scene.screen_fidelity.occlusion},
         {"sun_shafts", &scene.screen_fidelity.shafts},
         {"depth_of_field", &scene.screen_fidelity.focus},
         {"motion_blur", &scene.screen_fidelity.shutter}}};
    for (const auto& [name, fidelity] : with_fidelity) {
        auto settings = table->table(name);
        if (!settings) continue;
        *fidelity = read_fidelity(*settings);
        settings->finish();
        scene.effect_settings.emplace(name, settings->location());
    }
    for (const std::string_view name : kEffectsToCome) {
        auto settings = table->table(name);
        if (settings)
            context.note_not_built(settings->location(), fmt::format("[effects.{}]", name));
    }
    table->finish();
}

}  // namespace

void LoadContext::note_not_built(const SourceLocation& location, std::string what) {
    if (not_built.empty()) not_built_location = location;
    not_built.push_back(std::move(what));
}

const Result<Reference>& LoadContext::reference(const TomlNode& node) const {
    const std::pair<std::string, std::string> key(file_of(node.location), *node.text());
    const auto known = references.find(key);
    if (known != references.end()) return known->second;
    return references.emplace(key, find_reference(key.first, assets_folder, key.second))
        .first->second;
}

namespace {

std::optional<int> optional_integer(TableReader& table, std::string_view key, int most) {
    if (!table.has(key)) return {};
    return table.integer(key, 1, 1, most);
}

}  // namespace

Accuracy read_accuracy(TableReader& table) {
    std::vector<std::string_view> names;
    for (const Preset& preset : presets()) names.push_back(preset.name);
    constexpr std::size_t kBalanced = 1;
    const Preset& preset = presets()[table.choice("preset", kBalanced, names)];

    Accuracy accuracy;
    accuracy.preset = preset.name;
    accuracy.step_hz =
        table.integer("step_hz", preset.step_hz, limits::kStepHzMin, limits::kStepHzMax);
    accuracy.substeps = optional_integer(table, "substeps", kMostSubsteps);
    accuracy.substeps_max = optional_integer(table, "substeps_max", kMostSubsteps);
    accuracy.iterations = optional_integer(table, "iterations", kMostIterations);
    constexpr Range kTolerance{1e-9, 1, "a relative error above 0, up to 1"};
    if (const auto tolerance = table.optional_number("tolerance", kTolerance))
        accuracy.tolerance = static_cast<double>(*tolerance);
    constexpr Range kBudget_ms{1e-6, 1e6, "a time above 0 ms, up to 1000000 ms"};
    if (const auto budget_ms = table.optional_number("budget_ms", kBudget_ms))
        accuracy.budget_ms = static_cast<double>(*budget_ms);
    if (accuracy.tolerance && accuracy.budget_ms)
        table.error("budget_ms", "is a second wish beside tolerance; expected one of the two");
    accuracy.step_hz_given = table.has("step_hz");
    accuracy.solver_given = table.has("solver");

    std::array<std::string_view, physics::kSolvers.size()> solver_names{};
    std::ranges::transform(physics::kSolvers, solver_names.begin(), physics::solver_name);
    accuracy.solver = physics::kSolvers[table.choice("solver", 0, solver_names)];
    constexpr std::array<std::string_view, 2> kMethods{"direct", "iterative"};
    accuracy.joints = static_cast<physics::JointMethod>(table.choice("joints", 0, kMethods));
    if (accuracy.substeps && accuracy.substeps_max && *accuracy.substeps > *accuracy.substeps_max) {
        table.error("substeps_max",
                    fmt::format("{} is below substeps = {}; expected at least as many",
                                *accuracy.substeps_max,
                                *accuracy.substeps));
    }
    return accuracy;
}

void read_sections(TableReader& root, SceneDescription& scene, LoadContext& context) {
    if (auto table = root.table("scene")) {
        scene.title = table->text("title", {});
        scene.description = table->text("description", {});
        scene.controls = table->text("controls", {});
        for (const char* followed_before : {"include", "base", "without"})
            table->find(followed_before);
        table->finish();
    }
    read_world(root, scene);
    if (auto table = root.table("accuracy")) {
        scene.accuracy = read_accuracy(*table);
        table->finish();
    }
    read_player(root, scene);
    read_camera(root, scene);
    read_lights_and_air(root, scene, context);
    read_acoustics(root, scene);
    read_effects(root, scene, context);
}

}  // namespace plumbline::scene
