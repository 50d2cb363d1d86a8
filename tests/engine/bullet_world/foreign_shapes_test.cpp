// Every shape of Bullet's comes to rest as high as its surface says.
#include "engine/bullet_world/foreign_shapes.h"

#include "tests/engine/bullet_world/bullet_rig.h"

#include <BulletCollision/CollisionShapes/btHeightfieldTerrainShape.h>
#include <BulletCollision/Gimpact/btGImpactShape.h>

#include <array>

namespace plumbline::bullet_world {
namespace {

/// How high the body's centre lies at rest on the floor.
double rests_at_m(btCollisionShape& shape, btScalar from_m = 2) {
    OurRig rig;
    rig.floor();
    btRigidBody& body = rig.add(shape, {0, from_m, 0}, 2);
    rig.run(4);
    EXPECT_TRUE(rig.world.notes().empty());
    return static_cast<double>(place(body).y());
}

TEST(ForeignShapes, PrimitivesRestOnTheirSurface) {
    btSphereShape sphere(btScalar(0.7));
    EXPECT_NEAR(rests_at_m(sphere), 0.7, 1e-3);
    btBoxShape box({1, btScalar(0.4), 1});
    EXPECT_NEAR(rests_at_m(box), 0.4, 1e-3);
    btCapsuleShapeX capsule(btScalar(0.3), 2);
    EXPECT_NEAR(rests_at_m(capsule), 0.3, 1e-3);
    btCylinderShape upright({btScalar(0.5), btScalar(0.6), btScalar(0.5)});
    EXPECT_NEAR(rests_at_m(upright), 0.6, 1e-3);
    btCylinderShapeX along_x({btScalar(0.6), btScalar(0.3), btScalar(0.3)});
    EXPECT_NEAR(rests_at_m(along_x), 0.3, 1e-3);
    btCylinderShapeZ along_z({btScalar(0.3), btScalar(0.3), btScalar(0.6)});
    EXPECT_NEAR(rests_at_m(along_z), 0.3, 1e-3);
    btConeShape cone(btScalar(0.5), 1);
    EXPECT_NEAR(rests_at_m(cone), 0.5, 1e-3);
}

TEST(ForeignShapes, ScalingIsPartOfTheSize) {
    btBoxShape box({1, 1, 1});
    box.setLocalScaling({1, btScalar(0.25), 1});
    EXPECT_NEAR(rests_at_m(box), 0.25, 1e-3);
    btSphereShape sphere(1);
    sphere.setLocalScaling({btScalar(0.5), btScalar(0.5), btScalar(0.5)});
    EXPECT_NEAR(rests_at_m(sphere), 0.5, 1e-3);
}

TEST(ForeignShapes, AHullHasNoMarginAroundIt) {
    btConvexHullShape hull;
    for (const btScalar x : {btScalar(-1), btScalar(1)}) {
        for (const btScalar y : {btScalar(-1), btScalar(1)}) {
            for (const btScalar z : {btScalar(-1), btScalar(1)})
                hull.addPoint({x, y * btScalar(0.5), z});
        }
    }
    EXPECT_NEAR(rests_at_m(hull), 0.5, 1e-3);
}

TEST(ForeignShapes, WhatOursLackBecomesAHull) {
    const std::array<btVector3, 2> centres{btVector3(-1, 0, 0), btVector3(1, 0, 0)};
    const std::array<btScalar, 2> radii{btScalar(0.5), btScalar(0.5)};
    btMultiSphereShape spheres(centres.data(), radii.data(), 2);
    EXPECT_NEAR(rests_at_m(spheres), 0.45, 0.05);  // of 64 corners at most
}

TEST(ForeignShapes, CompoundsKeepTheirPartsInPlace) {
    btSphereShape ball(btScalar(0.5));
    btCompoundShape dumbbell;
    dumbbell.addChildShape(btTransform(btQuaternion::getIdentity(), {-1, btScalar(0.2), 0}), &ball);
    dumbbell.addChildShape(btTransform(btQuaternion::getIdentity(), {1, btScalar(0.2), 0}), &ball);
    const auto shape = foreign_shape(dumbbell, true);
    ASSERT_TRUE(shape);
    const auto& compound = std::get<physics::CompoundShape>(shape->def);
    ASSERT_EQ(compound.children.size(), 2U);
    EXPECT_NEAR(compound.children[1].body_from_child.position.x, 1, 1e-6);
    EXPECT_NEAR(compound.children[1].body_from_child.position.y, 0.2, 1e-6);
}

/// How high a ball of 0.5 m lies on a static body of the shape.
double carries_at_m(btCollisionShape& ground) {
    OurRig rig;
    rig.add(ground, {0, 0, 0}, 0);
    btRigidBody& ball =
        rig.add(rig.shape<btSphereShape>(btScalar(0.5)), {btScalar(0.3), 3, btScalar(0.2)}, 1);
    rig.run(4);
    EXPECT_TRUE(rig.world.notes().empty());
    return static_cast<double>(place(ball).y());
}

TEST(ForeignShapes, PlanesMeshesAndHeightFieldsCarry) {
    btStaticPlaneShape plane({0, 1, 0}, btScalar(0.75));
    EXPECT_NEAR(carries_at_m(plane), 1.25, 1e-3);

    btTriangleMesh triangles;
    triangles.addTriangle({-5, 1, -5}, {-5, 1, 5}, {5, 1, 5});
    triangles.addTriangle({-5, 1, -5}, {5, 1, 5}, {5, 1, -5});
    btBvhTriangleMeshShape mesh(&triangles, true);
    EXPECT_NEAR(carries_at_m(mesh), 1.5, 1e-3);
    btScaledBvhTriangleMeshShape scaled(&mesh, {1, btScalar(0.5), 1});
    EXPECT_NEAR(carries_at_m(scaled), 1.0, 1e-3);

    const std::array<float, 81> heights{};
    btHeightfieldTerrainShape field(9, 9, heights.data(), btScalar(0), btScalar(1), 1, false);
    EXPECT_NEAR(carries_at_m(field), -0.5 + 0.5, 1e-3);
}

TEST(ForeignShapes, ATiltedPlaneIsTilted) {
    OurRig rig;
    btRigidBody& ball = rig.add(rig.shape<btSphereShape>(btScalar(0.5)), {0, 2, 0}, 1);
    rig.add(
        rig.shape<btStaticPlaneShape>(btVector3(1, 1, 0).normalized(), btScalar(0)), {0, 0, 0}, 0);
    rig.run(1.5);
    EXPECT_GT(place(ball).x(), 1);
    EXPECT_NEAR((place(ball).x() + place(ball).y()) * SIMDSQRT12, 0.5, 1e-2);
}

TEST(ForeignShapes, MeshesThatMoveBecomeHulls) {
    btTriangleMesh triangles;
    const btVector3 top(0, 1, 0);
    const std::array<btVector3, 3> base{
        btVector3(-1, 0, -1), btVector3(1, 0, -1), btVector3(0, 0, 1)};
    triangles.addTriangle(base[0], base[1], base[2]);
    for (std::size_t i = 0; i < 3; ++i) triangles.addTriangle(base[i], base[(i + 1) % 3], top);
    btGImpactMeshShape mesh(&triangles);
    mesh.updateBound();
    const auto shape = foreign_shape(mesh, true);
    ASSERT_TRUE(shape);
    EXPECT_EQ(std::get<physics::HullShape>(shape->def).points_m.size(), 4U);
    EXPECT_FALSE(shape->is_mesh);
}

TEST(ForeignShapes, WhatHasNoSurfaceIsRefused) {
    btEmptyShape empty;
    EXPECT_FALSE(foreign_shape(empty, true));
    btCompoundShape nothing;
    EXPECT_FALSE(foreign_shape(nothing, true));
    btStaticPlaneShape plane({0, 1, 0}, 0);
    EXPECT_FALSE(foreign_shape(plane, true));
}

TEST(ForeignShapes, EqualShapesHaveEqualHashes) {
    btBoxShape a({1, 2, 3});
    btBoxShape b({1, 2, 3});
    btBoxShape c({1, 2, 4});
    const auto hash_of = [](const btCollisionShape& shape) {
        return shape_hash(foreign_shape(shape, true)->def);
    };
    EXPECT_EQ(hash_of(a), hash_of(b));
    EXPECT_NE(hash_of(a), hash_of(c));
    btSphereShape sphere(1);
    EXPECT_NE(hash_of(a), hash_of(sphere));
}

}  // namespace
}  // namespace plumbline::bullet_world
