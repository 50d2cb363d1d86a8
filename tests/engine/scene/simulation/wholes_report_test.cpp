// What a state file says of ropes and of what broke; of the others their own tests do.
#include "engine/scene/simulation/wholes_report.h"

#include "engine/scene/build/fragments.h"
#include "tests/support/scene_in_code.h"

#include <nlohmann/json.hpp>

namespace plumbline::scene {
namespace {

nlohmann::json wholes_of(const Simulation& simulation) {
    JsonText text(JsonLayout::OneLine);
    text.begin_object();
    add_wholes(text, simulation, {});
    text.end_object();
    return nlohmann::json::parse(text.str());
}

TEST(WholesReport, HasAListOfEachKind) {
    test::Running run(test::scene_of({}));
    const nlohmann::json wholes = wholes_of(*run);
    for (const char* kind : {"ropes", "vehicles", "cloths", "softs", "waters", "breaks"})
        EXPECT_EQ(wholes[kind], nlohmann::json::array()) << kind;
}

TEST(WholesReport, SaysWhatBrokeWhenAndIntoHowMany) {
    EntityDescription cube = test::cube("cube", {0, 5, 0});
    cube.body->fracture = FractureDescription{.pieces = 8};
    test::Running run(test::scene_of({cube}));
    EXPECT_TRUE(wholes_of(*run)["breaks"].empty());
    run.step(30);
    run->break_up(run->find("cube"),
                  std::vector<std::vector<std::uint32_t>>{{0, 1}, {2, 3, 4}, {5, 6, 7}},
                  {});
    run->destroy_marked();
    const nlohmann::json breaks = wholes_of(*run)["breaks"];
    ASSERT_EQ(breaks.size(), 1U);
    EXPECT_EQ(breaks[0]["name"], "cube");
    EXPECT_NEAR(static_cast<double>(breaks[0]["at_s"]), 0.5, 1e-9);
    EXPECT_EQ(breaks[0]["pieces"], 3);
}

}  // namespace
}  // namespace plumbline::scene
