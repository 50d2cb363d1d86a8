// Stock Bullet was measured on the same scenes by others: our copies of the scenes and our Bullet must
// give their figures.
#include "engine/core/io/files.h"
#include "engine/study/report/peers.h"
#include "engine/study/scenarios/scenario.h"

#include <gtest/gtest.h>

namespace plumbline::study {

namespace {

constexpr Setting kStockBullet{
    .solver = physics::Solver::BulletSi, .step_hz = 60, .substeps = 1, .iterations = 10};

/// The first metric's error of stock Bullet at 60 Hz, as the others measured it.
double their_error(const Scenario& scenario) {
    const auto csv = read_file("assets/data/peers.csv", std::size_t{1} << 24U);
    EXPECT_TRUE(csv);
    const auto rows = parse_peers(*csv);
    EXPECT_TRUE(rows);
    for (const PeerPoint& peer :
         comparable_peers(*rows, scenario.peer_scene, scenario.metrics.front().name)) {
        if (peer.engine == "bullet32" && peer.substeps == 1) return peer.error;
    }
    ADD_FAILURE() << scenario.id << " has no comparable figure";
    return 0;
}

double our_error(const Scenario& scenario) {
    Course course(Course::Mode::Looked);
    return std::abs(scenario.run(kStockBullet, course).front());
}

const Scenario& peer_scene(const std::string& name) {
    static const std::vector<Scenario> all = [] {
        std::vector<Scenario> made;
        add_peer_scenes(made);
        return made;
    }();
    for (const Scenario& scenario : all) {
        if (scenario.peer_scene == name) return scenario;
    }
    ADD_FAILURE() << name;
    return all.front();
}

TEST(PeerScenes, StockBulletDoesHereWhatItDidElsewhere) {
    for (const char* name : {"chainv", "slideroll"}) {
        const Scenario& scenario = peer_scene(name);
        const double theirs = their_error(scenario);
        EXPECT_NEAR(our_error(scenario) / theirs, 1, 0.01) << name << " theirs " << theirs;
    }
}

TEST(PeerScenes, EveryOneHasFiguresToCompareWith) {
    std::vector<Scenario> all;
    add_peer_scenes(all);
    ASSERT_FALSE(all.empty());
    for (const Scenario& scenario : all) EXPECT_GT(their_error(scenario), 0) << scenario.id;
}

TEST(PeerScenes, AChainThatIsSolvedDirectlyDoesNotStretch) {
    Course course(Course::Mode::Looked);
    EXPECT_LT(peer_scene("chainv").run({.substeps = 4}, course).front(), 1e-5);
}

}  // namespace

}  // namespace plumbline::study
