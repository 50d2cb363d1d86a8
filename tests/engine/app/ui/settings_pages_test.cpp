// Settings are stored as they are changed; accuracy is of the scene.
#include "tests/engine/app/ui/pages_fixture.h"

namespace plumbline::app::ui {
namespace {

class SettingsPages : public PagesTest {};

TEST_F(SettingsPages, SettingsAreStoredAtOnceAndKeptOverARestart) {
    keys({kEscape});
    choose("Settings");
    choose("low", "Quality level");
    EXPECT_EQ(config_->current().quality_level, QualityLevel::Low);
    EXPECT_NE(written("app.ui.toml").find("level = \"low\""), std::string::npos);
    ASSERT_TRUE(point_at("70", "Field of view"));
    keys({262, 262, 262});
    EXPECT_EQ(config_->current().fov_deg, 85.0F);
    choose("Sound");
    choose("off", "Mute");

    start();
    EXPECT_EQ(config_->current().quality_level, QualityLevel::Low);
    EXPECT_EQ(config_->current().fov_deg, 85.0F);
    EXPECT_TRUE(config_->current().mute);

    keys({kEscape});
    choose("Settings");
    choose("Reset to defaults");
    EXPECT_EQ(config_->current().quality_level, QualityLevel::Auto);
    EXPECT_EQ(config_->current().fov_deg, 70.0F);
    EXPECT_TRUE(config_->current().mute);  // another page's
}

TEST_F(SettingsPages, AccuracyIsOfTheSceneAndACopyKeepsIt) {
    keys({kEscape});
    choose("Settings");
    choose("Accuracy");
    choose("120", "Step rate, Hz");
    EXPECT_EQ(accuracy_.step_hz, 120);
    EXPECT_EQ(written("app.ui.toml"), "") << "no setting of the person's";
    choose("Save a copy");
    EXPECT_TRUE(adopted_);
}

TEST_F(SettingsPages, SlidersHaveAWordAtTheLowestStepThatIsZero) {
    constexpr int kRight = 262;
    constexpr int kLeft = 263;
    keys({kEscape});
    choose("Settings");
    ASSERT_TRUE(point_at("automatic", "Render scale"));
    keys({kRight});
    EXPECT_EQ(config_->current().render_scale, 0.25F);
    keys({kRight});
    EXPECT_EQ(config_->current().render_scale, 0.3F) << "as it is written, not 0.30000001";
    keys({kLeft, kLeft});
    EXPECT_EQ(config_->current().render_scale, 0.0F);
}

TEST_F(SettingsPages, TheMousesSpeedMovesByEqualFactorsAndResets) {
    constexpr int kRight = 262;
    keys({kEscape});
    choose("Settings");
    choose("Mouse and pad");
    ASSERT_TRUE(point_at("0.066", "Mouse sensitivity"));
    keys({kRight});
    // From 0.001 to 2 in 44 equal factors; from between two of them to the next.
    const double notch = std::log2(2.0 / 0.001) / 44.0;
    const double next = std::ceil(std::log2(0.066 / 0.001) / notch) * notch;
    EXPECT_NEAR(bindings_->current().tuning.mouse_deg_per_count, 0.001 * std::exp2(next), 1e-4);
    choose("off", "Invert Y axis");
    EXPECT_TRUE(bindings_->current().tuning.invert_y);
    choose("Reset to defaults");
    EXPECT_EQ(bindings_->current().tuning.mouse_deg_per_count, 0.066F);
    EXPECT_FALSE(bindings_->current().tuning.invert_y);
}

// Whoever goes through the tabs finds them where they were.
TEST_F(SettingsPages, TheTabsStayWhereTheyAreOnEveryTabAndWhenThePageScrolls) {
    keys({kEscape});
    choose("Settings");
    const auto tabs = [this] {
        std::vector<std::pair<float, float>> places;
        for (const PlacedCell& placed : control_->menu().layout().cells) {
            const Box box = shown_box(placed, control_->menu().scroll_px());
            if (placed.place.line == 0) places.emplace_back(box.x, box.y);
        }
        return places;
    };
    resize(320, 140);
    const auto at_first = tabs();
    const Box panel = control_->menu().layout().panel;
    ASSERT_EQ(at_first.size(), 8U);
    for (const char* tab : {"Display", "Sound", "Mouse and pad", "Light and fog", "Accuracy"}) {
        choose(tab);
        lay_out();
        EXPECT_EQ(tabs(), at_first) << tab;
        EXPECT_EQ(control_->menu().layout().panel.height, panel.height) << tab;
    }
    keys({267});
    EXPECT_GT(control_->menu().scroll_px(), 0.0F) << "the text below the accuracy is long";
    EXPECT_EQ(tabs(), at_first);
}

TEST_F(SettingsPages, OfferEachPresetAndSolverAndMarkWhatIsInForce) {
    keys({kEscape});
    choose("Settings");
    choose("Accuracy");
    const auto marked = [this](const std::string& label) {
        std::vector<std::string> texts;
        for (const Line& line : control_->menu().page().lines)
            if (line.label == label)
                for (const Cell& each : line.cells)
                    if (each.marked) texts.push_back(each.text);
        return texts;
    };
    choose("bullet_si", "Solver");
    EXPECT_EQ(accuracy_.solver, physics::Solver::BulletSi);
    choose("240", "Step rate, Hz");
    lay_out();
    EXPECT_EQ(marked("Solver"), std::vector<std::string>{"bullet_si"});
    EXPECT_EQ(marked("Step rate, Hz"), std::vector<std::string>{"240"});
    EXPECT_EQ(accuracy_.step_hz, 240);
    for (const Line& line : control_->menu().page().lines)
        for (const Cell& each : line.cells) EXPECT_NE(each.text, "auto") << "a study's to choose";
}

}  // namespace
}  // namespace plumbline::app::ui
