// What each level of the image leaves out.
#include "engine/render/quality.h"

#include <gtest/gtest.h>

namespace plumbline::render {
namespace {

TEST(Quality, LevelsHaveNamesThatLeadBackToThem) {
    using enum QualityLevel;
    for (const QualityLevel level : {Low, Medium, High})
        EXPECT_EQ(quality_level_named(name_of(level)), level);
    EXPECT_EQ(name_of(Medium), "medium");
    for (const char* other : {"", "full", "Low", "auto"})
        EXPECT_EQ(quality_level_named(other), std::nullopt) << other;
}

TEST(Quality, AHigherLevelLeavesNoMoreOut) {
    const Quality low = quality_of(QualityLevel::Low);
    const Quality medium = quality_of(QualityLevel::Medium);
    const Quality high = quality_of(QualityLevel::High);
    for (const auto& [less, more] : {std::pair{low, medium}, std::pair{medium, high}}) {
        EXPECT_LE(less.render_scale, more.render_scale);
        EXPECT_LE(less.shadow_detail, more.shadow_detail);
        EXPECT_LE(less.shadowed_lights, more.shadowed_lights);
        EXPECT_LE(less.ambient_occlusion, more.ambient_occlusion);
        EXPECT_LE(less.sun_shafts, more.sun_shafts);
        EXPECT_LE(less.ground_cover, more.ground_cover);
        EXPECT_GE(less.lod_error_px, more.lod_error_px);
        EXPECT_GE(less.smallest_px, more.smallest_px);
    }
    EXPECT_GE(low.render_scale, kSmallestRenderScale);
    EXPECT_EQ(high.render_scale, 1.0F);
    EXPECT_EQ(low.refraction, Drawn::Always) << "water shows its basin at every level";
}

TEST(Quality, WithoutAGpuOnlyWhatIsAlwaysDrawnStays) {
    Quality asked;
    asked.parallax = Drawn::OnGpu;
    asked.refraction = Drawn::Never;
    const Quality given = without_gpu(asked);
    EXPECT_EQ(given.parallax, Drawn::Never);
    EXPECT_EQ(given.refraction, Drawn::Never);
    EXPECT_EQ(given.ambient_occlusion, Drawn::Always);
    for (Drawn Quality::*part : {&Quality::contact_hardening,
                                 &Quality::ambient_occlusion,
                                 &Quality::sun_shafts,
                                 &Quality::refraction}) {
        Quality each;
        each.*part = Drawn::OnGpu;
        EXPECT_EQ(without_gpu(each).*part, Drawn::Never);
    }
}

TEST(Quality, OnlyMsaaKeepsSeveralSamples) {
    EXPECT_EQ(samples_of(AntiAliasing::Off), 1U);
    EXPECT_EQ(samples_of(AntiAliasing::Fxaa), 1U);
    EXPECT_EQ(samples_of(AntiAliasing::Ssaa4), 1U);
    EXPECT_EQ(samples_of(AntiAliasing::Msaa2), 2U);
    EXPECT_EQ(samples_of(AntiAliasing::Msaa4), 4U);
    EXPECT_EQ(samples_of(AntiAliasing::Msaa8), 8U);
}

TEST(Quality, SaysWhatTheImageLacks) {
    EXPECT_EQ(what_gave_way({}), "");
    EXPECT_EQ(what_gave_way(quality_of(QualityLevel::Low)),
              "render scale 60 %, surface maps, smooth shadows, fine shadows, shadows of lamps, "
              "ambient occlusion, sun shafts, detail far off, grass 50 %, things below 4 px");
    EXPECT_EQ(what_gave_way(without_gpu(quality_of(QualityLevel::High))),
              "ambient occlusion, sun shafts");
    EXPECT_EQ(what_gave_way({.render_scale = 0.999F}), "render scale 100 %");
}

}  // namespace
}  // namespace plumbline::render
