// [sun] [time] [sky] [ambient] [fog] [flashlight] [post], and the lights of entities.
#include "engine/assets/skybox_files.h"
#include "engine/scene/environment/sun_path.h"
#include "engine/scene/sections/scene_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

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
    outer_deg = table.single("outer_deg", outer_deg, kHalfAngle_deg);
    if (only_outer) inner_deg = std::min(inner_deg, outer_deg * 0.6F);
    inner_deg = table.single("inner_deg", inner_deg, kHalfAngle_deg);
    if (inner_deg > outer_deg) {
        table.error("inner_deg",
                    fmt::format("{} is wider than outer_deg, {}", inner_deg, outer_deg));
    }
}

std::optional<ShadowDescription> read_sun_shadow(TableReader& sun) {
    Wish wish = read_wish(sun, "shadow");
    if (!wish.is_made) return {};
    ShadowDescription shadow;
    shadow.location = wish.location;
    if (!wish.numbers) return shadow;
    shadow.cascades = wish.numbers->integer("cascades", shadow.cascades, 1, 4);
    shadow.size_px = wish.numbers->integer("size_px", shadow.size_px, 64, 8192);
    constexpr Range kDistance_m{1, 1e4, "a length from 1 to 10000 m"};
    shadow.distance_m = wish.numbers->number("distance_m", shadow.distance_m, kDistance_m);
    constexpr Range kDisc_deg{0, 10, "degrees from 0 to 10"};
    shadow.angular_size_deg =
        wish.numbers->single("angular_size_deg", shadow.angular_size_deg, kDisc_deg);
    wish.numbers->finish();
    return shadow;
}

void read_sun(TableReader& root, SceneDescription& scene) {
    auto table = root.table("sun");
    if (!table) return;
    SunDescription sun;
    sun.location = table->location();
    sun.direction = Vec3(table->direction("direction", Vec3d(sun.direction)));
    sun.color = table->color("color", sun.color);
    sun.intensity = table->single("intensity", sun.intensity, kIntensity);
    constexpr Range kTurn_degps{-3600, 3600, "degrees per second from -3600 to 3600"};
    sun.rotation_radps =
        radians_from_degrees(table->number("rotation_degps", Real{0}, kTurn_degps));
    sun.cube_m = table->single("cube_m", sun.cube_m, kCubeEdge_m);
    sun.cube_distance_m = table->single("cube_distance_m", sun.cube_distance_m, kReach_m);
    sun.shadow = read_sun_shadow(*table);
    sun.shafts = read_shafts(*table);
    table->finish();
    scene.sun = sun;
}

void read_time(TableReader& root, SceneDescription& scene) {
    auto table = root.table("time");
    if (!table) return;
    TimeDescription time;
    time.location = table->location();
    constexpr Range kLatitude_deg{-90, 90, "degrees from -90 to 90"};
    constexpr Range kTurn_deg{-360, 360, "degrees from -360 to 360"};
    const auto angle = [&](std::string_view key, double fallback_rad, const Range& range) {
        return radians_from_degrees(static_cast<double>(
            table->number(key, static_cast<Real>(degrees_from_radians(fallback_rad)), range)));
    };
    time.hour = static_cast<double>(table->number("hour", static_cast<Real>(time.hour), kHour));
    time.latitude_rad = angle("latitude_deg", time.latitude_rad, kLatitude_deg);
    time.day_of_year = table->integer("day_of_year", time.day_of_year, 1, 366);
    time.north_rad = angle("north_deg", time.north_rad, kTurn_deg);
    table->finish();
    if (!scene.sun)
        return table->warning("hour", "there is no [sun] whose time it could be; ignored");
    scene.time = time;
    scene.sun->direction = Vec3(-to_sun_at(time, time.hour));
}

/// The folder of six faces that `key` names, if they are all there; else empty, with a fault that
/// says what is seen `instead`.
fs::path read_faces(TableReader& table,
                    std::string_view key,
                    std::string_view instead,
                    const LoadContext& context) {
    const TomlNode* node = table.find(key);
    const std::string name = table.text(key, {});
    if (node == nullptr || node->text() == nullptr) return {};
    const Result<Reference>& folder = context.reference(*node);
    if (!folder) {
        table.error(key, folder.error().message);
        return {};
    }
    if (!folder->exists) {
        table.warning(key, fmt::format("\"{}\" does not exist; {}", shown(name), instead));
        return {};
    }
    const auto faces = assets::skybox_files(folder->file);
    const auto missing = std::ranges::find_if(faces, &fs::path::empty);
    if (missing == faces.end()) return folder->file;
    table.warning(
        key,
        fmt::format("\"{}\" holds no {}.exr, .png or .jpg; {}",
                    shown(name),
                    assets::kSkyboxFaces[static_cast<std::size_t>(missing - faces.begin())],
                    instead));
    return {};
}

