#include "engine/core/actions.h"

#include "engine/core/assert.h"

namespace plumbline {
namespace {

struct ActionRow {
    std::string_view name;
    ActionGroup group;
};

using enum ActionGroup;

// In the order of the enumeration.
constexpr std::array<ActionRow, kActionCount> kRows{{
    {"forward", Walk},
    {"back", Walk},
    {"left", Walk},
    {"right", Walk},
    {"look", Walk},
    {"jump", Walk},
    {"crouch", Walk},
    {"sprint", Walk},
    {"move_mode", Walk},
    {"select_1", Things},
    {"select_2", Things},
    {"select_3", Things},
    {"select_4", Things},
    {"select_5", Things},
    {"select_6", Things},
    {"select_7", Things},
    {"select_8", Things},
    {"select_9", Things},
    {"next_thing", Things},
    {"previous_thing", Things},
    {"drop", Things},
    {"throw", Things},
    {"grab", Things},
    {"use", Things},
    {"rotate_held", Things},
    {"push", Things},
    {"pull", Things},
    {"freeze", Things},
    {"remove", Things},
    {"undo_drop", Things},
    {"shoot", Things},
    {"lift", Things},
    {"explode", Things},
    {"flashlight", View},
    {"fog", View},
    {"fog_denser", View},
    {"fog_thinner", View},
    {"fog_color", View},
    {"filled", View},
    {"wireframe", View},
    {"points", View},
    {"collision_shapes", View},
    {"collision_boxes", View},
    {"depth_test", View},
    {"hud", View},
    {"help", View},
    {"stats", View},
    {"accuracy_panel", View},
    {"screenshot", View},
    {"record", View},
    {"film", View},
    {"fullscreen", View},
    {"zoom_in", View},
    {"zoom_out", View},
    {"rotate_left", View},
    {"rotate_right", View},
    {"grid", View},
    {"axes", View},
    {"normals", View},
    {"turntable", View},
    {"ground", View},
    {"background", View},
    {"animation_pause", View},
    {"next_animation", View},
    {"turn_model", View},
    {"shift_model", View},
    {"shading", View},
    {"textures", View},
    {"sun_shadow", View},
    {"sun_faster", Light},
    {"sun_stop", Light},
    {"light_brighter", Light},
    {"light_dimmer", Light},
    {"aim_spot", Light},
    {"camera_record", CameraPath},
    {"camera_play", CameraPath},
    {"camera_reload", CameraPath},
    {"pause", Time},
    {"step", Time},
    {"slower", Time},
    {"faster", Time},
    {"reset", Time},
    {"quick_save", Time},
    {"quick_load", Time},
    {"reload", Time},
    {"menu", Menu},
    {"accept", Menu},
    {"back_out", Menu},
}};

}  // namespace

std::string_view action_name(Action action) {
    PL_ASSERT(action < Action::Count, "an action");
    return kRows[index_of(action)].name;
}

std::optional<Action> action_from_name(std::string_view name) {
    for (std::size_t i = 0; i < kRows.size(); ++i) {
        if (kRows[i].name == name) return static_cast<Action>(i);
    }
    return std::nullopt;
}

ActionGroup group_of(Action action) {
    PL_ASSERT(action < Action::Count, "an action");
    return kRows[index_of(action)].group;
}

std::string_view group_name(ActionGroup group) {
    switch (group) {
        case Walk:
            return "walk";
        case Things:
            return "things";
        case View:
            return "view";
        case Light:
            return "light";
        case CameraPath:
            return "camera_path";
        case Time:
            return "time";
        case ActionGroup::Menu:
            return "menu";
    }
    return "";
}

}  // namespace plumbline
