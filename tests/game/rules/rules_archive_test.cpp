// The playground put back from its fields: what is in the hand, in the air, on the floor and in mind.
#include "engine/physics/totals.h"
#include "engine/scene/simulation/simulation_archive.h"
#include "tests/game/rules/playground.h"

namespace plumbline::game {
namespace {

std::string saved(Playground& world) {
    Archive archive;
    world.game->serialize(archive, *world.simulation);
    serialize_state(*world.simulation, archive);
    EXPECT_FALSE(archive.failed()) << archive.fault();
    return archive.take();
}

void put_back(const std::string& bytes, Playground& world) {
    Archive archive(bytes);
    world.game->serialize(archive, *world.simulation);
    serialize_state(*world.simulation, archive);
    EXPECT_FALSE(archive.failed()) << archive.fault();
    EXPECT_EQ(archive.left(), 0U);
}

/// Crates beside the person, one of which may be destroyed.
scene::SceneDescription crates() {
    scene::SceneDescription scene = meadow();
    for (int i = 0; i < 4; ++i)
        scene.entities.push_back(block("crate" + std::to_string(i),
                                       {0.5_r, 0.5_r, 0.5_r},
                                       {static_cast<Real>(i) - 1.5_r, 0.25_r, -4},
                                       physics::BodyKind::Dynamic,
                                       8));
    return scene;
}

class SavedPlayground : public testing::Test {
protected:
    void go_on_from_here() {
        put_back(saved(there_), here_);
        EXPECT_EQ(saved(here_), saved(there_));
        EXPECT_EQ(here_.simulation->state_hash(), there_.simulation->state_hash());
        EXPECT_EQ(here_.feet(), there_.feet());
        EXPECT_EQ(here_.game->holds(), there_.game->holds());
    }
    void both(double seconds, const Actions& actions = {}) {
        there_.run(seconds, actions);
        here_.run(seconds, actions);
        same();
    }
    void both_once(const Actions& actions) {
        there_.step(actions);
        here_.step(actions);
        same();
    }
    void same() {
        ASSERT_EQ(here_.simulation->state_hash(), there_.simulation->state_hash());
        ASSERT_EQ(here_.feet(), there_.feet());
        ASSERT_EQ(here_.thing_count(), there_.thing_count());
        ASSERT_EQ(here_.game->holds(), there_.game->holds());
    }

