#include "engine/render/culling/draw_list.h"

#include "engine/assets/primitives.h"

#include <gtest/gtest.h>

#include <vector>

namespace plumbline::render {
namespace {

class DrawListTest : public testing::Test {
protected:
    struct Thing {
        assets::MeshId mesh;
        assets::MaterialId material;
        float z;
        bool casts_shadow{true};
    };
    const RenderFrame& frame_of(const std::vector<Thing>& things) {
        frame_ = {};
        for (const Thing& thing : things) {
            add_item(frame_,
                     {.mesh = thing.mesh,
                      .world_from_body = glm::translate(Mat4f{1.0F}, Vec3f{0.0F, 0.0F, thing.z}),
                      .casts_shadow = thing.casts_shadow},
                     {&thing.material, 1});
        }
        return frame_;
    }
    std::vector<VisibleItem> all_of(const std::vector<Thing>& things) {
        const Mat4f everything = glm::ortho(-1e4F, 1e4F, -1e4F, 1e4F, -1e4F, 1e4F);
        return cull(frame_of(things), library_, {.frustum = Frustum{everything}});
    }

    RenderFrame frame_;  ///< what all_of() tells of lives in it

    assets::AssetLibrary library_;
    assets::MeshId box_{library_.add_mesh("box", assets::box_mesh(Vec3f{1.0F}))};
    assets::MeshId ball_{library_.add_mesh("ball", assets::sphere_mesh(0.5F))};
    assets::MaterialId red_{library_.add_material({.name = "red"})};
    assets::MaterialId glass_{
        library_.add_material({.name = "glass", .alpha_mode = assets::AlphaMode::Blend})};
};

TEST_F(DrawListTest, JoinsEqualItemsNearestFirst) {
    const std::vector<Thing> items{
        {box_, red_, -20.6F}, {box_, red_, -20.2F}, {box_, red_, -20.4F}};
    DrawList list;
    build_draws(all_of(items), library_, DrawKind::Opaque, list);
    ASSERT_EQ(list.runs.size(), 1U);
    EXPECT_EQ(list.runs[0].instance_count, 3U);
    EXPECT_FLOAT_EQ(list.instances[0].row_z.w, -20.2F);
    EXPECT_FLOAT_EQ(list.instances[1].row_z.w, -20.4F);
    EXPECT_FLOAT_EQ(list.instances[2].row_z.w, -20.6F);
}

TEST_F(DrawListTest, DrawsNearThingsOfAnyKindBeforeFarOnes) {
    const std::vector<Thing> items{
        {box_, red_, -90.0F}, {ball_, red_, -30.0F}, {box_, red_, -3.0F}};
    DrawList list;
    build_draws(all_of(items), library_, DrawKind::Opaque, list);
    ASSERT_EQ(list.runs.size(), 3U);
    EXPECT_EQ(list.runs[0].mesh, box_);
    EXPECT_EQ(list.runs[1].mesh, ball_);
    EXPECT_EQ(list.runs[2].mesh, box_);
}

TEST_F(DrawListTest, PutsGlassLastAndFarGlassFirst) {
    const std::vector<Thing> items{
        {box_, glass_, -3.0F}, {box_, red_, -5.0F}, {box_, glass_, -9.0F}};
    DrawList opaque;
    build_draws(all_of(items), library_, DrawKind::Opaque, opaque);
    ASSERT_EQ(opaque.runs.size(), 1U);
    EXPECT_EQ(opaque.runs[0].material, red_);
    DrawList translucent;
    build_draws(all_of(items), library_, DrawKind::Translucent, translucent);
    ASSERT_EQ(translucent.runs.size(), 2U);
    EXPECT_FLOAT_EQ(translucent.instances[0].row_z.w, -9.0F);
    EXPECT_FLOAT_EQ(translucent.instances[1].row_z.w, -3.0F);
}

TEST_F(DrawListTest, CastsNoShadowOfGlassNorOfWhatCastsNone) {
    const std::vector<Thing> items{
        {box_, glass_, -3.0F}, {box_, red_, -5.0F}, {ball_, red_, -5.0F, false}};
    DrawList list;
    build_depth_draws(all_of(items), library_, Emitters::Cast, list);
    ASSERT_EQ(list.runs.size(), 1U);
    EXPECT_EQ(list.runs[0].mesh, box_);
    EXPECT_EQ(list.runs[0].index_count, 36U);
}

TEST_F(DrawListTest, CullsWhatIsOutOfSight) {
    const std::vector<Thing> items{{box_, red_, -10.0F}, {box_, red_, 10.0F}};
    const Mat4f ahead = glm::perspective(1.0F, 1.0F, 0.1F, 100.0F);
    EXPECT_EQ(cull(frame_of(items), library_, {.frustum = Frustum{ahead}}).size(), 1U);
}

TEST_F(DrawListTest, LeavesOutWhatLooksTooSmall) {
    // A box of 1 m has a diagonal of 1.732 m; its near side is 99.5 m off.
    const std::vector<Thing> items{{box_, red_, -100.0F}, {box_, red_, -10.0F}};
    const Mat4f everything = glm::ortho(-1e4F, 1e4F, -1e4F, 1e4F, -1e4F, 1e4F);
    CullView view{.frustum = Frustum{everything}, .smallest_rad = 0.0173F};
    EXPECT_EQ(cull(frame_of(items), library_, view).size(), 2U);
    view.smallest_rad = 0.0175F;
    EXPECT_EQ(cull(frame_of(items), library_, view).size(), 1U);
}

TEST_F(DrawListTest, TakesTheCoarsestVersionThatIsFineEnough) {
    const LodTable lods{{box_,
                         {{.error_m = 0.01F, .sub_meshes = {{36, 24, 0}}},
                          {.error_m = 0.1F, .sub_meshes = {{60, 12, 0}}}}}};
    const Mat4f everything = glm::ortho(-1e4F, 1e4F, -1e4F, 1e4F, -1e4F, 1e4F);
    // A thousandth of the distance: 1 cm from 10 m on, 10 cm from 100 m on.
    const CullView view{.frustum = Frustum{everything}, .lods = &lods, .error_rad = 1e-3F};
    const auto visible =
        cull(frame_of({{box_, red_, -9.0F}, {box_, red_, -50.0F}, {box_, red_, -200.0F}}),
             library_,
             view);
    ASSERT_EQ(visible.size(), 3U);
    EXPECT_EQ(visible[0].parts[0].index_count, 36U);
    EXPECT_EQ(visible[1].parts[0].index_count, 24U);
    EXPECT_EQ(visible[2].parts[0].index_count, 12U);
    DrawList list;
    build_draws(visible, library_, DrawKind::Opaque, list);
    ASSERT_EQ(list.runs.size(), 3U);
    EXPECT_EQ(list.runs[2].first_index, 60U);
}

TEST_F(DrawListTest, TakesFoliageInTheOrderOfTheSideThatIsSeen) {
    MeshLod crown{.error_m = 0.0F, .sub_meshes = {{0, 36, 0}}};
    for (std::uint32_t side = 0; side < 8; ++side) crown.by_side.push_back({{100 + side, 36, 0}});
    const LodTable lods{{box_, {crown}}};
    const Mat4f everything = glm::ortho(-1e4F, 1e4F, -1e4F, 1e4F, -1e4F, 1e4F);
    CullView view{.frustum = Frustum{everything}, .lods = &lods, .error_rad = 1e-3F};
    // The eye is on the side of +z, which is the third from +x.
    const RenderFrame& frame = frame_of({{box_, red_, -9.0F}});
    EXPECT_EQ(cull(frame, library_, view)[0].parts[0].first_index, 0U);
    view.sorts_foliage = true;
    EXPECT_EQ(cull(frame, library_, view)[0].parts[0].first_index, 102U);
}

TEST_F(DrawListTest, DrawsWhatTheFlashlightReachesApart) {
    // Straight ahead, 0.6 m far: it reaches only the box whose near side is at 0.5 m.
    const ConvexVolume beam = ConvexVolume::cone(Vec3f{0.0F}, Vec3f{0.0F, 0.0F, -1.0F}, 0.2F, 0.6F);
    const Mat4f everything = glm::ortho(-1e4F, 1e4F, -1e4F, 1e4F, -1e4F, 1e4F);
    CullView view{.frustum = Frustum{everything}};
    const RenderFrame& frame = frame_of({{box_, red_, -1.0F}, {box_, red_, -1.3F}});
    DrawList together;
    build_draws(cull(frame, library_, view), library_, DrawKind::Opaque, together);
    ASSERT_EQ(together.runs.size(), 1U);
    EXPECT_FALSE(together.runs[0].in_beam);
    view.beam = &beam;
    DrawList apart;
    build_draws(cull(frame, library_, view), library_, DrawKind::Opaque, apart);
    ASSERT_EQ(apart.runs.size(), 2U);
    EXPECT_EQ(apart.runs[0].in_beam, apart.instances[0].row_z.w == -1.0F);
    EXPECT_NE(apart.runs[0].in_beam, apart.runs[1].in_beam);
}

TEST_F(DrawListTest, GlassDropsRingsAndStarsMixColors) {
    EXPECT_FALSE(mixes_colors(frame_of({{box_, red_, -5.0F}}), library_));
    EXPECT_TRUE(mixes_colors(frame_of({{box_, red_, -5.0F}, {box_, glass_, -5.0F}}), library_));
    frame_ = {};
    frame_.sky = Sky{};
    EXPECT_FALSE(mixes_colors(frame_, library_));
    frame_.sky->model = SkyModel{};
    EXPECT_TRUE(mixes_colors(frame_, library_));
    frame_ = {};
    frame_.drops.emplace_back();
    EXPECT_TRUE(mixes_colors(frame_, library_));
    frame_ = {};
    frame_.water_rings.emplace_back();
    EXPECT_TRUE(mixes_colors(frame_, library_));
}

}  // namespace
}  // namespace plumbline::render
