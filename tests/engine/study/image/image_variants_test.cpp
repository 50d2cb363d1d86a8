#include "engine/study/image/image_variants.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace plumbline::study {
namespace {

render::RenderFrame sunny() {
    render::RenderFrame frame;
    frame.quality = render::quality_of(render::QualityLevel::High);
    frame.sun = render::DirectionalLight{};
    frame.sun_shadow = render::SunShadow{.cascades = 2, .angular_size_rad = 0.009F};
    frame.light_shadows = render::LightShadows{};
    frame.occlusion = render::AmbientOcclusion{};
    frame.refraction = render::Refraction{.caustics = true};
    return frame;
}

TEST(ImageVariants, BeginWithLevelHighAndHaveNamesOfTheirOwn) {
    const std::vector<ImageVariant> ways = image_variants(sunny());
    EXPECT_EQ(ways.front().name, "level high");
    std::set<std::string> names;
    for (const ImageVariant& way : ways) names.insert(way.name);
    EXPECT_EQ(names.size(), ways.size());
    EXPECT_FALSE(names.contains("2 cascades")) << "so it is already";
}

TEST(ImageVariants, ThoseOfShadowsNeedASunThatCastsThem) {
    const render::RenderFrame dull;
    for (const ImageVariant& way : image_variants(dull)) {
        render::RenderFrame frame = dull;
        way.apply(frame);
        EXPECT_FALSE(frame.sun_shadow.has_value()) << way.name;
    }
    EXPECT_LT(image_variants(dull).size(), image_variants(sunny()).size());
}

TEST(ImageVariants, EachDoesWhatItSays) {
    const auto applied = [](const std::string& name) {
        render::RenderFrame frame = sunny();
        const std::vector<ImageVariant> ways = image_variants(frame);
        const auto found = std::ranges::find(ways, name, &ImageVariant::name);
        EXPECT_NE(found, ways.end()) << name;
        if (found != ways.end()) found->apply(frame);
        return frame;
    };
    EXPECT_FALSE(applied("no shadow of the sun").sun_shadow.has_value());
    EXPECT_FALSE(applied("no shadows of lamps").light_shadows.has_value());
    EXPECT_EQ(applied("edges of shadows of one width").quality.contact_hardening,
              render::Drawn::Never);
    EXPECT_EQ(applied("edges as wide as the sun's disc").quality.contact_hardening,
              render::Drawn::Always);
    EXPECT_EQ(applied("4 cascades").sun_shadow->cascades, 4U);
    EXPECT_EQ(applied("shadow maps a quarter as wide").quality.shadow_detail, 0.25F);
    EXPECT_EQ(applied("no ambient occlusion").quality.ambient_occlusion, render::Drawn::Never);
    EXPECT_EQ(applied("ambient occlusion").quality.ambient_occlusion, render::Drawn::Always);
    EXPECT_EQ(applied("no sight into water").quality.refraction, render::Drawn::Never);
    EXPECT_FALSE(applied("even light in water").refraction->caustics);
    EXPECT_EQ(applied("render scale 50 %").quality.render_scale, 0.5F);
    EXPECT_EQ(applied("4 samples a pixel").quality.anti_aliasing, render::AntiAliasing::Ssaa4);
    EXPECT_EQ(applied("edges of 4 samples").quality.anti_aliasing, render::AntiAliasing::Msaa4);
    EXPECT_EQ(applied("level low").quality.render_scale,
              render::quality_of(render::QualityLevel::Low).render_scale);
}

}  // namespace
}  // namespace plumbline::study
