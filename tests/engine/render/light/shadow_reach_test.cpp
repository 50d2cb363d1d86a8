#include "engine/render/light/shadow_reach.h"

#include "engine/assets/primitives.h"
#include "engine/render/culling/draw_list.h"

#include <gtest/gtest.h>

#include <random>

namespace plumbline::render {
namespace {

/// A floor of 100 m with its top at 0, and boxes of 1 m over it.
class ShadowReachTest : public testing::Test {
protected:
    DrawItem& add(assets::MeshId mesh, const Vec3f& at) {
        add_item(frame_,
                 {.mesh = mesh, .world_from_body = glm::translate(Mat4f{1.0F}, at)},
                 {&plain_, 1});
        return frame_.items.back();
    }
    std::optional<ConvexVolume> on_floor(const Vec3f& direction, float margin_m = 0.0F) const {
        return shadows_of_others(
            frame_, library_, frame_.items.front(), glm::normalize(direction), margin_m);
    }

    RenderFrame frame_;
    assets::AssetLibrary library_;
    assets::MaterialId plain_{library_.add_material({.name = "plain"})};
    assets::MeshId box_{library_.add_mesh("box", assets::box_mesh(Vec3f{1.0F}))};
    assets::MeshId floor_{library_.add_mesh("floor", assets::box_mesh({100.0F, 1.0F, 100.0F}))};
};

Aabb place(const Vec3f& at) {
    return {.min = at - 1e-3F, .max = at + 1e-3F};
}

TEST_F(ShadowReachTest, AFloorAloneIsNowhereInShadow) {
    add(floor_, {0.0F, -0.5F, 0.0F});
    EXPECT_FALSE(on_floor({0.0F, -1.0F, 0.0F}));
}

TEST_F(ShadowReachTest, ABoxShadowsWhereTheSunThrowsItAndNotBeside) {
    add(floor_, {0.0F, -0.5F, 0.0F});
    add(box_, {0.0F, 5.0F, 0.0F});
    // Down by one, along x by one: 5 m up throws 5 m far.
    const auto dark = on_floor({1.0F, -1.0F, 0.0F});
    ASSERT_TRUE(dark);
    EXPECT_TRUE(dark->reaches(place({5.0F, 0.0F, 0.0F})));
    EXPECT_TRUE(dark->reaches(place({5.9F, 0.0F, 0.4F})));
    EXPECT_FALSE(dark->reaches(place({0.0F, 0.0F, 0.0F})));
    EXPECT_FALSE(dark->reaches(place({5.0F, 0.0F, 0.6F})));
    EXPECT_TRUE(on_floor({1.0F, -1.0F, 0.0F}, 0.2F)->reaches(place({5.0F, 0.0F, 0.6F})));
}

TEST_F(ShadowReachTest, WhatCastsNoShadowDoesNotCount) {
    add(floor_, {0.0F, -0.5F, 0.0F});
    add(box_, {0.0F, 5.0F, 0.0F}).casts_shadow = false;
    EXPECT_FALSE(on_floor({1.0F, -1.0F, 0.0F}));
}

TEST_F(ShadowReachTest, AFloorShadesNothingUntilSomethingLiesBelowItsTop) {
    add(floor_, {0.0F, -0.5F, 0.0F});
    const auto shades_nothing_below = [&](const Vec3f& sun) {
        return shades_nothing(frame_, library_, frame_.items.front(), glm::normalize(sun), 0.05F);
    };
    const Vec3f aslant{0.6F, -1.0F, 0.3F};
    EXPECT_TRUE(shades_nothing_below(aslant));
    add(box_, {0.0F, 0.47F, 0.0F});  // 3 cm in it
    add(box_, {49.9F, 5.0F, 0.0F});
    EXPECT_TRUE(shades_nothing_below(aslant));
    EXPECT_FALSE(shades_nothing_below({0.0F, 1.0F, 0.0F})) << "a sun from below";
    add(box_, {-55.0F, -3.0F, 0.0F});  // before the side that the sun shines on
    EXPECT_TRUE(shades_nothing_below(aslant));
    add(box_, {55.0F, -3.0F, 0.0F});  // fell over the far edge
    EXPECT_FALSE(shades_nothing_below(aslant));
}

TEST_F(ShadowReachTest, ATurnedAndMirroredFloorKeepsItsLitSide) {
    add(floor_, {0.0F, 0.0F, 0.0F});
    DrawItem& floor = frame_.items.front();
    floor.world_from_body =
        glm::scale(glm::rotate(Mat4f{1.0F}, 0.3F, {0.0F, 0.0F, 1.0F}), {-1.0F, 1.0F, 1.0F});
    const Vec3f up{-std::sin(0.3F), std::cos(0.3F), 0.0F};
    add(box_, up * 2.0F);
    const auto shades = [&] {
        return !shades_nothing(frame_, library_, frame_.items.front(), {0.0F, -1.0F, 0.0F}, 0.0F);
    };
    EXPECT_FALSE(shades());
    add(box_, up * -2.0F);
    EXPECT_TRUE(shades());
}

TEST_F(ShadowReachTest, MissesNoShadowedPlace) {
    std::mt19937 random(3);
    const auto in = [&](float low, float high) {
        return std::uniform_real_distribution<float>(low, high)(random);
    };
    for (int round = 0; round < 50; ++round) {
        frame_ = {};
        add(floor_, {0.0F, -0.5F, 0.0F});
        std::vector<Vec3f> boxes;
        for (int i = 0; i < 5; ++i) {
            boxes.emplace_back(in(-20, 20), in(0.5F, 9), in(-20, 20));
            add(box_, boxes.back());
        }
        const Vec3f sun = glm::normalize(Vec3f{in(-1, 1), -in(0.2F, 1), in(-1, 1)});
        const auto dark = on_floor(sun);
        ASSERT_TRUE(dark);
        for (const Vec3f& box : boxes) {
            const Vec3f inside = box + Vec3f{in(-0.5F, 0.5F), in(-0.5F, 0.5F), in(-0.5F, 0.5F)};
            const Vec3f shadow = inside - sun * (inside.y / sun.y);
            EXPECT_TRUE(dark->reaches(place(shadow)));
        }
    }
}

TEST_F(ShadowReachTest, KnowsConvexMeshes) {
    EXPECT_TRUE(is_convex(assets::box_mesh({3.0F, 1.0F, 2.0F})));
    assets::MeshData two = assets::box_mesh(Vec3f{1.0F});
    assets::MeshData other = two;
    for (assets::Vertex& vertex : other.vertices) vertex.position_body.x += 3.0F;
    const auto first = static_cast<std::uint32_t>(two.vertices.size());
    two.vertices.insert(two.vertices.end(), other.vertices.begin(), other.vertices.end());
    for (const std::uint32_t index : other.indices) two.indices.push_back(first + index);
    two.bounds = assets::bounds_of(two);
    EXPECT_FALSE(is_convex(two));
    assets::MeshData room = assets::box_mesh(Vec3f{1.0F});
    for (std::size_t i = 0; i < room.indices.size(); i += 3)
        std::swap(room.indices[i], room.indices[i + 1]);
    EXPECT_FALSE(is_convex(room));
}

}  // namespace
}  // namespace plumbline::render