SkyDescription read_sky_model(TableReader& table,
                              const SceneDescription& scene,
                              const LoadContext& context) {
    constexpr std::array<std::string_view, 1> kModels{"atmosphere"};
    constexpr Range kHaze{0, 20, "a factor from 0 to 20"};
    SkyModelDescription model;
    table.choice("model", 0, kModels);
    table.either("model", "skybox");
    model.haze = table.single("haze", model.haze, kHaze);
    constexpr Range kVisibility_m{100, 1e6, "a length from 100 to 1000000 m"};
    model.visibility_m = table.single("visibility_m", model.visibility_m, kVisibility_m);
    model.clouds = table.single("clouds", model.clouds, kFraction);
    const fs::path clouds = read_faces(table, "cloud_map", "there are no clouds", context);
    if (!scene.sun) table.warning("model", "there is no [sun]; the sky is that of a night");
    return {.folder = clouds, .model = model, .location = table.location()};
}

void read_sky(TableReader& root, SceneDescription& scene, const LoadContext& context) {
    auto table = root.table("sky");
    if (!table) return;
    if (table->has("model")) {
        scene.sky = read_sky_model(*table, scene, context);
        return table->finish();
    }
    if (!table->has("skybox")) {
        table->error("skybox",
                     "missing; expected a folder of six faces, or model = \"atmosphere\"");
    }
    const fs::path folder = read_faces(*table, "skybox", "the clear colour is used", context);
    table->finish();
    if (!folder.empty())
        scene.sky = SkyDescription{.folder = folder, .location = table->location()};
}

void read_fog(TableReader& root, SceneDescription& scene) {
    auto table = root.table("fog");
    if (!table) return;
    FogDescription fog;
    fog.location = table->location();
    fog.color = table->color("color", fog.color);
    constexpr Range kDensity{0, 10, "a density from 0 to 10 per m"};
    fog.density_per_m = table->single("density_per_m", fog.density_per_m, kDensity);
    fog.on = table->flag("on", fog.on);
    table->finish();
    scene.fog = fog;
}

constexpr std::array<std::string_view, 2> kFlashlightPlaces{"hand", "eye"};

void read_flashlight(TableReader& root, SceneDescription& scene) {
    auto table = root.table("flashlight");
    if (!table) return;
    FlashlightDescription light;
    light.location = table->location();
    light.color = table->color("color", light.color);
    light.intensity = table->single("intensity", light.intensity, kIntensity);
    light.radius_m = table->single("radius_m", light.radius_m, kReach_m);
    read_cone(*table, light.inner_deg, light.outer_deg);
    light.on = table->flag("on", light.on);
    light.at_eye = table->choice("at", 0, kFlashlightPlaces) == 1;
    light.cube_m = table->single("cube_m", light.cube_m, kCubeEdge_m);
    table->finish();
    scene.flashlight = light;
}

void read_post(TableReader& root, SceneDescription& scene) {
    auto table = root.table("post");
    if (!table) return;
    PostDescription post;
    post.location = table->location();
    constexpr Range kExposure{1e-3, 1e3, "a factor from 0.001 to 1000"};
    post.bloom = table->single("bloom", post.bloom, kFraction);
    post.adapts = table->flag("adapts", post.adapts);
    post.exposure = table->single("exposure", post.exposure, kExposure);
    post.shutter = read_shutter(*table);
    table->finish();
    scene.post = post;
}

/// `on = true`, false, or "dark".
LampOn read_lamp_on(TableReader& light) {
    const TomlNode* node = light.find("on");
    if (node == nullptr) return LampOn::Always;
    if (node->text() == nullptr) return light.flag("on", true) ? LampOn::Always : LampOn::Never;
    constexpr std::array<std::string_view, 1> kWords{"dark"};
    light.choice("on", 0, kWords);
    return LampOn::Dark;
}

}  // namespace

std::optional<LightDescription> read_light(TableReader& entity) {
    auto table = entity.table("light");
    if (!table) return {};
    constexpr std::array<std::string_view, 2> kLightKinds{"point", "spot"};
    LightDescription light;
    light.location = table->location();
    light.is_spot = table->choice("kind", 0, kLightKinds) == 1;
    light.color = table->color("color", light.color);
    light.intensity = table->single("intensity", light.intensity, kIntensity);
    light.radius_m = table->single("radius_m", light.radius_m, kReach_m);
    light.shadow = table->flag("shadow", false);
    light.on = read_lamp_on(*table);
    light.offset_m = table->vector("offset_m", light.offset_m, kOffset_m);
    light.direction = Vec3f(table->direction("direction", Vec3d(light.direction)));
    read_cone(*table, light.inner_deg, light.outer_deg);
    if (!light.is_spot) {
        for (const std::string_view key : {"direction", "inner_deg", "outer_deg"}) {
            if (table->has(key)) table->warning(key, "a point light shines everywhere; ignored");
        }
    }
    table->finish();
    return light;
}

void read_lights_and_air(TableReader& root, SceneDescription& scene, LoadContext& context) {
    read_sun(root, scene);
    read_time(root, scene);
    read_sky(root, scene, context);
    if (auto table = root.table("ambient")) {
        scene.ambient.color = table->color("color", scene.ambient.color);
        scene.ambient.occlusion = read_occlusion(*table);
        scene.ambient.indirect = read_indirect(*table);
        table->finish();
    }
    read_fog(root, scene);
    read_flashlight(root, scene);
    read_post(root, scene);
}

}  // namespace plumbline::scene
