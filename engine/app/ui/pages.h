// The pages of the menu: what is on them and what choosing asks for.
#pragma once

#include "engine/app/controls/live_bindings.h"
#include "engine/app/request.h"
#include "engine/app/settings/best_results.h"
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
#include <utility>
#include <vector>

namespace plumbline::app::ui {

/// A place for a saved game of the running scene.
struct SaveSlot {
    int number{1};
    std::string saved{};    ///< when, for people; empty: nothing is there
    bool is_latest{false};  ///< what the keys save to and load from
};

/// What the pages show: the program as it is at the beginning of a frame. Pages change their copy as
/// something is chosen, so that every press of a frame counts, and ask for the same.
struct MenuWorld {
    const LiveBindings* bindings{nullptr};  ///< must outlive the menu, as the scenes
    const std::vector<scene::ListedScene>* scenes{nullptr};
    AppConfig config{};
    AppConfig config_below{};  ///< where "reset" leads back to
    std::string scene_title{};
    bool replaying{false};       ///< a recording keeps its accuracy
    bool looks_at_model{false};  ///< a model by itself is turned, nobody plays
    study::Setting accuracy{};   ///< as the world runs
    scene::LiveSwitches switches{};
    scene::FogDescription fog{.on = false};  ///< as the scene has it, or a plain one
    std::optional<double> hour{};            ///< of the scene's day; none: its sun stands still
    std::vector<SaveSlot> saves{};
    const BestResults* results{nullptr};  ///< of small games; null: none are kept
};

class MenuPages {
public:
    MenuPages(Menu& menu, MenuWorld world) : menu_(menu), world_(std::move(world)) {}
    MenuPages(const MenuPages&) = delete;
    MenuPages& operator=(const MenuPages&) = delete;

    /// Once a frame, before what was pressed in it.
    void show(MenuWorld world) {
        world_ = std::move(world);
        changed_bindings_.reset();
    }
    /// What was chosen since the last call.
    Requests take_requests() { return std::exchange(requests_, {}); }
    const LiveBindings& bindings() const { return *world_.bindings; }

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

    void ask(Request request) { requests_.push_back(std::move(request)); }

    // pages.cpp
    Page all_scenes();
    Page games();
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
    void change_accuracy(const study::Setting& setting);

    // light_page.cpp
    void add_light(Page& page);
    Line fog_colors();
    void add_hour(Page& page, double hour);
    void switch_effect(const std::string& effect, std::optional<bool> on);
    void set_fog(float density_scale, std::size_t color);
    void set_light(float scale);
    void set_hour(double hour);

    // controls_pages.cpp
    Page controls();
    Page press_page();
    Page conflict_page();
    Line binding_line(Action action);
    /// As they are stored, with what was changed in this frame.
    const input::Bindings& stored() const {
        return changed_bindings_ ? *changed_bindings_ : world_.bindings->stored();
    }
    void change_bindings(const std::function<void(input::Bindings&)>& change);
    void wait_for_press(Slot slot);
    void bind(Slot slot, const input::Input& input);

    Menu& menu_;
    MenuWorld world_;
    std::optional<input::Bindings> changed_bindings_;
    Requests requests_;
    Tab tab_{Tab::Image};
    bool has_pad_{false};
    bool capture_begins_{false};
    std::optional<input::PressCapture> capture_;
    Slot slot_;
    std::string refused_;  ///< why the last press could not drive the action
    std::optional<input::Input> wanted_;
};

}  // namespace plumbline::app::ui
