// Every pair of kinds in random poses, against an optimiser of its own and against symmetries.
#include "tests/engine/physics/collision/narrow_phase/convex_rig.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <optional>
#include <string>

namespace plumbline::physics {
namespace {

using namespace convex_rig;

constexpr double kPairReach_m = 0.1;
/// Of the smaller shape's size: how far beside a face its points may lie, how far above the deepest the others.
constexpr double kBeside = 1.5e-4;
constexpr double kPairLevel = 2.1e-4;

/// Poses for each pair; PLUMBLINE_CONVEX_POSES asks for more.
int poses(int usual) {
    const char* wanted = std::getenv("PLUMBLINE_CONVEX_POSES");
    return wanted != nullptr ? std::atoi(wanted) : usual;
}

struct Placed {
    PlacedConvex a;
    PlacedConvex b;
};

/// Near each other: along a random direction they overlap by up to 0.3 m or are up to 0.02 m apart.
Placed random_pair(const Solid& a, const Solid& b, Random& random) {
    const Vec3d direction = random_direction(random);
    Placed pair{placed(a, random_turn(random), {0, 0, 0}),
                placed(b, random_turn(random), {0, 0, 0})};
    const double gap_m = random.uniform(-0.3F, 0.02F);
    pair.a.center_m = direction * (gap_m - gap_along(pair.a, pair.b, direction));
    return pair;
}

template <class Check>
void for_each_pair(int count, std::uint64_t seed, const Check& check) {
    Random random(seed);
    const std::vector<Solid>& solids = catalogue();
    for (std::size_t i = 0; i < solids.size(); ++i) {
        for (std::size_t k = i; k < solids.size(); ++k) {
            SCOPED_TRACE(solids[i].name + " and " + solids[k].name);
            for (int pose = 0; pose < count; ++pose) {
                check(random_pair(solids[i], solids[k], random));
                if (testing::Test::HasFailure()) {
                    ADD_FAILURE() << "pose " << pose;
                    return;
                }
            }
        }
    }
}

double size_of(const Placed& pair) {
    return std::min(physics::size_of(pair.a), physics::size_of(pair.b));
}

TEST(ConvexPairs, TheDistanceIsThatAlongTheNormalAndOfTheNearestPoints) {
    for_each_pair(poses(2000), 1, [](const Placed& pair) {
        const auto found = separation_of(pair.a, pair.b, 10);
        ASSERT_TRUE(found);
        ASSERT_NEAR(glm::length(found->normal), 1, 1e-9);
        ASSERT_NEAR(found->distance_m, gap_along(pair.a, pair.b, found->normal), 1e-6);
        // Nowhere are they nearer than the gap along any direction, so points as far apart as a gap prove both.
        const Vec3d on_a = found->on_a - found->normal * pair.a.radius_m;
        const Vec3d on_b = found->on_b + found->normal * pair.b.radius_m;
        if (found->distance_m > 0) {
            ASSERT_NEAR(glm::distance(on_a, on_b), found->distance_m, 1e-6);
        }
        ASSERT_NEAR(height_over(pair.a, on_a), 0, 2e-6);
        ASSERT_NEAR(height_over(pair.b, on_b), 0, 2e-6);
    });
}

TEST(ConvexPairs, NoDirectionPartsOverlappingShapesMoreEasily) {
    for_each_pair(poses(40), 2, [](const Placed& pair) {
        const auto found = separation_of(pair.a, pair.b, 10);
        ASSERT_TRUE(found);
        if (found->distance_m > 0) return;
        const Direction near = climbed(pair.a, pair.b, found->normal, 1e-3);
        const Direction far = widest_gap(pair.a, pair.b, 500, 6);
        ASSERT_LE(near.gap_m, found->distance_m + 1e-6);
        ASSERT_LE(far.gap_m, found->distance_m + 1e-6);
        const bool is_the_same = glm::dot(far.normal, found->normal) > 0.9;
        if (is_the_same && far.gap_m > found->distance_m - 1e-9) {
            ASSERT_NEAR(glm::distance(far.normal, found->normal), 0, 2e-2);
        }
    });
}

/// How far off a surface a point may lie: of a capsule that leans, also because the normal is not across its axis.
double beside_m(const PlacedConvex& convex, const Vec3d& normal, double size_m) {
    const double lean = glm::dot(convex.axes[1], normal);
    return kBeside * size_m + convex.radius_m * (1 - std::sqrt(std::max(1 - lean * lean, 0.0)));
}

TEST(ConvexPairs, AContactLiesOnBothSurfacesAndHasTheDeepestPoint) {
    int contacts = 0;
    for_each_pair(poses(2000), 3, [&](const Placed& pair) {
        const auto separation = separation_of(pair.a, pair.b, 10);
        const auto found = contact_of(pair.a, pair.b, kPairReach_m);
        ASSERT_EQ(found.has_value(), separation->distance_m <= kPairReach_m);
        if (!found) return;
        ++contacts;
        const double size_m = size_of(pair);
        ASSERT_NEAR(found->separation.distance_m, separation->distance_m, 2e-6 * size_m);
        ASSERT_NEAR(found->separation.distance_m,
                    gap_along(pair.a, pair.b, found->separation.normal),
                    1e-6);
        const Vec3d& normal = found->separation.normal;
        ASSERT_GE(found->contact.count, 1U);
        double least_m = kPairReach_m;
        for (std::size_t i = 0; i < found->contact.count; ++i) {
            const RegionPoint& point = found->contact.points[i];
            ASSERT_NEAR(
                height_over(pair.a, point.on_a), 0, 1e-5 + beside_m(pair.a, normal, size_m));
            ASSERT_NEAR(
                height_over(pair.b, point.on_b), 0, 1e-5 + beside_m(pair.b, normal, size_m));
            ASSERT_NEAR(glm::dot(point.on_a - point.on_b, normal), point.distance_m, 2e-6);
            ASSERT_LE(point.distance_m, kPairReach_m);
            least_m = std::min(least_m, point.distance_m);
        }
        ASSERT_GE(least_m, found->separation.distance_m - 1e-6 - kBeside * size_m);
        ASSERT_LE(least_m, found->separation.distance_m + kPairLevel * size_m);
    });
    EXPECT_GT(contacts, 100);
}

/// Whether both have the same points, in any order.
bool same_points(const SurfaceContact& found, const SurfaceContact& wanted, double near_m) {
    if (found.count != wanted.count) return false;
    for (std::size_t i = 0; i < found.count; ++i) {
        bool is_there = false;
        for (std::size_t k = 0; k < wanted.count; ++k) {
            is_there |= glm::distance(found.points[i].on_a, wanted.points[k].on_a) < near_m &&
                        glm::distance(found.points[i].on_b, wanted.points[k].on_b) < near_m;
        }
        if (!is_there) return false;
    }
    return true;
}

/// Compares the contacts of pairs with those of the same pairs seen another way. Where two directions are as good
/// as each other, or two sets of points, rounding decides: that is rare.
class Seen {
public:
    template <class Change, class Back>
    void compare(const Placed& pair, const Change& change, const Back& back) {
        const auto wanted = contact_of(pair.a, pair.b, kPairReach_m);
        const Placed changed = change(pair);
        auto found = contact_of(changed.a, changed.b, kPairReach_m);
        ASSERT_EQ(found.has_value(), wanted.has_value());
        if (!found) return;
        ++count_;
        ASSERT_NEAR(found->separation.distance_m, wanted->separation.distance_m, 2e-6);
        back(*found);
        const double off = glm::distance(found->separation.normal, wanted->separation.normal);
        if (off > 1e-4 || !same_points(found->contact, wanted->contact, 2e-4)) ++differ_;
    }
    ~Seen() {
        EXPECT_GT(count_, 100);
        EXPECT_LE(differ_, count_ / 200) << "of " << count_;
    }
    Seen() = default;
    Seen(const Seen&) = delete;
    Seen& operator=(const Seen&) = delete;

private:
    int count_{0};
    int differ_{0};
};

TEST(ConvexPairs, TheOrderOfTheShapesDoesNotMatter) {
    Seen seen;
    for_each_pair(poses(500), 4, [&](const Placed& pair) {
        seen.compare(
            pair,
            [](const Placed& p) {
                return Placed{p.b, p.a};
            },
            [](ConvexPair& found) {
                found.separation.normal = -found.separation.normal;
                for (RegionPoint& point : found.contact.points) std::swap(point.on_a, point.on_b);
            });
    });
}

TEST(ConvexPairs, AWorldMovedAndTurnedHasTheSameContacts) {
    Seen seen;
    Random random(9);
    const Vec3d moved_m{100, -50, 30};
    for_each_pair(poses(500), 5, [&](const Placed& pair) {
        const glm::dmat3 turn = random_turn(random);
        const glm::dmat3 back = glm::transpose(turn);
        seen.compare(
            pair,
            [&](Placed p) {
                for (PlacedConvex* convex : {&p.a, &p.b}) {
                    convex->axes = turn * convex->axes;
                    convex->center_m = turn * convex->center_m + moved_m;
                }
                return p;
            },
            [&](ConvexPair& found) {
                found.separation.normal = back * found.separation.normal;
                for (RegionPoint& point : found.contact.points) {
                    point.on_a = back * (point.on_a - moved_m);
                    point.on_b = back * (point.on_b - moved_m);
                }
            });
    });
}

TEST(ConvexPairs, AWorldInAMirrorHasTheSameContacts) {
    Seen seen;
    const glm::dmat3 mirror{-1, 0, 0, 0, 1, 0, 0, 0, 1};
    for_each_pair(poses(500), 6, [&](const Placed& pair) {
        // Hulls are their own mirror image only with their corners; the others, turned back.
        if (pair.a.shape->kind == Kind::Hull || pair.b.shape->kind == Kind::Hull) return;
        seen.compare(
            pair,
            [&](Placed p) {
                for (PlacedConvex* convex : {&p.a, &p.b}) {
                    convex->axes = mirror * convex->axes * mirror;
                    convex->center_m = mirror * convex->center_m;
                }
                return p;
            },
            [&](ConvexPair& found) {
                found.separation.normal = mirror * found.separation.normal;
                for (RegionPoint& point : found.contact.points) {
                    point.on_a = mirror * point.on_a;
                    point.on_b = mirror * point.on_b;
                }
            });
    });
}

}  // namespace
}  // namespace plumbline::physics
