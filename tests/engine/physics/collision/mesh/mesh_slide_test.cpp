// Things on meshes.
#include "tests/engine/physics/test_world.h"

#include <cmath>

namespace plumbline::physics {
namespace {

struct SlideCase {
    const char* name;
    ShapeDef shape;
    Real height_m;
    Real yaw_rad;
};

class MeshSlide : public testing::TestWithParam<int> {};

INSTANTIATE_TEST_SUITE_P(Things, MeshSlide, testing::Range(0, 4));

TEST_P(MeshSlide, KeepsSpeedHeadingAndStaysDown) {
    const std::vector<SlideCase> cases{
        {"box", BoxShape{}, 0.5_r, 0},
        {"box, turned", BoxShape{}, 0.5_r, radians_from_degrees(30.0_r)},
        {"ball", SphereShape{}, 0.5_r, 0},
        {"ball, turned", SphereShape{}, 0.5_r, radians_from_degrees(30.0_r)}};
    const SlideCase& slide = cases[static_cast<std::size_t>(GetParam())];
    SCOPED_TRACE(slide.name);
    TestWorld test(in_small_steps());
    test.add(flat_mesh(64, 1), {0, 0, 0}, {.kind = BodyKind::Static, .friction = 0});
    const Vec3 heading{std::cos(slide.yaw_rad), 0, std::sin(slide.yaw_rad)};
    const Vec3 start = Vec3{0, slide.height_m, 0} - 15.0_r * heading;
    const BodyId body =
        test.add(slide.shape,
                 start,
                 {.kind = BodyKind::Dynamic, .velocity_mps = 10.0_r * heading, .friction = 0});
    double fastest_up = 0;
    for (int i = 0; i < 180; ++i) {
        test.world.step();
        fastest_up = std::max(fastest_up, test.velocity(body).y);
    }
    const Vec3d v = test.velocity(body);
    EXPECT_LT(fastest_up, 0.02);
    EXPECT_NEAR(std::hypot(v.x, v.z), 10.0, 0.01);
    const Vec3d h{heading};
    EXPECT_LT(std::abs(v.x * h.z - v.z * h.x) / 10.0, 0.0017) << "heading off by 0.1 degree";
}

TEST(MeshContact, HoldsOnMeshesThatAreMovedAndTurned) {
    // A hillside made of a flat mesh, far from the origin: Bullet 3.24 alone lets
    // things fall through such a mesh.
    for (const Real degrees : {0.0_r, 20.0_r, 180.0_r}) {
        TestWorld test(in_small_steps());
        const Quat turned = glm::angleAxis(radians_from_degrees(degrees), Vec3{1, 0, 0});
        test.world.create_body(
            {.shape = test.shape(flat_mesh(24, 1)),
             .world_from_body = {.position = {40, -30, 10}, .orientation = turned},
             .friction = 4});
        const Vec3 normal = turned * Vec3{0, degrees > 90 ? -1.0_r : 1.0_r, 0};
        const std::vector<ShapeDef> shapes{BoxShape{.size_m = {0.4_r, 0.4_r, 0.4_r}},
                                           SphereShape{.radius_m = 0.2_r},
                                           CapsuleShape{.radius_m = 0.2_r, .height_m = 0.5_r},
                                           CylinderShape{.radius_m = 0.2_r, .height_m = 0.5_r},
                                           ConeShape{.radius_m = 0.2_r, .height_m = 0.5_r}};
        std::vector<BodyId> things;
        for (const ShapeDef& shape : shapes) {
            const Vec3 along = turned * Vec3{static_cast<Real>(things.size()) - 2, 0, 0.3_r};
            things.push_back(test.add(shape, Vec3{40, -30, 10} + along + 0.7_r * normal));
        }
        test.run(1.0);
        for (std::size_t i = 0; i < things.size(); ++i) {
            const Vec3 above =
                test.world.state(things[i]).world_from_body.position - Vec3{40, -30, 10};
            EXPECT_GT(glm::dot(above, normal), 0.05_r) << degrees << " degrees, thing " << i;
        }
    }
}

}  // namespace
}  // namespace plumbline::physics
