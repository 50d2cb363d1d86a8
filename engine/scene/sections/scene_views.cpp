// [[view]]: places worth an image.
#include "engine/scene/sections/scene_parts.h"

#include <fmt/format.h>

#include <algorithm>

namespace plumbline::scene {
namespace {

constexpr std::size_t kViews = 200;

/// The name becomes part of an image's file name.
bool is_file_name(std::string_view name) {
    return std::ranges::all_of(name, [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
               c == '_' || c == '-';
    });
}

ViewDescription read_view(TableReader& table, std::string fallback_name) {
    constexpr Range kWait_s{0, 600, "seconds from 0 to 600"};
    constexpr Range kLight{0, 100, "a factor from 0 to 100"};
    ViewDescription view;
    view.name = read_name(table);
    if (view.name.empty()) view.name = std::move(fallback_name);
    if (!is_file_name(view.name)) {
        table.error(
            "name",
            fmt::format("\"{}\"; expected letters, digits, _ and - only, for it names a file",
                        shown(view.name)));
    }
    for (const std::string_view key : {"position_m", "target_m"}) {
        if (!table.has(key)) table.error(key, "missing; expected [x, y, z] in m");
    }
    view.position_m = table.vector("position_m", view.position_m, kCoordinate_m);
    view.target_m = table.vector("target_m", view.target_m, kCoordinate_m);
    if (glm::distance(view.position_m, view.target_m) < 1e-6_r)
        table.error("target_m", "is where the view is taken from; expected another point");
    view.wait_s = table.number("wait_s", view.wait_s, kWait_s);
    view.flashlight = table.flag("flashlight", view.flashlight);
    view.light_scale = table.single("light_scale", view.light_scale, kLight);
    if (const auto hour = table.optional_number("hour", kHour))
        view.hour = static_cast<double>(*hour);
    table.finish();
    return view;
}

}  // namespace

void read_views(TableReader& root, SceneDescription& scene) {
    const auto nodes = root.tables("view");
    if (nodes.size() > kViews) {
        root.error("view", fmt::format("{} views; at most {} are kept", nodes.size(), kViews));
        return;
    }
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        TableReader table(nodes[i], fmt::format("view[{}]", i), root.faults());
        scene.views.push_back(read_view(table, fmt::format("view_{}", i + 1)));
    }
}

}  // namespace plumbline::scene
