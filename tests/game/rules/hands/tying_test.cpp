// Ropes tied, hung on, cut and taken back by a person.
#include "engine/scene/simulation/entity_lookup.h"
#include "engine/scene/simulation/simulation_archive.h"
#include "tests/game/rules/playground.h"

namespace plumbline::game {
namespace {

constexpr double kBeam_m = 3;
constexpr double kCrate_kg = 8;

/// A beam overhead, and a crate on a stool below it.
scene::SceneDescription gallows() {
    scene::SceneDescription scene = meadow();
    scene.entities.push_back(block("beam", {2, 0.2_r, 0.2_r}, {0, 3.1_r, -3}));
    scene.entities.push_back(
        block("stool", {0.3_r, 0.5_r, 0.3_r}, {0, 0.25_r, -3}, physics::BodyKind::Dynamic, 5));
    scene.entities.push_back(
        block("crate", {0.4_r, 0.4_r, 0.4_r}, {0, 0.7_r, -3}, physics::BodyKind::Dynamic, 8));
    return scene;
}

class Tied : public testing::Test {
protected:
    explicit Tied(const scene::SceneDescription& scene = gallows()) : play_(scene) {}

    /// The view turned so that it looks at a place, then the key.
    void press_at(const Vec3& point_m) {
        play_.step(play_.turn_to(point_m));
        play_.step(press({Action::Tie}));
    }
    void tie(const Vec3& from_m, const Vec3& to_m) {
        press_at(from_m);
        press_at(to_m);
    }
    const scene::Rope& rope() const { return play_.simulation->ropes().front(); }
    Real height_of(const std::string& name) const {
        return play_.state(name).world_from_body.position.y;
    }
    void hang_the_crate() {
        tie({0, 0.9_r, -2.95_r}, {0, 3.1_r, -2.9_r});
        ASSERT_EQ(play_.simulation->ropes().size(), 1U);
        destroy(*play_.simulation, play_.simulation->find("stool"));
        play_.run(4);
    }

