// What a saved game keeps of dropped things and of parts.
#include "engine/scene/simulation/saved_thing.h"

#include "engine/scene/build/fragments.h"
#include "tests/support/scene_in_code.h"

namespace plumbline::scene {
namespace {

EntityDescription fragile_cube() {
    EntityDescription cube = test::cube("cube", {0, 5, 0});
    cube.body->fracture = FractureDescription{.pieces = 8};
    return cube;
}

TEST(SavedThing, OfAThingIsItsDescriptionAndItsName) {
    test::Running run(test::scene_of({}));
    const ecs::Entity entity = run->spawn(fragile_cube());
    const SavedThing saved = saved_thing(*run, entity);
    EXPECT_EQ(saved.description, "cube");
    EXPECT_EQ(saved.name, "cube#1");
    EXPECT_FALSE(saved.is_dropped);
    EXPECT_TRUE(saved.pieces.empty()) << "it is whole";
    ASSERT_EQ(saved.made.size(), 1U);
    EXPECT_EQ(saved.made[0].entity, entity);
    EXPECT_EQ(saved.made[0].body, run.body("cube#1"));
}

TEST(SavedThing, OfAPartIsItsWholeAndItsPieces) {
    test::Running run(test::scene_of({fragile_cube()}));
    const std::vector<std::vector<std::uint32_t>> parts{{0, 2, 4, 6}, {1, 3, 5, 7}};
    run->break_up(run->find("cube"), parts, {});
    run->destroy_marked();
    const SavedThing saved = saved_thing(*run, run->find("cube/1"));
    EXPECT_EQ(saved.whole, "cube");
    EXPECT_EQ(saved.pieces, parts[1]);
}

TEST(SavedThing, PlacesAreReservedOnce) {
    test::Running run(test::scene_of({fragile_cube()}));
    const Made there{.entity = run->find("cube"), .body = run.body("cube")};
    EXPECT_FALSE(reserve(*run, {there})) << "somebody has it";
}

}  // namespace
}  // namespace plumbline::scene
