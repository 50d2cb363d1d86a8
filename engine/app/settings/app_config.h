// Settings of the program itself, layer over layer: built-in, config/app.toml as shipped, the
// user's own app.toml, and app.ui.toml, which the settings pages write. The user's own file is
// never written by the program.
#pragma once

#include "engine/core/text/diagnostics.h"

#include <array>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace plumbline::app {

enum class QualityLevel : std::uint8_t { Auto, Low, Medium, High };
inline constexpr std::array<std::string_view, 4> kImageLevelNames{"auto", "low", "medium", "high"};

enum class EdgeWish : std::uint8_t { Auto, Off, Fxaa, Msaa2, Msaa4, Msaa8 };
inline constexpr std::array<std::string_view, 6> kEdgeWishNames{
    "auto", "off", "fxaa", "msaa2", "msaa4", "msaa8"};

/// So many fields because each key of app.toml is one.
struct AppConfig {
    int width{1280};  ///< [window]
    int height{720};
    bool vsync{true};
    int max_fps{240};  ///< when vsync does not hold the loop back
    bool pause_on_focus_loss{false};
    QualityLevel quality_level{QualityLevel::Auto};  ///< [image]
    float target_ms{33.0F};                          ///< of a frame: what the level `auto` aims at
    float render_scale{0.0F};                        ///< of each side of the image; 0: by the level
    EdgeWish anti_aliasing{EdgeWish::Auto};          ///< auto: by the level, and by what draws
    float fov_deg{70.0F};  ///< upright field of view of a walker; other cameras follow
    float ui_scale{0.0F};  ///< [hud] 0: from window and screen
    bool hints{true};
    bool reduce_motion{false};  ///< nothing fades, sways or turns by itself
    float master_gain{1.0F};    ///< [sound] 0…1
    float effects_gain{1.0F};   ///< of what strikes, steps and breaks
    float ambience_gain{1.0F};  ///< of what sounds on: wind, insects, rolling
    float ui_gain{0.5F};        ///< of the menu's own sounds
    bool mute{false};
    bool mono{false};      ///< every sound as loud on both sides
    bool doppler{false};   ///< what comes is heard higher, what goes lower
    bool captions{false};  ///< loud events in words, with an arrow to where they are
    int voices{32};

    friend bool operator==(const AppConfig&, const AppConfig&) = default;
};

struct FlagSetting {
    bool* value;
};
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
/// One of some words; `value` is the place of an enumeration that counts them.
struct WordSetting {
    std::uint8_t* value;
    std::span<const std::string_view> words;
};
using SettingTarget = std::variant<IntSetting, FloatSetting, FlagSetting, WordSetting>;

/// One key of app.toml and the place of its value.
struct Setting {
    std::string_view table;
    std::string_view key;
    SettingTarget target;
    std::string_view label;  ///< as a settings page words it
};

/// Every setting of `config`, table after table: what reading, writing and the pages go through.
std::vector<Setting> settings_of(AppConfig& config);

/// Both of the same row.
void copy_value(const Setting& from, const Setting& to);

/// Lays the files over the built-in values, in order. Missing files mean nothing; bad entries cost
/// only themselves and are warnings; a file that is left out as a whole is an error.
AppConfig load_app_config(const std::vector<std::filesystem::path>& files, Diagnostics& faults);

/// The text of app.ui.toml: the settings in which `wanted` differs from the layers below.
std::string ui_config_text(const AppConfig& below, const AppConfig& wanted);

}  // namespace plumbline::app
