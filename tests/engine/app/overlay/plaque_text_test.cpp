// What plaques say: before there is a measurement, after it, and of an expectation of 0.
#include "engine/app/overlay/plaque_text.h"

#include <gtest/gtest.h>

namespace plumbline::app {
namespace {

std::vector<std::string> texts_of(const scene::PlaqueReading& reading, double cost_ms = 0.25) {
    std::vector<std::string> texts;
    for (const ui::HudLine& line : plaque_lines(reading, cost_ms)) texts.push_back(line.text);
    return texts;
}

scene::PlaqueReading pendulum() {
    scene::PlaqueReading reading;
    reading.says = {.title = "Pendulum", .formula = "T = 2 pi sqrt(L / g)", .of = "bob"};
    reading.says.quantity = scene::PlaqueQuantity::Period;
    reading.says.expected = 2;
    return reading;
}

TEST(PlaqueText, SaysThatNothingIsMeasuredYet) {
    EXPECT_EQ(texts_of(pendulum()),
              (std::vector<std::string>{"Pendulum",
                                        "T = 2 pi sqrt(L / g)",
                                        "expected 2 s",
                                        "not measured yet",
                                        "cost of all rigid bodies: 0.250 ms a step"}));
}

TEST(PlaqueText, HasTheErrorInPercent) {
    scene::PlaqueReading reading = pendulum();
    reading.measured = 2.001;
    reading.periods = 8;
    const std::vector<std::string> texts = texts_of(reading);
    EXPECT_EQ(texts[3], "measured 2.001 s, mean of 8 periods");
    EXPECT_EQ(texts[4], "error +0.050 %");
    EXPECT_EQ(plaque_lines(reading, 0)[4].tone, ui::Tone::Good);
    reading.measured = 1.9;
    EXPECT_EQ(plaque_lines(reading, 0)[4].tone, ui::Tone::Bad);
}

TEST(PlaqueText, ComparesWithNothingInItsUnit) {
    scene::PlaqueReading reading = pendulum();
    reading.says.quantity = scene::PlaqueQuantity::Speed;
    reading.says.expected = 0;
    reading.says.effect = "drag";
    reading.measured = 0.002;
    const std::vector<std::string> texts = texts_of(reading);
    EXPECT_EQ(texts[4], "error +0.002 m/s");
    EXPECT_EQ(texts[5], "cost of drag: 0.250 ms a step");
}

}  // namespace
}  // namespace plumbline::app
