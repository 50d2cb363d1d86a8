#include "engine/render/culling/occlusion_culling.h"

#include "engine/assets/primitives.h"
#include "engine/render/culling/frustum.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <random>
#include <set>
#include <vector>

namespace plumbline::render {
namespace {

constexpr std::uint32_t kWidth_px = 64;
constexpr std::uint32_t kHeight_px = 40;

class OcclusionCullingTest : public testing::Test {
protected:
    void add(const Mat4f& world_from_body,
             assets::MeshId mesh,
             assets::MaterialId material,
             bool is_static = false) {
        add_item(frame_,
                 {.mesh = mesh, .world_from_body = world_from_body, .is_static = is_static},
                 {&material, 1});
    }
    void add_box(const Vec3f& center, const Vec3f& size, assets::MaterialId material) {
        add(glm::scale(glm::translate(Mat4f{1.0F}, center), size), box_, material);
    }
    void add_box(const Vec3f& center, const Vec3f& size) { add_box(center, size, matt_); }
    /// Boxes of a metre or so, turned any way, from -6 to 6 m in x and y and 4 to 16 m before the eye.
    void add_heap(int count) {
        std::mt19937 random{7};
        std::uniform_real_distribution<float> part{0.0F, 1.0F};
        for (int i = 0; i < count; ++i) {
            const Vec3f at{12.0F * part(random) - 6.0F,
                           12.0F * part(random) - 6.0F,
                           -4.0F - 12.0F * part(random)};
            const Vec3f axis = Vec3f{part(random), part(random), part(random)} - 0.4F;
            const Mat4f turned = glm::rotate(
                glm::translate(Mat4f{1.0F}, at), 6.0F * part(random), glm::normalize(axis));
            add(glm::scale(turned, Vec3f{0.6F + part(random)}), box_, matt_);
        }
    }
    std::vector<VisibleItem> items() const {
        return cull(frame_, library_, {.frustum = Frustum{view_.clip_from_world}});
    }
    std::vector<const DrawItem*> shown(const OcclusionView& view) const {
        std::vector<VisibleItem> visible = items();
        remove_hidden(visible, library_, view);
        std::vector<const DrawItem*> left;
        for (const VisibleItem& item : visible) left.push_back(item.item);
        return left;
    }
    std::size_t shown_count() const { return shown(view_).size(); }

    /// Where a line of sight enters the item's box; none: it passes.
    std::optional<float> entry(const DrawItem& item, const Vec3f& from, const Vec3f& way) const {
        const Mat4f body_from_world = glm::inverse(item.world_from_body);
        const Vec3f start{body_from_world * Vec4f{from, 1.0F}};
        const Vec3f along{body_from_world * Vec4f{way, 0.0F}};
        const Aabb& box = library_.mesh(item.mesh).bounds;
        const Vec3f to_min = (box.min - start) / along;
        const Vec3f to_max = (box.max - start) / along;
        const Vec3f in = glm::min(to_min, to_max);
        const Vec3f out = glm::max(to_min, to_max);
        const float first = std::max({in.x, in.y, in.z, 0.0F});
        if (first > std::min({out.x, out.y, out.z})) return {};
        return first;
    }
    struct Seen {
        const DrawItem* item;
        Vec3f at;
    };
    /// By casting rays: what each pixel's centre shows.
    std::vector<Seen> seen() const {
        const Mat4f world_from_clip = glm::inverse(view_.clip_from_world);
        std::vector<Seen> all;
        for (std::uint32_t i = 0; i < kWidth_px * kHeight_px; ++i) {
            const Vec2f px{i % kWidth_px, i / kWidth_px};
            const Vec2f at = (px + 0.5F) / Vec2f{kWidth_px, kHeight_px} * 2.0F - 1.0F;
            const auto world = [&](float depth) {
                const Vec4f place = world_from_clip * Vec4f{at, depth, 1.0F};
                return Vec3f{place} / place.w;
            };
            const Vec3f from = world(-1.0F);
            const Vec3f way = glm::normalize(world(0.5F) - from);
            const DrawItem* nearest = nullptr;
            float distance_m = std::numeric_limits<float>::max();
            for (const DrawItem& item : frame_.items) {
                const std::optional<float> hit = entry(item, from, way);
                if (!hit || *hit >= distance_m) continue;
                distance_m = *hit;
                nearest = &item;
            }
            if (nearest != nullptr) all.push_back({nearest, from + way * distance_m});
        }
        return all;
    }

