// Deforming bodies that touch each other: what lies on what, what is kept, who wakes whom.
#include "engine/physics/deformables.h"

#include "engine/core/io/archive.h"
#include "engine/physics/sheet.h"
#include "engine/physics/soft_body.h"
#include "engine/physics/soft_grid.h"
#include "tests/engine/physics/test_world.h"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

namespace plumbline::physics {
namespace {

const Quatd kFaceUp = glm::angleAxis(1.5707963267948966, Vec3d{1, 0, 0});
constexpr double kClothThickness_m = 0.004;

std::unique_ptr<PointBody> cloth_in(const Vec3d& middle_m, double size_m, std::uint32_t cells) {
    return std::make_unique<Sheet>(SheetDef{.size_m = {size_m, size_m},
                                            .cells = {cells, cells},
                                            .position_m = middle_m,
                                            .orientation = kFaceUp,
                                            .density_kgpm2 = 0.3,
                                            .stretch_Npm = 1500,
                                            .shear_Npm = 500,
                                            .damping_s = 0.03});
}

std::unique_ptr<PointBody> block_at(const Vec3d& middle_m, double side_m, std::uint32_t cells = 4) {
    SoftGrid grid = box_grid(Vec3d{side_m, side_m, side_m}, {cells, cells, cells});
    for (Vec3d& point : grid.points_m) point += middle_m;
    return std::make_unique<SoftBody>(SoftBodyDef{
        .grid = std::move(grid), .density_kgpm3 = 1000, .young_Pa = 1e5, .damping_s = 0.02});
}

/// Some of them in a world, as effects would have them.
struct Wardrobe {
    explicit Wardrobe(PhysicsWorld& in) : world(in), all(in) {}

    Deformable& add(std::unique_ptr<PointBody> body, std::vector<DeformablePin> pins = {}) {
        const DeformableDef def{.surface = {.thickness_m = kClothThickness_m, .friction = 0.5},
                                .pins = std::move(pins)};
        bodies.push_back(std::make_unique<Deformable>(world, std::move(body), def));
        return *bodies.back();
    }
    void run(double seconds) {
        const double step_s = world.def().step_s;
        for (int i = 0; i < static_cast<int>(seconds / step_s + 0.5); ++i) {
            for (const auto& body : bodies) all.enter(*body, 4);
            all.begin_step(step_s);
            ForceField* const field = &all;
            world.step({&field, 1});
            all.end_step();
        }
    }
    std::vector<Deformable*> list() const {
        std::vector<Deformable*> result;
        for (const auto& body : bodies) result.push_back(body.get());
        return result;
    }

