#include "engine/scene/build/collision_groups.h"

#include <gtest/gtest.h>

namespace plumbline::scene {
namespace {

TEST(CollisionGroups, HaveABitForEachOfThirtyTwo) {
    CollisionGroups groups;
    EXPECT_EQ(*groups.bit("default"), 1U);
    for (unsigned i = 1; i < 32; ++i) EXPECT_EQ(*groups.bit(std::to_string(i)), 1U << i);
    EXPECT_EQ(*groups.bit("7"), 1U << 7U) << "the same name has the same bit";
    const auto refused = groups.bit("more");
    ASSERT_FALSE(refused.ok());
    EXPECT_EQ(refused.error().message,
              "group \"more\" is one too many: there can be 31 beside \"default\"");
}

TEST(CollisionGroups, OfABodyAreThoseOfAllItsParts) {
    CollisionGroups groups;
    BodyDescription body;
    body.parts.push_back({.friction = Real{2}, .group = "left", .collides_with = {"default"}});
    body.parts.push_back({.group = "right", .collides_with = {"left"}});
    const Result<physics::CollisionFilter> all = groups.filter_of(body);
    ASSERT_TRUE(all.ok());
    const std::uint32_t left = *groups.bit("left");
    const std::uint32_t right = *groups.bit("right");
    EXPECT_EQ(all->group, left | right);
    EXPECT_EQ(all->collides_with, 1U | left);

    const Surface surface{.friction = 0.25_r, .restitution = 0.5_r};
    const auto parts = groups.parts_of(body, surface);
    ASSERT_TRUE(parts.ok());
    ASSERT_EQ(parts->size(), 2U);
    EXPECT_EQ((*parts)[0].material.friction, Real{2});
    EXPECT_EQ((*parts)[1].material.friction, 0.25_r) << "the surface's";
    EXPECT_EQ((*parts)[0].material.restitution, 0.5_r);
    EXPECT_EQ((*parts)[0].filter.group, left);
    EXPECT_EQ((*parts)[1].filter.collides_with, left);
}

}  // namespace
}  // namespace plumbline::scene
