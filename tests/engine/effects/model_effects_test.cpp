// Animations play with the steps; the aids of the viewer are there for a model by itself alone.
#include "engine/effects/effect_runtime.h"
#include "engine/scene/extract.h"
#include "engine/scene/scene_file.h"
#include "tests/engine/assets/fixture.h"
#include "tests/engine/effects/drawn.h"
#include "tests/support/scene_in_code.h"

#include <algorithm>

namespace plumbline::effects {
namespace {

using assets::test::TempFolder;
using assets::test::TriangleFile;

/// A triangle that slides from x = 0 to 2 m in one second, beside one that stands at x = 5.
std::string sliding_model() {
    TriangleFile file;
    file.json["nodes"] = {{{"mesh", 0}, {"name", "sled"}},
                          {{"mesh", 0}, {"translation", {5, 0, 0}}}};
    file.json["scenes"][0]["nodes"] = {0, 1};
    file.slide(0);
    file.json["animations"][0]["name"] = "slide";
    return file.glb();
}

scene::SceneDescription model_scene(const TempFolder& folder, const std::string& bytes) {
    Diagnostics faults;
    auto scene = scene::read_description(folder.write("m.glb", bytes), {}, faults);
    EXPECT_TRUE(scene.ok());
    scene->sun.reset();
    return *scene;
}

std::vector<float> places_x(const render::RenderFrame& frame) {
    std::vector<float> places;
    for (const render::DrawItem& item : frame.items) places.push_back(item.world_from_body[3].x);
    std::sort(places.begin(), places.end());
    return places;
}

TEST(ModelAnimation, MovesItsPartsWithTheStepsAndRepeats) {
    const TempFolder folder;
    test::Running run(model_scene(folder, sliding_model()));
    EffectRuntime effects(*run, {.frame = true});
    const float ground_x =
        run->registry.get<scene::Transform>(run->find("ground")).world_from_body.position.x;
    run.step(15, effects);  // a quarter of the second
    render::RenderFrame frame = draw(run, effects);
    ASSERT_EQ(frame.items.size(), 3U) << "ground, what stands, what slides; not the model at rest";
    std::vector<float> expected{0.0F, 0.5F, ground_x};
    std::sort(expected.begin(), expected.end());
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(places_x(frame)[i], expected[i], 1e-4);

    run.step(60, effects);  // once round
    frame = draw(run, effects);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(places_x(frame)[i], expected[i], 1e-4);

    for (auto [entity, playing] : run->registry.view<scene::PlayingModel>()) playing.paused = true;
    run.step(7, effects);
    frame = draw(run, effects);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(places_x(frame)[i], expected[i], 1e-4);
}

TEST(ModelAnimation, StandsBetweenTwoStepsAsTheFrameDoes) {
    const TempFolder folder;
    test::Running run(model_scene(folder, sliding_model()));
    EffectRuntime effects(*run, {.frame = true});
    const auto sled_x = [&](Real blend) {
        return draw(run, effects, blend).items.back().world_from_body[3].x;
    };
    EXPECT_NEAR(sled_x(0.5_r), 0.0, 1e-4) << "before the first step";
    run.step(15, effects);  // 2 m a second, 60 steps a second
    EXPECT_NEAR(sled_x(1), 2.0 * 15 / 60, 1e-4);
    EXPECT_NEAR(sled_x(0.5_r), 2.0 * 14.5 / 60, 1e-4);
    EXPECT_NEAR(sled_x(0), 2.0 * 14 / 60, 1e-4);
    run.step(45, effects);  // at its start again
    EXPECT_NEAR(sled_x(0.25_r), 2.0 * 59.25 / 60, 1e-4) << "the rest of the round before";
    for (auto [entity, playing] : run->registry.view<scene::PlayingModel>()) playing.paused = true;
    run.step(1, effects);
    EXPECT_NEAR(sled_x(0.25_r), sled_x(1), 1e-6);
}

std::string turning_model() {
    TriangleFile file;
    file.hang_on_turning_bone();
    return file.glb();
}

TEST(ViewerAids, ShowNormalsAsThePoseOfTheFrameHasThem) {
    for (const bool skinned : {false, true}) {
        const TempFolder folder;
        test::Running run(model_scene(folder, skinned ? turning_model() : sliding_model()));
        EffectRuntime effects(*run, {.frame = true});
        run->switches.normals = true;
        run.step(15, effects);
        const LineList lines = draw(run, effects).lines;
        // The sliding model shows its triangle twice.
        ASSERT_EQ(lines.vertices.size(), skinned ? 6U : 12U);
        const Vec3f from = lines.vertices.at(lines.vertices.size() - 4).position_world;
        const Vec3f to = lines.vertices.at(lines.vertices.size() - 3).position_world;
        const Vec3f along = glm::normalize(to - from);
        // The corner at x = 1: slid by half a metre, or turned by 45 degrees to the left.
        const float eighth = std::sqrt(0.5F);
        const Vec3f place = skinned ? Vec3f{eighth, 0, -eighth} : Vec3f{1.5F, 0, 0};
        const Vec3f normal = skinned ? Vec3f{eighth, 0, eighth} : Vec3f{0, 0, 1};
        EXPECT_NEAR(glm::distance(from, place), 0, 1e-4) << skinned;
        EXPECT_NEAR(glm::distance(along, normal), 0, 1e-3) << skinned;
    }
}

TEST(ViewerAids, PushTheNearPlaneUpToWhatIsNearest) {
    const TempFolder folder;
    test::Running run(model_scene(folder, TriangleFile{}.glb()));
    EffectRuntime effects(*run, {.frame = true});
    run->switches.ground = false;
    const auto near_m_at = [&](const Vec3& eye_m) {
        effects.refresh(*run);
        scene::ViewPoint view;
        view.world_from_camera.position = eye_m;
        render::RenderFrame frame = scene::extract(*run, view, 64, 64);
        effects.extract(*run, view, frame);
        return frame.camera.near_m;
    };
    // The triangle lies between (0, 0, 0) and (1, 1, 0), the grid at y = 0.
    EXPECT_NEAR(near_m_at({0.5_r, 9, 0}), 4.0F, 1e-4);
    EXPECT_NEAR(near_m_at({0.5_r, 2, 40}), 1.0F, 1e-4) << "the grid is nearer";
    EXPECT_NEAR(near_m_at({0.5_r, 0.5_r, 0.0001_r}),
                0.002F * static_cast<float>(run->description().model_radius_m),
                1e-6);
}

TEST(ViewerAids, AreOnlyWhereAModelIsByItselfAndDoWhatTheirSwitchesSay) {
    const TempFolder folder;
    test::Running run(model_scene(folder, TriangleFile{}.glb()));
    EffectRuntime effects(*run, {.frame = true});
    const render::RenderFrame plain = draw(run, effects);
    EXPECT_TRUE(plain.lines.vertices.empty());
    EXPECT_EQ(plain.items.size(), 2U);

    run->switches.grid = true;
    run->switches.normals = true;
    run->switches.ground = false;
    run->switches.background = 1;
    const render::RenderFrame frame = draw(run, effects);
    // 21 lines each way, and one for each of the triangle's three normals.
    EXPECT_EQ(frame.lines.vertices.size(), 2U * (42 + 3));
    EXPECT_EQ(frame.items.size(), 1U);
    EXPECT_EQ(frame.clear_color, Vec3f(1.0F));

    test::Running other(test::scene_of({test::ground()}));
    other->switches.grid = true;
    EffectRuntime none(*other, {.frame = true});
    EXPECT_TRUE(draw(other, none).lines.vertices.empty());
}

}  // namespace
}  // namespace plumbline::effects
