#include "engine/study/image/image_findings.h"

#include "engine/study/image/image_variants.h"
#include "engine/study/report/image_section.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace plumbline::study {
namespace {

ImageRow row(const std::string& name, double rms, double ms, double more_ms) {
    return {.name = name,
            .error = {.mean = 0.5 * rms, .rms = rms},
            .cpu_ms = ms,
            .more_ms = {.mean = more_ms, .standard_error = 0.1, .pairs = 4}};
}

ImageFindings judged() {
    ImageFindings findings{.scene = "yard.toml",
                           .width_px = 640,
                           .height_px = 360,
                           .samples_per_pixel = 16,
                           .mean_luminance = 0.25,
                           .rows = {row("level high", 0.10, 50, 0.0),
                                    row("cheap", 0.20, 20, -30.0),
                                    row("dear and worse", 0.15, 60, 10.0),
                                    row("nearer", 0.05, 90, 40.0),
                                    row("the same", 0.101, 50, 0.15)}};
    judge(findings);
    return findings;
}

TEST(ImageFindings, SayWhatIsGainedAndWhatItCosts) {
    const std::vector<ImageRow> rows = judged().rows;
    EXPECT_EQ(rows[0].verdict, "what the others are compared to");
    EXPECT_EQ(rows[1].verdict, "100 % more error, saves 30.0 ms");
    EXPECT_EQ(rows[2].verdict, "50 % more error, costs 10.0 ms more");
    EXPECT_EQ(rows[3].verdict, "50 % less error, costs 40.0 ms more");
    EXPECT_EQ(rows[4].verdict, "as near to the reference, no cost that could be told");
}

TEST(ImageFindings, AreUnbeatenWhereNothingIsCheaperAndNearer) {
    std::vector<bool> unbeaten;
    for (const ImageRow& each : judged().rows) unbeaten.push_back(each.unbeaten);
    EXPECT_EQ(unbeaten, (std::vector{true, true, false, true, false}));
}

TEST(ImageFindings, OfEqualsNoneIsBeaten) {
    ImageFindings findings{.rows = {row("a", 0.1, 5, 0), row("b", 0.1, 5, 0)}};
    judge(findings);
    EXPECT_TRUE(findings.rows[0].unbeaten && findings.rows[1].unbeaten);
}

TEST(ImageFindings, AreATableForPeople) {
    const std::string text = image_text(judged());
    EXPECT_NE(text.find("* cheap"), std::string::npos);
    EXPECT_NE(text.find("  dear and worse"), std::string::npos);
    EXPECT_NE(text.find("640 x 360 pixels against 16 samples"), std::string::npos);
    EXPECT_NE(text.find("20 %"), std::string::npos);
}

TEST(ImageFindings, AreATableAndADiagramOfThePage) {
    ImageFindings findings = judged();
    findings.rows[1].name = "<cheap>";
    const std::string html = image_table(findings);
    EXPECT_NE(html.find("<b>&lt;cheap&gt;</b>"), std::string::npos);
    EXPECT_NE(html.find("<td>dear and worse</td>"), std::string::npos);
    const auto plot = image_plot(findings);
    ASSERT_TRUE(plot.has_value());
    ASSERT_EQ(plot->curves.size(), 2U);
    EXPECT_EQ(plot->curves[0].points.size(), 2U);
    EXPECT_EQ(plot->curves[1].points.size(), 3U);
    EXPECT_TRUE(std::ranges::is_sorted(plot->curves[1].points, {}, &PlotPoint::x));
    EXPECT_LT(plot->x.least, 20.0);
    EXPECT_GT(plot->x.most, 90.0);
    findings.rows.resize(1);
    EXPECT_FALSE(image_plot(findings).has_value());
}

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
