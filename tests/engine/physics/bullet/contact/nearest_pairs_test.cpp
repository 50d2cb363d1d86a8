// In a crowd a body meets those that are nearest.
#include "engine/core/io/pose_archive.h"
#include "engine/physics/totals.h"
#include "tests/engine/physics/test_world.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace plumbline::physics {
namespace {

constexpr std::uint64_t kNear = kNearestPairs;

using Marks = std::pair<std::uint64_t, std::uint64_t>;

std::set<Marks> touching_marks(const PhysicsWorld& world) {
    std::set<Marks> pairs;
    for (const ContactEvent& contact : all_contacts(world))
        pairs.insert(std::minmax(contact.user_a, contact.user_b));
    return pairs;
}

WorldDef weightless_by(Solver solver) {
    WorldDef def = weightless();
    def.solver = solver;
    def.substeps = 1;
    return def;
}

std::uint64_t left_out(const PhysicsWorld& world) {
    return world.report().cost.interventions.left_out_pairs;
}

/// At one place each body's nearest are those of the lowest ids: all pairs with the first 100.
std::uint64_t kept_of(std::uint64_t bodies) {
    return kNear * bodies - kNear * (kNear + 1) / 2;
}

TEST(NearestPairs, OnOneSpotAreAtMostAHundredForEachBody) {
    for (const Solver solver : kSolvers) {
        for (const std::uint64_t bodies : {101U, 102U, 150U, 400U}) {
            TestWorld test(weightless_by(solver));
            for (std::uint64_t i = 0; i < bodies; ++i)
                test.add(SphereShape{.radius_m = 0.25_r}, {0, 1, 0});
            test.world.step();
            if (solver == Solver::SmallStep) {
                EXPECT_EQ(test.world.report().cost.pairs, kept_of(bodies));
            }
            EXPECT_EQ(test.world.report().cost.contacts, kept_of(bodies)) << solver_name(solver);
            EXPECT_EQ(left_out(test.world), bodies * (bodies - 1) / 2 - kept_of(bodies));
        }
    }
}

/// Uneven places in a row that is shorter than its balls: all overlap, no two distances are equal.
double place_m(int i) {
    return 1e-3 * i + 1e-6 * i * i;
}

std::set<Marks> nearest_in_row(int balls) {
    std::set<Marks> pairs;
    for (int i = 0; i < balls; ++i) {
        std::vector<std::pair<double, int>> others;
        for (int k = 0; k < balls; ++k) {
            if (k != i) others.emplace_back(std::abs(place_m(k) - place_m(i)), k);
        }
        std::sort(others.begin(), others.end());
        for (std::size_t n = 0; n < kNear; ++n)
            pairs.insert(std::minmax<std::uint64_t>(static_cast<std::uint64_t>(i),
                                                    static_cast<std::uint64_t>(others[n].second)));
    }
    return pairs;
}

TEST(NearestPairs, AreTheSameInWhateverOrderBodiesAreMade) {
    constexpr int kBalls = 150;
    const std::set<Marks> expected = nearest_in_row(kBalls);
    for (const int stride : {1, 149, 67}) {  // each has no divisor in common with 150
        TestWorld test(weightless());
        for (int i = 0; i < kBalls; ++i) {
            const int mark = i * stride % kBalls;
            test.add(SphereShape{.radius_m = 1},
                     {static_cast<Real>(place_m(mark)), 0, 0},
                     {.kind = BodyKind::Dynamic, .user = static_cast<std::uint64_t>(mark)});
        }
        test.world.step();
        EXPECT_EQ(touching_marks(test.world), expected) << "every " << stride << "th";
    }
}

/// Pairs of balls of which one has the other among its nearest, if all overlap.
std::set<Marks> nearest_by_places(const TestWorld& test, const std::vector<BodyId>& balls) {
    std::set<Marks> pairs;
    for (std::size_t i = 0; i < balls.size(); ++i) {
        std::vector<std::pair<Real, std::size_t>> others;
        const Vec3 here = test.world.state(balls[i]).world_from_body.position;
        for (std::size_t k = 0; k < balls.size(); ++k) {
            const Vec3 there = test.world.state(balls[k]).world_from_body.position;
            if (k != i) others.emplace_back(glm::distance(here, there), k);
        }
        std::sort(others.begin(), others.end());
        for (std::size_t n = 0; n < kNear; ++n)
            pairs.insert(std::minmax<std::uint64_t>(i, others[n].second));
    }
    return pairs;
}

/// Where a ball of a swarm is: nearer to all others than a diameter, and 3 mm farther each step, so that
/// most boxes stay within their margins and the broad phase has nothing to report.
Vec3 swarm_place(std::size_t ball, int step) {
    const double phase = 1.7 * static_cast<double>(ball) + 0.01 * step;
    return Vec3{Vec3d{0.3 * std::sin(phase), 0.3 * std::cos(2.3 * phase), 0}};
}

TEST(NearestPairs, AreChosenAnewInEachStep) {
    for (const Solver solver : {Solver::SmallStep, Solver::BulletSi}) {
        TestWorld test(weightless_by(solver));
        std::vector<BodyId> balls;
        for (std::size_t i = 0; i < 300; ++i)
            balls.push_back(test.add(SphereShape{.radius_m = 1},
                                     swarm_place(i, 0),
                                     {.kind = BodyKind::Dynamic, .user = i}));
        std::set<Marks> last;
        for (int step = 0; step < 10; ++step) {
            for (std::size_t i = 0; i < balls.size(); ++i) {
                test.world.set_pose(balls[i], {.position = swarm_place(i, step)});
                test.world.set_velocity(balls[i], {0, 0, 0}, {0, 0, 0});
            }
            const std::set<Marks> expected = nearest_by_places(test, balls);
            EXPECT_NE(expected, last);
            last = expected;
            test.world.step();
            EXPECT_EQ(touching_marks(test.world), expected) << solver_name(solver) << step;
            EXPECT_EQ(left_out(test.world), 300 * 299 / 2 - expected.size());
        }
    }
}

struct BallsOnASpot {
    explicit BallsOnASpot(int count, Solver solver = Solver::SmallStep)
        : test(weightless_by(solver)) {
        for (int i = 0; i < count; ++i)
            balls.push_back(test.add(SphereShape{.radius_m = 0.25_r}, {0, 1, 0}));
    }
    TestWorld test;
    std::vector<BodyId> balls;
};

void load_from(PhysicsWorld& saved, PhysicsWorld& other) {
    Archive out;
    saved.serialize(out);
    Archive in(out.written());
    other.serialize(in);
    ASSERT_FALSE(in.failed()) << in.fault();
}

TEST(NearestPairs, OfASavedWorldAreTheSame) {
    for (const Solver solver : {Solver::SmallStep, Solver::BulletSi}) {
        BallsOnASpot crowd(250, solver);
        BallsOnASpot loaded(250, solver);
        crowd.test.world.step();
        EXPECT_GT(left_out(crowd.test.world), 0U);
        load_from(crowd.test.world, loaded.test.world);
        for (int i = 0; i < 10; ++i) {
            crowd.test.world.step();
            loaded.test.world.step();
            EXPECT_EQ(left_out(loaded.test.world), left_out(crowd.test.world));
            EXPECT_EQ(loaded.test.hash(loaded.balls), crowd.test.hash(crowd.balls))
                << solver_name(solver) << i;
        }
    }
}

TEST(NearestPairs, OfACrowdThatHasGoneAreAllThatAreLeft) {
    for (const Solver solver : {Solver::SmallStep, Solver::BulletSi}) {
        BallsOnASpot crowd(300, solver);
        BallsOnASpot loaded(300, solver);
        crowd.test.world.step();
        load_from(crowd.test.world, loaded.test.world);
        for (BallsOnASpot* each : {&crowd, &loaded}) {
            for (std::size_t i = 0; i < 250; ++i) each->test.world.destroy_body(each->balls[i]);
            each->test.world.step();
            EXPECT_EQ(each->test.world.report().cost.contacts, 50U * 49U / 2U)
                << solver_name(solver);
            EXPECT_EQ(left_out(each->test.world), 0U);
        }
    }
}

TEST(NearestPairs, OfAHeapTooLargeForAMatrixAreSwept) {
    for (const Solver solver : {Solver::BulletDantzig, Solver::BulletPgs}) {
        BallsOnASpot few(15, solver);
        few.test.world.step();
        EXPECT_EQ(few.test.world.report().cost.interventions.oversized_islands, 0U);
        BallsOnASpot many(1000, solver);
        many.test.world.step();
        EXPECT_EQ(many.test.world.report().cost.interventions.oversized_islands, 1U);
        EXPECT_GT(many.test.world.report().cost.row_solves, 0U);
        EXPECT_TRUE(many.test.world.report().isolated.empty());
    }
}

/// So many rows of ten boxes, 0.3 m wide and 0.4 m apart, on what is `top_m` high.
void add_boxes(TestWorld& test, int rows, Real left_m, Real top_m) {
    for (int row = 0; row < rows; ++row) {
        for (int i = 0; i < 10; ++i) {
            const Vec3 at{left_m + 0.4_r * static_cast<Real>(row),
                          top_m + 0.15_r,
                          0.4_r * static_cast<Real>(i) - 1.8_r};
            test.add(BoxShape{.size_m = {0.3_r, 0.3_r, 0.3_r}}, at);
        }
    }
}

TEST(NearestPairs, OfAPlateAreAllTheBoxesThatItCarries) {
    TestWorld test;
    test.ground();
    test.add(BoxShape{.size_m = {8, 0.2_r, 4}},
             {0, 0.1_r, 0},
             {.kind = BodyKind::Dynamic, .mass_kg = 100});
    add_boxes(test, 20, -3.8_r, 0.2_r);
    test.run(0.25);
    EXPECT_EQ(left_out(test.world), 0U);
    EXPECT_EQ(all_contacts(test.world).size(), 201U) << "with the ground";
}

// Farther apart than any box is from the middle of its plate.
TEST(NearestPairs, OfTwoLadenPlatesAreThePlatesThemselves) {
    TestWorld test;
    test.ground();
    const BodyDef heavy{.kind = BodyKind::Dynamic, .mass_kg = 100};
    test.add(BoxShape{.size_m = {20, 0.2_r, 4}}, {0, 0.1_r, 0}, heavy);
    const BodyId upper = test.add(BoxShape{.size_m = {8, 0.2_r, 4}}, {-5, 0.3_r, 0}, heavy);
    add_boxes(test, 11, 0.2_r, 0.2_r);
    add_boxes(test, 11, -6.8_r, 0.4_r);
    test.run(0.25);
    EXPECT_EQ(left_out(test.world), 0U);
    EXPECT_NEAR(test.at(upper).y, 0.3, 1e-3);
}

}  // namespace
}  // namespace plumbline::physics
