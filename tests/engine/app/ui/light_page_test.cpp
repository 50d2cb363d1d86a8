// Light and fog of the visit.
#include "tests/engine/app/ui/pages_fixture.h"

namespace plumbline::app::ui {
namespace {

class LightPage : public PagesTest {};

// SOURCES B26
TEST_F(LightPage, FogIsOfTheVisitAndChangedByTheStepsOfItsKeys) {
    keys({kEscape});
    choose("Settings");
    choose("Light and fog");
    EXPECT_FALSE(switches_.is_on("fog", false));
    choose("white", "Fog colour");
    EXPECT_EQ(switches_.fog_color, 1U);
    EXPECT_TRUE(switches_.is_on("fog", false)) << "who changes it wants to see it";
    ASSERT_TRUE(point_at("0.04 per m", "Fog density"));
    constexpr int kRight = 262;
    keys({kRight});
    EXPECT_NEAR(switches_.fog_density_scale, 1.25, 0.02);
    keys({kRight, kRight});
    EXPECT_NEAR(switches_.fog_density_scale, 1.25 * 1.25 * 1.25, 0.02);
    EXPECT_EQ(written("app.ui.toml"), "") << "no setting of the person's";
}

TEST_F(LightPage, TheHourMovesByQuartersAndLampsGoByThemselvesOnOrOff) {
    const auto has_hour = [this] {
        return std::ranges::any_of(control_->menu().page().lines,
                                   [](const Line& line) { return line.label == "Time of day"; });
    };
    hour_.reset();
    keys({kEscape});
    choose("Settings");
    choose("Light and fog");
    EXPECT_FALSE(has_hour()) << "a sun that stands still has none";
    hour_ = 12.1;
    choose("Light and fog");
    ASSERT_TRUE(has_hour());
    constexpr int kRight = 262;
    constexpr int kLeft = 263;
    ASSERT_TRUE(point_at("12:06", "Time of day"));
    keys({kRight});
    EXPECT_DOUBLE_EQ(*hour_, 12.25);
    keys({kLeft, kLeft});
    EXPECT_DOUBLE_EQ(*hour_, 11.75);
    choose("on", "Lamps");
    EXPECT_TRUE(switches_.is_on("lamps", false));
    choose("off", "Lamps");
    EXPECT_FALSE(switches_.is_on("lamps", true));
    choose("automatic", "Lamps");
    EXPECT_FALSE(switches_.effects.contains("lamps"));
}

}  // namespace
}  // namespace plumbline::app::ui
