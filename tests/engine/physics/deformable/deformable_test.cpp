// Deforming bodies among rigid ones: who holds, touches, carries and wakes whom.
#include "engine/physics/deformables.h"
#include "engine/physics/sheet.h"
#include "engine/physics/soft_grid.h"
#include "tests/engine/physics/test_world.h"

#include <gtest/gtest.h>

#include <memory>

namespace plumbline::physics {
namespace {

const Quatd kLevel = glm::angleAxis(1.5707963267948966, Vec3d{1, 0, 0});

/// The body of a test as an effect would have it.
struct Field {
    Field(PhysicsWorld& in, std::unique_ptr<PointBody> body, const DeformableDef& def)
        : world(in), deformable(in, std::move(body), def), all(in) {}

    void run(double seconds) {
        const double step_s = world.def().step_s;
        for (int i = 0; i < static_cast<int>(seconds / step_s + 0.5); ++i) {
            all.enter(deformable, 4);
            all.begin_step(step_s);
            ForceField* const field = &all;
            world.step({&field, 1});
            all.end_step();
        }
    }
    Vec3d lowest_m() const {
        Vec3d lowest = deformable.body().positions_m()[0];
        for (const Vec3d& at : deformable.body().positions_m()) {
            if (at.y < lowest.y) lowest = at;
        }
        return lowest;
    }

