// Which bodies make a pair.
#include "tests/engine/physics/test_world.h"

#include <algorithm>

namespace plumbline::physics {
namespace {

TEST(Filters, BothSidesMustAgree) {
    TestWorld test;
    test.add(PlaneShape{},
             {0, 0, 0},
             {.kind = BodyKind::Static, .filter = {.group = 2, .collides_with = 1}});
    const BodyId willing =
        test.add(BoxShape{},
                 {0, 0.5_r, 0},
                 {.kind = BodyKind::Dynamic, .filter = {.group = 1, .collides_with = 2}});
    const BodyId refuses =
        test.add(BoxShape{},
                 {3, 0.5_r, 0},
                 {.kind = BodyKind::Dynamic, .filter = {.group = 1, .collides_with = 4}});
    const BodyId unseen =
        test.add(BoxShape{},
                 {6, 0.5_r, 0},
                 {.kind = BodyKind::Dynamic, .filter = {.group = 4, .collides_with = 2}});
    test.run(0.5);
    EXPECT_NEAR(test.at(willing).y, 0.5, 0.01);
    const double fallen = 0.5 - 0.5 * kG * 0.25;
    EXPECT_NEAR(test.at(refuses).y, fallen, 1e-5);
    EXPECT_NEAR(test.at(unseen).y, fallen, 1e-5);
}

/// The floor has the mark 1; a box with an even mark may not touch it.
class OddOnes final : public PairRules {
public:
    bool may_touch(std::uint64_t user_a, std::uint64_t user_b) const override {
        return std::max(user_a, user_b) % 2 == 1;
    }
    Material combined(std::uint64_t user_a, std::uint64_t user_b) const override {
        return {.friction = std::max(user_a, user_b) == 3 ? 0.0_r : 1.0_r};
    }
};

TEST(Filters, PairRulesDecideWhatTouchesAndHowMaterialsCombine) {
    const OddOnes rules;
    TestWorld test({.gravity_mps2 = {4, -9.81_r, 0}, .pair_rules = &rules});
    test.add(PlaneShape{}, {0, 0, 0}, {.kind = BodyKind::Static, .user = 1});
    const auto box = [&test](Real z, std::uint64_t user) {
        return test.add(BoxShape{}, {0, 0.5_r, z}, {.kind = BodyKind::Dynamic, .user = user});
    };
    const BodyId through = box(0, 2);
    const BodyId slides = box(3, 3);
    const BodyId holds = box(6, 5);
    test.run(1);
    EXPECT_NEAR(test.at(through).y, 0.5 - kG / 2, 1e-4);
    EXPECT_NEAR(test.velocity(slides).x, 4, 0.04);
    EXPECT_NEAR(test.velocity(holds).x, 0, 1e-3);
}

}  // namespace
}  // namespace plumbline::physics
