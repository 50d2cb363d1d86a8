// Places of a surface against rigid bodies: found before touch, stopped at touch, rubbed, with equal and opposite impulses.
#include "engine/physics/surface_contacts.h"

#include "engine/physics/sheet.h"
#include "tests/engine/physics/test_world.h"

#include <gtest/gtest.h>

namespace plumbline::physics {
namespace {

constexpr double kContactStep_s = 1e-3;

/// A level sheet of one cell over a box whose top is at y = 0.
struct SheetOverBox {
    explicit SheetOverBox(double height_m)
        : sheet({.size_m = {0.2, 0.2},
                 .cells = {1, 1},
                 .position_m = {0, height_m, 0},
                 .orientation = glm::angleAxis(1.5707963267948966, Vec3d{1, 0, 0})}) {
        box = test.add(BoxShape{{1, 1, 1}}, {0, -0.5_r, 0}, {.kind = BodyKind::Static});
        near.push_back({.id = box, .own = {.center_m = {0, -0.5, 0}}, .friction = 0.5});
        sheet.plan(kContactStep_s, 1);
    }
    void find() { contacts.find(test.world, sheet, near, 0.01, kContactStep_s); }
    void throw_all(const Vec3d& velocity_mps) {
        for (std::size_t i = 0; i < 4; ++i) sheet.change_velocity(i, velocity_mps);
    }

    TestWorld test;
    BodyId box;
    Sheet sheet;
    std::vector<NearBody> near;
    SurfaceContacts contacts;
};

TEST(SurfaceContacts, StopAtTouchAndRub) {
    SheetOverBox over(0.006);  // a millimetre above its half thickness
    over.throw_all({10, -4, 0});
    over.find();
    over.contacts.solve(over.sheet, over.near, kContactStep_s);
    for (const Vec3d& v : over.sheet.velocities_mps()) {
        EXPECT_NEAR(v.y, -1, 1e-4);        // as far as the gap
        EXPECT_NEAR(v.x, 10 - 1.5, 1e-4);  // half of what stopped it
    }
    EXPECT_NEAR(over.near[0].felt_Ns.y, -3 * over.sheet.mass_kg(), 1e-5);
    EXPECT_NEAR(over.near[0].felt_Ns.x, 1.5 * over.sheet.mass_kg(), 1e-5);
}

TEST(SurfaceContacts, LetGoWhatLeavesAndWhatIsFar) {
    SheetOverBox leaving(0.004);
    leaving.throw_all({0, 1, 0});
    leaving.find();
    leaving.contacts.solve(leaving.sheet, leaving.near, kContactStep_s);
    for (const Vec3d& v : leaving.sheet.velocities_mps()) EXPECT_NEAR(v.y, 1, 1e-9);
    SheetOverBox far(0.5);
    far.throw_all({0, -4, 0});
    far.find();
    far.contacts.solve(far.sheet, far.near, kContactStep_s);
    EXPECT_EQ(far.near[0].felt_Ns, (Vec3d{0, 0, 0}));
}

// Friction acts towards the speed of the belt, and of the turntable at each place.
TEST(SurfaceContacts, BeltsCarryWhatTouchesThem) {
    SheetOverBox over(0.006);
    over.near[0].belt = {.velocity_mps = {1, 0, 0}, .spin_radps = {0, 2, 0}};
    over.near[0].friction = 10;
    over.throw_all({0, -4, 0});
    over.find();
    for (int i = 0; i < 20; ++i) over.contacts.solve(over.sheet, over.near, kContactStep_s);
    for (std::size_t i = 0; i < 4; ++i) {
        const Vec3d& at = over.sheet.positions_m()[i];
        const Vec3d& v = over.sheet.velocities_mps()[i];
        EXPECT_NEAR(v.x, 1 + 2 * at.z, 0.02);
        EXPECT_NEAR(v.z, -2 * at.x, 0.02);
    }
}

TEST(SurfaceContacts, FollowTheMotion) {
    SheetOverBox over(0.006);
    over.throw_all({0, -1, 0});
    over.find();
    over.contacts.solve(over.sheet, over.near, kContactStep_s);
    over.sheet.move(over.sheet.substep_s());
    over.contacts.follow(over.sheet, over.near, kContactStep_s);
    over.contacts.solve(over.sheet, over.near, kContactStep_s);
    for (const Vec3d& v : over.sheet.velocities_mps()) EXPECT_NEAR(v.y, 0, 1e-4);
}

// A free body takes what the sheet loses, and turns.
TEST(SurfaceContacts, PushAFreeBody) {
    SheetOverBox over(0.005);
    BodyInField state{.id = over.box, .mass_kg = 0.1, .inertia_kgm2 = {1, 1, 1}};
    over.near[0].own.state = &state;
    over.near[0].own.inverse_mass = 10;
    over.near[0].own.inverse_inertia = {1, 1, 1};
    over.throw_all({0, -2, 0});
    over.find();
    over.contacts.solve(over.sheet, over.near, kContactStep_s);
    const double momentum =
        over.sheet.totals().momentum_kgmps.y + 0.1 * over.near[0].own.velocity_mps.y;
    EXPECT_NEAR(momentum, -2 * over.sheet.mass_kg(), 1e-9);
    EXPECT_NEAR(state.impulse_Ns.y, 0.1 * over.near[0].own.velocity_mps.y, 1e-12);
    NearMotion turning{.state = &state, .inverse_mass = 1, .inverse_inertia = {0, 0, 2}};
    turning.push({0, 3, 0}, {1, 0, 0});
    EXPECT_NEAR(turning.spin_radps.z, 6, 1e-12);
    turning.move(0.5);
    EXPECT_NEAR(turning.center_m.y, 1.5, 1e-12);
}

}  // namespace
}  // namespace plumbline::physics
