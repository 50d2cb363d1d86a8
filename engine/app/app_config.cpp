#include "engine/app/app_config.h"

#include "engine/core/files.h"
#include "engine/core/limits.h"
#include "engine/core/nearest_name.h"
#include "engine/core/toml_prescan.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <variant>

// The library's exceptions stay inside the one function that parses.
#include <toml++/toml.h>

namespace plumbline::app {
namespace {

struct IntSetting {
    int* value;
    int min;
    int max;
};
struct FloatSetting {
    float* value;
    float min;
    float max;
};
using Target = std::variant<IntSetting, FloatSetting, bool*>;

struct Setting {
    std::string_view table;
    std::string_view key;
    Target target;
};

std::array<Setting, 10> settings_of(AppConfig& config) {
    return {{{"window", "width", IntSetting{&config.width, 64, 16384}},
             {"window", "height", IntSetting{&config.height, 64, 16384}},
             {"window", "vsync", &config.vsync},
             {"window", "max_fps", IntSetting{&config.max_fps, 10, 10000}},
             {"window", "pause_on_focus_loss", &config.pause_on_focus_loss},
             {"time", "max_steps_per_frame", IntSetting{&config.max_steps_per_frame, 1, 64}},
             {"hud", "ui_scale", FloatSetting{&config.ui_scale, 0.0F, 4.0F}},
             {"hud", "hints", &config.hints},
             {"sound", "master_gain", FloatSetting{&config.master_gain, 0.0F, 1.0F}},
             {"sound", "voices", IntSetting{&config.voices, 1, 256}}}};
}

/// Empty when it was taken.
std::string set(const Target& target, const toml::node& node) {
    if (bool* const* flag = std::get_if<bool*>(&target)) {
        const std::optional<bool> value = node.value_exact<bool>();
        if (!value) return "expected true or false";
        **flag = *value;
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
                    .key = fmt::format("{}.{}", table, key),
                    .message = std::move(message)});
    };
    std::array<std::string_view, 10> known;
    std::size_t count = 0;
    for (const Setting& setting : settings_of(config)) {
        if (setting.table == table && setting.key == key) {
            const std::string wrong = set(setting.target, node);
            if (!wrong.empty()) fault(wrong + "; the value before it stands");
            return;
        }
        known[count++] = setting.key;
    }
    const std::string_view nearest = nearest_name(key, known);
    fault(nearest.empty()
              ? "no such setting. Line ignored."
              : fmt::format("no such setting. Nearest: \"{}\". Line ignored.", nearest));
}

void apply_layer(const std::filesystem::path& path, AppConfig& config, Diagnostics& faults) {
    std::error_code ignored;
    if (path.empty() || !std::filesystem::exists(path, ignored)) return;
    const std::string file = path.filename().string();
    const Result<std::string> text = read_file(path, limits::kConfigFileBytes);
    if (!text) {
        faults.add({.severity = Severity::Warning, .file = file, .message = text.error().message});
        return;
    }
    if (const std::optional<TextFault> fault = prescan_toml(*text)) {
        faults.add({.severity = Severity::Warning,
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
        faults.add({.severity = Severity::Warning,
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
        for (const auto& [key, node] : *entries) {
            apply_entry(file, table.str(), key.str(), node, config, faults);
        }
    }
}

}  // namespace

AppConfig load_app_config(const std::filesystem::path& shipped_folder,
                          const std::filesystem::path& user_folder,
                          Diagnostics& faults) {
    AppConfig config;
    apply_layer(shipped_folder / "app.toml", config, faults);
    if (!user_folder.empty()) apply_layer(user_folder / "app.toml", config, faults);
    return config;
}

}  // namespace plumbline::app
