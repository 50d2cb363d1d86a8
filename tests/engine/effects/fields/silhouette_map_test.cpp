// What is blended between corners against what is asked for.
#include "engine/effects/fields/silhouette_map.h"

#include "engine/core/random.h"

#include <gtest/gtest.h>

#include <cmath>

namespace plumbline::effects {
namespace {

/// A box of 0.4 x 1 x 0.7 m.
double box_m2(const Vec3d& direction) {
    return glm::dot(glm::abs(direction), Vec3d{0.7, 0.28, 0.4});
}

TEST(SilhouetteMap, IsWithinAPerCentInEveryDirection) {
    SilhouetteMap map;
    Random random(5);
    for (int i = 0; i < 2000; ++i) {
        const Vec3d direction = normalize_or(Vec3d{static_cast<double>(random.uniform(-1, 1)),
                                                   static_cast<double>(random.uniform(-1, 1)),
                                                   static_cast<double>(random.uniform(-1, 1))},
                                             Vec3d{0, 1, 0});
        EXPECT_NEAR(map.at(direction, &box_m2) / box_m2(direction), 1, 0.01);
        EXPECT_EQ(map.at(direction, &box_m2), map.at(-direction, &box_m2));
    }
    for (const Vec3d& axis : {Vec3d{1, 0, 0}, Vec3d{0, 1, 0}, Vec3d{0, 0, -1}})
        EXPECT_NEAR(map.at(axis, &box_m2), box_m2(axis), 1e-12);
}

TEST(SilhouetteMap, AsksForEachCornerOnce) {
    SilhouetteMap map;
    int asked = 0;
    const auto counted = [&asked](const Vec3d& direction) {
        ++asked;
        return box_m2(direction);
    };
    const Vec3d direction = glm::normalize(Vec3d{0.31, 0.52, -0.77});
    const double first = map.at(direction, counted);
    EXPECT_EQ(asked, 4);
    EXPECT_EQ(map.at(direction, counted), first);
    EXPECT_EQ(asked, 4);
}

}  // namespace
}  // namespace plumbline::effects