    assets::AssetLibrary library_;
    assets::MeshId box_{library_.add_mesh("box", assets::box_mesh(Vec3f{1.0F}))};
    assets::MeshId ball_{library_.add_mesh("ball", assets::sphere_mesh(0.5F))};
    assets::MaterialId matt_{library_.add_material({.name = "matt"})};
    assets::MaterialId glass_{
        library_.add_material({.name = "glass", .alpha_mode = assets::AlphaMode::Blend})};
    assets::MaterialId leaves_{
        library_.add_material({.name = "leaves", .alpha_mode = assets::AlphaMode::Mask})};
    assets::MaterialId lamp_{library_.add_material({.name = "lamp", .emissive = Vec3f{1.0F}})};
    RenderFrame frame_;
    /// From the origin along -z.
    OcclusionView view_{.clip_from_world = glm::perspective(1.2F, 1.5F, 0.05F, 100.0F),
                        .width_px = kWidth_px,
                        .height_px = kHeight_px};
};

TEST_F(OcclusionCullingTest, ABoxIsAClosedMeshAsLargeAsItsBounds) {
    EXPECT_TRUE(is_box(library_.mesh(box_)));
    EXPECT_TRUE(is_box(assets::box_mesh(Vec3f{120.0F, 1.0F, 0.01F})));
    EXPECT_FALSE(is_box(library_.mesh(ball_)));
    assets::MeshData open = library_.mesh(box_);
    open.indices.resize(30);
    EXPECT_FALSE(is_box(open));
    assets::MeshData cut = library_.mesh(box_);
    cut.vertices[cut.indices[0]].position_body *= 0.9F;
    EXPECT_FALSE(is_box(cut));
    assets::MeshData inside_out = library_.mesh(box_);
    std::ranges::reverse(inside_out.indices);
    EXPECT_FALSE(is_box(inside_out));
}

TEST_F(OcclusionCullingTest, LeavesOutWhatStandsWhollyBehindABox) {
    add_box({0.0F, 0.0F, -10.0F}, Vec3f{1.0F});
    add_box({0.0F, 0.0F, -5.0F}, Vec3f{2.0F});
    add(glm::translate(Mat4f{1.0F}, Vec3f{0.5F, 0.0F, -12.0F}), ball_, leaves_);
    add_box({2.2F, 0.0F, -10.0F}, Vec3f{2.0F});  // looks out beside it
    EXPECT_EQ(shown(view_), (std::vector<const DrawItem*>{&frame_.items[1], &frame_.items[3]}));
}

TEST_F(OcclusionCullingTest, OnlyOpaqueBoxesHide) {
    for (const assets::MaterialId material : {glass_, leaves_}) {
        frame_ = {};
        add_box({0.0F, 0.0F, -5.0F}, Vec3f{2.0F}, material);
        add_box({0.0F, 0.0F, -10.0F}, Vec3f{1.0F});
        EXPECT_EQ(shown_count(), 2U);
    }
    frame_ = {};
    add(glm::scale(glm::translate(Mat4f{1.0F}, Vec3f{0.0F, 0.0F, -5.0F}), Vec3f{2.0F}),
        ball_,
        matt_);
    add_box({0.0F, 0.0F, -10.0F}, Vec3f{0.5F});
    EXPECT_EQ(shown_count(), 2U) << "a ball is no box";
}

TEST_F(OcclusionCullingTest, WhatShinesHidesNothingFromItsOwnLight) {
    add_box({0.0F, 0.0F, -5.0F}, Vec3f{2.0F}, lamp_);
    add_box({0.0F, 0.0F, -10.0F}, Vec3f{1.0F});
    EXPECT_EQ(shown_count(), 1U);
    OcclusionView from_lamp = view_;
    from_lamp.emitters = Emitters::LetThrough;
    EXPECT_EQ(shown(from_lamp).size(), 2U);
}

TEST_F(OcclusionCullingTest, ABoxRoundTheEyeHidesNothingAndIsNotHidden) {
    add_box({0.0F, 0.0F, 0.0F}, Vec3f{1.0F});
    add_box({0.0F, 0.0F, -5.0F}, Vec3f{2.0F});
    EXPECT_EQ(shown_count(), 2U);
}

TEST_F(OcclusionCullingTest, WhatTheNearPlaneCutsOpenHidesNothing) {
    add_box({0.0F, 0.0F, -0.53F}, Vec3f{1.0F});  // from 3 cm on; the plane is 5 cm off
    add_box({0.0F, 0.0F, -5.0F}, Vec3f{0.5F});
    EXPECT_EQ(shown_count(), 2U);
    frame_.items[0].world_from_body = glm::translate(Mat4f{1.0F}, Vec3f{0.0F, 0.0F, -0.56F});
    EXPECT_EQ(shown_count(), 1U);
}

TEST_F(OcclusionCullingTest, SeveralBoxesHideTogetherUnlessSamplesShowTheirSeam) {
    // Their common edge lies between two columns' centres.
    add_box({-1.0F, 0.0F, -5.0F}, {2.0F, 2.0F, 1.0F});
    add_box({1.0F, 0.0F, -5.0F}, {2.0F, 2.0F, 1.0F});
    add_box({0.0F, 0.0F, -10.0F}, Vec3f{1.0F});
    EXPECT_EQ(shown_count(), 2U);
    OcclusionView sampled = view_;
    sampled.reach_px = kSamplesReach_px;
    EXPECT_EQ(shown(sampled).size(), 3U);
}

TEST_F(OcclusionCullingTest, WhatAnyPixelOfAHeapShowsIsLeftIn) {
    add_heap(300);
    const std::vector<const DrawItem*> left = shown(view_);
    std::set<const DrawItem*> needed;
    for (const Seen& pixel : seen()) needed.insert(pixel.item);
    for (const DrawItem* item : needed)
        EXPECT_TRUE(std::ranges::find(left, item) != left.end()) << item - frame_.items.data();
    EXPECT_GT(needed.size(), 50U);
    EXPECT_LT(left.size(), items().size() - 50U) << "and much is left out";
}

TEST_F(OcclusionCullingTest, ParallelLightSeesAHeapLikewise) {
    view_.clip_from_world = glm::ortho(-7.0F, 7.0F, -7.0F, 7.0F, 0.0F, 20.0F);
    add_heap(400);
    const std::vector<const DrawItem*> left = shown(view_);
    for (const Seen& pixel : seen()) ASSERT_TRUE(std::ranges::find(left, pixel.item) != left.end());
    EXPECT_LT(left.size(), items().size() - 50U);
}

class UnseenCastersTest : public OcclusionCullingTest {
protected:
    std::vector<const DrawItem*> casters_left() const {
        std::vector<VisibleItem> visible = items();
        remove_hidden(visible, library_, view_);
        const Mat4f everything = glm::ortho(-1e3F, 1e3F, -1e3F, 1e3F, -1e3F, 1e3F);
        std::vector<VisibleItem> casters = cull(frame_, library_, {.frustum = Frustum{everything}});
        remove_unseen_casters(
            casters,
            library_,
            {.view = view_, .visible = visible, .light_direction_world = way_, .margin_m = 0.05F});
        std::vector<const DrawItem*> left;
        for (const VisibleItem& caster : casters) left.push_back(caster.item);
        return left;
    }

