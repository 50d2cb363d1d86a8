// [sun] [time] [sky] [ambient] [fog] [flashlight] [post], and the lights of entities.
#include "engine/assets/skybox_files.h"
#include "engine/scene/environment/sun_path.h"
#include "engine/scene/sections/scene_parts.h"

#include <algorithm>

namespace plumbline::scene {
namespace {

namespace fs = std::filesystem;

constexpr Range kIntensity{0, 1e6, "a number from 0 to 1000000"};
constexpr Range kReach_m{1e-2, 1e4, "a length from 0.01 to 10000 m"};
constexpr Range kOffset_m{-100, 100, "a length from -100 to 100 m"};
constexpr Range kHalfAngle_deg{0, 89, "degrees from 0 to 89"};
constexpr Range kCubeEdge_m{0, 100, "a length from 0 to 100 m"};

void read_cone(TableReader& table, float& inner_deg, float& outer_deg) {
    const bool only_outer = table.has("outer_deg") && !table.has("inner_deg");
    table.read("outer_deg", outer_deg, kHalfAngle_deg);
    if (only_outer) inner_deg = std::min(inner_deg, outer_deg * 0.6F);
    table.read("inner_deg", inner_deg, kHalfAngle_deg);
    if (inner_deg > outer_deg)
        table.error("inner_deg", "{} is wider than outer_deg, {}", inner_deg, outer_deg);
}

void read_sun_shadow(TableReader& table, ShadowDescription& shadow) {
    table.read("cascades", shadow.cascades, 1, 4);
    table.read("size_px", shadow.size_px, 64, 8192);
    table.read("distance_m", shadow.distance_m, {1, 1e4, "a length from 1 to 10000 m"});
    table.read("angular_size_deg", shadow.angular_size_deg, {0, 10, "degrees from 0 to 10"});
}

void read_sun(TableReader& table, SunDescription& sun) {
    table.read_direction("direction", sun.direction);
    table.read_color("color", sun.color);
    table.read("intensity", sun.intensity, kIntensity);
    constexpr Range kTurn_degps{-3600, 3600, "degrees per second from -3600 to 3600"};
    table.read_degrees("rotation_degps", sun.rotation_radps, kTurn_degps);
    table.read("cube_m", sun.cube_m, kCubeEdge_m);
    table.read("cube_distance_m", sun.cube_distance_m, kReach_m);
    table.read_wish("shadow", sun.shadow, read_sun_shadow);
    table.read_wish("shafts", sun.shafts, read_shafts);
}

void read_time(TableReader& table, TimeDescription& time, const SceneDescription& scene) {
    table.read("hour", time.hour, kHour);
    table.read_degrees("latitude_deg", time.latitude_rad, {-90, 90, "degrees from -90 to 90"});
    table.read("day_of_year", time.day_of_year, 1, 366);
    table.read_degrees("north_deg", time.north_rad, {-360, 360, "degrees from -360 to 360"});
    if (!scene.sun) table.warning("hour", "there is no [sun] whose time it could be; ignored");
}

/// The folder of six faces that `key` names, if they are all there; else empty, with a fault that
/// says what is seen `instead`.
fs::path read_faces(TableReader& table,
                    std::string_view key,
                    std::string_view instead,
                    const LoadContext& context) {
    const TomlNode* node = table.find(key);
    const std::string name = table.text(key);
    if (node == nullptr || node->text() == nullptr) return {};
    const Result<Reference>& folder = context.reference(*node);
    if (!folder) {
        table.error(key, folder.error().message);
        return {};
    }
    if (!folder->exists) {
        table.warning(key, "\"{}\" does not exist; {}", shown(name), instead);
        return {};
    }
    const auto faces = assets::skybox_files(folder->file);
    const auto missing = std::ranges::find_if(faces, &fs::path::empty);
    if (missing == faces.end()) return folder->file;
    table.warning(key,
                  "\"{}\" holds no {}.exr, .png or .jpg; {}",
                  shown(name),
                  assets::kSkyboxFaces[static_cast<std::size_t>(missing - faces.begin())],
                  instead);
    return {};
}

void read_sky_model(TableReader& table,
                    SkyDescription& sky,
                    const SceneDescription& scene,
                    const LoadContext& context) {
    SkyModelDescription& model = sky.model.emplace();
    table.expect("model", "atmosphere");
    table.either("model", "skybox");
    table.read("haze", model.haze, {0, 20, "a factor from 0 to 20"});
    table.read("visibility_m", model.visibility_m, {100, 1e6, "a length from 100 to 1000000 m"});
    table.read("clouds", model.clouds, kFraction);
    sky.folder = read_faces(table, "cloud_map", "there are no clouds", context);
    if (!scene.sun) table.warning("model", "there is no [sun]; the sky is that of a night");
}

void read_sky(TableReader& table,
              SkyDescription& sky,
              const SceneDescription& scene,
              const LoadContext& context) {
    if (table.has("model")) return read_sky_model(table, sky, scene, context);
    table.require("skybox", "a folder of six faces, or model = \"atmosphere\"");
    sky.folder = read_faces(table, "skybox", "the clear colour is used", context);
}

void read_fog(TableReader& table, FogDescription& fog) {
    table.read_color("color", fog.color);
    table.read("density_per_m", fog.density_per_m, {0, 10, "a density from 0 to 10 per m"});
    table.read("on", fog.on);
}

void read_flashlight(TableReader& table, FlashlightDescription& light) {
    table.read_color("color", light.color);
    table.read("intensity", light.intensity, kIntensity);
    table.read("radius_m", light.radius_m, kReach_m);
    read_cone(table, light.inner_deg, light.outer_deg);
    table.read("on", light.on);
    table.read_choice("at", light.at_eye, {"hand", "eye"});
    table.read("cube_m", light.cube_m, kCubeEdge_m);
}

void read_post(TableReader& table, PostDescription& post) {
    table.read("bloom", post.bloom, kFraction);
    table.read("adapts", post.adapts);
    table.read("exposure", post.exposure, {1e-3, 1e3, "a factor from 0.001 to 1000"});
    post.shutter = read_shutter(table);
}

/// `on = true`, false, or "dark".
LampOn read_lamp_on(TableReader& light) {
    const TomlNode* node = light.find("on");
    if (node != nullptr && node->text() != nullptr) {
        light.expect("on", "dark");
        return LampOn::Dark;
    }
    bool is_on = true;
    light.read("on", is_on);
    return is_on ? LampOn::Always : LampOn::Never;
}

}  // namespace

void read_light(TableReader& table, LightDescription& light) {
    table.read_choice("kind", light.is_spot, {"point", "spot"});
    table.read_color("color", light.color);
    table.read("intensity", light.intensity, kIntensity);
    table.read("radius_m", light.radius_m, kReach_m);
    table.read("shadow", light.shadow);
    light.on = read_lamp_on(table);
    table.read("offset_m", light.offset_m, kOffset_m);
    table.read_direction("direction", light.direction);
    read_cone(table, light.inner_deg, light.outer_deg);
    if (light.is_spot) return;
    for (const std::string_view key : {"direction", "inner_deg", "outer_deg"}) {
        if (table.has(key)) table.warning(key, "a point light shines everywhere; ignored");
    }
}

void read_lights_and_air(TableReader& root, SceneDescription& scene, LoadContext& context) {
    root.read_table("sun", scene.sun, read_sun);
    root.read_table("time", scene.time, read_time, scene);
    if (!scene.sun) scene.time.reset();
    if (scene.time) scene.sun->direction = Vec3(-to_sun_at(*scene.time, scene.time->hour));
    root.read_table("sky", scene.sky, read_sky, scene, context);
    // A skybox that cannot be had is no sky.
    if (scene.sky && !scene.sky->model && scene.sky->folder.empty()) scene.sky.reset();
    if (auto table = root.table("ambient")) {
        table->read_color("color", scene.ambient.color);
        table->read_wish("occlusion", scene.ambient.occlusion, read_occlusion);
        table->read_table("indirect", scene.ambient.indirect, read_indirect);
        table->finish();
    }
    root.read_table("fog", scene.fog, read_fog);
    root.read_table("flashlight", scene.flashlight, read_flashlight);
    root.read_table("post", scene.post, read_post);
}

}  // namespace plumbline::scene
