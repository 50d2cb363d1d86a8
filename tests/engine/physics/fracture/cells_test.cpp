// A body's cells fill it, and their bonds are what they share.
#include "engine/physics/fracture.h"
#include "tests/engine/physics/test_world.h"

#include <cmath>
#include <numeric>

namespace plumbline::physics {
namespace {

TEST(FracturePattern, FillsTheBody) {
    const std::vector<ShapeDef> shapes{
        BoxShape{{1, 0.5_r, 0.2_r}},
        SphereShape{0.3_r},
        CylinderShape{0.2_r, 0.6_r},
        HullShape{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.6_r, 0.6_r, 0.6_r}}}};
    for (const ShapeDef& shape : shapes) {
        TestWorld rig;
        const BodyId body = rig.add(shape, {1, 2, 3});
        const FracturePattern pattern = fracture_pattern(rig.world, body, 30, 5);
        ASSERT_EQ(pattern.pieces.size(), 30U);
        double volume_m3 = 0;
        Vec3d moment{0, 0, 0};
        for (const FracturePiece& piece : pattern.pieces) {
            volume_m3 += piece.volume_m3;
            moment += piece.volume_m3 * piece.center_m;
            EXPECT_GT(piece.volume_m3, 0.2 * pattern.volume_m3 / 30) << "of about the same size";
        }
        EXPECT_NEAR(volume_m3 / pattern.volume_m3, 1, 1e-9);
        const Vec3d center_m(rig.world.state(body).mass.center_of_mass_m);
        EXPECT_LT(glm::distance(moment / volume_m3, center_m), 1e-5);
    }
}

TEST(FracturePattern, BondsLieBetweenTheirPieces) {
    TestWorld rig;
    const BodyId body = rig.add(BoxShape{{1, 1, 1}}, {0, 0, 0});
    const FracturePattern pattern = fracture_pattern(rig.world, body, 27, 2);
    ASSERT_GT(pattern.bonds.size(), 27U);
    for (const FractureBond& bond : pattern.bonds) {
        const Vec3d a = pattern.pieces[bond.pieces[0]].seed_m;
        const Vec3d b = pattern.pieces[bond.pieces[1]].seed_m;
        EXPECT_NEAR(glm::distance(a, bond.center_m), glm::distance(b, bond.center_m), 1e-9);
        EXPECT_NEAR(glm::dot(bond.normal, b - a), bond.distance_m, 1e-12);
        for (const Vec3d& corner : bond.corners_m)
            EXPECT_NEAR(glm::dot(bond.normal, corner - bond.center_m), 0, 1e-9);
    }
}

// Two cells of a bar share its section: its moments in closed form.
TEST(FracturePattern, ASectionHasTheMomentsOfItsRectangle) {
    TestWorld rig;
    const double b = 0.1;
    const double h = 0.2;
    const BodyId body = rig.add(BoxShape{Vec3(Vec3d{4, h, b})}, {0, 0, 0});
    const FracturePattern pattern = fracture_pattern(rig.world, body, 2, 1);
    ASSERT_EQ(pattern.bonds.size(), 1U);
    const FractureBond& bond = pattern.bonds.front();
    EXPECT_NEAR(bond.area_m2, b * h, 1e-6);
    EXPECT_NEAR(bond.second_m4[2][2], b * h * h * h / 12, 1e-8);
    EXPECT_NEAR(bond.second_m4[1][1], h * b * b * b / 12, 1e-8);
    EXPECT_NEAR(bond.torsion_m3, 0.246 * h * b * b, 0.05 * 0.246 * h * b * b);
}

TEST(FracturePattern, ASeedGivesTheSameCellsAndAnotherOthers) {
    TestWorld rig;
    const BodyId body = rig.add(BoxShape{{1, 1, 1}}, {0, 0, 0});
    const auto first = [&](std::uint64_t seed) {
        return fracture_pattern(rig.world, body, 10, seed).pieces.front().seed_m;
    };
    EXPECT_EQ(first(3), first(3));
    EXPECT_NE(first(3), first(4));
}

TEST(FracturePattern, IsThinnedOrNoneWhereTheBodyIsTooSmallOrNoSingleSolid) {
    TestWorld rig;
    const BodyId crumb = rig.add(BoxShape{{0.01_r, 0.01_r, 0.01_r}}, {0, 0, 0});
    EXPECT_LE(fracture_pattern(rig.world, crumb, 200, 1).pieces.size(), 15U);
    CompoundShape two;
    two.children = {{.shape = BoxShape{}}, {.shape = SphereShape{}}};
    EXPECT_TRUE(fracture_pattern(rig.world, rig.add(two, {5, 0, 0}), 20, 1).pieces.empty());
}

TEST(FracturePattern, APointBelongsToTheNearestOfThePiecesAsked) {
    TestWorld rig;
    const BodyId body = rig.add(BoxShape{{1, 1, 1}}, {0, 0, 0});
    const FracturePattern pattern = fracture_pattern(rig.world, body, 10, 1);
    std::vector<std::uint32_t> all(10);
    std::iota(all.begin(), all.end(), 0U);
    for (std::uint32_t i = 0; i < 10; ++i)
        EXPECT_EQ(pattern.piece_at(pattern.pieces[i].center_m, all), i);
    EXPECT_EQ(pattern.piece_at(pattern.pieces[3].center_m, std::vector<std::uint32_t>{5}), 5U);
}

}  // namespace
}  // namespace plumbline::physics
