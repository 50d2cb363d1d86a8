// Pieces put together, weighed; meshes.
#include "tests/engine/physics/bullet/shape/shape_rig.h"

namespace plumbline::physics {
namespace {

TEST(ShapeMass, CompoundWeighsByVolumeAndParallelAxes) {
    TestWorld test;
    // Two unit cubes 3 m apart: I = 2 * (1/6) along, 2 * (1/6 + 1.5^2) across, for 2 kg.
    CompoundShape dumbbell;
    dumbbell.children.push_back({.shape = BoxShape{}, .body_from_child = {.position = {-1, 5, 0}}});
    dumbbell.children.push_back({.shape = BoxShape{}, .body_from_child = {.position = {2, 5, 0}}});
    const MassProperties mass = weigh(test, dumbbell, 2);
    expect_near(mass.center_of_mass_m, {0.5, 5, 0}, 50 * kRounding);
    const double across = 2 * (1.0 / 6.0 + 2.25);
    expect_near(mass.inertia_kgm2, {1.0 / 3.0, across, across}, 100 * kRounding);
}

TEST(ShapeContact, CompoundTableStandsOnItsLegs) {
    TestWorld test;
    test.ground();
    CompoundShape table;
    table.children.push_back({.shape = BoxShape{.size_m = {1, 0.1_r, 1}}, .body_from_child = {}});
    for (const Real x : {-0.4_r, 0.4_r}) {
        for (const Real z : {-0.4_r, 0.4_r}) {
            table.children.push_back({.shape = BoxShape{.size_m = {0.1_r, 0.8_r, 0.1_r}},
                                      .body_from_child = {.position = {x, -0.45_r, z}}});
        }
    }
    const BodyId body = test.add(table, {0, 0.9_r, 0}, {.kind = BodyKind::Dynamic, .mass_kg = 10});
    test.run(3.0);
    EXPECT_NEAR(test.at(body).y, 0.85, 0.01);
}

TEST(ShapeNotes, TrianglesWithoutAreaAreLeftOut) {
    TestWorld test;
    MeshShape mesh = flat_mesh(2, 1);
    mesh.triangles.push_back({0, 1, 2});
    mesh.triangles.push_back({4, 4, 5});
    std::vector<std::string> notes;
    ASSERT_TRUE(test.world.create_shape(mesh, &notes).ok());
    EXPECT_EQ(notes, std::vector<std::string>{"mesh: 2 triangles without area left out"});
}

}  // namespace
}  // namespace plumbline::physics