    Playground play_;
};

TEST_F(Tied, HoldsWhatHangsOnIt) {
    hang_the_crate();
    EXPECT_EQ(play_.messages(),
              (std::vector<std::string>{"rope fixed here: now choose where its other end goes",
                                        "rope tied"}));
    // It reached from the crate's face to the beam, with a hundredth to spare, and does not stretch.
    const double tied_m = glm::distance(Vec3d{0, 0.9, -2.95}, Vec3d{0, kBeam_m + 0.1, -2.9});
    const std::vector<Vec3d> points = play_.simulation->points_of(rope());
    EXPECT_NEAR(scene::length_of(points), 1.01 * tied_m, 0.01);
    EXPECT_NEAR(glm::distance(points.front(), points.back()), 1.01 * tied_m, 0.01) << "taut";
    // It holds the crate, which swings: the mean over many swings is its weight.
    double sum_N = 0;
    constexpr int kSteps = 600;
    for (int i = 0; i < kSteps; ++i) {
        play_.step();
        sum_N += static_cast<double>(
            play_.simulation->physics.joint(rope().joints.front()).state.force_N);
    }
    EXPECT_NEAR(sum_N / kSteps, kCrate_kg * 9.81, 0.02 * kCrate_kg * 9.81);
}

TEST_F(Tied, ACutLetsItFall) {
    hang_the_crate();
    const Real hung_m = height_of("crate");
    ASSERT_GT(hung_m, 0.5_r);
    const std::vector<Vec3d> points = play_.simulation->points_of(rope());
    play_.messages();
    press_at(Vec3((points[points.size() / 2])));
    EXPECT_EQ(play_.messages(), std::vector<std::string>{"rope cut"});
    play_.run(2);
    EXPECT_NEAR(height_of("crate"), 0.2_r, 0.02_r) << "it lies on the ground";
    EXPECT_EQ(play_.simulation->ropes().size(), 1U) << "nothing was tied by the same press";
    // Both halves are there: one hangs from the beam.
    EXPECT_NEAR(play_.simulation->points_of(rope()).back().y, kBeam_m + 0.1, 0.12);
}

TEST_F(Tied, IsUndoneAsOneThing) {
    hang_the_crate();
    play_.step(press({Action::UndoDrop}));
    EXPECT_EQ(play_.thing_count(), 0U);
    play_.run(2);
    EXPECT_NEAR(height_of("crate"), 0.2_r, 0.02_r);
}

TEST_F(Tied, SaysWhyNot) {
    press_at({0, 0.7_r, -2.8_r});
    press_at({0, 0.75_r, -2.8_r});
    EXPECT_EQ(play_.messages().back(), "tie the other end to another object");
    press_at({0, 40, -3});
    EXPECT_EQ(play_.messages(), std::vector<std::string>{"rope put away"});
    press_at({0, 40, -3});
    EXPECT_EQ(play_.messages(), std::vector<std::string>{"nothing to tie a rope to"});
    tie({1, 0, -2}, {1.05_r, 0, -2});
    EXPECT_EQ(play_.messages().back(), "rope put away: too close to tie");
    press_at({0, 0.7_r, -2.8_r});
    destroy(*play_.simulation, play_.simulation->find("crate"));
    play_.step();
    press_at({0, 3.1_r, -2.9_r});
    EXPECT_EQ(play_.messages().back(), "rope fixed here: now choose where its other end goes")
        << "the first end went with the crate";
    EXPECT_TRUE(play_.simulation->ropes().empty());
}

// A step may remove the body before the image is drawn: it broke, or fell out of the world.
TEST_F(Tied, ARopeInHandIsNotDrawnFromWhatIsGone) {
    press_at({0, 0.7_r, -2.8_r});
    play_.step(play_.turn_to({0, 3.1_r, -2.9_r}));
    const auto drawn = [&] {
        LineList lines;
        play_.game->add_lines(*play_.simulation, 1, lines);
        return lines.vertices.size();
    };
    const std::size_t with_rope = drawn();
    ASSERT_GE(with_rope, 2U);
    destroy(*play_.simulation, play_.simulation->find("crate"));
    EXPECT_LT(drawn(), with_rope);
}

TEST_F(Tied, GoesOnFromASavedGameToTheBit) {
    hang_the_crate();
    const std::vector<Vec3d> points = play_.simulation->points_of(rope());
    press_at(Vec3(points[points.size() / 2]));    // one is cut
    tie({0.5_r, 0, -3}, {0.8_r, 3.1_r, -2.9_r});  // one is tied between what stands still
    destroy(*play_.simulation,
            scene::entity_of(*play_.simulation, play_.simulation->ropes().back().pieces[3]));
    press_at({1, 0, -2});  // one is begun
    Archive written;
    play_.game->serialize(written, *play_.simulation);
    serialize_state(*play_.simulation, written);
    ASSERT_FALSE(written.failed()) << written.fault();

    Playground other(gallows());
    Archive read(written.written());
    other.game->serialize(read, *other.simulation);
    serialize_state(*other.simulation, read);
    ASSERT_FALSE(read.failed()) << read.fault();
    EXPECT_EQ(other.simulation->ropes().size(), 2U);
    for (int i = 0; i < 30; ++i) {
        ASSERT_EQ(other.simulation->state_hash(), play_.simulation->state_hash()) << i;
        play_.step();
        other.step();
    }
    play_.step(press({Action::UndoDrop}));
    other.step(press({Action::UndoDrop}));
    EXPECT_EQ(other.thing_count(), play_.thing_count());
    EXPECT_EQ(other.thing_count(), play_.simulation->ropes().front().pieces.size());
    play_.step(press({Action::Tie}));
    other.step(press({Action::Tie}));
    EXPECT_EQ(other.messages().back(), play_.messages().back());
}

// Its line passes through a wall, half of its pieces are deep inside: it may stay there or come out, but flings nothing.
TEST(TiedRope, ThroughAWallDoesNotBlowUp) {
    scene::SceneDescription scene = meadow();
    scene.entities.push_back(block("wall", {3, 3, 2}, {0, 1.5_r, -5}));
    scene.entities.push_back(
        block("crate", {0.4_r, 0.4_r, 0.4_r}, {0, 0.2_r, -3}, physics::BodyKind::Dynamic, 8));
    Playground play(scene);
    const Result<Done> tied = play.simulation->tie_rope(
        {.names = {"crate", "world"}, .anchors_world_m = {Vec3{0, 0.4_r, -3}, Vec3{0, 1.5_r, -7}}});
    ASSERT_TRUE(tied) << tied.error().message;
    Real fastest_mps = 0;
    for (int i = 0; i < 300; ++i) {
        play.step();
        for (const scene::MovingBody& moving : play.simulation->moving_bodies())
            fastest_mps = std::max(
                fastest_mps, glm::length(play.simulation->physics.state(moving.body).velocity_mps));
    }
    EXPECT_LT(fastest_mps, 10);
    EXPECT_LT(glm::distance(play.state("crate").world_from_body.position, Vec3{0, 0.2_r, -3}), 2);
    EXPECT_TRUE(play.simulation->physics.report().isolated.empty());
}

}  // namespace
}  // namespace plumbline::game
