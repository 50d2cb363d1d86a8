#include "engine/render/light/ray_scene.h"

#include "engine/assets/image/image_import.h"
#include "engine/assets/primitives.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

namespace plumbline::render {
namespace {

const Vec3f kDown{0.0F, -1.0F, 0.0F};
const Vec3f kUp{0.0F, 1.0F, 0.0F};

/// A floor whose top lies at y = 0.
class RayScenes : public testing::Test {
protected:
    RayScenes() { add(assets::box_mesh({40.0F, 1.0F, 40.0F}), "floor", {0.0F, -0.5F, 0.0F}, {}); }

    void add(assets::MeshData mesh,
             const std::string& name,
             const Vec3f& place,
             const assets::MaterialData& look,
             bool casts_shadow = true) {
        const assets::MaterialId material = library_.add_material(look);
        add_item(frame_,
                 {.mesh = library_.add_mesh(name, std::move(mesh)),
                  .world_from_body = glm::translate(Mat4f{1.0F}, place),
                  .casts_shadow = casts_shadow},
                 {&material, 1});
    }
    /// A card of 2 x 2 m at the height of 2 m that lies flat, its right half a hole.
    void add_card_with_a_hole() {
        const auto file = folder_.path() / "card.png";
        ASSERT_TRUE(assets::write_png(file,
                                      {.width = 2,
                                       .height = 1,
                                       .format = assets::PixelFormat::Rgba8,
                                       .bytes = {9, 200, 9, 255, 9, 200, 9, 0}})
                        .ok());
        assets::MeshData card;
        for (const Vec2f& uv : {Vec2f{0.0F}, {0.0F, 1.0F}, {1.0F, 1.0F}, {1.0F, 0.0F}}) {
            assets::Vertex vertex;
            vertex.position_body = {2.0F * uv.x - 1.0F, 0.0F, 2.0F * uv.y - 1.0F};
            vertex.uv = uv;
            card.vertices.push_back(vertex);
        }
        card.indices = {0, 1, 2, 0, 2, 3};
        card.sub_meshes = {{0, 6, 0}};
        card.bounds = assets::bounds_of(card);
        add(std::move(card),
            "card",
            {0.0F, 2.0F, 0.0F},
            {.base_color_map = file, .alpha_mode = assets::AlphaMode::Mask, .two_sided = true});
    }
    RayHit floor_at(const RayScene& rays, float x, float z) {
        const std::optional<RayHit> hit = rays.first_hit({x, 0.5F, z}, kDown);
        EXPECT_TRUE(hit.has_value());
        return hit.value_or(RayHit{});
    }

