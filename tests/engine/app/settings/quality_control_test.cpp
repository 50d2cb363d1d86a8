#include "engine/app/settings/quality_control.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace plumbline::app {
namespace {

using Level = render::QualityLevel;

/// A machine on which an image costs a fixed part, and a part by its pixels.
struct Machine {
    double fixed_ms{10};
    double pixels_ms{100};  ///< at scale 1, level high
    double ms(const QualityControl& control) const {
        const double scale = static_cast<double>(control.quality().render_scale);
        const double level = control.level() == Level::High     ? 1.0
                             : control.level() == Level::Medium ? 0.8
                                                                : 0.5;
        return fixed_ms + level * pixels_ms * scale * scale;
    }
};

/// Draws so many frames; tells how often the image changed.
int draw(QualityControl& control, const Machine& machine, int frames) {
    int changes = 0;
    for (int i = 0; i < frames; ++i) {
        const double ms = machine.ms(control);
        changes += control.add_frame({.wall_ms = ms, .cpu_ms = 2.0, .gpu_ms = ms}) ? 1 : 0;
    }
    return changes;
}

TEST(QualityControl, ComesWithinTheTargetOnEveryMachineThatCan) {
    for (const double fixed_ms : {1.0, 10.0, 20.0}) {
        for (const double pixels_ms : {5.0, 20.0, 60.0, 120.0, 180.0}) {
            QualityControl control({}, true);
            const Machine machine{fixed_ms, pixels_ms};
            draw(control, machine, 1000);
            EXPECT_LE(machine.ms(control), 44.0) << fixed_ms << ' ' << pixels_ms;
        }
    }
}

TEST(QualityControl, ProbeOfAHandfulOfFramesDecidesAtOnce) {
    QualityControl slow({}, true);
    EXPECT_LE(draw(slow, {20.0, 120.0}, 5), 1);
    EXPECT_EQ(slow.level(), Level::Low);
    QualityControl fast({}, false);
    draw(fast, {1.0, 4.0}, 5);
    EXPECT_EQ(fast.level(), Level::High);
    EXPECT_EQ(fast.quality().render_scale, 1.0F);
}

TEST(QualityControl, GivesAllItCanWhereItIsCheap) {
    QualityControl control({}, true);
    draw(control, {2.0, 10.0}, 1000);
    EXPECT_EQ(control.level(), Level::High);
    EXPECT_EQ(control.quality().render_scale, 1.0F);
    EXPECT_EQ(render::what_gave_way(control.quality()), "ambient occlusion, sun shafts");
}

TEST(QualityControl, StaysWithinItsBoundsWhateverItCosts) {
    QualityControl control({}, true);
    draw(control, {500.0, 5000.0}, 3000);
    EXPECT_EQ(control.level(), Level::Low);
    EXPECT_EQ(control.quality().render_scale, render::kSmallestRenderScale);
}

TEST(QualityControl, DoesNotSwing) {
    // Every cost around the threshold, with frames that differ by a tenth: after the first second
    // and a half the image changes a few times at most in the next 6000 frames.
    for (double pixels_ms = 30.0; pixels_ms < 150.0; pixels_ms += 7.0) {
        QualityControl control({}, true);
        const Machine machine{8.0, pixels_ms};
        draw(control, machine, 40);
        int changes = 0;
        for (int i = 0; i < 6000; ++i) {
            const double noise = 1.0 + 0.1 * std::sin(0.7 * i) + 0.05 * std::sin(0.013 * i);
            const double ms = machine.ms(control) * noise;
            changes += control.add_frame({.wall_ms = ms}) ? 1 : 0;
        }
        EXPECT_LE(changes, 24) << pixels_ms;
    }
}

TEST(QualityControl, FollowsASceneThatGrowsDearerAndCheaperAgain) {
    QualityControl control({.target_ms = 40.0}, true);
    draw(control, {5.0, 40.0}, 600);
    const float before = control.quality().render_scale;
    draw(control, {5.0, 160.0}, 200);
    const Machine dear{5.0, 160.0};
    EXPECT_LE(dear.ms(control), 44.0);
    draw(control, {5.0, 40.0}, 4000);
    // What was good enough before is not left for a little more: within a rung or two.
    EXPECT_EQ(control.level(), Level::High);
    EXPECT_NEAR(control.quality().render_scale, before, 0.11F);
}

TEST(QualityControl, OneLongFrameChangesNothing) {
    QualityControl control({}, true);
    const Machine machine{5.0, 40.0};
    draw(control, machine, 600);
    for (int i = 0; i < 20; ++i) {
        EXPECT_FALSE(control.add_frame({.wall_ms = 900.0}));
        EXPECT_EQ(draw(control, machine, 30), 0);
    }
}

TEST(QualityControl, WaitingForTheScreenIsNoCostOfAGpu) {
    QualityControl control({}, false);
    for (int i = 0; i < 500; ++i) {
        control.add_frame({.wall_ms = 100.0, .cpu_ms = 3.0, .gpu_ms = 2.0});
    }
    EXPECT_EQ(control.level(), Level::High);
    // Without the driver's timer nothing but the wall is known.
    QualityControl blind({}, false);
    for (int i = 0; i < 500; ++i) blind.add_frame({.wall_ms = 100.0, .cpu_ms = 3.0});
    EXPECT_EQ(blind.level(), Level::Low);
}

TEST(QualityControl, KeepsALevelThatWasAskedFor) {
    QualityControl control({.level = Level::High}, true);
    EXPECT_EQ(draw(control, {100.0, 1000.0}, 500), 0);
    EXPECT_EQ(control.level(), Level::High);
    EXPECT_EQ(control.quality().render_scale, 0.8F);
    EXPECT_EQ(QualityControl({.level = Level::High}, false).quality().render_scale, 1.0F);
    const QualityControl full({.level = Level::High, .render_scale = 1.0F}, true);
    EXPECT_EQ(full.quality().render_scale, 1.0F);
    QualityControl scaled({.level = Level::Low, .render_scale = 0.9F}, true);
    EXPECT_EQ(scaled.quality().render_scale, 0.9F);
    EXPECT_FALSE(scaled.quality().surface_maps);
}

TEST(QualityControl, KeepsARenderScaleThatWasAskedForAndMovesTheLevelOnly) {
    QualityControl control({.render_scale = 0.5F}, true);
    draw(control, {2.0, 4000.0}, 500);
    EXPECT_EQ(control.level(), Level::Low);
    EXPECT_EQ(control.quality().render_scale, 0.5F);
    draw(control, {2.0, 10.0}, 20'000);
    EXPECT_EQ(control.level(), Level::High);
    EXPECT_EQ(control.quality().render_scale, 0.5F);
}

TEST(QualityControl, SaysWhatGaveWay) {
    const QualityControl low({.level = Level::Low}, true);
    EXPECT_EQ(render::what_gave_way(low.quality()),
              "render scale 60 %, surface maps, smooth shadows, fine shadows, shadows of lamps, "
              "ambient occlusion, sun shafts, detail far off, grass 50 %, things below 4 px");
    const QualityControl high({.level = Level::High}, true);
    EXPECT_EQ(render::what_gave_way(high.quality()),
              "render scale 80 %, ambient occlusion, sun shafts");
    const QualityControl on_gpu({.level = Level::High}, false);
    EXPECT_EQ(render::what_gave_way(on_gpu.quality()), "");
}

TEST(QualityControl, EdgesAreSmoothedAsWishedOrAsTheGpuAffords) {
    const auto chosen = [](const AppConfig& config, Level level, bool draws_on_cpu) {
        QualityRequest wish = quality_request_of(config);
        wish.level = level;
        return QualityControl(wish, draws_on_cpu).quality().anti_aliasing;
    };
    using render::AntiAliasing;
    AppConfig config;
    EXPECT_EQ(chosen(config, Level::High, true), AntiAliasing::Fxaa);
    EXPECT_EQ(chosen(config, Level::High, false), AntiAliasing::Msaa4);
    EXPECT_EQ(chosen(config, Level::Low, false), AntiAliasing::Fxaa);
    config.anti_aliasing = EdgeWish::Msaa8;
    EXPECT_EQ(chosen(config, Level::Low, true), AntiAliasing::Msaa8);
    config.anti_aliasing = EdgeWish::Off;
    EXPECT_EQ(chosen(config, Level::High, false), AntiAliasing::Off);
}

TEST(QualityControl, WishIsWhatTheSettingsSay) {
    AppConfig config;
    EXPECT_EQ(quality_request_of(config), QualityRequest{});
    config.quality_level = *quality_level_named("medium");
    config.render_scale = 0.1F;
    config.target_ms = 20.0F;
    const QualityRequest wish = quality_request_of(config);
    EXPECT_EQ(wish.level, Level::Medium);
    EXPECT_EQ(wish.render_scale, render::kSmallestRenderScale);
    EXPECT_EQ(wish.target_ms, 20.0);
    config.quality_level = *quality_level_named("auto");
    EXPECT_FALSE(quality_request_of(config).level);
    EXPECT_FALSE(quality_level_named("ultra"));
}

}  // namespace
}  // namespace plumbline::app
