// [ambient] occlusion and indirect, [sun] shafts, [camera] focus, [post] shutter_s.
#include "engine/scene/sections/scene_parts.h"

#include <algorithm>

namespace plumbline::scene {

Wish read_wish(TableReader& table, std::string_view key) {
    const TomlNode* node = table.find(key);
    if (node == nullptr) return {};
    Wish wish{.location = node->location};
    if (std::get_if<bool>(&node->value) != nullptr) {
        wish.is_made = table.flag(key, false);
        return wish;
    }
    wish.numbers = table.table(key);
    wish.is_made = wish.numbers.has_value();
    return wish;
}

std::optional<OcclusionDescription> read_occlusion(TableReader& ambient) {
    Wish wish = read_wish(ambient, "occlusion");
    if (!wish.is_made) return {};
    OcclusionDescription occlusion{.location = wish.location};
    if (!wish.numbers) return occlusion;
    constexpr Range kRadius_m{0.02, 10, "a length from 0.02 to 10 m"};
    occlusion.radius_m = wish.numbers->single("radius_m", occlusion.radius_m, kRadius_m);
    occlusion.strength = wish.numbers->single("strength", occlusion.strength, kFraction);
    wish.numbers->finish();
    return occlusion;
}

std::optional<IndirectLightDescription> read_indirect(TableReader& ambient) {
    auto table = ambient.table("indirect");
    if (!table) return {};
    constexpr Range kSpacing_m{0.1, 5, "a length from 0.1 to 5 m"};
    constexpr Range kGain{0, 100, "a number from 0 to 100"};
    constexpr float kMostPoints = 20000.0F;
    IndirectLightDescription indirect{.location = table->location()};
    const Vec3 min_m = table->vector("min_m", {0, 0, 0}, kCoordinate_m);
    const Vec3 max_m = table->vector("max_m", {1, 1, 1}, kCoordinate_m);
    indirect.min_m = Vec3f(min_m);
    indirect.max_m = Vec3f(max_m);
    indirect.spacing_m = table->single("spacing_m", indirect.spacing_m, kSpacing_m);
    indirect.gain = table->single("gain", indirect.gain, kGain);
    const Vec3f size = indirect.max_m - indirect.min_m;
    const Vec3f points = glm::ceil(size / indirect.spacing_m);
    if (std::min({size.x, size.y, size.z}) <= 0.0F) {
        table->error("max_m", "must be above min_m along each axis");
    } else if (points.x * points.y * points.z > kMostPoints) {
        table->error("spacing_m", "more than 20000 points; take a larger one or a smaller box");
    }
    table->finish();
    return indirect;
}

std::optional<ShaftsDescription> read_shafts(TableReader& sun) {
    Wish wish = read_wish(sun, "shafts");
    if (!wish.is_made) return {};
    ShaftsDescription shafts{.location = wish.location};
    if (!wish.numbers) return shafts;
    constexpr Range kDensity_perm{0, 1, "a density from 0 to 1 per m"};
    constexpr Range kDistance_m{1, 1000, "a length from 1 to 1000 m"};
    shafts.density_per_m =
        wish.numbers->single("density_per_m", shafts.density_per_m, kDensity_perm);
    shafts.distance_m = wish.numbers->single("distance_m", shafts.distance_m, kDistance_m);
    wish.numbers->finish();
    return shafts;
}

std::optional<FocusDescription> read_focus(TableReader& camera) {
    auto table = camera.table("focus");
    if (!table) return {};
    constexpr Range kDistance_m{0.01, 1e4, "a length from 0.01 to 10000 m"};
    constexpr Range kAperture_m{0, 10, "a length from 0 to 10 m"};
    FocusDescription focus{.location = table->location()};
    focus.distance_m = table->single("distance_m", focus.distance_m, kDistance_m);
    focus.aperture_m = table->single("aperture_m", focus.aperture_m, kAperture_m);
    table->finish();
    return focus;
}

std::optional<ShutterDescription> read_shutter(TableReader& post) {
    const TomlNode* node = post.find("shutter_s");
    if (node == nullptr) return {};
    constexpr Range kOpen_s{0, 1, "a time from 0 to 1 s"};
    const float open_s = post.single("shutter_s", 0.0F, kOpen_s);
    if (open_s <= 0.0F) return {};
    return ShutterDescription{.open_s = open_s, .location = node->location};
}

}  // namespace plumbline::scene
