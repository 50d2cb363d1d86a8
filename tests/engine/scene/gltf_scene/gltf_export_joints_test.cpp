// Joints written as sums of limits and read back are the same.
#include "tests/engine/scene/gltf_scene/gltf_round_trip.h"

#include <cmath>

namespace plumbline::scene::gltf {
namespace {

using physics::BodyKind;
using test::ball;
using test::box;
using test::cube;
using test::ground;
using test::Running;
using test::scene_of;

TEST(GltfExportJoints, KeepsJoints) {
    SceneDescription scene = scene_of({});
    const auto hang = [&](const char* name, Real x, JointKind kind) -> JointDescription& {
        EntityDescription entity = cube(name, {x, 5, 0});
        entity.body->mass_kg = 4;
        scene.entities.push_back(entity);
        JointDescription joint;
        joint.name = std::string("joint of ") + name;
        joint.kind = kind;
        joint.a = name;
        joint.b = "world";
        joint.anchor_a_m = joint.anchor_b_m = {x + 1, 5.5_r, 0};
        joint.axis = {0, 0, 1};
        joint.location = in_file("test.toml", 1);
        scene.joints.push_back(joint);
        return scene.joints.back();
    };
    hang("ball", 0, JointKind::BallAndSocket);
    hang("hinge", 5, JointKind::Hinge).limits = std::array{-0.5_r, 0.4_r};
    hang("motor", 10, JointKind::Hinge).motor = physics::JointMotor{.target = 2, .max = 500};
    hang("servo", 45, JointKind::Hinge).motor = physics::JointMotor{
        .target = 1, .max = 1e3_r, .stiffness = 300, .damping = 20, .position = 0.5_r};
    JointDescription& slider = hang("slider", 15, JointKind::Slider);
    slider.axis = {0.6_r, 0.8_r, 0};
    slider.limits = std::array{-0.5_r, Real{1}};
    hang("fixed", 20, JointKind::Fixed);
    JointDescription& cone = hang("cone", 25, JointKind::Cone);
    cone.axis = {1, 0, 0};
    cone.limits = std::array{Real{0}, 0.4_r};
    cone.twist = std::array{-0.1_r, 0.2_r};
    hang("rod", 30, JointKind::Distance).anchor_b_m = {32, 7, 0};
    JointDescription& spring = hang("spring", 35, JointKind::Spring);
    spring.anchor_b_m = {36, 8, 0};
    spring.stiffness_Npm = 80;
    spring.damping_Nspm = 2;
    spring.rest_length_m = Real{1};
    JointDescription& pair = hang("pair", 40, JointKind::Hinge);
    pair.b = "fixed";
    pair.anchor_a_m = pair.anchor_b_m = {30, 5, 0};
    pair.break_N = 1e6_r;
    RoundTrip trip(scene);
    ASSERT_NE(trip.after, nullptr);
    ASSERT_EQ((*trip.after)->joints().size(), scene.joints.size());
    const auto& back = trip.description.value().joints;
    EXPECT_EQ(back.back().break_N, 1e6_r);
    EXPECT_EQ(back.back().b, "fixed");
    EXPECT_LT(trip.apart_m(120), 2e-3);
}

}  // namespace
}  // namespace plumbline::scene::gltf
