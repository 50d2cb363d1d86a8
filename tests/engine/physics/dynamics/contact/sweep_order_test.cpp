// Which constraints may be solved at once.
#include "engine/physics/dynamics/contact/sweep_order.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <set>
#include <vector>

namespace plumbline::physics {
namespace {

/// Bodies after the world's own, which nothing moves.
std::vector<SolverBody> movable_bodies(std::size_t count) {
    std::vector<SolverBody> bodies(count + 1);
    for (std::size_t i = 1; i < bodies.size(); ++i) bodies[i].inverse_mass = 1;
    return bodies;
}

/// A wall of rows, each brick touches the next and the one above; the first row stands on the ground.
struct Wall {
    std::vector<SolverBody> bodies;
    std::vector<ContactConstraint> constraints;

    Wall(std::uint32_t columns, std::uint32_t rows) : bodies(movable_bodies(columns * rows)) {
        for (std::uint32_t i = 1; i < bodies.size(); ++i) {
            if (i <= columns) constraints.push_back({.a = i, .b = kWorldBody});
            if (i % columns != 0) constraints.push_back({.a = i, .b = i + 1});
            if (i + columns < bodies.size()) constraints.push_back({.a = i, .b = i + columns});
        }
    }
};

void expect_each_once(const SweepOrder& order, const std::vector<ContactConstraint>& constraints) {
    std::vector<int> visits(constraints.size(), 0);
    std::vector<int> homes(constraints.size(), 0);
    for (std::size_t stage = 0; stage < order.stages(); ++stage) {
        for (const auto& part : order.parts(stage)) {
            for (const SweepPlace& place : part) {
                ++visits[place.constraint];
                EXPECT_EQ(place.a, constraints[place.constraint].a);
                EXPECT_EQ(place.b, constraints[place.constraint].b);
            }
        }
    }
    for (std::size_t cell = 0; cell < order.cells(); ++cell) {
        order.each_part_of(cell, [&](std::span<const SweepPlace> part) {
            for (const SweepPlace& place : part) ++homes[place.constraint];
        });
    }
    EXPECT_EQ(visits, std::vector<int>(constraints.size(), 1));
    EXPECT_EQ(homes, std::vector<int>(constraints.size(), 1));
}

TEST(SweepOrder, FewAreOneCellInTheirOrderAndThoseOfTheGroundLast) {
    const Wall wall(8, 6);
    SweepOrder order;
    order.build(wall.constraints, wall.bodies);
    EXPECT_EQ(order.cells(), 1U);
    EXPECT_EQ(order.bodies_of(0).size(), wall.bodies.size());
    expect_each_once(order, wall.constraints);
    ASSERT_EQ(order.stages(), 2U);
    std::uint32_t last = 0;
    for (const SweepPlace& place : order.parts(0)[0]) {
        EXPECT_NE(place.b, kWorldBody);
        EXPECT_GE(place.constraint, last);
        last = place.constraint;
    }
    EXPECT_EQ(order.parts(1)[0].size(), 8U);
}

TEST(SweepOrder, PartsOfOneStageShareNoBodyThatMoves) {
    const Wall wall(50, 60);
    SweepOrder order;
    order.build(wall.constraints, wall.bodies);
    EXPECT_GE(order.cells(), 8U);
    expect_each_once(order, wall.constraints);
    for (std::size_t stage = 0; stage < order.stages(); ++stage) {
        std::set<std::uint32_t> of_others;
        for (const auto& part : order.parts(stage)) {
            std::set<std::uint32_t> own;
            for (const SweepPlace& place : part) {
                for (const std::uint32_t body : {place.a, place.b}) {
                    if (wall.bodies[body].movable()) own.insert(body);
                }
            }
            for (const std::uint32_t body : own) EXPECT_TRUE(of_others.insert(body).second) << body;
        }
    }
}

TEST(SweepOrder, CellsHaveEveryBodyOnceAndLeaveLittleBetweenThem) {
    const Wall wall(50, 60);
    SweepOrder order;
    order.build(wall.constraints, wall.bodies);
    std::vector<int> visits(wall.bodies.size(), 0);
    for (std::size_t cell = 0; cell < order.cells(); ++cell) {
        for (const std::uint32_t body : order.bodies_of(cell)) ++visits[body];
    }
    EXPECT_EQ(visits, std::vector<int>(wall.bodies.size(), 1));
    std::size_t within = 0;
    for (const auto& part : order.parts(0)) within += part.size();
    EXPECT_GT(within, wall.constraints.size() * 8 / 10);
}

TEST(SweepOrder, WhatIsTangledStaysOneCell) {
    const std::uint32_t count = 3000;
    const std::vector<SolverBody> bodies = movable_bodies(count);
    std::vector<ContactConstraint> constraints;  // each body meets two in the other half
    for (std::uint32_t i = 1; i <= count / 2; ++i) {
        for (const std::uint32_t step : {0U, 7U, 91U})
            constraints.push_back({.a = i, .b = count / 2 + 1 + (i * 13 + step) % (count / 2)});
    }
    SweepOrder order;
    order.build(constraints, bodies);
    EXPECT_EQ(order.cells(), 1U);
    expect_each_once(order, constraints);
}

}  // namespace
}  // namespace plumbline::physics
