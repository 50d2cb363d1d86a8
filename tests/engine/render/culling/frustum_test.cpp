#include "engine/render/culling/frustum.h"

#include <gtest/gtest.h>

namespace plumbline::render {
namespace {

Aabb box_at(const Vec3f& center, float half = 0.5F) {
    return {.min = center - Vec3f{half}, .max = center + Vec3f{half}};
}

/// A camera at the origin that looks down -Z, 90 degrees each way, from 1 to 100 m.
Frustum right_angled() {
    return Frustum{glm::perspective(glm::half_pi<float>(), 1.0F, 1.0F, 100.0F)};
}

TEST(Frustum, KeepsWhatIsAheadAndDropsWhatIsNot) {
    const Frustum frustum = right_angled();
    EXPECT_TRUE(frustum.may_touch(box_at({0.0F, 0.0F, -10.0F})));
    EXPECT_FALSE(frustum.may_touch(box_at({0.0F, 0.0F, 10.0F})));
    EXPECT_FALSE(frustum.may_touch(box_at({0.0F, 0.0F, -101.0F})));
    // At 10 m the edge of sight is 10 m off the axis.
    EXPECT_TRUE(frustum.may_touch(box_at({10.4F, 0.0F, -10.0F})));
    EXPECT_FALSE(frustum.may_touch(box_at({11.6F, 0.0F, -10.0F})));
    EXPECT_FALSE(frustum.may_touch(box_at({0.0F, -11.6F, -10.0F})));
}

TEST(Frustum, KeepsABoxThatHoldsTheWholeView) {
    EXPECT_TRUE(right_angled().may_touch(box_at(Vec3f{0.0F}, 1000.0F)));
}

TEST(Frustum, HasNothingToSeeInAnEmptyBox) {
    EXPECT_FALSE(right_angled().may_touch(Aabb{}));
}

TEST(Transformed, TurnsABoxIntoTheBoxAroundIt) {
    const Mat4f turn = glm::rotate(glm::translate(Mat4f{1.0F}, Vec3f{5.0F, 0.0F, 0.0F}),
                                   glm::quarter_pi<float>(),
                                   Vec3f{0.0F, 1.0F, 0.0F});
    const Aabb box = transformed(box_at(Vec3f{0.0F}, 1.0F), turn);
    const float diagonal = std::sqrt(2.0F);
    EXPECT_NEAR(box.min.x, 5.0F - diagonal, 1e-5F);
    EXPECT_NEAR(box.max.x, 5.0F + diagonal, 1e-5F);
    EXPECT_NEAR(box.max.y, 1.0F, 1e-5F);
    EXPECT_NEAR(box.max.z, diagonal, 1e-5F);
}

}  // namespace
}  // namespace plumbline::render
