// What a person may ask for, by name, and what one simulation step is told of it. Plain data:
// the input module fills it, the game reads it, a recording stores it.
#pragma once

#include <array>
#include <bitset>
#include <cstdint>
#include <optional>
#include <string_view>

namespace plumbline {

/// Tables of the bindings file, and which actions are live together.
enum class ActionGroup : std::uint8_t { Walk, Things, View, Light, CameraPath, Time, Menu };

// THE list of actions: enumerator; name in files and on the command line; group; what people read in the
// help, on the controls pages and in messages.
#define PL_ACTIONS(ROW)                                                                       \
    ROW(Forward, "forward", Walk, "Move forward")                                             \
    ROW(Back, "back", Walk, "Move back")                                                      \
    ROW(Left, "left", Walk, "Move left")                                                      \
    ROW(Right, "right", Walk, "Move right")                                                   \
    ROW(Look, "look", Walk, "Look around")                                                    \
    ROW(Jump, "jump", Walk, "Jump; when flying: up")                                          \
    ROW(Crouch, "crouch", Walk, "Crouch; when flying: down")                                  \
    ROW(Sprint, "sprint", Walk, "Sprint")                                                     \
    ROW(MoveMode, "move_mode", Walk, "Switch between walk, fly and orbit")                    \
    ROW(Select1, "select_1", Things, "Select crate")                                          \
    ROW(Select2, "select_2", Things, "Select ball")                                           \
    ROW(Select3, "select_3", Things, "Select barrel")                                         \
    ROW(Select4, "select_4", Things, "Select brick")                                          \
    ROW(Select5, "select_5", Things, "Select plank")                                          \
    ROW(Select6, "select_6", Things, "Select stone")                                          \
    ROW(Select7, "select_7", Things, "Select domino")                                         \
    ROW(Select8, "select_8", Things, "Select object 8")                                       \
    ROW(Select9, "select_9", Things, "Select object 9")                                       \
    ROW(NextThing, "next_thing", Things, "Next object")                                       \
    ROW(PreviousThing, "previous_thing", Things, "Previous object")                           \
    ROW(Drop, "drop", Things, "Drop the selected object")                                     \
    ROW(Throw, "throw", Things, "Throw (hold to throw harder)")                               \
    ROW(Grab, "grab", Things, "Grab or release")                                              \
    ROW(Use, "use", Things, "Open, close, switch, sit on or drive the object")                \
    ROW(RotateHeld, "rotate_held", Things, "Rotate the held object (hold)")                   \
    ROW(Push, "push", Things, "Push the held object away; otherwise: move faster")            \
    ROW(Pull, "pull", Things, "Pull the held object closer; otherwise: move slower")          \
    ROW(Freeze, "freeze", Things, "Freeze or unfreeze the object")                            \
    ROW(Remove, "remove", Things, "Delete the object")                                        \
    ROW(UndoDrop, "undo_drop", Things, "Undo the last drop")                                  \
    ROW(Shoot, "shoot", Things, "Shoot a 1 kg box at 25 m/s")                                 \
    ROW(Tie, "tie", Things, "Tie a rope from here to there, or cut the rope")                 \
    ROW(Lift, "lift", Things, "Lift the object with 20 N (hold)")                             \
    ROW(Explode, "explode", Things, "Explosion at the crosshair")                             \
    ROW(Flashlight, "flashlight", View, "Flashlight on/off")                                  \
    ROW(Fog, "fog", View, "Fog on/off")                                                       \
    ROW(FogDenser, "fog_denser", View, "Increase fog density")                                \
    ROW(FogThinner, "fog_thinner", View, "Decrease fog density")                              \
    ROW(FogColor, "fog_color", View, "Next fog colour")                                       \
    ROW(Filled, "filled", View, "Solid view")                                                 \
    ROW(Wireframe, "wireframe", View, "Wireframe view")                                       \
    ROW(Points, "points", View, "Point view")                                                 \
    ROW(CollisionShapes, "collision_shapes", View, "Show collision shapes")                   \
    ROW(CollisionBoxes, "collision_boxes", View, "Show bounding boxes")                       \
    ROW(DepthTest, "depth_test", View, "Next depth test mode")                                \
    ROW(Hud, "hud", View, "Show or hide the HUD")                                             \
    ROW(Help, "help", View, "Help")                                                           \
    ROW(Stats, "stats", View, "Frame statistics")                                             \
    ROW(AccuracyPanel, "accuracy_panel", View, "Accuracy panel")                              \
    ROW(Screenshot, "screenshot", View, "Screenshot")                                         \
    ROW(Record, "record", View, "Save an input recording")                                    \
    ROW(Film, "film", View, "Start or stop video")                                            \
    ROW(Fullscreen, "fullscreen", View, "Fullscreen on/off")                                  \
    ROW(ZoomIn, "zoom_in", View, "Zoom in")                                                   \
    ROW(ZoomOut, "zoom_out", View, "Zoom out")                                                \
    ROW(RotateLeft, "rotate_left", View, "Turn left")                                         \
    ROW(RotateRight, "rotate_right", View, "Turn right")                                      \
    ROW(Grid, "grid", View, "Model viewer: grid")                                             \
    ROW(Axes, "axes", View, "Model viewer: axes")                                             \
    ROW(Normals, "normals", View, "Model viewer: normals")                                    \
    ROW(Turntable, "turntable", View, "Model viewer: turntable")                              \
    ROW(Ground, "ground", View, "Model viewer: ground on/off")                                \
    ROW(Background, "background", View, "Model viewer: next background")                      \
    ROW(AnimationPause, "animation_pause", View, "Pause or resume model animation")           \
    ROW(NextAnimation, "next_animation", View, "Next model animation")                        \
    ROW(TurnModel, "turn_model", View, "Model viewer: rotate the model (hold)")               \
    ROW(ShiftModel, "shift_model", View, "Model viewer: pan the model (hold)")                \
    ROW(Shading, "shading", View, "Blinn-Phong shading on/off")                               \
    ROW(Textures, "textures", View, "Textures on/off")                                        \
    ROW(SunShadow, "sun_shadow", View, "Sun shadows on/off")                                  \
    ROW(SunFaster, "sun_faster", Light, "Speed up the sun")                                   \
    ROW(SunStop, "sun_stop", Light, "Stop the sun")                                           \
    ROW(LightBrighter, "light_brighter", Light, "Brighter light")                             \
    ROW(LightDimmer, "light_dimmer", Light, "Dimmer light")                                   \
    ROW(AimSpot, "aim_spot", Light, "Aim the spotlight (hold)")                               \
    ROW(CameraRecord, "camera_record", CameraPath, "Start or stop recording the camera path") \
    ROW(CameraPlay, "camera_play", CameraPath, "Play or stop the camera path")                \
    ROW(CameraReload, "camera_reload", CameraPath, "Reload the camera path")                  \
    ROW(Pause, "pause", Time, "Pause or resume")                                              \
    ROW(Step, "step", Time, "Advance one step")                                               \
    ROW(Slower, "slower", Time, "Slow down time")                                             \
    ROW(Faster, "faster", Time, "Speed up time")                                              \
    ROW(Reset, "reset", Time, "Reset scene")                                                  \
    ROW(QuickSave, "quick_save", Time, "Quick save")                                          \
    ROW(QuickLoad, "quick_load", Time, "Quick load")                                          \
    ROW(Reload, "reload", Time, "Reload the scene file")                                      \
    ROW(Menu, "menu", Menu, "Menu")                                                           \
    ROW(Accept, "accept", Menu, "Confirm")                                                    \
    ROW(BackOut, "back_out", Menu, "Back")

#define PL_ENUMERATOR(action, name, group, words) action,
enum class Action : std::uint8_t { PL_ACTIONS(PL_ENUMERATOR) Count };
#undef PL_ENUMERATOR

inline constexpr std::size_t kActionCount = static_cast<std::size_t>(Action::Count);
/// Its place in arrays of kActionCount.
constexpr std::size_t index_of(Action action) {
    return static_cast<std::size_t>(action);
}

std::string_view action_name(Action action);  ///< "undo_drop"
std::optional<Action> action_from_name(std::string_view name);
ActionGroup group_of(Action action);
std::string_view action_words(Action action);     ///< "Undo the last drop"
std::string_view group_name(ActionGroup group);   ///< "camera_path"
std::string_view group_words(ActionGroup group);  ///< "Camera path"

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