    test::TemporaryFolder folder_;
    assets::AssetLibrary library_;
    RenderFrame frame_;
};

TEST_F(RayScenes, ARayMeetsTheNearestThing) {
    add(assets::box_mesh(Vec3f{2.0F}), "box", {0.0F, 1.0F, 0.0F}, {});
    const RayScene rays(frame_, library_);
    const auto on_box = rays.first_hit({0.3F, 5.0F, 0.2F}, kDown);
    ASSERT_TRUE(on_box.has_value());
    EXPECT_NEAR(on_box->distance_m, 3.0F, 1e-5F);
    EXPECT_NEAR(on_box->normal_world.y, 1.0F, 1e-6F);
    const auto on_floor = rays.first_hit({1.5F, 5.0F, 0.2F}, kDown);
    ASSERT_TRUE(on_floor.has_value());
    EXPECT_NEAR(on_floor->position_world.y, 0.0F, 1e-5F);
    EXPECT_FALSE(rays.first_hit({0.0F, 5.0F, 0.0F}, kUp).has_value());
}

TEST_F(RayScenes, ABoxShadesWhereGeometrySaysSo) {
    // Edges at x = -1 and 1, 2 m high; the sun at 45 degrees from the side of -x: the shadow on the
    // floor reaches from x = 1 to x = 3.
    add(assets::box_mesh(Vec3f{2.0F}), "box", {0.0F, 1.0F, 0.0F}, {});
    const RayScene rays(frame_, library_);
    const Vec3f to_sun = glm::normalize(Vec3f{-1.0F, 1.0F, 0.0F});
    for (const float x : {1.001F, 2.0F, 2.999F})
        EXPECT_TRUE(rays.is_shaded(floor_at(rays, x, 0.0F), to_sun)) << x;
    for (const float x : {-1.001F, 3.001F, 9.0F})
        EXPECT_FALSE(rays.is_shaded(floor_at(rays, x, 0.0F), to_sun)) << x;
    EXPECT_FALSE(rays.is_shaded(floor_at(rays, 2.0F, 1.001F), to_sun));
}

TEST_F(RayScenes, SurfacesDoNotShadeThemselvesHoweverFarOff) {
    const RayScene rays(frame_, library_);
    for (const float height : {0.02F, 0.5F, 5.0F}) {
        const Vec3f to_sun = glm::normalize(Vec3f{1.0F, height, 0.3F});
        for (float x = -19.0F; x < 19.0F; x += 0.37F) {
            const auto hit =
                rays.first_hit({0.0F, 300.0F, 0.0F}, glm::normalize(Vec3f{x, -300.0F, 0.4F * x}));
            ASSERT_TRUE(hit.has_value());
            EXPECT_FALSE(rays.is_shaded(*hit, to_sun)) << x << ' ' << height;
        }
    }
}

TEST_F(RayScenes, RaysGoThroughTheHolesOfAMask) {
    add_card_with_a_hole();
    const RayScene rays(frame_, library_);
    const auto leaf = rays.first_hit({-0.5F, 5.0F, 0.0F}, kDown);
    ASSERT_TRUE(leaf.has_value());
    EXPECT_NEAR(leaf->distance_m, 3.0F, 1e-5F);
    EXPECT_TRUE(leaf->two_sided);
    // Around the middle of a texel, where the place among texels is a hair below a whole number.
    for (const float x : {-0.5F - 1e-7F, -0.5F - 6e-8F, -0.5F + 6e-8F, -0.5F + 1e-7F}) {
        const auto near_it = rays.first_hit({x, 5.0F, 0.0F}, kDown);
        ASSERT_TRUE(near_it.has_value());
        EXPECT_NEAR(near_it->distance_m, 3.0F, 1e-5F) << x;
    }
    const auto hole = rays.first_hit({0.5F, 5.0F, 0.0F}, kDown);
    ASSERT_TRUE(hole.has_value());
    EXPECT_NEAR(hole->distance_m, 5.0F, 1e-5F);
    EXPECT_TRUE(rays.is_shaded(floor_at(rays, -0.5F, 0.0F), kUp));
    EXPECT_FALSE(rays.is_shaded(floor_at(rays, 0.5F, 0.0F), kUp));
    // Seen from below, the sun shines on its other side and through it.
    const auto below = rays.first_hit({-0.5F, 0.5F, 0.0F}, kUp);
    ASSERT_TRUE(below.has_value());
    EXPECT_FALSE(rays.is_shaded(*below, kUp));
}

TEST_F(RayScenes, GlassNeitherHidesNorShades) {
    add(assets::box_mesh({4.0F, 0.1F, 4.0F}),
        "glass",
        {0.0F, 2.0F, 0.0F},
        {.alpha = 0.5F, .alpha_mode = assets::AlphaMode::Blend});
    const RayScene rays(frame_, library_);
    const auto hit = rays.first_hit({0.0F, 5.0F, 0.0F}, kDown);
    ASSERT_TRUE(hit.has_value());
    EXPECT_NEAR(hit->distance_m, 5.0F, 1e-5F);
    EXPECT_FALSE(rays.is_shaded(*hit, kUp));
}

TEST_F(RayScenes, WhatCastsNoShadowIsSeenAllTheSame) {
    add(assets::box_mesh(Vec3f{2.0F}), "ghost", {0.0F, 3.0F, 0.0F}, {}, false);
    const RayScene rays(frame_, library_);
    const auto hit = rays.first_hit({0.0F, 9.0F, 0.0F}, kDown);
    ASSERT_TRUE(hit.has_value());
    EXPECT_NEAR(hit->distance_m, 5.0F, 1e-5F);
    EXPECT_FALSE(rays.is_shaded(floor_at(rays, 0.0F, 0.0F), kUp));
}

TEST_F(RayScenes, WhoAsksForBacksSeesThem) {
    add(assets::box_mesh(Vec3f{2.0F}), "box", {0.0F, 3.0F, 0.0F}, {});
    const RayScene rays(frame_, library_);
    const auto back = rays.first_hit({0.0F, 3.0F, 0.0F}, kDown, Backs::Seen);
    ASSERT_TRUE(back.has_value());
    EXPECT_TRUE(back->from_behind);
    EXPECT_NEAR(back->distance_m, 1.0F, 1e-5F);
    EXPECT_EQ(back->normal_world, kDown) << "out of the box, along the ray";
}

TEST_F(RayScenes, AHitHasItsPartsMeanColour) {
    add(assets::box_mesh(Vec3f{2.0F}),
        "box",
        {0.0F, 3.0F, 0.0F},
        {.base_color = {0.8F, 0.2F, 0.1F}});
    frame_.items.back().tint = {0.5F, 1.0F, 1.0F};
    const auto hit = RayScene(frame_, library_).first_hit({0.0F, 9.0F, 0.0F}, kDown);
    ASSERT_TRUE(hit.has_value());
    EXPECT_NEAR(hit->albedo.x, 0.4F, 1e-4F);
    EXPECT_NEAR(hit->albedo.y, 0.2F, 1e-4F);
    EXPECT_FALSE(hit->from_behind);
}

TEST_F(RayScenes, LooksThroughBacksAsTheImageDoes) {
    add(assets::box_mesh(Vec3f{2.0F}), "box", {0.0F, 1.0F, 0.0F}, {});
    const RayScene rays(frame_, library_);
    // From inside: the image shows no back of a wall.
    EXPECT_FALSE(rays.first_hit({0.0F, 1.0F, 0.0F}, {1.0F, 0.0F, 0.0F}).has_value());
}

TEST(RayScene, OfNothingHasNothingToMeet) {
    assets::AssetLibrary library;
    const RayScene rays(RenderFrame{}, library);
    EXPECT_FALSE(rays.first_hit(Vec3f{0.0F}, kDown).has_value());
    EXPECT_FALSE(rays.is_shaded({}, kUp));
}

}  // namespace
}  // namespace plumbline::render
