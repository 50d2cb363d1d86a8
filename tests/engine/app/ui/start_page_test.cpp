// What a person meets first: the start page, its scenes, the help, and which controls suit what is open.
#include "engine/platform/device_events.h"
#include "tests/engine/app/ui/pages_fixture.h"

#include <algorithm>
#include <map>
#include <set>

namespace plumbline::app::ui {
namespace {

TEST_F(PagesTest, ASceneIsChosenByItsCard) {
    control_->show_start();
    choose("The garden");
    EXPECT_EQ(opened_.filename(), "garden.toml");
    choose("Hard cases");
    choose("H01");
    EXPECT_EQ(opened_.filename(), "H01.toml");
}

// Whoever adopted a copy finds it again; each scene has its image, the hard ones too.
TEST_F(PagesTest, TheGardenStandsFirstAndOwnScenesHaveAPlace) {
    fs::create_directories(user_ / "scenes");
    std::ofstream(user_ / "scenes" / "pile-adopted.toml") << "[scene]\ntitle = \"A pile\"\n"
                                                             "[[entity]]\nname = \"a\"\n";
    start();
    control_->show_start();
    lay_out();
    const auto cards_below = [&](const std::string& heading) {
        const std::vector<Line>& lines = control_->menu().page().lines;
        const auto at = std::ranges::find(lines, heading, &Line::label);
        return at == lines.end() ? std::vector<Cell>{} : std::next(at)->cells;
    };
    ASSERT_FALSE(cards_below("Scenes").empty());
    EXPECT_EQ(cards_below("Scenes").front().text, "The garden");
    ASSERT_EQ(cards_below("Your scenes").size(), 1U);
    EXPECT_EQ(cards_below("Your scenes").front().text, "pile-adopted");
    EXPECT_EQ(cards_below("Your scenes").front().note, "A pile");
    choose("pile-adopted");
    EXPECT_EQ(opened_, user_ / "scenes" / "pile-adopted.toml");
    const fs::path thumbnails = fs::path(PL_SOURCE_DIR) / "assets" / "thumbnails";
    for (const scene::ListedScene& scene : scenes_) {
        if (scene.is_users_own || scene.name.starts_with("bench/")) continue;
        EXPECT_TRUE(fs::exists(thumbnails / (scene.name + ".jpg"))) << scene.name;
        EXPECT_FALSE(scene.description.empty()) << scene.name;
    }
}

// A pad alone leads from the start page to a scene and back: what the window library reports of it
// goes through all that lies between it and the menu.
TEST_F(PagesTest, APadAloneLeadsToASceneAndBack) {
    control_->show_start();
    platform::DeviceEvents devices;
    double now_s = 1.0;
    const auto report = [&](const platform::PadReading& reading) {
        take(devices.take(now_s += 0.1, reading));
    };
    platform::PadReading at_rest{.present = true};
    at_rest.axes = {0.0F, 0.0F, 0.0F, 0.0F, -1.0F, -1.0F};
    report(at_rest);
    const auto pad = [&](std::size_t button) {
        platform::PadReading pressed = at_rest;
        pressed.buttons.set(button);
        report(pressed);
        report(at_rest);
    };
    const auto stick = [&](float x, float y) {
        platform::PadReading pushed = at_rest;
        pushed.axes[0] = x;
        pushed.axes[1] = y;
        report(pushed);
        report(at_rest);
    };
    constexpr std::size_t kSouth = 0;
    constexpr std::size_t kEast = 1;
    constexpr std::size_t kCrossUp = 11;
    constexpr std::size_t kCrossDown = 13;
    pad(kCrossDown);
    EXPECT_EQ(cell(control_->menu().focus()).text, "The garden");
    stick(1.0F, 0.0F);
    const std::string second = cell(control_->menu().focus()).text;
    EXPECT_NE(second, "The garden");
    const auto on_hard_cases = [&] {
        return cell(control_->menu().focus()).text.starts_with("Hard");
    };
    for (int row = 0; row < 6 && !on_hard_cases(); ++row) {
        for (int i = 0; i < 6 && !on_hard_cases(); ++i) stick(1.0F, 0.0F);
        for (int i = 0; i < 6 && !on_hard_cases(); ++i) stick(-1.0F, 0.0F);
        if (!on_hard_cases()) stick(0.0F, 1.0F);
    }
    pad(kSouth);
    EXPECT_EQ(control_->menu().page().title, "Hard cases");
    for (int i = 0; i < 8; ++i) pad(kCrossDown);
    EXPECT_GT(control_->menu().scroll_px(), 0.0F) << "what is chosen is seen";
    pad(kSouth);
    EXPECT_EQ(opened_.parent_path().filename(), "hard") << opened_;
    pad(kEast);
    EXPECT_EQ(control_->menu().page().title, "Plumbline");
    for (int i = 0; i < 6; ++i) pad(kCrossUp);
    pad(kEast);
    EXPECT_FALSE(control_->open());
}

TEST_F(PagesTest, HelpListsOnlyWhatThisVersionDoes) {
    keys({'H'});
    std::string all;
    for (const Line& line : control_->menu().page().lines)
        all += line.label + "=" + line.value + "\n";
    EXPECT_NE(all.find("M=Switch between walk, fly and orbit"), std::string::npos) << all;
    EXPECT_NE(all.find("Ctrl+R=Reload the scene file"), std::string::npos);
    EXPECT_EQ(all.find("save the state"), std::string::npos);
    EXPECT_EQ(all.find("move_mode"), std::string::npos);
    EXPECT_NE(all.find("=Drop the selected object"), std::string::npos);
    EXPECT_EQ(all.find("Model viewer"), std::string::npos);
}

TEST_F(PagesTest, HelpBeginsWithTheTenKeysThatMatterMost) {
    keys({'H'});
    const std::vector<Line>& lines = control_->menu().page().lines;
    ASSERT_GT(lines.size(), 13U);
    EXPECT_EQ(lines[1].label, "Essentials");
    EXPECT_EQ(lines[2].label + "=" + lines[2].value, "W A S D=Move");
    std::set<std::string> values;
    for (std::size_t i = 2; i < 12; ++i) {
        EXPECT_EQ(lines[i].kind, LineKind::Keys) << i;
        values.insert(lines[i].value);
    }
    EXPECT_EQ(lines[12].kind, LineKind::Heading);
    // What is said above is not said again below.
    for (std::size_t i = 12; i < lines.size(); ++i) EXPECT_FALSE(values.contains(lines[i].value));
}

TEST_F(PagesTest, HelpSpeaksOfAPadOnlyWhereOneIsPluggedIn) {
    const auto words_of_pads = [this] {
        std::string found;
        for (const Line& line : control_->menu().page().lines)
            for (const char* word : {"Pad ", "stick", "bumper", "trigger", "(A)"})
                if (line.kind == LineKind::Keys && line.label.find(word) != std::string::npos)
                    found += line.label + "\n";
        return found;
    };
    keys({'H'});
    EXPECT_EQ(words_of_pads(), "");
    InputSnapshot with_pad;
    with_pad.pad_present = true;
    take(with_pad);
    lay_out();
    EXPECT_NE(words_of_pads().find("Space or South (A)"), std::string::npos);
}

TEST_F(PagesTest, HelpAtAModelListsWhatOneDoesWithModels) {
    looks_at_model_ = true;
    bindings_->use_usual_profile("viewer");
    keys({'H'});
    std::string all;
    for (const Line& line : control_->menu().page().lines)
        all += line.label + "=" + line.value + "\n";
    EXPECT_EQ(all.find("Drop the selected object"), std::string::npos) << all;
    EXPECT_EQ(all.find("Jump"), std::string::npos);
    EXPECT_NE(all.find("Left mouse=Model viewer: rotate the model (hold)"), std::string::npos)
        << all;
}

// The usual profile gives way to one that somebody asked for, and goes when something else is open.
TEST_F(PagesTest, TheUsualProfileGivesWayToTheOnesThatWereAskedFor) {
    const auto turns_by_mouse = [&] { return !words(Action::TurnModel).empty(); };
    EXPECT_FALSE(turns_by_mouse());
    bindings_->use_usual_profile("viewer");
    EXPECT_TRUE(turns_by_mouse());
    bindings_->use_usual_profile("");
    EXPECT_FALSE(turns_by_mouse());
    std::ofstream(user_ / "bindings.toml") << "profile = \"book\"\n";
    start();
    bindings_->use_usual_profile("viewer");
    EXPECT_FALSE(turns_by_mouse());
    EXPECT_TRUE(bindings_->faults().list().empty());
}

TEST_F(PagesTest, GamesHaveAPageWithTheBestTimes) {
    BestResults results{{}};
    results.note("cans", 31.25);
    results_ = &results;
    control_->show(world());
    control_->show_start();
    choose("Games");
    lay_out();
    std::map<std::string, std::string> notes;
    for (const Line& line : control_->menu().page().lines) {
        if (line.kind != LineKind::Cards) continue;
        for (const Cell& cell : line.cells) notes[cell.text] = cell.note;
    }
    EXPECT_GE(notes.size(), 4U);
    EXPECT_TRUE(notes["Tin cans"].starts_with("Best: 31.2 s")) << notes["Tin cans"];
    EXPECT_TRUE(notes["The tower"].starts_with("Not won yet")) << notes["The tower"];
    EXPECT_FALSE(notes.contains("The garden"));
    choose("The ferry");
    EXPECT_EQ(opened_.filename(), "ferry.toml");
}

}  // namespace
}  // namespace plumbline::app::ui
