#include "engine/core/lines.h"

#include "engine/core/bounds.h"

#include <gtest/gtest.h>

namespace plumbline {
namespace {

TEST(LineList, CountsWhatItDoesNotKeep) {
    LineList lines{.limit = 2};
    for (int i = 0; i < 5; ++i) lines.add(Vec3f{0.0F}, Vec3f{1.0F}, Vec3f{1.0F});
    EXPECT_EQ(lines.vertices.size(), 4U);
    EXPECT_EQ(lines.not_shown, 3U);
    lines.clear();
    EXPECT_TRUE(lines.vertices.empty());
    EXPECT_EQ(lines.not_shown, 0U);
}

TEST(Aabb, IsEmptyUntilSomethingIsIn) {
    Aabb box;
    EXPECT_TRUE(box.empty());
    EXPECT_EQ(box.size(), Vec3f{0.0F});
    box.include(Aabb{});
    EXPECT_TRUE(box.empty());
    box.include(Vec3f{1.0F, 2.0F, 3.0F});
    EXPECT_FALSE(box.empty());
    EXPECT_EQ(box.center(), (Vec3f{1.0F, 2.0F, 3.0F}));
    box.include(Vec3f{-1.0F, 2.0F, 7.0F});
    EXPECT_EQ(box.center(), (Vec3f{0.0F, 2.0F, 5.0F}));
    EXPECT_EQ(box.size(), (Vec3f{2.0F, 0.0F, 4.0F}));
}

TEST(Sphere, AroundABoxReachesItsCorners) {
    Aabb box;
    box.include(Vec3f{-1.0F, -2.0F, -2.0F});
    box.include(Vec3f{1.0F, 2.0F, 2.0F});
    EXPECT_FLOAT_EQ(sphere_around(box).radius, 3.0F);  // 1 + 4 + 4 = 9
    EXPECT_EQ(sphere_around(Aabb{}).radius, 0.0F);
}

}  // namespace
}  // namespace plumbline
