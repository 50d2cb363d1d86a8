// How many shader programs the meshes of a scene need, whatever is switched while it is played.
#include "engine/render/passes/mesh_pass.h"
#include "tests/engine/render/renderer_fixture.h"

namespace plumbline::render {
namespace {

using namespace mesh_feature;

class MeshPassGl : public RendererGl {
protected:
    /// New programs of a frame.
    std::uint32_t new_programs(const RenderFrame& frame) {
        draw(frame);
        return renderer_->stats().new_programs;
    }
};

TEST_F(MeshPassGl, SwitchesOfPlayNeedNoOtherPrograms) {
    RenderFrame frame = sunny_box();
    frame.post = Post{};
    EXPECT_GT(new_programs(frame), 0U);
    frame.fog = Fog{};
    frame.wind = Wind{.mean_mps = {3.0F, 0.0F}};
    for (const DepthTest test :
         {DepthTest::Always, DepthTest::Off, DepthTest::Never, DepthTest::Greater}) {
        frame.depth_test = test;
        EXPECT_EQ(new_programs(frame), 0U) << name_of(test);
    }
    frame.fog.reset();
    frame.depth_test = DepthTest::Less;
    EXPECT_EQ(new_programs(frame), 0U);
}

TEST_F(MeshPassGl, FarAndNearThingsShareTheirProgramInHazyAir) {
    RenderFrame frame = sunny_box();
    frame.sky = Sky{.model = SkyModel{.to_sun_world = {0.3F, 0.8F, 0.2F}, .visibility_m = 100.0F}};
    draw(frame);
    add_box(frame, Vec3f{8.0F}, {0.0F, 3.0F, -60.0F}, frame.material_ids.back());
    EXPECT_EQ(new_programs(frame), 0U);
}

TEST(VariantOf, WhatBelongsToSomethingAbsentMakesNoVariant) {
    EXPECT_EQ(variant_of(kVertexColor, kSun | kHardShadows), kVertexColor | kSun);
    EXPECT_EQ(variant_of(kVertexColor, kSun | kCascades | kContactHardening), kVertexColor | kSun);
    EXPECT_EQ(variant_of(kVertexColor, kLightShadows), kVertexColor);
    EXPECT_EQ(variant_of(kVertexColor, kSoftShadows), kVertexColor);
    const FeatureSet shadowed = kSun | kSunShadow | kCascades | kHardShadows;
    EXPECT_EQ(variant_of(kVertexColor, shadowed), kVertexColor | shadowed);
    EXPECT_EQ(variant_of(kVertexColor, kCoverage), kVertexColor) << "nothing is masked";
    EXPECT_EQ(variant_of(kBlend, kOcclusion), kBlend) << "alpha says how much it hides";
    EXPECT_EQ(variant_of(kUnlit, shadowed | kFlashlight | kLocalLights | kSkyLight), kUnlit);
    EXPECT_EQ(variant_of(kBaseMap, kFaceted), kBaseMap);
}

}  // namespace
}  // namespace plumbline::render