    Playground there_{crates()};
    Playground here_{crates()};
};

TEST_F(SavedPlayground, AThingInTheHandIsStillThereAndIsThrownAsFar) {
    there_.step(press({Action::Drop}));
    there_.step(press({Action::Grab}));
    there_.run(0.4, hold({Action::Grab, Action::Forward}));
    ASSERT_TRUE(there_.game->holds());
    go_on_from_here();
    both(0.5, hold({Action::Grab, Action::Left}));
    both_once(press({Action::Throw, Action::Grab}));
    both(0.4, hold({Action::Throw, Action::Grab}));
    both(1.5);
    EXPECT_FALSE(there_.game->holds());
}

TEST_F(SavedPlayground, InTheMiddleOfAThrow) {
    there_.step(press({Action::Throw}));
    there_.run(0.3, hold({Action::Throw}));
    go_on_from_here();
    both(0.3, hold({Action::Throw}));
    both(1);
    EXPECT_EQ(there_.thing_count(), 1U);
}

TEST_F(SavedPlayground, WhatIsGoneStaysGoneAndNewThingsGetTheSameNumbers) {
    for (int i = 0; i < 3; ++i) {
        there_.step(press({Action::Drop}));
        there_.run(0.3, hold({Action::Back}));
    }
    destroy(*there_.simulation, there_.simulation->find("crate1"));
    there_.step(press({Action::UndoDrop}));
    there_.step(press({Action::Select2}));
    there_.step(press({Action::Drop}));
    there_.run(0.3);
    go_on_from_here();
    EXPECT_FALSE(here_.simulation->find("crate1"));
    EXPECT_TRUE(here_.simulation->find("ball#1"));
    both_once(press({Action::Drop}));
    both_once(press({Action::UndoDrop}));
    both_once(press({Action::UndoDrop}));
    both_once(press({Action::Drop}));
    both(1, hold({Action::Forward}));
    EXPECT_EQ(here_.simulation->find("ball#3"), there_.simulation->find("ball#3"));
}

TEST_F(SavedPlayground, APersonWhoCrouchesOnAFrozenThing) {
    there_.step(press({Action::Drop}));
    there_.step(press({Action::Freeze}));
    there_.run(0.5, hold({Action::Crouch, Action::Right}));
    there_.step(press({Action::Drop}));
    go_on_from_here();
    both(0.5, hold({Action::Crouch, Action::Left}));
    both(0.5, hold({Action::Forward, Action::Sprint}));
    both_once(press({Action::Jump}));
    both(1, hold({Action::Forward}));
}

TEST_F(SavedPlayground, WhoCrouchesStillDoes) {
    EXPECT_FALSE(there_.game->crouches());
    there_.run(0.5, hold({Action::Crouch}));
    EXPECT_TRUE(there_.game->crouches());
    go_on_from_here();
    EXPECT_TRUE(here_.game->crouches());
    both(0.5, hold({Action::Crouch, Action::Left}));
    both(0.5);
    EXPECT_FALSE(here_.game->crouches());
}

/// Room to stand at the origin, and behind it 1.4 m of room, from 1 m on.
scene::SceneDescription low_ceiling() {
    scene::SceneDescription scene = meadow();
    scene.entities.push_back(block("ceiling", {4, 0.2_r, 5}, {0, 1.5_r, 3.5_r}));
    return scene;
}

TEST(SavedCrouch, ForcedByALowCeilingIsNotWanted) {
    Playground there(low_ceiling());
    there.run(2.2, hold({Action::Crouch, Action::Back}));
    ASSERT_NEAR(there.feet().z, 2.2 * 0.9, 0.1);
    there.run(0.5);
    ASSERT_TRUE(there.game->player()->state().crouched);
    ASSERT_FALSE(there.game->crouches());
    Playground here(low_ceiling());
    put_back(saved(there), here);
    EXPECT_TRUE(here.game->player()->state().crouched);
    EXPECT_FALSE(here.game->crouches()) << "a toggled crouch would go on";
    here.run(2.5, hold({Action::Forward}));
    EXPECT_LT(here.feet().z, 0.5);
    EXPECT_FALSE(here.game->player()->state().crouched);
}

TEST_F(SavedPlayground, WhileEverythingSleeps) {
    there_.run(4);
    ASSERT_EQ(awake_count(there_.simulation->physics), 0U);
    go_on_from_here();
    both(0.5);
    there_.simulation->physics.wake(there_.body("crate2"));
    here_.simulation->physics.wake(here_.body("crate2"));
    both(2, hold({Action::Forward, Action::Sprint}));
}

TEST_F(SavedPlayground, EveryCameraAndSwitch) {
    there_.step(press({Action::MoveMode}));
    there_.run(0.5, hold({Action::Forward, Action::Jump}));
    there_.step(press({Action::MoveMode, Action::Fog, Action::LightBrighter}));
    there_.run(0.2, hold({Action::RotateLeft}));
    go_on_from_here();
    EXPECT_EQ(here_.simulation->switches.light_scale, there_.simulation->switches.light_scale);
    EXPECT_TRUE(here_.simulation->switches.is_on("fog", false));
    both(0.3, hold({Action::RotateLeft, Action::ZoomIn}));
    const auto eye = [](const Playground& world) {
        return world.game->view(*world.simulation, 1, 0, 0).world_from_camera.position;
    };
    EXPECT_EQ(eye(here_), eye(there_));
}

TEST_F(SavedPlayground, CutAnywhereItIsRefused) {
    there_.step(press({Action::Drop}));
    const std::string bytes = saved(there_);
    for (std::size_t size = 0; size < bytes.size(); size += 97) {
        Playground fresh(crates());
        Archive archive(std::string_view(bytes).substr(0, size));
        fresh.game->serialize(archive, *fresh.simulation);
        serialize_state(*fresh.simulation, archive);
        EXPECT_TRUE(archive.failed()) << size;
    }
}

// Its whole is in no scene file and gone: it is made once more for its pieces.
TEST(SavedParts, OfWhatWasDroppedAndBrokeAreThereAgain) {
    scene::SceneDescription scene = meadow();
    scene::EntityDescription crate =
        block("crate", {0.4_r, 0.4_r, 0.4_r}, {0, 0, 0}, physics::BodyKind::Dynamic, 5);
    crate.body->fracture = scene::FractureDescription{.pieces = 6};
    scene.prefabs.emplace("crate", crate);
    Playground there(scene);
    Playground here(scene);
    there.step(press({Action::Drop}));
    there.run(1);
    const std::vector<std::vector<std::uint32_t>> parts{{0, 1}, {2, 3, 4}, {5}};
    there.simulation->break_up(there.simulation->find("crate#1"), parts, {2, 3});
    there.run(0.2);
    put_back(saved(there), here);
    EXPECT_EQ(saved(here), saved(there));
    EXPECT_EQ(here.thing_count(), 3U);
    const ecs::Entity part = here.simulation->find("crate#1/1");
    ASSERT_TRUE(part);
    EXPECT_EQ(here.simulation->registry.get<scene::Fragile>(part).pieces, parts[1]);
    EXPECT_EQ(here.simulation->registry.get<scene::Fragile>(part).cracked,
              (std::vector<std::uint32_t>{2, 3}));
    there.run(1);
    here.run(1);
    EXPECT_EQ(here.simulation->state_hash(), there.simulation->state_hash());
    here.step(press({Action::UndoDrop}));
    EXPECT_EQ(here.thing_count(), 0U);
}

}  // namespace
}  // namespace plumbline::game
