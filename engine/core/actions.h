// What a person may ask for, by name, and what one simulation step is told of it. Plain data:
// the input module fills it, the game reads it, a recording stores it.
#pragma once

#include <array>
#include <bitset>
#include <cstdint>
#include <optional>
#include <string_view>

namespace plumbline {

/// Every action. The names in files and on the command line are those of action_name().
enum class Action : std::uint8_t {
    // walk
    Forward,
    Back,
    Left,
    Right,
    Look,
    Jump,
    Crouch,
    Sprint,
    MoveMode,
    // things
    Select1,
    Select2,
    Select3,
    Select4,
    Select5,
    Select6,
    Select7,
    Select8,
    Select9,
    NextThing,
    PreviousThing,
    Drop,
    Throw,
    Grab,
    Use,
    RotateHeld,
    Push,
    Pull,
    Freeze,
    Remove,
    UndoDrop,
    Shoot,
    Lift,
    Explode,
    // view
    Flashlight,
    Fog,
    FogDenser,
    FogThinner,
    FogColor,
    Filled,
    Wireframe,
    Points,
    CollisionShapes,
    CollisionBoxes,
    DepthTest,
    Hud,
    Help,
    Stats,
    AccuracyPanel,
    Screenshot,
    Record,
    Film,
    Fullscreen,
    ZoomIn,
    ZoomOut,
    RotateLeft,
    RotateRight,
    Grid,
    Axes,
    Normals,
    Turntable,
    Ground,
    Background,
    AnimationPause,
    NextAnimation,
    TurnModel,
    ShiftModel,
    Shading,
    Textures,
    SunShadow,
    // light
    SunFaster,
    SunStop,
    LightBrighter,
    LightDimmer,
    AimSpot,
    // camera path
    CameraRecord,
    CameraPlay,
    CameraReload,
    // time
    Pause,
    Step,
    Slower,
    Faster,
    Reset,
    QuickSave,
    QuickLoad,
    Reload,
    // menu
    Menu,
    Accept,
    BackOut,
    Count
};

inline constexpr std::size_t kActionCount = static_cast<std::size_t>(Action::Count);
/// Its place in arrays of kActionCount.
constexpr std::size_t index_of(Action action) {
    return static_cast<std::size_t>(action);
}

/// Tables of the bindings file, and which actions are live together.
enum class ActionGroup : std::uint8_t { Walk, Things, View, Light, CameraPath, Time, Menu };

std::string_view action_name(Action action);  ///< "undo_drop"
std::optional<Action> action_from_name(std::string_view name);
ActionGroup group_of(Action action);
std::string_view group_name(ActionGroup group);  ///< "camera_path"

/// What one fixed step sees. A press is in exactly one step, whatever the frame rate.
struct Actions {
    std::bitset<kActionCount> held{};                  ///< down now, after hold/toggle modes
    std::array<std::uint8_t, kActionCount> pressed{};  ///< presses since the last step
    std::array<float, kActionCount> amount{};          ///< 0…1: stick travel; 1 for a key held
    float look_yaw_rad{0.0F};    ///< turned left is positive, since the last step
    float look_pitch_rad{0.0F};  ///< up is positive, since the last step
    /// Where a free pointer is: right and up of the image's middle, per unit that the camera looks
    /// ahead. None: hands go where the camera looks.
    std::optional<std::array<float, 2>> pointer{};

    bool is_held(Action action) const { return held[index_of(action)]; }
    int presses(Action action) const { return pressed[index_of(action)]; }
    float amount_of(Action action) const { return amount[index_of(action)]; }
};

}  // namespace plumbline
