// What a stranger may have written into a world's fields is refused by name before a step runs.
#include "engine/core/io/pose_archive.h"
#include "tests/engine/physics/test_world.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <functional>

namespace plumbline::physics {
namespace {

/// Two boxes on a rod, one of which moves with speeds that nothing else has.
struct Rod {
    TestWorld test{weightless()};
    JointId joint{};

    Rod() {
        const BodyId a = test.add(
            BoxShape{}, {0, 5, 0}, {.kind = BodyKind::Dynamic, .velocity_mps = {1.0625_r, 0, 0}});
        const BodyId b = test.add(BoxShape{}, {3, 5, 0});
        test.add(BoxShape{}, {9, 5, 0});
        joint = *test.world.create_joint({.kind = JointKind::BallAndSocket,
                                          .a = a,
                                          .b = b,
                                          .anchor_a_world = {1.53125_r, 5, 0},
                                          .anchor_b_world = {1.53125_r, 5, 0}});
    }
};

std::string fields_of(PhysicsWorld& world) {
    Archive out;
    world.serialize(out);
    return out.take();
}

std::string bytes_of(double number) {
    Archive out;
    out(number);
    return out.take();
}

/// What is said to the fields after `change`; then the world still lives, and is thrown away.
std::string fault_after(const std::function<void(std::string&)>& change) {
    Rod there;
    std::string fields = fields_of(there.test.world);
    change(fields);
    Rod here;
    Archive in(fields);
    here.test.world.serialize(in);
    if (!in.failed()) here.test.run(0.1);
    return in.fault();
}

std::size_t place_of(const std::string& fields, double number) {
    const std::size_t at = fields.find(bytes_of(number));
    EXPECT_NE(at, std::string::npos) << number;
    return at;
}

/// The fault where `number` is another in all places.
std::string fault_with(double number, double other) {
    return fault_after([&](std::string& fields) {
        for (std::size_t at = place_of(fields, number); at != std::string::npos;
             at = fields.find(bytes_of(number), at + 8))
            fields.replace(at, 8, bytes_of(other));
    });
}

TEST(Restored, ItselfIsTaken) {
    EXPECT_EQ(fault_after([](std::string&) {}), "");
}

TEST(Restored, NumbersThatAreNoneOrTooLargeAreRefused) {
    EXPECT_EQ(fault_with(1.0625, std::nan("")), "a number is not finite");
    EXPECT_EQ(fault_with(1.0625, INFINITY), "a number is not finite");
    EXPECT_EQ(fault_with(1.0625, 1e12), "body 0: it moves as nothing can");
    EXPECT_EQ(fault_with(9, 1e12), "body 2: it moves as nothing can");
}

TEST(Restored, JointsAreThoseOfTheirBodiesAndOfOneKind) {
    // Its kind stands before both ids, of eight bytes each, and the anchor.
    const auto kind = [](char other) {
        return fault_after([other](std::string& fields) {
            fields[place_of(fields, 1.53125) - 2 * 8 - 1] = other;
        });
    };
    EXPECT_EQ(kind(9), "a choice is none of those there are");
    EXPECT_EQ(kind(static_cast<char>(JointKind::Fixed)), "joint 0: it is solved as another");
    const auto first_body = [](char other) {
        return fault_after(
            [other](std::string& fields) { fields[place_of(fields, 1.53125) - 2 * 8] = other; });
    };
    EXPECT_EQ(first_body(2), "body 0: its joints are not those that hold it");
    EXPECT_EQ(first_body(1), "body 0: its joints are not those that hold it");
    EXPECT_EQ(first_body(7), "its bodies are not those of this scene");
    EXPECT_EQ(fault_with(1.53125, 1e12), "joint 0: its numbers are out of range");
}

TEST(Restored, ListsThatNameABodyTwiceAreRefused) {
    // The broad phase's order, by the places of its three bodies.
    const std::string order("\x03\0\0\0\0\0\0\0\0\0\0\0\x01\0\0\0\x02\0\0\0", 20);
    const auto with_third = [&](char third) {
        return fault_after([&](std::string& fields) {
            const std::size_t at = fields.find(order);
            ASSERT_NE(at, std::string::npos);
            fields[at + 16] = third;
        });
    };
    EXPECT_EQ(with_third(2), "");
    EXPECT_EQ(with_third(1), "its broad phase has other bodies");
    EXPECT_EQ(with_third(3), "its broad phase has other bodies");
}

// Every field in turn becomes what no field should be: none may end the program.
TEST(Restored, NoFieldEndsTheProgram) {
    for (const Solver solver : {Solver::SmallStep, Solver::BulletSi}) {
        const auto make = [solver](TestWorld& test) {
            test.ground();
            for (int i = 0; i < 3; ++i) test.add(BoxShape{}, {0, 0.5_r + static_cast<Real>(i), 0});
            test.add(CylinderShape{.radius_m = 0.5_r, .height_m = 1}, {3, 0.5_r, 0});
        };
        const WorldDef def{.iterations = 4, .solver = solver};
        TestWorld there(def);
        make(there);
        there.run(solver == Solver::SmallStep ? 0.3 : 0.2);
        const std::string fields = fields_of(there.world);
        const std::size_t stride = 1 + fields.size() / 600;
        std::size_t refused = 0;
        std::size_t tried = 0;
        for (std::size_t at = 0; at + 4 < fields.size(); at += stride) {
            std::string mutant = fields;
            mutant.replace(at, 4, at % 2 == 0 ? "\xff\xff\xff\xff" : "\x7f\xff\xff\x80", 4);
            TestWorld here(def);
            make(here);
            Archive in(mutant);
            here.world.serialize(in);
            ++tried;
            if (in.failed()) ++refused;
            here.run(0.04);
        }
        EXPECT_GT(refused, tried / 5) << solver_name(solver);
    }
}

}  // namespace
}  // namespace plumbline::physics
