#include "engine/app/accuracy/accuracy_choice.h"
#include "engine/app/ui/pages.h"
#include "engine/app/ui/setting_cells.h"
#include "engine/input/tuning_keys.h"
#include "engine/scene/accuracy.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace plumbline::app::ui {
namespace {

struct NamedTuning {
    std::string_view key;
    std::string_view label;
};
constexpr std::array<NamedTuning, 7> kTuning{{{"mouse_deg_per_count", "Mouse sensitivity"},
                                              {"invert_y", "Invert Y axis"},
                                              {"pad_look_deg_per_sec", "Stick sensitivity"},
                                              {"pad_inner_dead_zone", "Stick inner dead zone"},
                                              {"pad_outer_dead_zone", "Stick outer dead zone"},
                                              {"pad_curve", "Stick response curve"},
                                              {"trigger_threshold", "Trigger threshold"}}};

/// As floats are written: without the digits that a float cannot hold.
float tidy(double value) {
    return static_cast<float>(std::round(value * 1e4) / 1e4);
}

Cell number_cell(std::string_view key,
                 const FloatSetting& real,
                 const std::function<void(float)>& set) {
    const float now = *real.value;
    const auto take = [set](double value) { set(tidy(value)); };
    if (key == "fov_deg") {
        return slider(fmt::format("{:.0f}°", now), static_cast<double>(now), 30, 120, 5, take);
    }
    if (key == "target_ms") {
        return slider(fmt::format("{:.0f} ms ({:.0f} fps)", now, 1000.0F / now),
                      static_cast<double>(now),
                      5,
                      100,
                      5,
                      take);
    }
    // The lowest step is 0, which chooses by itself.
    const auto or_automatic = [&](double lowest, double max, double step) {
        return slider(now == 0.0F ? "automatic" : percent(now),
                      now == 0.0F ? lowest : static_cast<double>(now),
                      lowest,
                      max,
                      step,
                      [take, least = lowest + step](double v) { take(v < least ? 0.0 : v); });
    };
    if (key == "render_scale") return or_automatic(0.2, 1, 0.05);
    if (key == "ui_scale") return or_automatic(0.5, 3, 0.25);
    return slider(percent(now),
                  static_cast<double>(now),
                  static_cast<double>(real.min),
                  static_cast<double>(real.max),
                  0.05,
                  take);
}

Cell count_cell(std::string_view key,
                const IntSetting& whole,
                const std::function<void(int)>& set) {
    const bool frames = key == "max_fps";
    const int max = frames ? 240 : whole.max;
    const int min = frames ? 10 : whole.min;
    return slider(fmt::format("{}", *whole.value),
                  std::clamp(*whole.value, min, max),
                  min,
                  max,
                  frames ? 10 : 1,
                  [set](double value) { set(static_cast<int>(std::lround(value))); });
}

}  // namespace

void MenuPages::change_accuracy(const study::Setting& setting) {
    world_.accuracy = setting;
    ask(WorldRequest{SetAccuracy{setting}});
}

Line MenuPages::setting_line(std::size_t row) {
    AppConfig now = world_.config;
    const Setting setting = settings_of(now)[row];
    Line line{.kind = LineKind::Cells, .label = std::string(setting.label)};
    const auto setter = [this, row]<class Target>(const Target&) {
        return [this, row](auto value) {
            *std::get<Target>(settings_of(world_.config)[row].target).value = value;
            ask(ChangeConfig{world_.config});
        };
    };
    if (const auto* flag = std::get_if<FlagSetting>(&setting.target)) {
        line.cells.push_back(toggle(*flag->value, setter(*flag)));
    } else if (const auto* real = std::get_if<FloatSetting>(&setting.target)) {
        line.cells.push_back(number_cell(setting.key, *real, setter(*real)));
    } else if (const auto* whole = std::get_if<IntSetting>(&setting.target)) {
        line.cells.push_back(count_cell(setting.key, *whole, setter(*whole)));
    } else {
        const auto& word = std::get<WordSetting>(setting.target);
        for (std::size_t i = 0; i < word.words.size(); ++i) {
            const auto each = static_cast<std::uint8_t>(i);
            line.cells.push_back({.text = std::string(word.words[i]),
                                  .activate = [set = setter(word), each] { set(each); },
                                  .marked = *word.value == each});
        }
    }
    return line;
}

void MenuPages::add_settings(Page& page, std::vector<std::string_view> tables) {
    // What only counts at the next start is for the file.
    constexpr std::array<std::string_view, 3> kAtStart{"width", "height", "voices"};
    AppConfig now = world_.config;
    const std::vector<Setting> settings = settings_of(now);
    for (std::size_t i = 0; i < settings.size(); ++i) {
        const bool shown = std::ranges::find(tables, settings[i].table) != tables.end() &&
                           std::ranges::find(kAtStart, settings[i].key) == kAtStart.end();
        if (shown) page.lines.push_back(setting_line(i));
    }
}

