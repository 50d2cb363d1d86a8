// A line a body, each as long as the first line says.
#include "engine/scene/simulation/trace_csv.h"

#include "tests/support/scene_in_code.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace plumbline::scene {
namespace {

TEST(TraceCsv, HasALineForEachBodyThatMayMove) {
    SceneDescription description =
        test::scene_of({test::ground(), test::cube("a \"cube\", red", {0, 2, 0})});
    description.entities.back().body->velocity_mps = {1, 2, 3};
    test::Running run(description);
    const std::string head = trace_csv_head();
    const std::string lines = trace_csv_lines(*run);
    EXPECT_EQ(std::ranges::count(lines, '\n'), 1);
    EXPECT_TRUE(lines.starts_with("0,\"a \"\"cube\"\", red\",")) << lines;
    EXPECT_NE(lines.find(",1,2,3,0,0,0,"), std::string::npos) << lines;
    // One comma more: that of the name.
    EXPECT_EQ(std::ranges::count(lines, ','), std::ranges::count(head, ',') + 1);
}

}  // namespace
}  // namespace plumbline::scene
