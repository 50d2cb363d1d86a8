#include "engine/app/accuracy/study_diagram.h"

#include <gtest/gtest.h>

#include <cmath>

namespace plumbline::app {
namespace {

study::Point point(double ms_a_frame, double error) {
    return {.errors = {error}, .cost = {.ms_per_s_min = 60 * ms_a_frame, .repeats = 1}};
}

TEST(StudyDiagram, AxesEndAtPowersOfTenRoundAllPoints) {
    const std::vector<study::Point> points{point(0.2, 0.05), point(3, 0.002)};
    const StudyDiagram diagram = diagram_of(points);
    EXPECT_EQ(diagram.ms.least_decade, -1);
    EXPECT_EQ(diagram.ms.most_decade, 1);
    EXPECT_EQ(diagram.error.least_decade, -3);
    EXPECT_EQ(diagram.error.most_decade, -1);
    EXPECT_NEAR(diagram.ms.place_of(1), 0.5, 1e-6);
    EXPECT_EQ(diagram.ms.place_of(100), 1) << "on the end";
    EXPECT_EQ(diagram.ms.place_of(0), 0);
    ASSERT_EQ(diagram.points.size(), 2U);
    EXPECT_NEAR(diagram.points[0].place.x, (std::log10(0.2) + 1) / 2, 1e-6);
    EXPECT_NEAR(diagram.points[0].place.y, (std::log10(0.05) + 3) / 2, 1e-6);
}

TEST(StudyDiagram, ShowsPointsWithAnErrorAndWhatNoOtherBeats) {
    std::vector<study::Point> points{point(1, 0.1), point(2, 0.2), point(3, 0.01), point(4, 0)};
    points.push_back({.status = study::RunStatus::Exploded});
    const StudyDiagram diagram = diagram_of(points);
    ASSERT_EQ(diagram.points.size(), 4U);
    EXPECT_EQ(diagram.points[3].of, 3U);
    EXPECT_EQ(diagram.points[3].place.y, 0) << "no error lies at the lower end";
    ASSERT_EQ(diagram.front.size(), 3U) << "the second is beaten";
    EXPECT_LT(diagram.front[0].x, diagram.front[1].x);
    EXPECT_TRUE(diagram_of({}).points.empty());
}

TEST(StudyDiagram, ThePointerFindsTheNearestWithinReach) {
    const std::vector<study::Point> points{point(1, 0.1), point(1.2, 0.1), point(10, 0.001)};
    const StudyDiagram diagram = diagram_of(points);
    const Vec2f size{400, 200};
    const Vec2f at = diagram.points[1].place + Vec2f{3, -2} / size;
    EXPECT_EQ(point_at(diagram, at, size, 8), 1U);
    EXPECT_EQ(point_at(diagram, at, size, 2), std::nullopt);
    EXPECT_EQ(point_at(diagram, {0, 0}, size, 8), std::nullopt);
}

}  // namespace
}  // namespace plumbline::app
