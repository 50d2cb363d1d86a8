#include "engine/app/ui/pages.h"

#include "engine/app/ui/canvas.h"
#include "engine/app/ui/menu_control.h"
#include "engine/core/files.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>

namespace plumbline::app::ui {
namespace {
namespace fs = std::filesystem;

constexpr int kEscape = 256;
constexpr int kEnter = 257;
constexpr int kDelete = 261;

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
        config_ = std::make_unique<LiveConfig>(shipped, user_);
        bindings_ = std::make_unique<LiveBindings>(
            BindingsDef{.shipped_folder = shipped, .user_folder = user_});
        control_ = std::make_unique<MenuControl>(MenuWorld{
            .config = *config_,
            .bindings = *bindings_,
            .scenes = scene::list_scenes(fs::path(PL_SOURCE_DIR) / "assets"),
            .scene_title = "The garden",
            .accuracy = [this] { return accuracy_; },
            .change_config = [this](const AppConfig& wanted) { stored(config_->change(wanted)); },
            .change_bindings =
                [this](const input::Bindings& wanted) { stored(bindings_->change(wanted)); },
            .change_accuracy = [this](const study::Setting& wanted) { accuracy_ = wanted; },
            .open_scene = [this](const fs::path& file) { opened_ = file; },
            .start_again = [this] { started_again_ = true; },
            .quit = [this] { quit_ = true; },
            .forget_first_minute = [this] { forgotten_ = true; }});
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
        lay_out();
        return control_->take(input, bindings_->current());
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
                const float y = placed.box.y - control_->menu().scroll_px() + 2.0F;
                if (y > view.y && y < view.bottom()) {
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
    std::unique_ptr<MenuControl> control_;
    fs::path opened_;
    bool started_again_{false};
    bool quit_{false};
    bool forgotten_{false};
    std::array<double, 2> cursor_{};
};

TEST_F(PagesTest, EscapeAndEnterLeadInAndOut) {
    keys({kEscape});
    EXPECT_TRUE(control_->open());
    EXPECT_EQ(cell(control_->menu().focus()).text, "Go on");
    keys({kEnter});
    EXPECT_FALSE(control_->open());
}

TEST_F(PagesTest, NoPressIsLostWhenAllComeInOneFrame) {
    // Opens the menu, goes down twice and up once, starts the scene again: one late frame.
    const InputSnapshot rest = keys({'Q', kEscape, 264, 264, 265, kEnter, 'W'});
    EXPECT_TRUE(started_again_);
    EXPECT_FALSE(control_->open());
    // What came before and after belongs to playing.
    std::vector<int> pressed;
    for (const DeviceEvent& event : rest.events)
        if (event.pressed) pressed.push_back(event.code);
    EXPECT_EQ(pressed, (std::vector<int>{'Q', kEscape, 'W'}));
}

TEST_F(PagesTest, TheHelpKeyOpensTheHelpAndClosesIt) {
    keys({'H'});
    ASSERT_TRUE(control_->open());
    EXPECT_EQ(control_->menu().page().title, "Help");
    keys({'H'});
    EXPECT_FALSE(control_->open());
    keys({'H', 'H', 'H'});
    EXPECT_TRUE(control_->open());
}

TEST_F(PagesTest, HelpListsOnlyWhatThisVersionDoes) {
    keys({'H'});
    std::string all;
    for (const Line& line : control_->menu().page().lines)
        all += line.label + "=" + line.value + "\n";
    EXPECT_NE(all.find("M=switch between walking, flying and orbiting"), std::string::npos) << all;
    EXPECT_NE(all.find("Ctrl+R=read the scene's file again"), std::string::npos);
    EXPECT_EQ(all.find("save the state"), std::string::npos);
    EXPECT_EQ(all.find("camera path"), std::string::npos);
    EXPECT_EQ(all.find("move_mode"), std::string::npos);
}

TEST_F(PagesTest, ASceneIsChosenByItsCard) {
    control_->show_start();
    choose("The garden");
    EXPECT_EQ(opened_.filename(), "garden.toml");
    choose("Hard cases");
    choose("H01");
    EXPECT_EQ(opened_.filename(), "H01.toml");
}

TEST_F(PagesTest, SettingsAreStoredAtOnceAndKeptOverARestart) {
    keys({kEscape});
    choose("Settings");
    choose("low", "Level of detail");
    EXPECT_EQ(config_->current().picture_level, PictureLevel::Low);
    EXPECT_NE(written("app.ui.toml").find("level = \"low\""), std::string::npos);
    ASSERT_TRUE(point_at("70", "Field of view"));
    keys({262, 262, 262});
    EXPECT_EQ(config_->current().fov_deg, 85.0F);
    choose("Sound");
    choose("off", "Mute");

    start();
    EXPECT_EQ(config_->current().picture_level, PictureLevel::Low);
    EXPECT_EQ(config_->current().fov_deg, 85.0F);
    EXPECT_TRUE(config_->current().mute);

    keys({kEscape});
    choose("Settings");
    choose("Reset these");
    EXPECT_EQ(config_->current().picture_level, PictureLevel::Auto);
    EXPECT_EQ(config_->current().fov_deg, 70.0F);
    EXPECT_TRUE(config_->current().mute);  // another page's
}

TEST_F(PagesTest, AKeyIsBoundByPressingItAndKeptOverARestart) {
    keys({kEscape});
    choose("Controls");
    choose("Q", "drop the chosen thing");
    EXPECT_TRUE(control_->menu().page().title.starts_with("Press what shall do"));
    keys({'K'});
    EXPECT_EQ(words(Action::Drop), (std::vector<std::string>{"k", "pad.right_bumper"}));
    EXPECT_NE(written("bindings.ui.toml").find("drop = [\"k\", \"pad.right_bumper\"]"),
              std::string::npos);
    start();
    EXPECT_EQ(words(Action::Drop), (std::vector<std::string>{"k", "pad.right_bumper"}));
    EXPECT_TRUE(bindings_->faults().list().empty());
}

TEST_F(PagesTest, AChordAWheelStepAMouseButtonAndAPadButtonCanBeBound) {
    keys({kEscape});
    choose("Controls");
    InputSnapshot chord;
    chord.events = {{DeviceEventKind::Key, 341, true},
                    {DeviceEventKind::Key, 340, true},
                    {DeviceEventKind::Key, 'X', true}};
    const std::vector<std::pair<InputSnapshot, std::string>> presses{
        {chord, "ctrl+shift+x"},
        {{.events = {{DeviceEventKind::MouseButton, 4, true}}}, "mouse.5"},
        {{.events = {{DeviceEventKind::Wheel, 2, true}}}, "wheel.left"},
        {{.events = {{DeviceEventKind::PadButton, 8, true}}}, "pad.guide"},
        {{.events = {{DeviceEventKind::Key, 346, true}, {DeviceEventKind::Key, 346, false}}},
         "right_alt"}};
    for (const auto& [input, word] : presses) {
        choose("+", "drop the chosen thing");
        take(input);
        EXPECT_EQ(words(Action::Drop).back(), word);
    }
    choose("+", "drop the chosen thing");
    InputSnapshot trigger;
    trigger.pad_present = true;
    trigger.pad_axes = {0.0F, 0.0F, 0.0F, 0.0F, -1.0F, -1.0F};
    take(trigger);
    trigger.pad_axes[4] = 0.9F;
    take(trigger);
    EXPECT_EQ(words(Action::Drop).back(), "pad.left_trigger");
}

TEST_F(PagesTest, AConflictNamesBothActionsAndAsks) {
    keys({kEscape});
    choose("Controls");
    choose("Q", "drop the chosen thing");
    keys({'F'});
    EXPECT_EQ(control_->menu().page().title, "F is taken");
    EXPECT_EQ(control_->menu().page().lines[0].label,
              "F does \"flashlight on and off\" now. Shall it do \"drop the chosen thing\" "
              "instead?");
    choose("No");
    EXPECT_EQ(words(Action::Drop)[0], "q");
    choose("Q", "drop the chosen thing");
    keys({'F'});
    choose("Yes");
    EXPECT_EQ(words(Action::Drop)[0], "f");
    EXPECT_EQ(words(Action::Flashlight), std::vector<std::string>{"pad.y"});
    start();
    EXPECT_TRUE(bindings_->faults().list().empty());
    EXPECT_EQ(words(Action::Flashlight), std::vector<std::string>{"pad.y"});
}

TEST_F(PagesTest, EscapeLeavesABindingAsItWas) {
    keys({kEscape});
    choose("Controls");
    choose("Q", "drop the chosen thing");
    keys({kEscape});
    EXPECT_EQ(control_->menu().page().title, "Controls");
    EXPECT_EQ(words(Action::Drop)[0], "q");
    EXPECT_FALSE(fs::exists(user_ / "bindings.ui.toml"));
}

TEST_F(PagesTest, WhatCannotBeHeldIsRefusedWithItsReason) {
    keys({kEscape});
    choose("Controls");
    choose("W", "forward");
    InputSnapshot wheel;
    wheel.events = {{DeviceEventKind::Wheel, 0, true}};
    take(wheel);
    lay_out();
    EXPECT_EQ(control_->menu().page().lines[0].label,
              "\"wheel.up\" cannot be held down, and \"forward\" needs that");
    keys({'I'});
    EXPECT_EQ(words(Action::Forward)[0], "i");
}

TEST_F(PagesTest, OneAGroupAndAllAreReset) {
    keys({kEscape});
    choose("Controls");
    ASSERT_TRUE(point_at("Q", "drop the chosen thing"));
    keys({kDelete});
    EXPECT_EQ(words(Action::Drop), std::vector<std::string>{"pad.right_bumper"});
    choose("reset", "drop the chosen thing");
    EXPECT_EQ(words(Action::Drop), (std::vector<std::string>{"q", "pad.right_bumper"}));
    EXPECT_EQ(written("bindings.ui.toml").find("drop"), std::string::npos);

    choose("Q", "drop the chosen thing");
    keys({'K'});
    choose("H", "this help");
    keys({'I'});
    choose("Reset all");
    for (const Action action : {Action::Drop, Action::Help})
        EXPECT_EQ(bindings_->current().of(action), bindings_->below().of(action));
}

// EXPERIENCE A14: the window goes to a monitor of another scale. Letters are made once, and what was
// chosen stays chosen.
TEST_F(PagesTest, AnotherMonitorsScaleRemakesTheLettersOnceAndKeepsThePlace) {
    keys({kEscape, 264, 264, 264});
    const std::string chosen = cell(control_->menu().focus()).text;
    EXPECT_EQ(canvas_.font_px(), 17.0F);
    EXPECT_TRUE(canvas_.resize(1280, 720, 1.25F, 0.0F));
    EXPECT_EQ(canvas_.font_px(), 21.0F);
    EXPECT_FALSE(canvas_.resize(1280, 720, 1.25F, 0.0F));
    lay_out();
    EXPECT_EQ(cell(control_->menu().focus()).text, chosen);
    EXPECT_EQ(chosen, "Settings");
}

// Every page at the sizes people have: nothing cut, nothing over something else, all in the window.
class PagesAtSize : public PagesTest, public testing::WithParamInterface<std::pair<int, int>> {
protected:
    void look() {
        lay_out();
        const MenuLayout& layout = control_->menu().layout();
        const std::string& title = control_->menu().page().title;
        const Box window{0.0F, 0.0F, canvas_.width_px(), canvas_.height_px()};
        for (const Box& box : {layout.panel, layout.title, layout.view}) {
            EXPECT_GE(box.x, 0.0F) << title;
            EXPECT_GE(box.y, 0.0F) << title;
            EXPECT_LE(box.right(), window.right() + 0.01F) << title;
            EXPECT_LE(box.bottom(), window.bottom() + 0.01F) << title;
        }
        std::vector<Box> boxes = layout.labels;
        for (const PlacedCell& placed : layout.cells) boxes.push_back(placed.box);
        for (std::size_t i = 0; i < boxes.size(); ++i) {
            EXPECT_GE(boxes[i].x, layout.view.x - 0.01F) << title;
            EXPECT_LE(boxes[i].right(), layout.view.right() + 0.01F) << title;
            for (std::size_t j = i + 1; j < boxes.size(); ++j)
                EXPECT_FALSE(overlap(boxes[i], boxes[j])) << title << ": " << i << ", " << j;
        }
        for (int pages = 0; pages < 60; ++pages) {
            const float before = control_->menu().scroll_px();
            canvas_.begin({});
            canvas_.draw(control_->menu());
            canvas_.end();
            EXPECT_TRUE(canvas_.cut_texts().empty()) << title << ": " << canvas_.cut_texts()[0];
            keys({267});
            if (control_->menu().scroll_px() == before) break;
        }
    }
};

TEST_P(PagesAtSize, NothingIsCutAndNothingOverlaps) {
    resize(GetParam().first, GetParam().second);
    control_->show_start();
    look();
    choose("Hard cases");
    look();
    keys({kEscape});
    choose("Settings");
    for (const char* tab : {"Picture", "Screen", "Sound", "Mouse and pad", "Accuracy"}) {
        choose(tab);
        look();
    }
    choose("Controls");
    look();
    choose("Q", "drop the chosen thing");
    look();
    keys({'F'});
    look();
    keys({kEscape, kEscape, kEscape, kEscape});
    keys({'H'});
    look();
    keys({'H', kEscape});
    look();
}

INSTANTIATE_TEST_SUITE_P(Windows,
                         PagesAtSize,
                         testing::Values(std::pair{640, 360},
                                         std::pair{1280, 720},
                                         std::pair{3840, 2160},
                                         std::pair{480, 270},
                                         std::pair{720, 1280}));

}  // namespace
}  // namespace plumbline::app::ui
