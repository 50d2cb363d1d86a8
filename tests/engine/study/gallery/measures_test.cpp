#include "engine/study/gallery/measures.h"

#include "engine/core/io/files.h"
#include "tests/engine/study/gallery/judged.h"

#include <cmath>
#include <string>

namespace plumbline::study {
namespace {

/// A measure of a cube on a known path, after half a second.
double measured(const std::string& measure, const scene::SceneDescription& like) {
    scene::SceneDescription scene = like;
    scene.hard_case = scene::HardCase{
        .id = "H1",
        .seconds = 0.5,
        .rules = {{.measure = measure, .of = {"cube"}, .from_s = 0.5, .below = 1e9}}};
    Judged judged(scene);
    judged.step(30);
    return judged.rule(0).value;
}

TEST(Measures, OfAThrownCube) {
    scene::SceneDescription scene = scene_of({cube("cube", {0, 5, 0})});
    scene.entities[0].body->velocity_mps = {3, 4, 0};
    scene.entities[0].body->angular_velocity_radps = {0, 0, 1};
    const double up = 4 - kG * 0.5;
    const double rise = 4 * 0.5 - 0.5 * kG * 0.25;
    EXPECT_NEAR(measured("drift_m", scene), 1.5, 1e-5);
    EXPECT_NEAR(measured("displacement_m", scene), std::hypot(1.5, rise), 1e-5);
    EXPECT_NEAR(measured("sag_m", scene), -rise, 1e-5);
    EXPECT_NEAR(measured("height_m", scene), 5 + rise, 1e-5);
    EXPECT_NEAR(measured("x_m", scene), 1.5, 1e-5);
    EXPECT_NEAR(measured("from_axis_m", scene), 1.5, 1e-5);
    EXPECT_NEAR(measured("speed_mps", scene), std::hypot(3, up), 1e-5);
    EXPECT_NEAR(measured("up_speed_mps", scene), up, 1e-5);
    EXPECT_NEAR(measured("horizontal_speed_mps", scene), 3, 1e-5);
    EXPECT_NEAR(measured("speed_change", scene), std::abs(std::hypot(3, up) - 5) / 5, 1e-5);
    EXPECT_NEAR(measured("heading_deg", scene), 0, 1e-3);
    EXPECT_NEAR(measured("reach_m", scene), 5 + 16 / (2 * kG), 1e-4);
    EXPECT_NEAR(measured("spin_radps", scene), 1, 1e-5);
    EXPECT_NEAR(measured("tilt_deg", scene), 0.5 * 180 / 3.14159265358979, 1e-2);
    EXPECT_EQ(measured("awake", scene), 1);
    EXPECT_EQ(measured("contact_force_N", scene), 0);
    EXPECT_NEAR(measured("mean_displacement_m", scene), std::hypot(1.5, rise), 1e-5);
    EXPECT_NEAR(measured("mean_height_m", scene), 5 + rise, 1e-5);
    EXPECT_NEAR(measured("energy_gain", scene), 0, 1e-5);
    EXPECT_NEAR(measured("kinetic_J", scene), 500 * (9 + up * up) + 0.5 * 1000 / 6, 0.1);
    EXPECT_NEAR(measured("momentum_change", scene), kG * 0.5 / 5, 1e-5);
    EXPECT_EQ(measured("penetration_m", scene), 0);
    EXPECT_EQ(measured("removed", scene), 0);
}

TEST(Measures, ContactForceOnACubeAtRestIsItsWeight) {
    scene::SceneDescription scene = scene_of({test::ground(), cube("cube", {0, 0.5_r, 0})});
    scene.entities[1].body->can_sleep = false;
    EXPECT_NEAR(measured("contact_force_N", scene), 1000 * kG, 100);
}

TEST(Measures, RelativeToAnotherBody) {
    scene::SceneDescription scene = scene_of({cube("cube", {2, 5, 0}), cube("lift", {0, 5, 0})});
    for (scene::EntityDescription& entity : scene.entities) entity.body->velocity_mps = {0, 0, 7};
    scene.hard_case = scene::HardCase{
        .id = "H1",
        .seconds = 0.5,
        .rules = {
            {.measure = "displacement_m", .of = {"cube"}, .relative_to = "lift", .below = 1e-5},
            {.measure = "from_axis_m",
             .of = {"cube"},
             .relative_to = "lift",
             .near = 2,
             .within = 1e-5}}};
    Judged judged(scene);
    judged.step(30);
    EXPECT_EQ(judged.judge.verdict(), Verdict::Pass);
}

TEST(Measures, NamesAreOnTheirPage) {
    const Result<std::string> page = read_file(PL_SOURCE_DIR "/docs/SCENE-FORMAT.md", 1 << 20);
    ASSERT_TRUE(page.ok());
    for (const Measure& measure : measures())
        EXPECT_NE(page->find("`" + std::string(measure.name) + "`"), std::string::npos)
            << measure.name;
}

double measured_of(const char* name, const std::vector<BodyObservation>& bodies) {
    return std::get<BodiesMeasure>(find_measure(name)->value)(bodies);
}

// Ten bodies on a line, 1 m apart, the middle ones 2 m up: 90 % lie within 4.5 m of the middle.
TEST(Measures, OfAHeap) {
    std::vector<BodyObservation> bodies(10);
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        bodies[i].now.world_from_body.position = {static_cast<Real>(i), i == 4 ? 2.0_r : 0, 0};
    }
    EXPECT_NEAR(measured_of("heap_slope_deg", bodies), std::atan2(2, 4.5) * 180 / 3.14159265, 1e-4);
    EXPECT_NEAR(measured_of("mean_height_m", bodies), 0.2, 1e-6);
    for (const char* name : {"heap_slope_deg", "mean_height_m", "mean_displacement_m"})
        EXPECT_EQ(measured_of(name, {}), 0) << "of nothing";
    EXPECT_EQ(find_measure("heap_slope"), nullptr);
}

}  // namespace
}  // namespace plumbline::study
