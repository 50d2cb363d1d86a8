#include "engine/study/machine.h"

#include "engine/study/workers/worker_pool.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>
#include <string_view>

namespace plumbline::study {
namespace {

TEST(Machine, IsNamedWithItsCores) {
    const std::string text = machine_text();
    EXPECT_TRUE(text.ends_with(fmt::format(", {} cores", default_workers()))) << text;
    EXPECT_GT(text.size(), std::string_view(", 1 cores").size());
    const std::string build = build_text();
    EXPECT_TRUE(build.starts_with("g++ ") || build.starts_with("clang ")) << build;
    EXPECT_TRUE(build.ends_with("optimised")) << build;
    const std::string today = today_text();
    ASSERT_EQ(today.size(), 10U);
    EXPECT_EQ(today[4], '-');
    EXPECT_EQ(today[7], '-');
}

}  // namespace
}  // namespace plumbline::study
