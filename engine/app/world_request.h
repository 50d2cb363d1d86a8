// What a person changes in the running world beside playing in it: in the menu, in the accuracy panel,
// with the bar of an animation. Plain data: Session::apply() does it between two steps, and a
// recording keeps it.
#pragma once

#include "engine/core/io/archive.h"
#include "engine/study/setting.h"

#include <cstdint>
#include <optional>
#include <string>
#include <variant>

namespace plumbline::app {

/// The scene from its start.
struct StartAgain {
    friend bool operator==(const StartAgain&, const StartAgain&) = default;
    void serialize(Archive&) {}
};

/// An effect of LiveSwitches on or off; absent: as the scene says.
struct SwitchEffect {
    std::string effect;
    std::optional<bool> on{};
    friend bool operator==(const SwitchEffect&, const SwitchEffect&) = default;
    void serialize(Archive& archive);
};

struct SetFog {
    float density_scale{1.0F};  ///< of what the scene says
    std::uint32_t color{0};     ///< in scene::kFogColors
    friend bool operator==(const SetFog&, const SetFog&) = default;
    void serialize(Archive& archive);
};

/// Sun and sky.
struct SetLight {
    float scale{1.0F};
    friend bool operator==(const SetLight&, const SetLight&) = default;
    void serialize(Archive& archive);
};

/// In a scene with [time].
struct SetHour {
    double hour{12};  ///< 0 to 24
    friend bool operator==(const SetHour&, const SetHour&) = default;
    void serialize(Archive& archive);
};

/// Until another scene is opened. A hard case starts again: what it showed at one setting says nothing
/// about another.
struct SetAccuracy {
    study::Setting setting;
    friend bool operator==(const SetAccuracy&, const SetAccuracy&) = default;
    void serialize(Archive& archive);
};

/// Of every model that plays an animation.
struct SetAnimation {
    double time_s{0};
    bool paused{false};
    bool next{false};  ///< the next animation of the file, from its start
    friend bool operator==(const SetAnimation&, const SetAnimation&) = default;
    void serialize(Archive& archive);
};

/// In the order of recordings: new kinds come last.
using WorldRequest =
    std::variant<StartAgain, SwitchEffect, SetFog, SetLight, SetHour, SetAccuracy, SetAnimation>;

/// Reading fails the archive where a value is out of its range.
void serialize(Archive& archive, WorldRequest& request);

}  // namespace plumbline::app
