#include "engine/physics/collision/shape/box_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace plumbline::physics {
namespace {

Vec3d random_place(std::mt19937& random, double size_m) {
    std::uniform_real_distribution<double> along(-size_m, size_m);
    const double x = along(random);
    const double y = along(random);
    return {x, y, along(random)};
}

std::vector<Bounds> random_boxes(std::size_t count, double size_m) {
    std::mt19937 random(7);
    std::vector<Bounds> boxes;
    for (std::size_t i = 0; i < count; ++i) {
        const Vec3d center = random_place(random, 10);
        const Vec3d half = glm::abs(random_place(random, size_m));
        boxes.push_back({center - half, center + half});
    }
    return boxes;
}

std::vector<std::uint32_t> visited(const BoxTree& tree, const Bounds& bounds) {
    std::vector<std::uint32_t> found;
    tree.visit(bounds, [&found](std::uint32_t item) { found.push_back(item); });
    return found;
}

bool boxes_meet(const Bounds& a, const Bounds& b) {
    return glm::all(glm::lessThanEqual(a.low, b.high)) &&
           glm::all(glm::lessThanEqual(b.low, a.high));
}

TEST(BoxTree, FindsWhatOverlapsAndNoMore) {
    const std::vector<Bounds> boxes = random_boxes(3000, 0.5);
    const BoxTree tree(boxes);
    std::mt19937 random(11);
    for (int trial = 0; trial < 200; ++trial) {
        const Vec3d center = random_place(random, 11);
        const Bounds asked{center - Vec3d{0.7}, center + Vec3d{0.7}};
        std::vector<std::uint32_t> found = visited(tree, asked);
        std::sort(found.begin(), found.end());
        std::vector<std::uint32_t> wanted;
        for (std::uint32_t i = 0; i < boxes.size(); ++i) {
            if (boxes_meet(boxes[i], asked)) wanted.push_back(i);
        }
        EXPECT_EQ(found, wanted);
    }
}

TEST(BoxTree, AnEmptyOneHasNothing) {
    EXPECT_TRUE(BoxTree().is_empty());
    EXPECT_TRUE(BoxTree(std::vector<Bounds>{}).is_empty());
    EXPECT_TRUE(visited(BoxTree(std::vector<Bounds>{}), {Vec3d{-1}, Vec3d{1}}).empty());
}

TEST(BoxTree, OneBoxIsFoundByTouchingIt) {
    const BoxTree tree(std::vector<Bounds>{{Vec3d{1}, Vec3d{2}}});
    EXPECT_EQ(visited(tree, {Vec3d{0}, Vec3d{1}}).size(), 1U);
    EXPECT_EQ(visited(tree, {Vec3d{2}, Vec3d{3}}).size(), 1U);
    EXPECT_TRUE(visited(tree, {Vec3d{0}, Vec3d{0.9999}}).empty());
}

TEST(BoxTree, BoxesBetweenFloatsAreNotMissed) {
    const Vec3d place{1.0 / 3, 20000.0 / 3, -7.0 / 3};
    const BoxTree tree(std::vector<Bounds>{{place, place}});
    EXPECT_EQ(visited(tree, {place, place}).size(), 1U);
}

TEST(BoxTree, ManyBoxesAtOnePlaceMakeATreeToo) {
    const std::vector<Bounds> boxes(20000, {Vec3d{1}, Vec3d{2}});
    EXPECT_EQ(visited(BoxTree(boxes), {Vec3d{0}, Vec3d{3}}).size(), boxes.size());
}

TEST(BoxTree, BoxesOfEverySizeMakeATreeToo) {
    std::vector<Bounds> boxes;
    double size_m = 1e-20;
    for (int i = 0; i < 400; ++i, size_m *= 1.25)
        boxes.push_back({Vec3d{size_m}, Vec3d{size_m * 2}});
    const BoxTree tree(boxes);
    EXPECT_EQ(visited(tree, {Vec3d{0}, Vec3d{1e30}}).size(), boxes.size());
}

}  // namespace
}  // namespace plumbline::physics
