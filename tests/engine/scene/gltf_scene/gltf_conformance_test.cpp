// The cases of the extension's own test files (tests/RigidBodies_* beside its text), built here, and what their descriptions say
// of each.
#include "tests/engine/scene/gltf_scene/gltf_fixture.h"

#include <array>
#include <cmath>

namespace plumbline::scene::gltf {
namespace {

using test::Running;

const double kHalf = std::sqrt(0.5);

Json locked(const char* axes, Json numbers, double at = 0) {
    return {{axes, std::move(numbers)}, {"min", at}, {"max", at}};
}
Json between(const char* axes, Json numbers, double min, double max) {
    return {{axes, std::move(numbers)}, {"min", min}, {"max", max}};
}

Json with_frame(const Json& translation, const Json& rotation) {
    return {{"translation", translation}, {"rotation", rotation}};
}
const Json kNoTurn{0, 0, 0, 1};

/// A cube of 1 m that stands at the origin and one that moves, each with a frame of the joint.
struct Joined {
    PhysicsFile file;
    Json at{0, -1, 0};  ///< the cube that moves
    Json turn = kNoTurn;
    Json frame_a = with_frame({0, 0, 0}, kNoTurn);
    Json frame_b = with_frame({0, 0, 0}, kNoTurn);
    Json motion{{"mass", 1}};
    Json limits = Json::array();
    Json drives = Json::array();
    bool collide{false};