    PhysicsWorld& world;
    std::vector<std::unique_ptr<Deformable>> bodies;
    Deformables all;
};

double lowest_point_m(const Deformable& of) {
    double lowest = of.body().positions_m()[0].y;
    for (const Vec3d& at : of.body().positions_m()) lowest = std::min(lowest, at.y);
    return lowest;
}

double highest_point_m(const Deformable& of) {
    double highest = of.body().positions_m()[0].y;
    for (const Vec3d& at : of.body().positions_m()) highest = std::max(highest, at.y);
    return highest;
}

std::vector<DeformablePin> four_corners(std::uint32_t cells) {
    const std::size_t last = cells;
    return {{0, {}}, {last, {}}, {last * (cells + 1), {}}, {last * (cells + 1) + last, {}}};
}

std::vector<DeformablePin> two_sides(std::uint32_t cells) {
    std::vector<DeformablePin> pins;
    for (std::size_t row = 0; row <= cells; ++row) {
        pins.push_back({row * (cells + 1), {}});
        pins.push_back({row * (cells + 1) + cells, {}});
    }
    return pins;
}

TEST(Deformables, ABlockLiesInAHammockThatBearsItsWeight) {
    TestWorld test(in_small_steps());
    Wardrobe scene(test.world);
    Deformable& hammock = scene.add(cloth_in({0, 1, 0}, 1, 16), two_sides(16));
    Deformable& block = scene.add(block_at({0, 1.2, 0}, 0.2));
    scene.run(6);
    EXPECT_GT(lowest_point_m(block), lowest_point_m(hammock));
    EXPECT_LT(highest_point_m(block), 1.1);
    Vec3d borne_Ns{0, 0, 0};
    for (const DeformablePin& pin : two_sides(16)) borne_Ns += hammock.body().support_Ns(pin.point);
    const double weight_N = (hammock.body().mass_kg() + block.body().mass_kg()) * 9.81;
    EXPECT_NEAR(-borne_Ns.y / hammock.body().substep_s(), weight_N, 0.02 * weight_N);
}

TEST(Deformables, ClothLiesOverABlockAndOverCloth) {
    TestWorld test(in_small_steps());
    test.ground();
    Wardrobe scene(test.world);
    Deformable& block = scene.add(block_at({0, 0.2, 0}, 0.4));
    Deformable& lower = scene.add(cloth_in({0.02, 0.5, 0.01}, 0.8, 16));
    Deformable& upper = scene.add(cloth_in({-0.01, 0.6, 0.03}, 0.7, 14));
    scene.run(4);
    const double top_m = highest_point_m(block);
    EXPECT_GT(top_m, 0.38);
    EXPECT_GT(highest_point_m(lower), top_m);
    EXPECT_GT(highest_point_m(upper), highest_point_m(lower) + 0.5 * kClothThickness_m);
    EXPECT_LT(highest_point_m(upper), top_m + 0.05);
}

TEST(Deformables, KeepMomentumWhenTheyMeet) {
    TestWorld test([] {
        WorldDef def = in_small_steps();
        def.gravity_mps2 = {0, 0, 0};
        return def;
    }());
    Wardrobe scene(test.world);
    Deformable& left = scene.add(block_at({-0.3, 0, 0.03}, 0.4));
    Deformable& right = scene.add(block_at({0.3, 0.05, 0}, 0.4));
    for (std::size_t i = 0; i < left.body().positions_m().size(); ++i)
        left.strike(i, Vec3d{4, 0, 0} * left.body().mass_kg(i));
    const double asked = 4 * left.body().mass_kg();
    scene.run(0.5);
    const PointTotals a = left.body().totals();
    const PointTotals b = right.body().totals();
    EXPECT_NEAR(a.momentum_kgmps.x + b.momentum_kgmps.x, asked, 1e-9 * asked);
    EXPECT_NEAR(a.momentum_kgmps.y + b.momentum_kgmps.y, 0, 1e-9 * asked);
    EXPECT_GT(b.momentum_kgmps.x / right.body().mass_kg(), 2) << "a half goes over, and more";
    EXPECT_LT(a.momentum_kgmps.x, b.momentum_kgmps.x);
    EXPECT_LT(a.kinetic_J + a.elastic_J + b.kinetic_J + b.elastic_J, 0.5 * 4 * asked);
}

TEST(Deformables, SleepTogetherAndWakeEachOther) {
    TestWorld test(in_small_steps());
    test.ground();
    Wardrobe scene(test.world);
    Deformable& lower = scene.add(block_at({0, 0.21, 0}, 0.4));
    Deformable& upper = scene.add(block_at({0.02, 0.51, 0}, 0.2, 2));
    scene.run(12);
    ASSERT_TRUE(lower.is_asleep());
    ASSERT_TRUE(upper.is_asleep());
    EXPECT_GT(lowest_point_m(upper), 0.35);
    upper.strike(0, {1, 2, 0});
    scene.run(0.05);
    EXPECT_FALSE(lower.is_asleep());
    scene.all.leave(lower);
    scene.bodies.erase(scene.bodies.begin());
    scene.run(1);
    EXPECT_LT(lowest_point_m(upper), 0.02) << "it fell when what it lay on went";
}

TEST(Deformables, GoOnFromASavedGameBitByBit) {
    const auto make = [](Wardrobe& scene) {
        scene.add(cloth_in({0, 0.5, 0}, 1, 12), four_corners(12));
        scene.add(cloth_in({0.1, 0.55, 0}, 0.6, 10));
    };
    TestWorld test(in_small_steps());
    Wardrobe first(test.world);
    make(first);
    first.run(0.6);
    Archive written;
    for (const auto& body : first.bodies) body->serialize(written);
    first.all.serialize(written, first.list());
    const std::string bytes = written.take();
    first.run(0.5);

    TestWorld again(in_small_steps());
    Wardrobe second(again.world);
    make(second);
    Archive read(bytes);
    for (const auto& body : second.bodies) body->serialize(read);
    second.all.serialize(read, second.list());
    ASSERT_FALSE(read.failed()) << read.fault();
    second.run(0.5);
    for (std::size_t i = 0; i < first.bodies.size(); ++i) {
        const auto a = first.bodies[i]->body().positions_m();
        const auto b = second.bodies[i]->body().positions_m();
        EXPECT_TRUE(std::ranges::equal(a, b));
    }
}

TEST(Deformables, RefuseASavedPairThatIsNotThere) {
    TestWorld test(in_small_steps());
    Wardrobe scene(test.world);
    scene.add(cloth_in({0, 0.5, 0}, 1, 4), four_corners(4));
    scene.add(cloth_in({0, 0.51, 0}, 1, 4), four_corners(4));
    scene.run(0.05);
    Archive written;
    scene.all.serialize(written, scene.list());
    Deformable* const one = scene.bodies[0].get();
    const std::string bytes = written.take();
    Archive read(bytes);
    scene.all.serialize(read, {&one, 1});
    EXPECT_TRUE(read.failed());
}

}  // namespace
}  // namespace plumbline::physics
