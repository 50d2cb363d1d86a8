// The aids of the viewer are there for a model by itself alone.
#include "tests/engine/effects/model_scene.h"

#include <cmath>

namespace plumbline::effects {
namespace {

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

// Bounds of 1 m by 1 m: a radius of 0.707 m, whose fifth is 0.14; the next of 1, 2 and 5 is 0.2 m.
TEST(ViewerAids, GridsCountAsPeopleDo) {
    const TempFolder folder;
    test::Running run(model_scene(folder, TriangleFile{}.glb()));
    EffectRuntime effects(*run, {.frame = true});
    run->switches.grid = true;
    const LineList lines = draw(run, effects).lines;
    ASSERT_EQ(lines.vertices.size(), 84U);
    const Vec3f first = lines.vertices[0].position_world;
    const Vec3f next = lines.vertices[4].position_world;
    EXPECT_NEAR(next.x - first.x, 0.2F, 1e-5F);
    EXPECT_NEAR(lines.vertices[1].position_world.z - first.z, 20 * 0.2F, 1e-5F);
    // Round a multiple of the step near the middle, (0.5, 0.5, 0).
    EXPECT_NEAR(std::abs(first.x / 0.2F - std::round(first.x / 0.2F)), 0, 1e-4);
}

TEST(ViewerAids, BackgroundsGoRound) {
    const TempFolder folder;
    test::Running run(model_scene(folder, TriangleFile{}.glb()));
    EffectRuntime effects(*run, {.frame = true});
    const Vec3f own = draw(run, effects).clear_color;
    const auto color_of = [&](int number) {
        run->switches.background = number;
        return draw(run, effects).clear_color;
    };
    EXPECT_EQ(color_of(1), Vec3f{1.0F});
    EXPECT_EQ(color_of(3), Vec3f{0.0F});
    EXPECT_EQ(color_of(4), own);
    EXPECT_EQ(color_of(5), Vec3f{1.0F});
    run->switches.axes = true;
    EXPECT_EQ(draw(run, effects).lines.vertices.size(), 6U) << "x, y and z";
}

}  // namespace
}  // namespace plumbline::effects