    Vec3d place_after(int steps) {
        const Json collider = PhysicsFile::collider(file.add_box(1, 1, 1));
        const std::size_t stands = file.add_body("stands", {0, 0, 0}, {{"collider", collider}});
        const std::size_t moves =
            file.add_body("moves", at, {{"motion", motion}, {"collider", collider}});
        file.json["nodes"][stands]["rotation"] = file.json["nodes"][moves]["rotation"] = turn;
        file.add("physicsJoints", {{"limits", limits}, {"drives", drives}});
        const std::size_t b = file.add_node(frame_b);
        frame_a["extensions"]["KHR_physics_rigid_bodies"]["joint"] = {
            {"connectedNode", b}, {"joint", 0}, {"enableCollision", collide}};
        file.add_child(stands, file.add_node(frame_a));
        file.add_child(moves, b);
        const ReadGltf read = file.read();
        EXPECT_TRUE(read.scene.ok()) << read.said();
        EXPECT_EQ(read->joints.size(), 1U) << read.said();
        Running run(unseen(*read));
        state = state_after(run, "moves", static_cast<double>(steps) / 60);
        return Vec3d(state.world_from_body.position);
    }
    physics::BodyState state{};
};

Joined at_the_edge(Json limits, const Json& rotation = kNoTurn) {
    Joined joined;
    joined.frame_a = with_frame({0.5, -0.5, 0.5}, rotation);
    joined.frame_b = with_frame({0.5, 0.5, 0.5}, rotation);
    joined.limits = std::move(limits);
    return joined;
}

TEST(GltfConformance, FixedJointHoldsAndABallJointSwings) {
    const Json point = locked("linearAxes", {0, 1, 2});
    Joined fixed = at_the_edge({point, locked("angularAxes", {0, 1, 2})});
    EXPECT_NEAR(glm::distance(fixed.place_after(120), Vec3d{0, -1, 0}), 0, 1e-5);
    Joined ball = at_the_edge({point});
    const Vec3d at = ball.place_after(30);
    EXPECT_GT(at.x, 0.05);
    EXPECT_NEAR(at.x, at.z, 1e-4) << "it swings in the plane of its corner and of gravity";
    EXPECT_NEAR(glm::distance(at, Vec3d{0.5, -0.5, 0.5}), std::sqrt(0.75), 1e-4);
}

TEST(GltfConformance, HingesTurnAboutTheAxisThatTheyLeave) {
    // The frames are a quarter turn about x: their y is z, their z is down. Gravity turns nothing about that.
    const std::array<Vec3d, 3> still{Vec3d{1, 0, 0}, Vec3d{0, 0, 1}, Vec3d{0, 1, 0}};
    for (std::size_t about = 0; about < 3; ++about) {
        Json others = Json::array();
        for (std::size_t i = 0; i < 3; ++i) {
            if (i != about) others.push_back(i);
        }
        Joined hinge = at_the_edge({locked("linearAxes", {0, 1, 2}), locked("angularAxes", others)},
                                   {kHalf, 0, 0, kHalf});
        const Vec3d moved = hinge.place_after(30) - Vec3d{0, -1, 0};
        EXPECT_NEAR(glm::dot(moved, still.at(about)), 0, 1e-4) << about;
        EXPECT_EQ(glm::length(moved) > 0.1, about < 2) << about << ": " << glm::length(moved);
    }
}

TEST(GltfConformance, PrismaticJointsSlideToTheirLimitOrToTheBodyInTheirWay) {
    for (const bool collide : {false, true}) {
        Joined slide;
        const double sine = std::sin(std::acos(-1) / 8);
        slide.turn = {0, 0, sine, std::sqrt(1 - sine * sine)};
        slide.at = {-std::sqrt(2), std::sqrt(2), 0};
        slide.limits = {locked("linearAxes", {0, 2}),
                        locked("angularAxes", {0, 1, 2}),
                        between("linearAxes", {1}, -2, 2)};
        slide.collide = collide;
        const Vec3d at = slide.place_after(240);
        const double along = collide ? -kHalf : 2 * kHalf;
        EXPECT_NEAR(glm::distance(at, Vec3d{along, -along, 0}), 0, 1e-3) << collide;
    }
}

TEST(GltfConformance, ADistanceOfThreeAxesIsARope) {
    Joined rope;
    rope.frame_a = with_frame({0, -0.5, 0}, kNoTurn);
    rope.frame_b = with_frame({0.5, 0.5, 0.5}, kNoTurn);
    rope.limits = {between("linearAxes", {0, 1, 2}, 0, 1)};
    for (const int steps : {20, 60, 200}) {
        Joined copy = rope;
        const Vec3d center = copy.place_after(steps);
        const Pose at = copy.state.world_from_body;
        const Vec3d corner(transform_point(at, Vec3{0.5_r, 0.5_r, 0.5_r}));
        EXPECT_LT(glm::distance(corner, Vec3d{0, -0.5, 0}), 1.001) << steps;
        EXPECT_LT(center.y, -1.0) << steps;
    }
}

TEST(GltfConformance, LimitsAwayFromZeroHoldThere) {
    Joined wheel;
    wheel.at = {1, 0, 0};
    wheel.limits = {
        locked("linearAxes", {0}, 1), locked("linearAxes", {1, 2}), locked("angularAxes", {1, 2})};
    Joined hung = wheel;
    hung.motion = {{"centerOfMass", {0, 0, 0.25}}};
    EXPECT_NEAR(glm::distance(hung.place_after(60), Vec3d{1, 0, 0}), 0, 1e-4);
    EXPECT_GT(std::abs(hung.state.angular_velocity_radps.x), 0.5_r) << "it swings under its axis";

    wheel.drives = {{{"type", "angular"},
                     {"mode", "acceleration"},
                     {"axis", 0},
                     {"velocityTarget", 1.5},
                     {"damping", 1}}};
    EXPECT_NEAR(glm::distance(wheel.place_after(60), Vec3d{1, 0, 0}), 0, 1e-4);
    EXPECT_NEAR(num(wheel.state.angular_velocity_radps.x), 1.5 * (1 - std::exp(-1.0)), 0.01)
        << "as much as its damping takes in a second";
}

TEST(GltfConformance, ADriveToAPositionIsASpring) {
    for (const double mass_kg : {1.0, 5.0}) {
        Joined lift;
        lift.at = {0, 2, 0};
        lift.motion = {{"mass", mass_kg}};
        lift.limits = {locked("linearAxes", {0, 2}),
                       locked("angularAxes", {0, 1, 2}),
                       between("linearAxes", {1}, -2, 2)};
        lift.drives = {{{"type", "linear"},
                        {"mode", "acceleration"},
                        {"axis", 1},
                        {"positionTarget", 2},
                        {"stiffness", 100},
                        {"damping", 1}}};
        EXPECT_NEAR(lift.place_after(1200).y, 2 - 9.81 / 100, 1e-3) << mass_kg;
    }
}

TEST(GltfConformance, MotionsGoOnWhereNothingPullsThem) {
    const auto after_a_second = [](Json motion, bool turned) {
        PhysicsFile file;
        motion["gravityFactor"] = 0;
        const std::size_t body = file.add_body(
            "body",
            {0, 0, 0},
            {{"motion", motion}, {"collider", PhysicsFile::collider(file.add_box(1, 1, 1))}});
        if (turned) file.add_child(file.add_node({{"rotation", {0, kHalf, 0, kHalf}}}), body);
        const ReadGltf read = file.read();
        EXPECT_TRUE(read.scene.ok()) << read.said();
        Running run(unseen(*read));
        return state_after(run, "body", 1);
    };
    const auto still = after_a_second(Json::object(), false);
    EXPECT_EQ(still.world_from_body.position, Vec3(0, 0, 0));
    for (const bool turned : {false, true}) {
        // A quarter turn about y takes z to x.
        const Json along = turned ? Json{0, 0, 1} : Json{1, 0, 0};
        const auto flies = after_a_second({{"linearVelocity", along}}, turned);
        EXPECT_NEAR(num(flies.world_from_body.position.x), 1, 1e-5);
        const auto turns = after_a_second({{"angularVelocity", along}}, turned);
        EXPECT_NEAR(num(turns.angular_velocity_radps.x), 1, 1e-5) << "no floor in its way";
        EXPECT_NEAR(num(glm::length(turns.world_from_body.position)), 0, 1e-6);
    }
}

/// Of a cube above another one below it in a compound, the two parts of which touch different things.
double height_of_compound(const std::array<Json, 2>& filters, bool upside_down) {
    PhysicsFile file;
    for (const Json& filter : filters) file.add("collisionFilters", filter);
    file.add("collisionFilters", {{"collisionSystems", {"static"}}});
    const std::size_t cube = file.add_box(1, 1, 1);
    const std::size_t floor = file.add_box(15, 1, 15);
    const std::size_t body = file.add_body("body", {0, 3, 0}, {{"motion", {{"mass", 1}}}});
    if (upside_down) file.json["nodes"][body]["rotation"] = {1, 0, 0, 0};
    for (std::size_t i = 0; i < 2; ++i) {
        Json collider = PhysicsFile::collider(cube);
        collider["collisionFilter"] = i;
        file.add_child(
            body,
            file.add_body(
                i == 0 ? "top" : "foot", {0, i == 0 ? 1 : -1, 0}, {{"collider", collider}}));
    }
    Json collider = PhysicsFile::collider(floor);
    collider["collisionFilter"] = 2;
    file.add_body("floor", {0, -0.5, 0}, {{"collider", collider}});
    const ReadGltf read = file.read();
    EXPECT_TRUE(read.scene.ok()) << read.said();
    Running run(unseen(*read));
    return num(state_after(run, "body", 4).world_from_body.position.y);
}

TEST(GltfConformance, PartsOfOneBodyHaveFiltersOfTheirOwn) {
    const std::array with{
        Json{{"collisionSystems", {"dynamic"}}, {"collideWithSystems", {"dynamic"}}},
        Json{{"collisionSystems", {"dynamic"}}, {"collideWithSystems", {"static"}}}};
    const std::array without{
        Json{{"collisionSystems", {"dynamic"}}, {"notCollideWithSystems", {"static"}}},
        Json{{"collisionSystems", {"dynamic"}}, {"notCollideWithSystems", {"dynamic"}}}};
    for (const auto& filters : {with, without}) {
        EXPECT_NEAR(height_of_compound(filters, false), 1.5, 1e-3) << "it stands on its foot";
        EXPECT_NEAR(height_of_compound(filters, true), -0.5, 1e-3)
            << "what is below goes through the floor until its foot, on top, is held";
    }
}

/// A shape of the extension, or a tetrahedron as a hull or a mesh.
struct Kind {
    const char* type;
    Json large;
    Json small;
    double top_m;  ///< of the large one
};

Json geometry_of(PhysicsFile& file, const char* type, const Json& fields) {
    const std::string kind = type;
    if (kind != "hull" && kind != "mesh") return {{"shape", file.add_shape(type, fields)}};
    const std::size_t mesh =
        file.add_mesh({-0.5F, 0, -0.5F, 0.5F, 0, -0.5F, 0, 0, 0.5F, 0, 0.5F, 0},
                      {0, 1, 2, 0, 3, 1, 1, 3, 2, 2, 3, 0});
    const std::size_t node = file.add_node({{"mesh", mesh}});
    return {{"node", node}, {"convexHull", kind == "hull"}};
}

TEST(GltfConformance, EveryShapeRestsOnEveryOther) {
    const std::vector<Kind> kinds{
        {"sphere", {{"radius", 10}}, Json::object(), 10},
        {"box", {{"size", {20, 20, 20}}}, Json::object(), 10},
        {"capsule", {{"height", 12}, {"radiusBottom", 10}, {"radiusTop", 10}}, Json::object(), 16},
        {"cylinder", {{"height", 20}, {"radiusBottom", 10}, {"radiusTop", 10}}, Json::object(), 10},
        {"hull", Json::object(), Json::object(), 0},
        {"mesh", Json::object(), Json::object(), 0}};
    for (const Kind& below : kinds) {
        for (const Kind& above : kinds) {
            PhysicsFile file;
            const std::size_t stands = file.add_body(
                "stands",
                {0, -below.top_m, 0},
                {{"collider", {{"geometry", geometry_of(file, below.type, below.large)}}}});
            if (below.top_m == 0) {
                file.json["nodes"][stands]["rotation"] = {1, 0, 0, 0};
                file.json["nodes"][stands]["scale"] = {10, 10, 10};
            }
            const std::size_t moves = file.add_body(
                "moves",
                {0, 3, 0},
                {{"motion", {{"mass", 1}}},
                 {"collider", {{"geometry", geometry_of(file, above.type, above.small)}}}});
            file.json["scenes"] = {{{"nodes", {stands, moves}}}};
            const ReadGltf read = file.read();
            ASSERT_TRUE(read.scene.ok()) << read.said();
            Running run(unseen(*read));
            EXPECT_GT(num(state_after(run, "moves", 4).world_from_body.position.y), -1e-3)
                << above.type << " on " << below.type;
        }
    }
}

}  // namespace
}  // namespace plumbline::scene::gltf