    Vec3f way_{glm::normalize(Vec3f{-0.3F, -1.0F, -0.4F})};
};

TEST_F(UnseenCastersTest, NoPixelsLightChanges) {
    add_heap(300);
    const std::vector<const DrawItem*> left = casters_left();
    EXPECT_LT(left.size(), frame_.items.size() - 20U);
    for (const Seen& pixel : seen()) {
        bool shaded_by_any = false;
        bool shaded_by_left = false;
        for (const DrawItem& item : frame_.items) {
            if (&item == pixel.item || !entry(item, pixel.at, -way_)) continue;
            shaded_by_any = true;
            shaded_by_left = shaded_by_left || std::ranges::find(left, &item) != left.end();
        }
        ASSERT_EQ(shaded_by_left, shaded_by_any);
    }
}

TEST_F(UnseenCastersTest, WhatCannotMoveStays) {
    add_box({0.0F, 0.0F, -5.0F}, Vec3f{4.0F});
    add(glm::translate(Mat4f{1.0F}, Vec3f{0.0F, 0.0F, -10.0F}), box_, matt_, true);
    EXPECT_EQ(casters_left().size(), 2U);
    frame_.items.back().is_static = false;
    EXPECT_EQ(casters_left().size(), 1U);
}

TEST_F(UnseenCastersTest, ALowSunLeavesAll) {
    add_box({0.0F, 0.0F, -5.0F}, Vec3f{4.0F});
    add_box({0.0F, 0.0F, -10.0F}, Vec3f{1.0F});
    way_ = glm::normalize(Vec3f{0.0F, -0.1F, -1.0F});
    EXPECT_EQ(casters_left().size(), 2U);
}

TEST_F(UnseenCastersTest, AShadowThatFallsBesideTheBoxKeepsItsCaster) {
    add_box({0.0F, 0.0F, -5.0F}, Vec3f{2.0F});
    add_box({0.0F, 0.0F, -8.0F}, Vec3f{1.0F});
    way_ = glm::normalize(Vec3f{0.0F, -1.0F, -0.2F});
    EXPECT_EQ(casters_left().size(), 1U);
    way_ = glm::normalize(Vec3f{-3.0F, -1.0F, 0.0F});
    EXPECT_EQ(casters_left().size(), 2U);
}

}  // namespace
}  // namespace plumbline::render
