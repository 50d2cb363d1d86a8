#include "engine/render/light/light_clusters.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace plumbline::render {
namespace {

constexpr std::size_t kClusters = PL_CLUSTERS_X * PL_CLUSTERS_Y * PL_CLUSTERS_Z;

ClusterView some_view() {
    const Vec3f eye{3.0F, 2.0F, -5.0F};
    return {.view_from_world = glm::lookAt(eye, Vec3f{10.0F, 1.0F, 20.0F}, Vec3f{0.0F, 1.0F, 0.0F}),
            .tan_x = 1.0F,
            .tan_y = 0.5625F};
}

/// The lights that a shader would reckon with at that place; none where it is out of sight.
std::vector<std::uint32_t> lights_at(const std::vector<std::uint32_t>& masks,
                                     const ClusterView& view,
                                     const Vec3f& world,
                                     bool& in_sight) {
    const Vec3f at{view.view_from_world * Vec4f{world, 1.0F}};
    const float depth = -at.z;
    const float x = at.x / (depth * view.tan_x) * 0.5F + 0.5F;
    const float y = at.y / (depth * view.tan_y) * 0.5F + 0.5F;
    in_sight = depth > 0.05F && x >= 0.0F && x < 1.0F && y >= 0.0F && y < 1.0F;
    if (!in_sight) return {};
    const int cluster =
        (cluster_slice(depth) * PL_CLUSTERS_Y + static_cast<int>(y * PL_CLUSTERS_Y)) *
            PL_CLUSTERS_X +
        static_cast<int>(x * PL_CLUSTERS_X);
    const std::size_t words = masks.size() / kClusters;
    std::vector<std::uint32_t> lights;
    for (std::uint32_t light = 0; light < words * 32; ++light) {
        const std::uint32_t word = masks[static_cast<std::size_t>(cluster) * words + light / 32];
        if ((word >> (light % 32) & 1U) != 0) lights.push_back(light);
    }
    return lights;
}

TEST(LightClusters, WhereverALightReachesItIsInTheList) {
    std::mt19937 random(5);
    std::uniform_real_distribution<float> place(-30.0F, 30.0F);
    std::uniform_real_distribution<float> reach(0.1F, 12.0F);
    std::vector<LocalLight> lights(PL_MAX_LIGHTS);
    for (LocalLight& light : lights) {
        light.position_world = {place(random), place(random), place(random)};
        light.radius_m = reach(random);
    }
    const ClusterView view = some_view();
    const std::vector<std::uint32_t> masks = light_clusters(view, lights);
    ASSERT_EQ(masks.size(), kClusters * PL_MAX_LIGHTS / 32);
    int seen = 0;
    std::size_t listed = 0;
    for (int i = 0; i < 20'000; ++i) {
        const Vec3f point{place(random), place(random), place(random)};
        bool in_sight = false;
        const auto list = lights_at(masks, view, point, in_sight);
        if (!in_sight) continue;
        ++seen;
        listed += list.size();
        for (std::uint32_t light = 0; light < lights.size(); ++light) {
            if (glm::distance(lights[light].position_world, point) >= lights[light].radius_m)
                continue;
            ASSERT_NE(std::ranges::find(list, light), list.end()) << i << ' ' << light;
        }
    }
    EXPECT_GT(seen, 1000);
    // And most of those that do not are not.
    EXPECT_LT(listed / static_cast<std::size_t>(seen), lights.size() / 4);
}

TEST(LightClusters, AWordForEvery32Lights) {
    for (const std::size_t count : {0U, 1U, 32U, 33U, 255U, 256U}) {
        const std::vector<LocalLight> lights(count);
        EXPECT_EQ(light_clusters(some_view(), lights).size(), kClusters * ((count + 31) / 32))
            << count;
    }
}

// SOURCES B30: nothing runs out of room, however many lights reach a place.
TEST(LightClusters, WhenAllReachEverywhereAllHaveTheirBitEverywhere) {
    std::vector<LocalLight> lights(300);
    for (LocalLight& light : lights) light.radius_m = 1000.0F;
    const std::vector<std::uint32_t> masks = light_clusters(some_view(), lights);
    ASSERT_EQ(masks.size(), kClusters * PL_MAX_LIGHTS / 32);
    EXPECT_TRUE(std::ranges::all_of(masks, [](std::uint32_t word) { return word == ~0U; }));
}

TEST(LightClusters, SlicesGrowWithDistanceAndTheLastHasNoEnd) {
    EXPECT_EQ(cluster_slice(-5.0F), 0);
    EXPECT_EQ(cluster_slice(0.5F * PL_CLUSTER_NEAR_M), 0);
    EXPECT_EQ(cluster_slice(1.01F * PL_CLUSTER_NEAR_M), 1);
    EXPECT_EQ(cluster_slice(1e6F), PL_CLUSTERS_Z - 1);
    for (float depth = 0.1F; depth < 300.0F; depth *= 1.01F) {
        EXPECT_GE(cluster_slice(depth * 1.01F), cluster_slice(depth));
    }
}

}  // namespace
}  // namespace plumbline::render