    PhysicsWorld& world;
    Deformable deformable;
    Deformables all;
};

std::unique_ptr<PointBody> cloth_at(double height_m, double size_m, std::uint32_t cells) {
    return std::make_unique<Sheet>(SheetDef{.size_m = {size_m, size_m},
                                            .cells = {cells, cells},
                                            .position_m = {0, height_m, 0},
                                            .orientation = kLevel,
                                            .stretch_Npm = 800,
                                            .shear_Npm = 270,
                                            .damping_s = 0.03,
                                            .drag = 1.2});
}

DeformableDef held_all_round(std::uint32_t cells) {
    DeformableDef def{.surface = {.thickness_m = 0.01}, .pins = {}};
    for (std::uint32_t i = 0; i <= cells; ++i) {
        for (const std::uint32_t point :
             {i, cells * (cells + 1) + i, i * (cells + 1), i * (cells + 1) + cells})
            def.pins.push_back({.point = point, .to = {}});
    }
    return def;
}

/// Cells of 15 cm under a ball of 24 cm, whose middle lies over the middle of one: between their corners it would show by 6 cm.
TEST(Deformable, ABallShowsLittleBelowACoarseCloth) {
    TestWorld test(in_small_steps());
    const BodyId ball = test.add(SphereShape{0.12_r}, {0, 0.63_r, 0});
    Field cloth(test.world, cloth_at(0.5, 1.05, 7), held_all_round(7));
    cloth.run(3);
    const auto middle_m = Vec3d(test.world.state(ball).world_from_body.position);
    const auto points_m = cloth.deformable.body().positions_m();
    Vec3d cell_m{0, 0, 0};
    for (const std::size_t point : {27U, 28U, 35U, 36U}) cell_m += points_m[point] / 4.0;
    EXPECT_GT(glm::distance(middle_m, cell_m), 0.12 - 0.01);
}

/// Cells of 15 cm over a box: where an edge lies between two points it would stick out by 5 cm.
TEST(Deformable, ABoxShowsLittleThroughACoarseCloth) {
    for (const BodyKind kind : {BodyKind::Static, BodyKind::Dynamic}) {
        TestWorld test(in_small_steps());
        test.ground();
        test.add(BoxShape{{0.8_r, 0.8_r, 0.8_r}}, {0.05_r, 0.4_r, 0.02_r}, {.kind = kind});
        Field cloth(
            test.world, cloth_at(1, 1.8, 12), {.surface = {.thickness_m = 0.01}, .pins = {}});
        cloth.run(4);
        double deepest_m = 0;
        for (const SurfacePlace& place : cloth.deformable.body().places(8)) {
            Vec3d at{0, 0, 0};
            for (std::size_t i = 0; i < 4; ++i)
                at += cloth.deformable.body().positions_m()[place.points[i]] * place.weights[i];
            const Vec3d out_m = glm::abs(at - Vec3d{0.05, 0.4, 0.02}) - 0.4;
            deepest_m = std::min(deepest_m, std::max({out_m.x, out_m.y, out_m.z}));
        }
        EXPECT_GT(deepest_m, -0.01) << static_cast<int>(kind);
    }
}

/// Static and kinematic bodies whose centre of mass is not their origin.
TEST(Deformable, ClothLiesOnWhatIsBuiltBesideItsOrigin) {
    TestWorld test(in_small_steps());
    const BoxShape top{{2, 0.2_r, 2}};
    const CompoundShape table{{{.shape = top, .body_from_child = {.position = {0.3_r, 0.4_r, 0}}},
                               {.shape = top, .body_from_child = {.position = {0.3_r, -2, 0}}}}};
    for (const BodyKind kind : {BodyKind::Static, BodyKind::Kinematic}) {
        const BodyId body = test.add(table, {0, 0, 0}, {.kind = kind});
        Field cloth(test.world, cloth_at(0.55, 0.5, 8), {.pins = {}});
        cloth.run(0.5);
        EXPECT_NEAR(cloth.lowest_m().y, 0.5 + 0.002, 2e-4);
        test.world.destroy_body(body);
    }
    test.ground();
    Field cloth(test.world, cloth_at(0.05, 0.5, 8), {.pins = {}});
    cloth.run(0.5);
    EXPECT_NEAR(cloth.lowest_m().y, 0.002, 2e-4);
}

TEST(Deformable, ClothDrapesOverWhatStands) {
    TestWorld test(in_small_steps());
    test.ground();
    test.add(SphereShape{0.3_r}, {0, 0.3_r, 0}, {.kind = BodyKind::Static});
    Field cloth(test.world, cloth_at(0.8, 1, 12), {.surface = {.thickness_m = 0.004}, .pins = {}});
    cloth.run(3);
    for (const Vec3d& at : cloth.deformable.body().positions_m()) {
        EXPECT_GT(at.y, 0.001);
        EXPECT_GT(glm::distance(at, Vec3d{0, 0.3, 0}), 0.3);
    }
    EXPECT_LT(cloth.lowest_m().y, 0.25);
}

// A ball comes to rest in it, and sleeps; the sheet pulls it up by its weight.
TEST(Deformable, ATrampolineCarriesABall) {
    TestWorld test(in_small_steps());
    const BodyId ball = test.add(SphereShape{0.15_r}, {0, 1.3_r, 0});
    Field cloth(test.world, cloth_at(1, 1, 12), held_all_round(12));
    cloth.run(8);
    EXPECT_GT(test.at(ball).y, 0.7);
    EXPECT_LT(test.at(ball).y, 1.15);
    EXPECT_LT(glm::length(test.velocity(ball)), 0.02);
    cloth.run(12);
    EXPECT_FALSE(test.world.state(ball).awake);
    EXPECT_TRUE(cloth.deformable.is_asleep());
    cloth.run(1);
    EXPECT_EQ(cloth.deformable.substeps(), 0U);
    test.world.apply_impulse(ball, {0, 5, 0});
    cloth.run(0.1);
    EXPECT_FALSE(cloth.deformable.is_asleep());
}

TEST(Deformable, ASmallBallDoesNotFallBetweenPoints) {
    TestWorld test(in_small_steps());
    BodyDef light{.kind = BodyKind::Dynamic};
    light.mass_kg = 0.02_r;
    const BodyId ball = test.add(SphereShape{0.03_r}, {0.04_r, 1.2_r, 0.04_r}, light);
    Field cloth(test.world, cloth_at(1, 1, 12), held_all_round(12));
    cloth.run(2);
    EXPECT_GT(test.at(ball).y, 0.9);
}

// Hung from a body, it goes with it and weighs it down.
TEST(Deformable, PinsFollowAndLoadWhatTheyAreTiedTo) {
    TestWorld test(in_small_steps());
    const BodyId box = test.add(BoxShape{{1, 0.1_r, 0.1_r}}, {0, 5, 0});
    auto sheet = std::make_unique<Sheet>(SheetDef{.position_m = {0, 4.5, 0}, .stretch_Npm = 500});
    DeformableDef def{.pins = {}};
    for (std::size_t i = 0; i <= 20; ++i) def.pins.push_back({.point = i, .to = box});
    const double mass_kg = static_cast<double>(test.world.state(box).mass.mass_kg);
    Field cloth(test.world, std::move(sheet), def);
    test.world.set_velocity(box, {2, 0, 0}, {0, 0, 0});
    cloth.run(1);
    const double whole_kg = mass_kg + cloth.deformable.body().mass_kg();
    const Vec3d momentum =
        test.velocity(box) * mass_kg + cloth.deformable.body().totals().momentum_kgmps;
    EXPECT_NEAR(momentum.x, 2 * (mass_kg + cloth.deformable.pinned_kg(box)), 1e-3 * mass_kg);
    EXPECT_NEAR(momentum.y, -9.81 * whole_kg, 2e-3 * 9.81 * whole_kg);
    const Vec3d corner = cloth.deformable.body().positions_m()[10];
    EXPECT_NEAR(glm::distance(corner, test.at(box)), 0, 0.01);
    test.world.destroy_body(box);
    cloth.run(0.5);
    EXPECT_GT(cloth.deformable.body().inverse_mass(10), 0);
}

// Thrown at it from far off, a box is held up.
TEST(Deformable, AFastBoxDoesNotPassThrough) {
    TestWorld test(in_small_steps());
    BodyDef fast{.kind = BodyKind::Dynamic};
    fast.mass_kg = 2;
    fast.velocity_mps = {0, -30, 0};
    const BodyId box = test.add(BoxShape{{0.2_r, 0.2_r, 0.2_r}}, {0, 4, 0}, fast);
    Field cloth(test.world, cloth_at(1, 1.5, 14), held_all_round(14));
    cloth.run(0.25);
    EXPECT_GT(test.velocity(box).y, -25);
    EXPECT_TRUE(cloth.deformable.body().is_sound());
}

// What holds it jumps about.
TEST(Deformable, PinsThatJumpDoNotBreakIt) {
    TestWorld test(in_small_steps());
    const BodyId rail =
        test.add(BoxShape{{1, 0.1_r, 0.1_r}}, {0, 5, 0}, {.kind = BodyKind::Kinematic});
    DeformableDef def{.pins = {}};
    for (std::size_t i = 0; i <= 20; ++i) def.pins.push_back({.point = i, .to = rail});
    Field cloth(test.world, std::make_unique<Sheet>(SheetDef{.position_m = {0, 4.5, 0}}), def);
    for (int i = 0; i < 40; ++i) {
        test.world.move_kinematic(rail, {.position = {i % 2 == 0 ? 0.5_r : -0.5_r, 5, 0}});
        cloth.run(1.0 / 60);
    }
    EXPECT_TRUE(cloth.deformable.body().is_sound());
    cloth.run(2);
    EXPECT_NEAR(glm::distance(cloth.deformable.body().positions_m()[10], test.at(rail)), 0, 0.05);
}

// A jelly of many times its mass on a box that stands on the ground neither sinks into it nor is thrown off.
TEST(Deformable, AHeavyJellyRestsOnALightBox) {
    TestWorld test(in_small_steps());
    test.ground();
    BodyDef light{.kind = BodyKind::Dynamic};
    light.mass_kg = 5;
    const BodyId box = test.add(BoxShape{{0.5_r, 0.5_r, 0.5_r}}, {0, 0.25_r, 0}, light);
    SoftGrid grid = box_grid({0.5, 0.3, 0.5}, {4, 3, 4});
    for (Vec3d& point : grid.points_m) point.y += 0.75;
    Field jelly(test.world,
                std::make_unique<SoftBody>(SoftBodyDef{.grid = grid, .damping_s = 0.02}),
                {.surface = {.thickness_m = 0.001}, .pins = {}});
    jelly.run(4);
    const PointBody& body = jelly.deformable.body();
    EXPECT_NEAR(body.totals().moment_kgm.y / body.mass_kg(), 0.64, 0.03);
    EXPECT_NEAR(test.at(box).y, 0.25, 0.01);
}

// The hand bears its weight, goes where it is led, and leaves it as it was.
TEST(Deformable, AGripCarriesItAndLetsGo) {
    TestWorld test;
    Field field(test.world, cloth_at(2, 0.4, 4), {.surface = {.thickness_m = 0.01}, .pins = {}});
    field.run(0.1);
    const std::vector<std::uint32_t> middle{12};
    field.deformable.grip(middle);
    const Vec3d taken = field.deformable.body().positions_m()[12];
    field.run(4);
    EXPECT_LT(glm::distance(field.deformable.body().positions_m()[12], taken), 1e-9);
    const double weight_N = field.deformable.body().mass_kg() * 9.81;
    EXPECT_NEAR(-field.deformable.grip_Ns().y / test.world.def().step_s, weight_N, 0.1 * weight_N);
    field.deformable.lead_grip({0.1, 0.2, 0});
    field.run(0.1);
    EXPECT_LT(glm::distance(field.deformable.body().positions_m()[12], taken + Vec3d{0.1, 0.2, 0}),
              1e-9);
    field.deformable.let_go();
    EXPECT_FALSE(field.deformable.is_gripped());
    field.run(0.5);
    EXPECT_LT(field.deformable.body().positions_m()[12].y, taken.y - 0.2);
}

}  // namespace
}  // namespace plumbline::physics
