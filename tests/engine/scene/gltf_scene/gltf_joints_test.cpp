// Sums of limits as joints: the kinds of the extension's sample, and what none of ours is.
#include "tests/engine/scene/gltf_scene/gltf_fixture.h"

#include <cmath>

namespace plumbline::scene::gltf {
namespace {

constexpr double kEighth_rad = 0.785398;

Json limit(const char* axes, Json numbers, Json min, Json max) {
    Json made{{axes, std::move(numbers)}};
    if (!min.is_null()) made["min"] = std::move(min);
    if (!max.is_null()) made["max"] = std::move(max);
    return made;
}
Json locked(const char* axes, Json numbers) {
    return limit(axes, std::move(numbers), 0, 0);
}

/// A ball at the origin that the joint holds to another one, or to the world. The connected node is the ball's.
ReadGltf jointed(Json limits,
                 Json drives = Json::array(),
                 bool to_world = false,
                 double gap_m = 0) {
    PhysicsFile file;
    const std::size_t a = file.add_ball("a", {0, 0, 0}, {{"mass", 1}});
    const std::size_t connected = file.add_node({{"name", "frame a"}, {"translation", {1, 0, 0}}});
    file.add_child(a, connected);
    const std::size_t joint =
        file.add("physicsJoints", {{"limits", std::move(limits)}, {"drives", std::move(drives)}});
    const Json own{{"connectedNode", connected}, {"joint", joint}, {"enableCollision", true}};
    const std::size_t node =
        file.add_body("hold", {to_world ? 1 + gap_m : -1 + gap_m, 0, 0}, {{"joint", own}});
    if (!to_world) file.add_child(file.add_ball("b", {2, 0, 0}, {{"mass", 1}}), node);
    ReadGltf read = file.read();
    EXPECT_TRUE(read.scene.ok()) << read.said();
    return read;
}

JointDescription only(const ReadGltf& read) {
    EXPECT_EQ(read->joints.size(), 1U) << read.said();
    return read->joints.empty() ? JointDescription{} : read->joints.front();
}

TEST(GltfJoints, OfThreeLockedLengthsAreBallJoints) {
    const Json three = {
        locked("linearAxes", {0}), locked("linearAxes", {1}), locked("linearAxes", {2})};
    for (const Json& limits : {Json{locked("linearAxes", {0, 1, 2})}, three}) {
        const JointDescription joint = only(jointed(limits));
        EXPECT_EQ(joint.kind, JointKind::BallAndSocket);
        EXPECT_EQ(joint.a, "a") << "it hangs on the connected node";
        EXPECT_EQ(joint.b, "b");
        EXPECT_EQ(joint.anchor_a_m, Vec3(1, 0, 0));
        EXPECT_TRUE(joint.collide);
        EXPECT_EQ(joint.name, "hold");
    }
}

TEST(GltfJoints, ThatLeaveOneTurnAreHinges) {
    const JointDescription joint = only(jointed({locked("linearAxes", {0, 1, 2}),
                                                 locked("angularAxes", {0, 1}),
                                                 limit("angularAxes", {2}, -0.5, 1)},
                                                {{{"type", "angular"},
                                                  {"axis", 2},
                                                  {"maxForce", 7},
                                                  {"velocityTarget", 3},
                                                  {"damping", 1e6}}}));
    EXPECT_EQ(joint.kind, JointKind::Hinge);
    EXPECT_EQ(joint.axis, Vec3(0, 0, 1));
    EXPECT_EQ(joint.limits, (std::array{-0.5_r, Real{1}}));
    ASSERT_TRUE(joint.motor);
    EXPECT_EQ(joint.motor->target, Real{3});
    EXPECT_EQ(joint.motor->max, Real{7});
}

// Ours count from the connected body; where that is the world, the other way round.
TEST(GltfJoints, WithTheWorldAtTheirOtherEndTurnTheOtherWay) {
    PhysicsFile file;
    const std::size_t frame = file.add_node({{"name", "wall"}});
    const std::size_t ball = file.add_ball("a", {0, 0, 0}, {{"mass", 1}});
    const std::size_t joint = file.add(
        "physicsJoints",
        {{"limits",
          {locked("linearAxes", {0, 1, 2}),
           locked("angularAxes", {1, 2}),
           limit("angularAxes", {0}, -0.5, 1)}},
         {"drives", {{{"type", "angular"}, {"axis", 0}, {"velocityTarget", 2}, {"damping", 4}}}}});
    file.add_child(
        ball,
        file.add_body(
            "hold", {0, 0, 0}, {{"joint", {{"connectedNode", frame}, {"joint", joint}}}}));
    const ReadGltf read = file.read();
    ASSERT_TRUE(read.scene.ok()) << read.said();
    const JointDescription made = only(read);
    EXPECT_EQ(made.a, "a");
    EXPECT_EQ(made.b, "world");
    EXPECT_EQ(made.limits, (std::array{Real{-1}, 0.5_r}));
    EXPECT_EQ(made.motor->target, Real{-2});
}

TEST(GltfJoints, ThatLeaveOneLengthAreSliders) {
    const JointDescription joint = only(jointed({limit("linearAxes", {0}, -0.5, 0.5),
                                                 locked("linearAxes", {1}),
                                                 locked("linearAxes", {2}),
                                                 locked("angularAxes", {0, 1, 2})}));
    EXPECT_EQ(joint.kind, JointKind::Slider);
    EXPECT_EQ(joint.axis, Vec3(1, 0, 0));
    EXPECT_EQ(joint.limits, (std::array{-0.5_r, 0.5_r}));
}

// What is between the frames as the scene begins counts: our joints begin at zero.
TEST(GltfJoints, CountTheirLimitsFromWhereTheyBegin) {
    const JointDescription joint = only(jointed({limit("linearAxes", {0}, -0.5, 0.5),
                                                 locked("linearAxes", {1, 2}),
                                                 locked("angularAxes", {0, 1, 2})},
                                                Json::array(),
                                                true,
                                                -0.25));
    EXPECT_EQ(joint.limits, (std::array{-0.75_r, 0.25_r})) << "a stands 0.25 m along the axis";
}

TEST(GltfJoints, ThatLeaveNothingAreFixed) {
    const JointDescription joint = only(jointed(
        {locked("linearAxes", {0, 2, 1}), locked("angularAxes", {0, 2, 1})}, Json::array(), true));
    EXPECT_EQ(joint.kind, JointKind::Fixed);
    EXPECT_EQ(joint.b, "world");
}

TEST(GltfJoints, WithBoundedTurnsAreCones) {
    const Json hold = locked("linearAxes", {0, 1, 2});
    const JointDescription cone = only(jointed({hold,
                                                limit("angularAxes", {0, 2}, nullptr, kEighth_rad),
                                                limit("angularAxes", {1}, -0.1, 0.2)}));
    EXPECT_EQ(cone.kind, JointKind::Cone);
    EXPECT_EQ(cone.axis, Vec3(0, 1, 0));
    EXPECT_NEAR(static_cast<double>((*cone.limits)[1]), kEighth_rad, 1e-6);
    EXPECT_EQ(cone.twist, (std::array{-0.1_r, 0.2_r}));
    const ReadGltf pyramid = jointed({hold,
                                      limit("angularAxes", {0}, -kEighth_rad, kEighth_rad),
                                      limit("angularAxes", {2}, -kEighth_rad, kEighth_rad),
                                      locked("angularAxes", {1})});
    EXPECT_EQ(only(pyramid).axis, Vec3(0, 1, 0));
    EXPECT_NEAR(static_cast<double>((*only(pyramid).limits)[1]), kEighth_rad, 1e-6);
    EXPECT_NE(pyramid.said().find("two limits of angles are one cone"), std::string::npos);
}

TEST(GltfJoints, WithADistanceAreRodsAndSprings) {
    const JointDescription rope =
        only(jointed({limit("linearAxes", {0, 1, 2}, 0, 2)}, Json::array(), true, 1));
    EXPECT_EQ(rope.kind, JointKind::Distance);
    EXPECT_EQ(rope.limits, (std::array{Real{0}, Real{2}}));
    EXPECT_EQ(rope.anchor_a_m, Vec3(1, 0, 0));
    EXPECT_EQ(rope.anchor_b_m, Vec3(2, 0, 0));
    Json soft = limit("linearAxes", {0, 1, 2}, 0.5, 0.5);
    soft["stiffness"] = 40;
    soft["damping"] = 3;
    const JointDescription spring = only(jointed({soft}, Json::array(), true, 1));
    EXPECT_EQ(spring.kind, JointKind::Spring);
    EXPECT_EQ(spring.stiffness_Npm, Real{40});
    EXPECT_EQ(spring.damping_Nspm, Real{3});
    EXPECT_EQ(spring.rest_length_m, 0.5_r);
    const ReadGltf box = jointed({limit("linearAxes", {0}, -0.25, 0.25),
                                  limit("linearAxes", {1}, -0.25, 0.25),
                                  limit("linearAxes", {2}, -0.25, 0.25)});
    EXPECT_EQ(only(box).kind, JointKind::Distance);
    EXPECT_NE(box.said().find("three limits of lengths are one distance"), std::string::npos);
}

TEST(GltfJoints, ThatWeDoNotHaveAreLeftOutAndSaidSo) {
    for (const Json& limits : {Json{limit("linearAxes", {0, 1}, 0, 2)},
                               Json{locked("linearAxes", {0})},
                               Json{locked("angularAxes", {0, 1, 2})},
                               Json::array()}) {
        const ReadGltf read = jointed(limits);
        EXPECT_TRUE(read->joints.empty()) << limits;
        EXPECT_NE(read.said().find("hold: the joint is left out"), std::string::npos)
            << read.said();
    }
}

TEST(GltfJoints, WithDrivesAreMotorsAndSprings) {
    const auto driven = [](Json drive) {
        drive["type"] = "angular";
        drive["axis"] = 2;
        return only(jointed({locked("linearAxes", {0, 1, 2}), locked("angularAxes", {0, 1})},
                            {std::move(drive)}))
            .motor;
    };
    const auto spring = driven({{"positionTarget", 1},
                                {"stiffness", 5},
                                {"damping", 2},
                                {"maxForce", 7},
                                {"mode", "acceleration"}});
    ASSERT_TRUE(spring);
    EXPECT_EQ(spring->stiffness, Real{5});
    EXPECT_EQ(spring->damping, Real{2});
    EXPECT_EQ(spring->position, Real{1});
    EXPECT_EQ(spring->max, Real{7});
    EXPECT_TRUE(spring->by_mass);
    const auto motor = driven({{"velocityTarget", 3}, {"damping", 1e6}});
    ASSERT_TRUE(motor);
    EXPECT_EQ(motor->target, Real{3});
    EXPECT_EQ(motor->damping, Real{0}) << "so damped, it holds its speed";
    EXPECT_FALSE(driven({{"velocityTarget", 3}}))
        << "without stiffness and damping it gives no force";
}

TEST(GltfJoints, NeedABodyThatMoves) {
    PhysicsFile file;
    const std::size_t wall = file.add_node({{"name", "wall"}});
    const std::size_t joint = file.add("physicsJoints", {{"limits", Json::array()}});
    file.add_body("hold", {0, 0, 0}, {{"joint", {{"connectedNode", wall}, {"joint", joint}}}});
    file.add_ball("ball", {0, 9, 0}, Json::object());
    const ReadGltf read = file.read();
    ASSERT_TRUE(read.scene.ok()) << read.said();
    EXPECT_TRUE(read->joints.empty());
    EXPECT_NE(read.said().find("must hang on a body that has motion"), std::string::npos);
}

}  // namespace
}  // namespace plumbline::scene::gltf
