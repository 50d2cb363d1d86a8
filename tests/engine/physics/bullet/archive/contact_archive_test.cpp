// Contacts of a saved game.
#include "engine/core/io/archive.h"
#include "engine/physics/collision/manifold_archive.h"
#include "engine/physics/totals.h"
#include "tests/engine/physics/test_world.h"

#include <utility>
#include <vector>

namespace plumbline::physics {
namespace {

CompoundShape bench() {
    return {{{.shape = BoxShape{{1, 0.2_r, 0.4_r}}, .body_from_child = {.position = {0, 0.1_r, 0}}},
             {.shape = BoxShape{{0.2_r, 0.4_r, 0.4_r}},
              .body_from_child = {.position = {-0.3_r, -0.2_r, 0}}},
             {.shape = BoxShape{{0.2_r, 0.4_r, 0.4_r}},
              .body_from_child = {.position = {0.3_r, -0.2_r, 0}}}}};
}

/// Two of a shape, one on the other, on a mesh or on a compound.
struct PairsOfShapes {
    TestWorld test;
    std::vector<BodyId> ids;

    PairsOfShapes(Solver solver, const ShapeDef& shape, Real height_m, bool on_mesh)
        : test(WorldDef{.iterations = solver == Solver::SmallStep ? 1 : 10, .solver = solver}) {
        if (on_mesh)
            test.add(flat_mesh(4, 1), {0, 0, 0}, {.kind = BodyKind::Static});
        else
            test.add(CompoundShape{{{.shape = BoxShape{{4, 1, 4}},
                                     .body_from_child = {.position = {0, -0.5_r, 0}}},
                                    {.shape = BoxShape{{1, 1, 1}},
                                     .body_from_child = {.position = {5, 0, 0}}}}},
                     {0, 0, 0},
                     {.kind = BodyKind::Static});
        for (int i = 0; i < 2; ++i)
            ids.push_back(test.add(shape, {0, height_m * (0.5_r + static_cast<Real>(i)), 0}));
    }
};

TEST(ContactArchive, WhatPressedGoesOnPressingToTheLastBit) {
    const std::vector<std::pair<ShapeDef, Real>> shapes{
        {BoxShape{}, 1.0_r}, {CylinderShape{}, 1.0_r}, {bench(), 0.6_r}};
    for (const Solver solver : {Solver::SmallStep, Solver::BulletSi}) {
        for (std::size_t i = 0; i < shapes.size(); ++i) {
            for (const bool on_mesh : {true, false}) {
                SCOPED_TRACE(testing::Message() << solver_name(solver) << " shape " << i
                                                << (on_mesh ? " on a mesh" : " on a compound"));
                PairsOfShapes there(solver, shapes[i].first, shapes[i].second, on_mesh);
                there.test.run(0.3);
                Archive out;
                there.test.world.serialize(out);
                PairsOfShapes here(solver, shapes[i].first, shapes[i].second, on_mesh);
                Archive in(out.written());
                here.test.world.serialize(in);
                ASSERT_FALSE(in.failed()) << in.fault();
                there.test.world.step();
                here.test.world.step();
                const auto pressed = all_contacts(there.test.world);
                const auto again = all_contacts(here.test.world);
                ASSERT_EQ(pressed.size(), 2U);
                ASSERT_EQ(again.size(), 2U);
                for (std::size_t k = 0; k < 2; ++k) {
                    EXPECT_EQ(again[k].impulse_Ns, pressed[k].impulse_Ns);
                    EXPECT_EQ(again[k].point_world, pressed[k].point_world);
                    EXPECT_GT(again[k].impulse_Ns, 0);
                    EXPECT_FALSE(again[k].began) << "they touched before";
                }
                EXPECT_EQ(here.test.hash(here.ids), there.test.hash(there.ids));
            }
        }
    }
}

}  // namespace
}  // namespace plumbline::physics
