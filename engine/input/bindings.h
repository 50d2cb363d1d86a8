// Which keys, buttons, wheels and sticks drive which actions: the bindings file, its layers and its
// faults. Parsing only; action_latch.h applies the result to devices.
//
// Layers, lowest first: built-in table, config/bindings.toml as shipped, a profile
// (config/controls/NAME.toml), the user's bindings.toml, the user's bindings.ui.toml, --bind.
// A higher layer replaces an action's whole list; [] unbinds it.
#pragma once

#include "engine/core/actions.h"
#include "engine/core/result.h"
#include "engine/core/text/diagnostics.h"

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace plumbline::input {

enum class DeviceKind : std::uint8_t {
    Key,
    Label,
    MouseButton,
    MouseMove,
    Wheel,
    PadButton,
    PadAxis,
    PadStick
};

enum Modifier : std::uint8_t { kCtrl = 1, kShift = 2, kAlt = 4, kSuper = 8 };

/// One way to drive an action.
struct Input {
    DeviceKind kind{DeviceKind::Key};
    int code{
        0};  ///< GLFW key, button or axis; wheel 0 up 1 down 2 left 3 right; stick 0 left 1 right
    int direction{0};           ///< pad axis: -1 or +1
    std::uint8_t modifiers{0};  ///< chord: all of these must be down
    char label{0};              ///< Label only: what the key prints
    std::string word;    ///< canonical, as printed by `plumbline controls`: "ctrl+r", "mouse.left"
    std::string origin;  ///< "built-in", "bindings.toml:14", "--bind"

    friend bool operator==(const Input& a, const Input& b) {
        return a.kind == b.kind && a.code == b.code && a.direction == b.direction &&
               a.modifiers == b.modifiers && a.label == b.label;
    }
};

enum class HoldMode : std::uint8_t { Hold, Toggle };

struct Tuning {
    float mouse_deg_per_count{0.066F};
    bool invert_y{false};
    float pad_look_deg_per_s{180.0F};
    float pad_inner_dead_zone{0.15F};
    float pad_outer_dead_zone{0.02F};
    float pad_curve{2.0F};
    float trigger_threshold{0.5F};
    bool free_pointer{false};  ///< the mouse moves a pointer and turns no view
};

struct Bindings {
    std::array<std::vector<Input>, kActionCount> inputs;
    std::array<HoldMode, kActionCount> hold_mode{};
    Tuning tuning{};
    /// Which layer an action's list comes from, also where that list is empty: "bindings.toml:14".
    std::array<std::string, kActionCount> origin;
    /// What happened to the list since: inputs that other layers took away.
    std::array<std::vector<std::string>, kActionCount> notes;
    /// Layers that could not be parsed and count for nothing. After a reload that has some, keep
    /// the table from before: a file being edited is not one being given up.
    std::vector<std::string> left_out;

    const std::vector<Input>& of(Action action) const { return inputs[index_of(action)]; }
};

/// One layer to lay over what is there.
struct BindingLayer {
    std::string name;  ///< file name as the person knows it
    std::string text;  ///< TOML
};

/// The whole stack of files for this user, in order; missing files are left out, unreadable ones
/// (folders, FIFOs, no permission, too large) noted in `faults`. `user_config_folder` may be empty (no
/// home).
struct BindingSources {
    std::vector<BindingLayer> layers;
    std::vector<std::filesystem::path> watched;  ///< files to reload on, existing or not
    std::vector<std::string> left_out;  ///< there, but not readable; see Bindings::left_out
};
/// Of the profiles book, nature and viewer: the one that was asked for; where it is empty the one of
/// `profile = "NAME"` in the user's bindings.toml; else the usual one; else none.
struct ProfileChoice {
    std::string_view asked{};
    std::string_view usual{};
};
BindingSources find_binding_sources(const std::filesystem::path& shipped_config_folder,
                                    const std::filesystem::path& user_config_folder,
                                    const ProfileChoice& profile,
                                    Diagnostics& faults);

/// Lays the layers over the built-in table and settles conflicts: a user's input takes that input
/// away from any default in the same conflict domain (said in a warning); of two lines in one layer
/// the second is refused, both named. A bad entry costs only itself.
/// `command_line`: "action=key[,key]" each.
Bindings load_bindings(const std::vector<BindingLayer>& layers,
                       const std::vector<std::string>& command_line,
                       Diagnostics& faults);

/// The other actions that this input drives while `action` is live.
std::vector<Action> also_drives(const Bindings& bindings, const Input& input, Action action);
/// Why this input cannot drive this action at all; empty when it can.
std::string why_not(const Bindings& bindings, const Input& input, Action action);

/// What the program has with no file at all: config/bindings.toml as it was built with.
Bindings built_in_bindings();

/// "left_shift", "mouse.left", "ctrl+f5", "pad.left_y-"; Quake-like aliases ("mouse1", "mwheelup",
/// "uparrow") are taken and canonical words given back.
Result<Input> parse_input(std::string_view word);

/// What this key, button, wheel step or axis is called, with its chord; nothing where it has no word.
std::optional<Input> input_of(DeviceKind kind, int code, int direction, std::uint8_t modifiers);

/// Every word that parse_input takes, canonical spelling, for --list-keys and nearest names.
const std::vector<std::string_view>& input_words();

/// The effective table as TOML, a comment on each line saying which layer it came from.
std::string print_bindings(const Bindings& bindings);
/// The list of a line, as TOML: ["w", "up"].
std::string inputs_text(const std::vector<Input>& inputs);

}  // namespace plumbline::input
