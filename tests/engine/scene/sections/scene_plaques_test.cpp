// Plaques as the file says them; what is wrong with one is named.
#include "tests/engine/scene/sections/scene_file_fixture.h"

namespace plumbline::scene {
namespace {

constexpr std::string_view kBob = R"([[entity]]
name = "bob"
primitive = { sphere = 0.1 }
body = {}
[[entity]]
name = "plate"
primitive = { box = [1, 1, 1] }
[entity.plaque]
)";

TEST_F(SceneFileTest, APlaqueIsRead) {
    const Outcome outcome = load(fmt::format("{}{}", kBob, R"(title = "Pendulum"
formula = "T = 2 pi (L / g)^0.5"
of = "bob"
quantity = "period_s"
axis = "z"
expected = 2.006
effect = "drag"
)"));
    ASSERT_TRUE(outcome.scene.ok()) << outcome.scene.error().message;
    EXPECT_TRUE(outcome.faults.empty());
    const PlaqueDescription& plaque = *outcome.scene->entities[1].plaque;
    EXPECT_EQ(plaque.title, "Pendulum");
    EXPECT_EQ(plaque.formula, "T = 2 pi (L / g)^0.5");
    EXPECT_EQ(plaque.of, "bob");
    EXPECT_EQ(plaque.quantity, PlaqueQuantity::Period);
    EXPECT_EQ(plaque.axis, 2);
    EXPECT_NEAR(plaque.expected, 2.006, 1e-6);
    EXPECT_EQ(plaque.effect, "drag");
}

TEST_F(SceneFileTest, WhatAPlaqueLacksOrGetsWrongIsNamed) {
    const auto fails = [this](std::string_view lines, const std::string& words) {
        const Outcome outcome = load(fmt::format("{}{}", kBob, lines));
        EXPECT_FALSE(outcome.scene.ok()) << lines;
        EXPECT_TRUE(std::ranges::any_of(
            outcome.faults,
            [&words](const std::string& fault) { return fault.find(words) != std::string::npos; }))
            << lines << fmt::format("{}", fmt::join(outcome.faults, "; "));
    };
    fails("quantity = \"height_m\"\nexpected = 1\n", "the entity that is measured");
    fails("of = \"bob\"\nexpected = 1\n", "what is measured");
    fails("of = \"bob\"\nquantity = \"height_m\"\n", "what the formula gives");
    fails("of = \"bob\"\nquantity = \"distance_m\"\nexpected = 1\n", "measured from");
    fails("of = \"bib\"\nquantity = \"height_m\"\nexpected = 1\n", "no entity is called \"bib\"");
    fails("of = \"bob\"\nquantity = \"height\"\nexpected = 1\n", "height_m");
    fails("of = \"bob\"\nquantity = \"height_m\"\nexpected = 1\neffect = \"drug\"\n",
          "no effect with a fidelity is called \"drug\"");
}

}  // namespace
}  // namespace plumbline::scene
