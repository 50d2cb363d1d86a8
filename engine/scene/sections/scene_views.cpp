// [[view]]: places worth an image.
#include "engine/scene/sections/scene_parts.h"

#include <fmt/format.h>

namespace plumbline::scene {
namespace {

constexpr std::size_t kViews = 200;

void read_view(TableReader& table, ViewDescription& view, const std::vector<ViewDescription>& all) {
    view.name = read_name(table);
    if (view.name.empty()) view.name = fmt::format("view_{}", all.size());
    if (!is_bare_key(view.name)) {
        table.error("name",
                    "\"{}\"; expected letters, digits, _ and - only, for it names a file",
                    shown(view.name));
    }
    for (const std::string_view key : {"position_m", "target_m"})
        table.require(key, "[x, y, z] in m");
    table.read("position_m", view.position_m, kCoordinate_m);
    table.read("target_m", view.target_m, kCoordinate_m);
    if (glm::distance(view.position_m, view.target_m) < 1e-6_r)
        table.error("target_m", "is where the view is taken from; expected another point");
    table.read("wait_s", view.wait_s, {0, 600, "seconds from 0 to 600"});
    table.read("flashlight", view.flashlight);
    table.read("light_scale", view.light_scale, {0, 100, "a factor from 0 to 100"});
    table.read("hour", view.hour, kHour);
}

}  // namespace

void read_views(TableReader& root, SceneDescription& scene) {
    const std::size_t count = root.tables("view").size();
    if (count > kViews) return root.error("view", "{} views; at most {} are kept", count, kViews);
    root.read_tables("view", scene.views, read_view, scene.views);
}

}  // namespace plumbline::scene
