#include "engine/scene/level/shipped_things.h"

#include <gtest/gtest.h>

namespace plumbline::scene {
namespace {

TEST(ShippedThings, AreThoseOfTheNumberKeys) {
    const SceneDescription things = shipped_things(std::filesystem::path(PL_SOURCE_DIR) / "assets");
    for (const char* name : {"crate", "ball", "barrel", "brick", "plank", "stone", "domino"})
        EXPECT_TRUE(things.prefabs.contains(name)) << name;
    EXPECT_TRUE(shipped_things("/nowhere").prefabs.empty());
}

TEST(ShippedThings, MoveWhateverTheirPrefabSays) {
    EntityDescription wall;
    wall.body = BodyDescription{.kind = physics::BodyKind::Static};
    EXPECT_EQ(thing_of(wall, "wall").body->kind, physics::BodyKind::Dynamic);
    EXPECT_EQ(thing_of(wall, "wall").name, "wall");
    EXPECT_TRUE(thing_of({}, "ghost").body) << "though it had none";
}

}  // namespace
}  // namespace plumbline::scene
