// [ambient] occlusion and indirect, [sun] shafts, [camera] focus, [post] shutter_s.
#include "engine/scene/sections/scene_parts.h"

#include <algorithm>

namespace plumbline::scene {

void read_occlusion(TableReader& table, OcclusionDescription& occlusion) {
    table.read("radius_m", occlusion.radius_m, {0.02, 10, "a length from 0.02 to 10 m"});
    table.read("strength", occlusion.strength, kFraction);
}

void read_indirect(TableReader& table, IndirectLightDescription& indirect) {
    constexpr Real kMostPoints = 20000;
    table.read("min_m", indirect.min_m, kCoordinate_m);
    table.read("max_m", indirect.max_m, kCoordinate_m);
    table.read("spacing_m", indirect.spacing_m, {0.1, 5, "a length from 0.1 to 5 m"});
    table.read("gain", indirect.gain, {0, 100, "a number from 0 to 100"});
    const Vec3 size_m = indirect.max_m - indirect.min_m;
    const Vec3 points = glm::ceil(size_m / Real{indirect.spacing_m});
    if (std::min({size_m.x, size_m.y, size_m.z}) <= 0) {
        table.error("max_m", "must be above min_m along each axis");
    } else if (points.x * points.y * points.z > kMostPoints) {
        table.error("spacing_m", "more than 20000 points; take a larger one or a smaller box");
    }
}

void read_shafts(TableReader& table, ShaftsDescription& shafts) {
    table.read("density_per_m", shafts.density_per_m, {0, 1, "a density from 0 to 1 per m"});
    table.read("distance_m", shafts.distance_m, {1, 1000, "a length from 1 to 1000 m"});
}

void read_focus(TableReader& table, FocusDescription& focus) {
    table.read("distance_m", focus.distance_m, {0.01, 1e4, "a length from 0.01 to 10000 m"});
    table.read("aperture_m", focus.aperture_m, {0, 10, "a length from 0 to 10 m"});
}

std::optional<ShutterDescription> read_shutter(TableReader& post) {
    const TomlNode* node = post.find("shutter_s");
    if (node == nullptr) return {};
    float open_s = 0.0F;
    post.read("shutter_s", open_s, {0, 1, "a time from 0 to 1 s"});
    if (open_s <= 0.0F) return {};
    return ShutterDescription{.open_s = open_s, .location = node->location};
}

}  // namespace plumbline::scene
