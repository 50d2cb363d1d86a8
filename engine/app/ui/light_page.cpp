// Light and fog of the running scene.
#include "engine/app/ui/pages.h"
#include "engine/app/ui/setting_cells.h"
#include "engine/scene/environment/live_light.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>

namespace plumbline::app::ui {

void MenuPages::switch_effect(const std::string& effect, std::optional<bool> on) {
    if (on)
        world_.switches.turn(effect, *on);
    else
        world_.switches.effects.erase(effect);
    ask(WorldRequest{SwitchEffect{effect, on}});
}

void MenuPages::set_fog(float density_scale, std::size_t color) {
    switch_effect("fog", true);  // whoever changes it wants to see it
    world_.switches.fog_density_scale = density_scale;
    world_.switches.fog_color = color;
    ask(WorldRequest{SetFog{density_scale, static_cast<std::uint32_t>(color)}});
}

void MenuPages::set_light(float scale) {
    world_.switches.light_scale = scale;
    ask(WorldRequest{SetLight{scale}});
}

void MenuPages::set_hour(double hour) {
    world_.hour = hour;
    ask(WorldRequest{SetHour{hour}});
}

Line MenuPages::fog_colors() {
    const scene::LiveSwitches& now = world_.switches;
    Line colors{.kind = LineKind::Cells, .label = "Fog colour"};
    for (std::size_t i = 0; i < scene::kFogColors.size(); ++i) {
        colors.cells.push_back(
            {.text = std::string(scene::kFogColors[i].name),
             .activate = [this, i] { set_fog(world_.switches.fog_density_scale, i); },
             .marked = now.fog_color == i});
    }
    return colors;
}

void MenuPages::add_light(Page& page) {
    const scene::LiveSwitches& now = world_.switches;
    const scene::FogDescription& fog = world_.fog;
    // Equal steps of the logarithm, as the keys take them.
    const auto factor = [](std::string text, float value, float least, float most, auto set) {
        const auto log_of = [](float number) { return static_cast<double>(std::log2(number)); };
        const double notch = log_of(scene::kLiveNotch);
        return slider(std::move(text),
                      log_of(value),
                      std::ceil(log_of(least) / notch) * notch,
                      std::floor(log_of(most) / notch) * notch,
                      notch,
                      [set](double wanted) { set(static_cast<float>(std::exp2(wanted))); });
    };
    page.add_cells(
        {toggle(now.is_on("fog", fog.on), [this](bool on) { switch_effect("fog", on); })}, "Fog");
    page.add_cells({factor(fmt::format("{:.2g} per m", fog.density_per_m * now.fog_density_scale),
                           now.fog_density_scale,
                           scene::kThinnestFog,
                           scene::kDensestFog,
                           [this](float value) { set_fog(value, world_.switches.fog_color); })},
                   "Fog density");
    page.lines.push_back(fog_colors());
    page.add_cells({factor(percent(now.light_scale),
                           now.light_scale,
                           scene::kDimmestLight,
                           scene::kBrightestLight,
                           [this](float value) { set_light(value); })},
                   "Sun and sky");
    if (world_.hour) add_hour(page, *world_.hour);
    page.add_text("These settings last until you reset or leave the scene.");
}

void MenuPages::add_hour(Page& page, double hour) {
    constexpr double kQuarter = 0.25;
    const auto minutes = std::lround(hour * 60.0) % (24 * 60);
    page.add_cells({slider(fmt::format("{}:{:02}", minutes / 60, minutes % 60),
                           hour,
                           0,
                           24 - kQuarter,  // 24 is 0 again
                           kQuarter,
                           [this](double wanted) { set_hour(wanted); })},
                   "Time of day");
    const scene::LiveSwitches& now = world_.switches;
    const bool by_themselves = !now.effects.contains("lamps");
    Line lamps{.kind = LineKind::Cells, .label = "Lamps"};
    lamps.cells.push_back({.text = "automatic",
                           .activate = [this] { switch_effect("lamps", std::nullopt); },
                           .marked = by_themselves});
    for (const bool on : {true, false}) {
        lamps.cells.push_back({.text = on ? "on" : "off",
                               .activate = [this, on] { switch_effect("lamps", on); },
                               .marked = !by_themselves && now.is_on("lamps", true) == on});
    }
    page.lines.push_back(std::move(lamps));
}

}  // namespace plumbline::app::ui
