// Stock Bullet was measured on the same scenes by others: our copies of the scenes and our Bullet must
// give their figures.
#include "engine/core/io/files.h"
#include "engine/study/scenarios/families/tops.h"
#include "engine/study/scenarios/scenario.h"
#include "engine/study/scenarios/world/peer_scene.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

namespace plumbline::study {

namespace {

constexpr Setting kStockBullet{
    .solver = physics::Solver::BulletSi, .step_hz = 60, .substeps = 1, .iterations = 10};

/// Fields of the lines of a table of assets/data, without its comments.
std::vector<std::vector<std::string>> table_of(const char* file) {
    const Result<std::string> csv =
        read_file(std::filesystem::path("assets/data") / file, std::size_t{1} << 24U);
    EXPECT_TRUE(csv);
    std::vector<std::vector<std::string>> rows;
    std::istringstream lines(*csv);
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with('#')) continue;
        std::istringstream fields(line);
        rows.emplace_back();
        for (std::string field; std::getline(fields, field, ',');) rows.back().push_back(field);
    }
    return rows;
}

/// The first metric's error of stock Bullet at 60 Hz, as the others measured it.
double their_error(const Scenario& scenario) {
    static const auto kMeanings = table_of("peer_metrics.csv");
    static const auto kFigures = table_of("peers.csv");
    for (const std::vector<std::string>& meaning : kMeanings) {
        if (meaning[0] != scenario.peer_scene || meaning[2] != scenario.metrics.front().name)
            continue;
        for (const std::vector<std::string>& row : kFigures) {
            if (row[0] == meaning[0] && row[1] == "bullet32" && row[2] == "1" &&
                row[5] == meaning[1])
                return std::abs(std::stod(row[6])) * std::stod(meaning[3]);
        }
    }
    ADD_FAILURE() << scenario.id << " has no comparable figure";
    return 0;
}

double our_error(const Scenario& scenario) {
    Stepper stepper(Stepper::Mode::Errors, kStockBullet);
    return std::abs(scenario.run(stepper).front());
}

const Scenario& peer_scene(const std::string& name) {
    static const std::vector<Scenario> all = peer_scenes_family();
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
    const std::vector<Scenario> all = peer_scenes_family();
    ASSERT_FALSE(all.empty());
    for (const Scenario& scenario : all) EXPECT_GT(their_error(scenario), 0) << scenario.id;
}

std::unique_ptr<PeerScene> opened(const std::string& name) {
    auto scene = PeerScene::open(name, {});
    EXPECT_TRUE(scene.ok()) << scene.error().message;
    return scene ? std::move(*scene) : nullptr;
}

physics::MassProperties mass_of(const PeerScene& scene, std::string_view entity) {
    return scene.world.physics.state(scene.body(entity)).mass;
}

TEST(PeerScenes, AreWhatTheirLawsSuppose) {
    const auto bounce = opened("bounce");
    EXPECT_EQ(bounce->world.at(bounce->body("ball")), (Vec3d{0, 10.5, 0}));
    const auto slide = opened("slideroll");
    EXPECT_EQ(slide->world.velocity(slide->body("ball")), (Vec3d{5, 0, 0}));
    for (const scene::EntityDescription& entity : slide->description().entities)
        EXPECT_EQ(entity.body->friction, 0.3_r) << entity.name;
    const auto top = opened("dzhani");
    const FreeBodyDef handle = t_handle();
    EXPECT_EQ(top->world.spin(top->body("handle")), Vec3d(Vec3(handle.spin_radps)));
    EXPECT_EQ(mass_of(*top, "handle").inertia_kgm2, Vec3(*handle.inertia_kgm2));
    EXPECT_NEAR(static_cast<double>(mass_of(*top, "handle").mass_kg), handle.mass_kg, 1e-5);
    for (const int ratio : {100, 1000}) {
        const auto heavy = opened("heavy" + std::to_string(ratio));
        EXPECT_EQ(mass_of(*heavy, "upper").mass_kg,
                  static_cast<Real>(ratio) * mass_of(*heavy, "lower").mass_kg);
        EXPECT_EQ(heavy->world.at(heavy->body("upper")), (Vec3d{0, 1.5, 0}));
    }
    for (const auto& [name, end_m] :
         {std::pair{"chainh", Vec3d{20.25, 30, 0}}, std::pair{"chainv", Vec3d{0, 9.75, 0}}}) {
        const auto chain = opened(name);
        ASSERT_EQ(chain->world.movers.size(), 51U);
        EXPECT_EQ(chain->world.movers.back(), chain->body("ball"));
        EXPECT_LT(glm::distance(chain->world.at(chain->body("ball")), end_m), 1e-5);
        EXPECT_EQ(mass_of(*chain, "ball").mass_kg, Real{100});
    }
}

TEST(PeerScenes, OneThatIsNotThereIsRefusedAndSaysSo) {
    const auto none = PeerScene::open("none", {});
    ASSERT_FALSE(none.ok());
    EXPECT_NE(none.error().message.find("none.toml"), std::string::npos) << none.error().message;
    const Scenario lost{.id = "P none",
                        .metrics = {{"a number", "1"}},
                        .run = [&](Stepper& stepper) { return stepper.refuse(none.error()); }};
    const Point point = run_scenario(lost, {}, {.wanted = 1, .budget_s = 0});
    EXPECT_EQ(point.status, RunStatus::Refused);
    EXPECT_EQ(point.why, none.error().message);
}

TEST(PeerScenes, AChainThatIsSolvedDirectlyDoesNotStretch) {
    Stepper stepper(Stepper::Mode::Errors, {.substeps = 4});
    EXPECT_LT(peer_scene("chainv").run(stepper).front(), 1e-5);
}

}  // namespace

}  // namespace plumbline::study
