#include "engine/physics/dynamics/joint/joint_topology.h"

#include "tests/engine/physics/dynamics/joint/joint_rig.h"

#include <gtest/gtest.h>

namespace plumbline::physics {
namespace {

/// n x n balls on a grid of ball joints, hung by two corners.
struct Net : JointRig {
    explicit Net(int n) {
        std::vector<std::uint32_t> at;
        for (int i = 0; i < n * n; ++i) {
            const bool held = i == 0 || i == n - 1;
            const Vec3d place{static_cast<double>(i % n), 0, static_cast<double>(i / n)};
            at.push_back(held ? 0 : add_ball_body(1, 0.4, place));
            const auto join = [&](int other, const Vec3d& middle) {
                add_ball(
                    at[static_cast<std::size_t>(i)], at[static_cast<std::size_t>(other)], middle);
            };
            if (i % n > 0) join(i - 1, place - Vec3d{0.5, 0, 0});
            if (i >= n) join(i - n, place - Vec3d{0, 0, 0.5});
        }
    }
};

TEST(JointTopology, SmallNetIsSolvedDirectly) {
    Net net(6);
    net.run(2, kFrame_s, 4);
    EXPECT_EQ(net.system.work().method, JointMethod::Direct);
    EXPECT_LT(net.max_error(), 1e-5);
}

TEST(JointTopology, LargeNetFallsBackToSweepsAndStaysTogether) {
    Net net(40);
    net.kick = Kick::Steady;
    net.run(2, kFrame_s, 4);
    EXPECT_EQ(net.system.work().method, JointMethod::Iterative);
    EXPECT_LT(net.max_speed(), 100);
    EXPECT_LT(net.max_error(), 0.35);
}

SolverJoint joint_between(JointKind kind, std::uint32_t a, std::uint32_t b, std::uint64_t key) {
    SolverJoint joint;
    joint.kind = kind;
    joint.a = a;
    joint.b = b;
    joint.key = key;
    return joint;
}

/// The world and `count` bodies of 1 kg.
std::vector<SolverBody> bodies_of_1_kg(std::size_t count) {
    std::vector<SolverBody> bodies(count + 1);
    for (std::size_t i = 1; i <= count; ++i) bodies[i].inverse_mass = 1;
    return bodies;
}

const JointTopology& topology_of(TopologyCache& cache,
                                 std::span<const SolverBody> bodies,
                                 std::span<const SolverJoint> joints) {
    std::vector<JointForm> forms;
    for (const SolverJoint& joint : joints) forms.push_back(form_of(joint, false));
    return cache.of(bodies, joints, forms);
}

TEST(JointTopology, RowsOfEveryKind) {
    const auto form = [](JointKind kind, bool limited = false, bool stiff = false) {
        SolverJoint joint;
        joint.kind = kind;
        if (limited) joint.twist_limits = {-1, 1};
        const JointForm made = form_of(joint, stiff);
        return std::pair(made.places, made.turns);
    };
    const auto both = [](NodeKind places, NodeKind turns) { return std::pair(places, turns); };
    EXPECT_EQ(form(JointKind::BallAndSocket), both(NodeKind::Point, NodeKind::None));
    EXPECT_EQ(form(JointKind::Hinge), both(NodeKind::Point, NodeKind::Align));
    EXPECT_EQ(form(JointKind::Slider), both(NodeKind::Across, NodeKind::Lock));
    EXPECT_EQ(form(JointKind::Fixed), both(NodeKind::Point, NodeKind::Lock));
    EXPECT_EQ(form(JointKind::Cone), both(NodeKind::Point, NodeKind::None)) << "free to swing";
    EXPECT_EQ(form(JointKind::Cone, true), both(NodeKind::Point, NodeKind::Swing));
    EXPECT_EQ(form(JointKind::Distance), both(NodeKind::Length, NodeKind::None));
    EXPECT_EQ(form(JointKind::Spring), both(NodeKind::None, NodeKind::None)) << "a force";
    EXPECT_EQ(form(JointKind::Spring, false, true), both(NodeKind::Length, NodeKind::None));
}

TEST(JointTopology, OnlyJointsThatCanDoSomethingHaveRows) {
    std::vector<SolverBody> bodies = bodies_of_1_kg(3);
    bodies[3].inverse_mass = 0;
    const std::vector<SolverJoint> joints{joint_between(JointKind::Hinge, 1, 0, 1),
                                          joint_between(JointKind::Fixed, 2, 2, 2),
                                          joint_between(JointKind::BallAndSocket, 3, 0, 3),
                                          joint_between(JointKind::Spring, 1, 2, 4)};
    TopologyCache cache;
    const JointTopology& made = topology_of(cache, bodies, joints);
    ASSERT_EQ(made.nodes.size(), 2U);
    EXPECT_EQ(made.nodes[0].kind, NodeKind::Point);
    EXPECT_EQ(made.nodes[1].kind, NodeKind::Align);
    EXPECT_EQ(made.sides.size(), joints.size());
    EXPECT_EQ(made.bodies[made.sides[3][1]], 2U);
    // A node needs a term for each earlier node on a movable body of its own: here body 1.
    ASSERT_EQ(made.terms.size(), 1U);
    EXPECT_EQ(made.terms[0].row, 1U);
    EXPECT_EQ(made.terms[0].column, 0U);
}

TEST(JointTopology, TheWorldAndWhatStandsDivideComponents) {
    const std::vector<SolverJoint> joints{joint_between(JointKind::BallAndSocket, 1, 0, 1),
                                          joint_between(JointKind::BallAndSocket, 2, 0, 2),
                                          joint_between(JointKind::BallAndSocket, 3, 2, 3)};
    TopologyCache cache;
    const JointTopology& made = topology_of(cache, bodies_of_1_kg(3), joints);
    ASSERT_EQ(made.components.size(), 2U);
    EXPECT_EQ(made.components[0].last_node - made.components[0].first_node, 1U);
    EXPECT_EQ(made.components[1].last_node - made.components[1].first_node, 2U);
    EXPECT_EQ(made.components[0].first_term, made.components[0].last_term);
    EXPECT_EQ(made.components[1].last_term - made.components[1].first_term, 1U);
}

TEST(JointTopology, IsMadeOnceForAsLongAsItComesAgain) {
    std::vector<SolverBody> bodies = bodies_of_1_kg(2);
    const std::vector<SolverJoint> joints{joint_between(JointKind::Hinge, 1, 0, 1),
                                          joint_between(JointKind::Hinge, 2, 1, 2)};
    TopologyCache cache;
    const JointTopology* first = &topology_of(cache, bodies, joints);
    EXPECT_EQ(&topology_of(cache, bodies, joints), first);
    bodies[1].inverse_mass = 0;
    const JointTopology* frozen = &topology_of(cache, bodies, joints);
    EXPECT_NE(frozen, first);
    EXPECT_EQ(frozen->nodes.size(), 2U) << "body 1 carries nothing any more";
    bodies[1].inverse_mass = 1;
    EXPECT_EQ(&topology_of(cache, bodies, joints), first) << "kept";
}

// Squares of the joints on each body together: 448 squared is above 200 000.
TEST(JointTopology, AStarOfManyArmsIsTooDear) {
    std::vector<SolverJoint> joints;
    for (std::uint32_t i = 0; i < 448; ++i)
        joints.push_back(joint_between(JointKind::BallAndSocket, 1, 0, i + 1));
    TopologyCache cache;
    const JointTopology& made = topology_of(cache, bodies_of_1_kg(1), joints);
    EXPECT_TRUE(made.too_dear);
    ASSERT_EQ(made.nodes.size(), joints.size());
    EXPECT_EQ(made.nodes[7].joint, 7U) << "in the joints' order, for sweeps";
    EXPECT_TRUE(made.terms.empty());
    joints.resize(40);
    EXPECT_FALSE(topology_of(cache, bodies_of_1_kg(1), joints).too_dear);
}

}  // namespace
}  // namespace plumbline::physics
