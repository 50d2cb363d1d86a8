// The menu over settings and controls in a folder of their own, pressed as a person would.
#pragma once

#include "engine/app/settings/live_config.h"
#include "engine/app/ui/canvas.h"
#include "engine/app/ui/menu_control.h"
#include "engine/app/ui/pages.h"
#include "engine/core/io/files.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <variant>

namespace plumbline::app::ui {
namespace fs = std::filesystem;

inline constexpr int kEscape = 256;
inline constexpr int kEnter = 257;
inline constexpr int kDelete = 261;

class PagesTest : public testing::Test {
protected:
    void SetUp() override {
        std::string name = testing::UnitTest::GetInstance()->current_test_info()->name();
        std::ranges::replace(name, '/', '_');
        user_ = fs::path(testing::TempDir()) / ("pages_" + name);
        fs::remove_all(user_);
        fs::create_directories(user_);
        start();
        resize(1280, 720);
    }
    void TearDown() override { fs::remove_all(user_); }

    /// The program from its start: settings are read anew.
    void start() {
        const fs::path shipped = fs::path(PL_SOURCE_DIR) / "config";
        scenes_ = scene::list_scenes(
            {.assets = fs::path(PL_SOURCE_DIR) / "assets", .user_scenes = user_ / "scenes"});
        config_ = std::make_unique<LiveConfig>(shipped, user_);
        bindings_ = std::make_unique<LiveBindings>(
            BindingsDef{.shipped_folder = shipped, .user_folder = user_});
        control_ = std::make_unique<MenuControl>(world());
    }

    /// As the program shows it at the beginning of a frame.
    MenuWorld world() const {
        return {.bindings = bindings_.get(),
                .scenes = &scenes_,
                .config = config_->current(),
                .config_below = config_->below(),
                .scene_title = "The garden",
                .looks_at_model = looks_at_model_,
                .accuracy = accuracy_,
                .switches = switches_,
                .fog = {.density_per_m = 0.04F, .on = false},
                .hour = hour_,
                .results = results_};
    }

    // What was asked for, done as the program does it.
    void apply(const StartAgain&) { started_again_ = true; }
    void apply(const SwitchEffect& asked) {
        switches_.effects.erase(asked.effect);
        if (asked.on) switches_.turn(asked.effect, *asked.on);
    }
    void apply(const SetFog& asked) {
        switches_.fog_density_scale = asked.density_scale;
        switches_.fog_color = asked.color;
    }
    void apply(const SetHour& asked) { hour_ = asked.hour; }
    void apply(const SetAccuracy& asked) { accuracy_ = asked.setting; }
    void apply(const WorldRequest& asked) {
        std::visit([this](const auto& each) { apply(each); }, asked);
    }
    void apply(const ChangeConfig& asked) { stored(config_->change(asked.wanted)); }
    void apply(const ChangeBindings& asked) { stored(bindings_->change(asked.wanted)); }
    void apply(const OpenScene& asked) { opened_ = asked.file; }
    void apply(const AdoptAccuracy&) { adopted_ = true; }
    void apply(const ShowHintsAgain&) { forgotten_ = true; }
    void apply(const Quit&) { quit_ = true; }
    template <class Other>
    void apply(const Other&) {
        ADD_FAILURE() << "nobody asked for that";
    }
    static void stored(const Result<Done>& result) { EXPECT_TRUE(result.ok()); }

    void resize(int width, int height) {
        canvas_.resize(width, height, 1.0F, 0.0F);
        lay_out();
    }
    void lay_out() {
        control_->lay_out(
            canvas_.width_px(), canvas_.height_px(), canvas_.font_px(), canvas_.text_size());
    }

    /// One frame in which these keys went down and up, in this order.
    InputSnapshot keys(const std::vector<int>& codes) {
        InputSnapshot input;
        for (const int code : codes) {
            input.events.push_back({DeviceEventKind::Key, code, true});
            input.events.push_back({DeviceEventKind::Key, code, false});
        }
        return take(input);
    }
    InputSnapshot take(const InputSnapshot& input) {
        control_->show(world());
        lay_out();
        Requests requests;
        InputSnapshot rest = control_->take(input, requests);
        for (const Request& request : requests)
            std::visit([this](const auto& asked) { apply(asked); }, request);
        return rest;
    }

    const Cell& cell(CellPlace place) const {
        return control_->menu().page().lines[place.line].cells[place.cell];
    }
    /// Moves the pointer to the first cell that begins so, below `label` if one is given.
    bool point_at(const std::string& text, const std::string& label = {}) {
        InputSnapshot away;
        away.cursor_px = {1.0, 1.0};
        take(away);
        const std::vector<PlacedCell> cells = control_->menu().layout().cells;
        for (const PlacedCell& placed : cells) {
            const Line& line = control_->menu().page().lines[placed.place.line];
            if (!label.empty() && line.label != label) continue;
            if (!cell(placed.place).text.starts_with(text)) continue;
            for (int i = 0; i < 400; ++i) {
                const Box& view = control_->menu().layout().view;
                const float y = shown_box(placed, control_->menu().scroll_px()).y + 2.0F;
                if (placed.pinned || (y > view.y && y < view.bottom())) {
                    InputSnapshot input;
                    input.cursor_px = {static_cast<double>(placed.box.x) + 2.0,
                                       static_cast<double>(y)};
                    take(input);
                    cursor_ = input.cursor_px;
                    return control_->menu().focus() == placed.place;
                }
                InputSnapshot wheel;
                wheel.cursor_px = {1.0, 1.0};
                wheel.events.push_back({DeviceEventKind::Wheel, y > view.y ? 1 : 0, true});
                take(wheel);
            }
        }
        ADD_FAILURE() << "no cell " << text << " on " << control_->menu().page().title;
        return false;
    }
    void choose(const std::string& text, const std::string& label = {}) {
        ASSERT_TRUE(point_at(text, label));
        InputSnapshot input;
        input.cursor_px = cursor_;
        input.events.push_back({DeviceEventKind::MouseButton, 0, true});
        input.events.push_back({DeviceEventKind::MouseButton, 0, false});
        take(input);
    }

    std::string written(const char* name) const {
        std::ifstream file(user_ / name);
        return {std::istreambuf_iterator<char>(file), {}};
    }
    std::vector<std::string> words(Action action) const {
        std::vector<std::string> list;
        for (const input::Input& input : bindings_->current().of(action))
            list.push_back(input.word);
        return list;
    }

    fs::path user_;
    Canvas canvas_;
    std::unique_ptr<LiveConfig> config_;
    std::unique_ptr<LiveBindings> bindings_;
    study::Setting accuracy_;
    scene::LiveSwitches switches_;
    std::optional<double> hour_{12.1};  ///< none: the scene has no [time]
    std::vector<scene::ListedScene> scenes_;
    bool adopted_{false};
    const BestResults* results_{nullptr};
    bool looks_at_model_{false};
    std::unique_ptr<MenuControl> control_;
    fs::path opened_;
    bool started_again_{false};
    bool quit_{false};
    bool forgotten_{false};
    std::array<double, 2> cursor_{};
};

}  // namespace plumbline::app::ui
