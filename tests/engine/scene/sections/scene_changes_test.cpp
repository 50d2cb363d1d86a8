// [[change]]: read and checked.
#include "tests/engine/scene/sections/scene_file_fixture.h"

namespace plumbline::scene {
namespace {

constexpr const char* kTwo =
    "[[entity]]\nname = \"ball\"\nprimitive = { sphere = 1 }\nbody = {}\n"
    "[[entity]]\nname = \"lamp\"\nprimitive = { sphere = 1 }\n"
    "[[array]]\nname = \"row\"\nprefab = \"box\"\ncount = [2, 1, 1]\n"
    "[[prefab]]\nname = \"box\"\nprimitive = { box = [1, 1, 1] }\nbody = {}\nrotation_deg = [0, "
    "90, 0]\n";

TEST_F(SceneFileTest, ChangesOfEntitiesAndCopies) {
    const SceneDescription scene =
        good(std::string(kTwo) +
             "[[change]]\nof = \"ball\"\ngone = true\n"
             "[[change]]\nof = \"row.1.0.0\"\nposition_m = [1, 2, 3]\nfrozen = true\n");
    ASSERT_EQ(scene.changes.size(), 2U);
    EXPECT_TRUE(scene.changes[0].gone);
    EXPECT_FALSE(scene.changes[0].world_from_body);
    EXPECT_FALSE(scene.changes[0].frozen);
    EXPECT_EQ(scene.changes[1].world_from_body->position, Vec3(1, 2, 3));
    EXPECT_NEAR(static_cast<double>(scene.changes[1].world_from_body->orientation.y), 0.7071, 1e-3)
        << "turned as it is described";
    EXPECT_EQ(scene.changes[1].frozen, true);
}

TEST_F(SceneFileTest, ChangesOfNothingAreErrors) {
    const auto said = [this](const char* change) {
        const Outcome outcome = load(std::string(kTwo) + change);
        EXPECT_FALSE(outcome.scene.ok()) << change;
        return outcome.faults.empty() ? std::string{} : outcome.faults.front();
    };
    EXPECT_NE(said("[[change]]\nof = \"bal\"\n").find("no entity is called \"bal\""),
              std::string::npos);
    EXPECT_NE(said("[[change]]\nof = \"lamp\"\n").find("body"), std::string::npos);
    EXPECT_NE(said("[[change]]\ngone = true\n").find("expected the name of an entity with a body"),
              std::string::npos);
    EXPECT_NE(said("[[change]]\nof = \"ball\"\nrotation_deg = [0, 9, 0]\n")
                  .find("missing; expected where it is turned so"),
              std::string::npos);
}

}  // namespace
}  // namespace plumbline::scene
