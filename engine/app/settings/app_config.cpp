#include "engine/app/settings/app_config.h"

#include "engine/core/io/files.h"
#include "engine/core/limits.h"
#include "engine/core/text/nearest_name.h"
#include "engine/core/text/toml_prescan.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <type_traits>

// The library's exceptions stay inside the one function that parses.
#include <toml++/toml.h>

namespace plumbline::app {
void copy_value(const Setting& from, const Setting& to) {
    std::visit(
        [&](const auto& source) {
            const auto& target = std::get<std::decay_t<decltype(source)>>(to.target);
            *target.value = *source.value;
        },
        from.target);
}

namespace {

bool same(const SettingTarget& a, const SettingTarget& b) {
    return std::visit(
        [&](const auto& mine) {
            const auto& other = std::get<std::decay_t<decltype(mine)>>(b);
            return *mine.value == *other.value;
        },
        a);
}

std::string toml_value(const SettingTarget& target) {
    if (const auto* flag = std::get_if<FlagSetting>(&target))
        return *flag->value ? "true" : "false";
    if (const auto* whole = std::get_if<IntSetting>(&target))
        return fmt::format("{}", *whole->value);
    if (const auto* word = std::get_if<WordSetting>(&target))
        return fmt::format("\"{}\"", word->words[*word->value]);
    return fmt::format("{}", *std::get<FloatSetting>(target).value);
}

/// Empty when it was taken.
std::string set(const SettingTarget& target, const toml::node& node) {
    if (const auto* flag = std::get_if<FlagSetting>(&target)) {
        const std::optional<bool> value = node.value_exact<bool>();
        if (!value) return "expected true or false";
        *flag->value = *value;
        return {};
    }
    if (const auto* whole = std::get_if<IntSetting>(&target)) {
        const std::optional<std::int64_t> value = node.value_exact<std::int64_t>();
        if (!value || *value < whole->min || *value > whole->max) {
            return fmt::format("expected a whole number from {} to {}", whole->min, whole->max);
        }
        *whole->value = static_cast<int>(*value);
        return {};
    }
    if (const auto* word = std::get_if<WordSetting>(&target)) {
        const auto found = std::ranges::find(word->words, node.value_or(std::string_view{}));
        if (found == word->words.end())
            return fmt::format("expected one of {}", fmt::join(word->words, ", "));
        *word->value = static_cast<std::uint8_t>(found - word->words.begin());
        return {};
    }
    const auto& real = std::get<FloatSetting>(target);
    const std::optional<double> value = node.value<double>();
    if (!value || !node.is_number() || !std::isfinite(*value) ||
        *value < static_cast<double>(real.min) || *value > static_cast<double>(real.max)) {
        return fmt::format("expected a number from {} to {}", real.min, real.max);
    }
    *real.value = static_cast<float>(*value);
    return {};
}

void apply_entry(const std::string& file,
                 std::string_view table,
                 std::string_view key,
                 const toml::node& node,
                 AppConfig& config,
                 Diagnostics& faults) {
    const auto fault = [&](std::string message) {
        faults.add({.severity = Severity::Warning,
                    .file = file,
                    .line = static_cast<int>(node.source().begin.line),
                    .column = static_cast<int>(node.source().begin.column),
                    .key = table.empty() ? std::string(key) : fmt::format("{}.{}", table, key),
                    .message = std::move(message)});
    };
    if (table == "time" && key == "max_steps_per_frame")
        return fault("this setting was removed. Line ignored.");
    std::vector<std::string_view> known;
    for (const Setting& setting : settings_of(config)) {
        if (setting.table == table && setting.key == key) {
            const std::string wrong = set(setting.target, node);
            if (!wrong.empty()) fault(wrong + "; keeping the previous value");
            return;
        }
        known.push_back(setting.key);
        // A key above the first table.
        if (table.empty() && setting.key == key)
            return fault(fmt::format("expected below [{}]. Line ignored.", setting.table));
    }
    const std::string_view nearest = nearest_name(key, known);
    fault(nearest.empty()
              ? "unknown setting. Line ignored."
              : fmt::format("unknown setting. Nearest: \"{}\". Line ignored.", nearest));
}

void apply_layer(const std::filesystem::path& path, AppConfig& config, Diagnostics& faults) {
    std::error_code ignored;
    if (path.empty() || !std::filesystem::exists(path, ignored)) return;
    const std::string file = path.filename().string();
    const Result<std::string> text = read_file(path, limits::kConfigFileBytes);
    if (!text) {
        faults.add({.severity = Severity::Error, .file = file, .message = text.error().message});
        return;
    }
    if (const std::optional<TextFault> fault = prescan_toml(*text)) {
        faults.add({.severity = Severity::Error,
                    .file = file,
                    .line = fault->line,
                    .column = fault->column,
                    .message = fault->message + "; the whole file is ignored"});
        return;
    }
    toml::table parsed;
    try {
        parsed = toml::parse(*text);
    } catch (const toml::parse_error& error) {
        faults.add({.severity = Severity::Error,
                    .file = file,
                    .line = static_cast<int>(error.source().begin.line),
                    .column = static_cast<int>(error.source().begin.column),
                    .message = fmt::format("{}; the whole file is ignored", error.description())});
        return;
    }
    for (const auto& [table, content] : parsed) {
        const toml::table* entries = content.as_table();
        if (entries == nullptr) {
            if (table.str() != "format")
                apply_entry(file, "", table.str(), content, config, faults);
            continue;
        }
        std::string_view name = table.str();
        if (name == "picture") {
            faults.add({.severity = Severity::Warning,
                        .file = file,
                        .line = static_cast<int>(table.source().begin.line),
                        .column = static_cast<int>(table.source().begin.column),
                        .key = std::string(name),
                        .message = "\"picture\" was renamed to \"image\""});
            name = "image";
        }
        for (const auto& [key, node] : *entries) {
            apply_entry(file, name, key.str(), node, config, faults);
        }
    }
}

template <class Enum>
std::uint8_t* place_of(Enum& value) {
    static_assert(std::is_same_v<std::underlying_type_t<Enum>, std::uint8_t>);
    return reinterpret_cast<std::uint8_t*>(&value);
}

}  // namespace

std::vector<Setting> settings_of(AppConfig& config) {
    return {
        {"window", "width", IntSetting{&config.width, 64, 16384}, "Window width"},
        {"window", "height", IntSetting{&config.height, 64, 16384}, "Window height"},
        {"window", "vsync", FlagSetting{&config.vsync}, "VSync"},
        {"window", "max_fps", IntSetting{&config.max_fps, 10, 10000}, "Frame rate limit"},
        {"window",
         "pause_on_focus_loss",
         FlagSetting{&config.pause_on_focus_loss},
         "Pause when unfocused"},
        {"image",
         "level",
         WordSetting{place_of(config.quality_level), kImageLevelNames},
         "Quality level"},
        {"image", "target_ms", FloatSetting{&config.target_ms, 4, 200}, "Auto: target frame time"},
        {"image", "render_scale", FloatSetting{&config.render_scale, 0, 1}, "Render scale"},
        {"image",
         "anti_aliasing",
         WordSetting{place_of(config.anti_aliasing), kEdgeWishNames},
         "Anti-aliasing"},
        {"image", "fov_deg", FloatSetting{&config.fov_deg, 30, 120}, "Field of view"},
        {"hud", "ui_scale", FloatSetting{&config.ui_scale, 0, 3}, "UI scale"},
        {"hud", "hints", FlagSetting{&config.hints}, "Tutorial hints"},
        {"hud", "reduce_motion", FlagSetting{&config.reduce_motion}, "Reduce motion"},
        {"sound", "master_gain", FloatSetting{&config.master_gain, 0, 1}, "Master volume"},
        {"sound", "effects_gain", FloatSetting{&config.effects_gain, 0, 1}, "Effects volume"},
        {"sound", "ambience_gain", FloatSetting{&config.ambience_gain, 0, 1}, "Ambience volume"},
        {"sound", "ui_gain", FloatSetting{&config.ui_gain, 0, 1}, "Menu volume"},
        {"sound", "mute", FlagSetting{&config.mute}, "Mute"},
        {"sound", "mono", FlagSetting{&config.mono}, "Mono"},
        {"sound", "doppler", FlagSetting{&config.doppler}, "Doppler shift"},
        {"sound", "captions", FlagSetting{&config.captions}, "Sound captions"},
        {"sound", "voices", IntSetting{&config.voices, 1, 256}, "Voice limit"},
    };
}

AppConfig load_app_config(const std::vector<std::filesystem::path>& files, Diagnostics& faults) {
    AppConfig config;
    for (const std::filesystem::path& file : files) apply_layer(file, config, faults);
    return config;
}

std::string ui_config_text(const AppConfig& below, const AppConfig& wanted) {
    AppConfig lower = below;
    AppConfig upper = wanted;
    const std::vector<Setting> before = settings_of(lower);
    const std::vector<Setting> after = settings_of(upper);
    std::string text =
        "# Written by Plumbline's settings pages. Your own lines belong in app.toml beside it,\n"
        "# which the program never writes; this file is laid over it.\n"
        "format = 1\n";
    std::string_view table;
    for (std::size_t i = 0; i < after.size(); ++i) {
        if (same(before[i].target, after[i].target)) continue;
        if (after[i].table != table) text += fmt::format("\n[{}]\n", after[i].table);
        table = after[i].table;
        text += fmt::format("{} = {}\n", after[i].key, toml_value(after[i].target));
    }
    return text;
}

}  // namespace plumbline::app
