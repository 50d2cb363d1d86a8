// The pages of the menu: what is on them and what choosing does.
#pragma once

#include "engine/app/controls/live_bindings.h"
#include "engine/app/settings/live_config.h"
#include "engine/app/ui/menu.h"
#include "engine/input/bindings_edit.h"
#include "engine/scene/paths/scene_list.h"
#include "engine/scene/simulation.h"
#include "engine/study/setting.h"

#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace plumbline::app::ui {

/// A place for a saved game of the running scene.
struct SaveSlot {
    int number{1};
    std::string saved{};    ///< when, for people; empty: nothing is there
    bool is_latest{false};  ///< what the keys save to and load from
};

/// What the pages read and do. All of it must outlive them. So many fields because each thing that can be
/// chosen in the menu is one.
struct MenuWorld {
    const LiveConfig& config;
    const LiveBindings& bindings;
    const std::vector<scene::ListedScene>& scenes;
    std::string scene_title;                   ///< of the one that is open
    std::function<study::Setting()> accuracy;  ///< as the world runs now
    bool accuracy_is_recorded{false};          ///< it cannot be changed then

    std::function<void(const AppConfig&)> change_config;
    std::function<void(const input::Bindings&)> change_bindings;
    std::function<void(const study::Setting&)> change_accuracy;
    std::function<void()> adopt_accuracy;  ///< into a copy of the scene
    std::function<bool()> looks_at_model;  ///< a model by itself is turned, nobody plays
    std::function<void(const std::filesystem::path&)> open_scene;
    std::function<scene::LiveSwitches&()> switches;    ///< of the running scene
    std::function<scene::FogDescription()> scene_fog;  ///< as the scene has it, or a plain one
    std::function<std::optional<double>()>
        hour;  ///< of the scene's day; none: its sun stands still
    std::function<void(double)> set_hour;
    std::function<void()> start_again;
    std::function<std::vector<SaveSlot>()> save_slots;
    std::function<void(int)> save_game;  ///< to the slot of this number
    std::function<void(int)> load_game;
    std::function<void()> quit;
    std::function<void()> forget_first_minute;
};

class MenuPages {
public:
    MenuPages(Menu& menu, MenuWorld world) : menu_(menu), world_(std::move(world)) {}
    MenuPages(const MenuPages&) = delete;
    MenuPages& operator=(const MenuPages&) = delete;

    /// With the running scene behind it, which goes on from here.
    Page start();
    Page in_play();
    Page help();

    /// Whether a gamepad is plugged in: the help speaks of its buttons only then.
    void set_pad_present(bool present) { has_pad_ = present; }
    /// While a press is waited for, the devices' events belong here and nowhere else.
    bool waits_for_press() const { return capture_.has_value(); }
    void take_press(const InputSnapshot& input);

private:
    enum class Tab : std::uint8_t { Image, Sound, Mouse, Screen, Light, Accuracy };
    /// The place of a binding that waits for its press.
    struct Slot {
        Action action{Action::Count};
        std::size_t index{0};
    };

    // pages.cpp
    Page all_scenes();
    Page saved_games();
    Page folder(const std::string& name);
    std::vector<Cell> cards(const std::string& folder, bool are_users_own);
    void add_scenes(Page& page);
    Cell to_page(std::string text, Icon icon, Page (MenuPages::*page)());
    Cell back_cell();
    void add_help_group(Page& page, ActionGroup group, std::span<const Action> shown_above);

    // settings_pages.cpp
    Page settings();
    void add_settings(Page& page, std::vector<std::string_view> tables);
    void add_mouse(Page& page);
    void add_accuracy(Page& page);
    Line setting_line(std::size_t row);
    void change_setting(std::size_t row, const std::function<void(const Setting&)>& change);

    // light_page.cpp
    void add_light(Page& page);
    Line fog_colors();
    void add_hour(Page& page, double hour);

    // controls_pages.cpp
    Page controls();
    Page press_page();
    Page conflict_page();
    Line binding_line(Action action);
    void change_bindings(const std::function<void(input::Bindings&)>& change);
    void wait_for_press(Slot slot);
    void bind(Slot slot, const input::Input& input);

    Menu& menu_;
    MenuWorld world_;
    Tab tab_{Tab::Image};
    bool has_pad_{false};
    bool capture_begins_{false};
    std::optional<input::PressCapture> capture_;
    Slot slot_;
    std::string refused_;  ///< why the last press could not drive the action
    std::optional<input::Input> wanted_;
};

}  // namespace plumbline::app::ui
