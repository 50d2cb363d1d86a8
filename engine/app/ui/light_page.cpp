// Light and fog of the running scene.
#include "engine/app/ui/pages.h"
#include "engine/app/ui/setting_cells.h"
#include "engine/scene/environment/live_light.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>

namespace plumbline::app::ui {

Line MenuPages::fog_colors() {
    Line colors{.kind = LineKind::Cells, .label = "Fog colour"};
    for (std::size_t i = 0; i < scene::kFogColors.size(); ++i) {
        colors.cells.push_back({.text = std::string(scene::kFogColors[i].name),
                                .activate =
                                    [this, i] {
                                        world_.switches().turn("fog", true);
                                        world_.switches().fog_color = i;
                                    },
                                .marked = world_.switches().fog_color == i});
    }
    return colors;
}

void MenuPages::add_light(Page& page) {
    const scene::LiveSwitches& now = world_.switches();
    const scene::FogDescription fog = world_.scene_fog();
    const auto change = [this](const std::function<void(scene::LiveSwitches&)>& change_of) {
        change_of(world_.switches());
    };
    // Equal steps of the logarithm, as the keys take them.
    const auto factor = [&](std::string text, float value, float least, float most, auto set) {
        const auto log_of = [](float number) { return static_cast<double>(std::log2(number)); };
        const double notch = log_of(scene::kLiveNotch);
        return slider(std::move(text),
                      log_of(value),
                      std::ceil(log_of(least) / notch) * notch,
                      std::floor(log_of(most) / notch) * notch,
                      notch,
                      [change, set](double wanted) {
                          change([&](scene::LiveSwitches& switches) {
                              set(switches, static_cast<float>(std::exp2(wanted)));
                          });
                      });
    };
    page.lines.push_back({.kind = LineKind::Cells,
                          .label = "Fog",
                          .cells = {toggle(now.is_on("fog", fog.on), [change](bool on) {
                              change([on](scene::LiveSwitches& s) { s.turn("fog", on); });
                          })}});
    page.lines.push_back(
        {.kind = LineKind::Cells,
         .label = "Fog density",
         .cells = {factor(fmt::format("{:.2g} per m", fog.density_per_m * now.fog_density_scale),
                          now.fog_density_scale,
                          scene::kThinnestFog,
                          scene::kDensestFog,
                          [](scene::LiveSwitches& s, float value) {
                              s.turn("fog", true);  // who changes it wants to see it
                              s.fog_density_scale = value;
                          })}});
    page.lines.push_back(fog_colors());
    page.lines.push_back(
        {.kind = LineKind::Cells,
         .label = "Sun and sky",
         .cells = {factor(percent(now.light_scale),
                          now.light_scale,
                          scene::kDimmestLight,
                          scene::kBrightestLight,
                          [](scene::LiveSwitches& s, float value) { s.light_scale = value; })}});
    if (const std::optional<double> hour = world_.hour()) add_hour(page, *hour);
    page.lines.push_back({.kind = LineKind::Text,
                          .label = "These settings last until you reset or leave the scene."});
}

void MenuPages::add_hour(Page& page, double hour) {
    constexpr double kQuarter = 0.25;
    const auto minutes = std::lround(hour * 60.0) % (24 * 60);
    page.lines.push_back({.kind = LineKind::Cells,
                          .label = "Time of day",
                          .cells = {slider(fmt::format("{}:{:02}", minutes / 60, minutes % 60),
                                           hour,
                                           0,
                                           24 - kQuarter,  // 24 is 0 again
                                           kQuarter,
                                           world_.set_hour)}});
    scene::LiveSwitches& now = world_.switches();
    const bool by_themselves = !now.effects.contains("lamps");
    Line lamps{.kind = LineKind::Cells, .label = "Lamps"};
    lamps.cells.push_back({.text = "automatic",
                           .activate = [this] { world_.switches().effects.erase("lamps"); },
                           .marked = by_themselves});
    for (const bool on : {true, false}) {
        lamps.cells.push_back({.text = on ? "on" : "off",
                               .activate = [this, on] { world_.switches().turn("lamps", on); },
                               .marked = !by_themselves && now.is_on("lamps", true) == on});
    }
    page.lines.push_back(std::move(lamps));
}

}  // namespace plumbline::app::ui