void MenuPages::add_mouse(Page& page) {
    const input::Bindings& bindings = stored();
    for (const NamedTuning& named : kTuning) {
        const input::TuningKey& key = *input::find_tuning_key(named.key);
        Line line{.kind = LineKind::Cells, .label = std::string(named.label)};
        if (key.flag != nullptr) {
            line.cells.push_back(toggle(bindings.tuning.*key.flag, [this, &key](bool on) {
                change_bindings([&](input::Bindings& wanted) { wanted.tuning.*key.flag = on; });
            }));
        } else {
            // Equal parts of the logarithm where the range is wide: each step feels alike.
            const bool wide = key.min > 0.0 && key.max / key.min >= 100.0;
            const auto from = [wide](double value) { return wide ? std::log2(value) : value; };
            const auto back = [wide](double value) { return wide ? std::exp2(value) : value; };
            const auto value = static_cast<double>(bindings.tuning.*key.number);
            line.cells.push_back(slider(
                fmt::format("{:.3g}", value),
                from(value),
                from(key.min),
                from(key.max),
                (from(key.max) - from(key.min)) / (wide ? 44.0 : 20.0),
                [this, &key, back](double wanted_value) {
                    const float rounded = tidy(back(wanted_value));
                    change_bindings([&](input::Bindings& wanted) {
                        wanted.tuning.*key.number = std::clamp(
                            rounded, static_cast<float>(key.min), static_cast<float>(key.max));
                    });
                }));
        }
        page.lines.push_back(std::move(line));
    }
    page.add_cells({reset("Reset to defaults", [this] {
        change_bindings(
            [this](input::Bindings& wanted) { wanted.tuning = world_.bindings->below().tuning; });
    })});
}

Page MenuPages::settings() {
    Page page{.title = "Settings", .pins_first_line = true};
    struct NamedTab {
        Tab tab;
        const char* text;
        Icon icon;
    };
    constexpr std::array<NamedTab, 6> kTabs{{{Tab::Image, "Graphics", Icon::Image},
                                             {Tab::Screen, "Display", Icon::Screen},
                                             {Tab::Sound, "Sound", Icon::Sound},
                                             {Tab::Mouse, "Mouse and pad", Icon::Mouse},
                                             {Tab::Light, "Light and fog", Icon::Light},
                                             {Tab::Accuracy, "Accuracy", Icon::Accuracy}}};
    Line tabs{.kind = LineKind::Cells, .cells = {back_cell()}};
    for (const NamedTab& each : kTabs) {
        tabs.cells.push_back({.text = each.text,
                              .icon = each.icon,
                              .activate = [this, tab = each.tab] { tab_ = tab; },
                              .marked = tab_ == each.tab});
    }
    tabs.cells.push_back(to_page("Controls", Icon::Keys, &MenuPages::controls));
    page.lines.push_back(std::move(tabs));
    if (tab_ == Tab::Mouse) add_mouse(page);
    if (tab_ == Tab::Light) add_light(page);
    if (tab_ == Tab::Accuracy) add_accuracy(page);
    std::vector<std::string_view> tables;
    if (tab_ == Tab::Image) tables = {"image"};
    if (tab_ == Tab::Screen) tables = {"window", "hud"};
    if (tab_ == Tab::Sound) tables = {"sound"};
    if (tables.empty()) return page;
    add_settings(page, tables);
    page.add_cells({reset("Reset to defaults", [this, tables] {
        const std::vector<Setting> to = settings_of(world_.config);
        const std::vector<Setting> from = settings_of(world_.config_below);
        for (std::size_t i = 0; i < to.size(); ++i) {
            if (std::ranges::find(tables, to[i].table) != tables.end()) copy_value(from[i], to[i]);
        }
        ask(ChangeConfig{world_.config});
    })});
    return page;
}

void MenuPages::add_accuracy(Page& page) {
    const study::Setting now = world_.accuracy;
    page.add_text(fmt::format("Current: {}", study::setting_text(now)));
    if (world_.replaying) return page.add_text("Accuracy is locked while replaying.");
    const auto choice = [&](std::string text, const study::Setting& setting) {
        return Cell{.text = std::move(text),
                    .activate = [this, setting] { change_accuracy(setting); },
                    .marked = setting == now};
    };
    Line presets{.kind = LineKind::Cells, .label = "Preset"};
    for (const scene::Preset& preset : scene::presets()) {
        if (preset.name == "auto") continue;  // a study chooses that one, before the scene opens
        presets.cells.push_back(choice(std::string(preset.name), with_preset(now, preset.name)));
    }
    Line solvers{.kind = LineKind::Cells, .label = "Solver"};
    for (const physics::Solver solver : physics::kSolvers) {
        const study::Setting other = solver == now.solver ? now : with_solver(now, solver);
        solvers.cells.push_back(choice(std::string(physics::solver_name(solver)), other));
    }
    Line rates{.kind = LineKind::Cells, .label = "Step rate, Hz"};
    for (const int hz : offered_rates_hz()) {
        study::Setting other = now;
        other.step_hz = hz;
        rates.cells.push_back(choice(fmt::format("{}", hz), other));
    }
    page.lines.push_back(std::move(presets));
    page.lines.push_back(std::move(solvers));
    page.lines.push_back(std::move(rates));
    page.add_cells({{.text = "Save a copy of the scene with these settings",
                     .icon = Icon::Scenes,
                     .activate = [this] { ask(AdoptAccuracy{}); }}});
    page.add_text(
        "Accuracy belongs to the scene file, so that everybody gets the same simulation. Changes "
        "made here last until you leave the scene; save a copy to keep them. The accuracy panel "
        "shows cost and error during play.");
}

}  // namespace plumbline::app::ui
