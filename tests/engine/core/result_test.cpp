#include "engine/core/result.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>

namespace plumbline {
namespace {

Result<int> half(int number) {
    if (number % 2 != 0) return Error{.message = "odd", .exit_code = ExitCode::Refused};
    return number / 2;
}

TEST(Result, HoldsAValueOrTheReason) {
    const Result<int> good = half(8);
    ASSERT_TRUE(good);
    EXPECT_EQ(*good, 4);
    const Result<int> bad = half(7);
    ASSERT_FALSE(bad);
    EXPECT_EQ(bad.error().message, "odd");
    EXPECT_EQ(static_cast<int>(bad.error().exit_code), 4);
}

TEST(Result, ErrorsFailTheRunUnlessToldOtherwise) {
    EXPECT_EQ(Error{.message = "x"}.exit_code, ExitCode::RunFailed);
}

TEST(Result, CarriesWhatCanOnlyBeMoved) {
    Result<std::unique_ptr<std::string>> result(std::make_unique<std::string>("inside"));
    EXPECT_EQ(**result, "inside");
    const std::unique_ptr<std::string> taken = std::move(*result);
    EXPECT_EQ(*taken, "inside");
}

TEST(ResultDeathTest, MustBeCheckedBeforeUse) {
    const Result<int> bad = half(7);
    EXPECT_DEATH(static_cast<void>(*bad), "a result that holds a value");
    const Result<int> good = half(8);
    EXPECT_DEATH(static_cast<void>(good.error()), "a result that holds an error");
}

// Scripts and CI read these.
TEST(ExitCode, IsTheContract) {
    EXPECT_EQ(static_cast<int>(ExitCode::Good), 0);
    EXPECT_EQ(static_cast<int>(ExitCode::RunFailed), 1);
    EXPECT_EQ(static_cast<int>(ExitCode::BadUsage), 2);
    EXPECT_EQ(static_cast<int>(ExitCode::NoDisplay), 3);
    EXPECT_EQ(static_cast<int>(ExitCode::Refused), 4);
    EXPECT_EQ(static_cast<int>(ExitCode::Differs), 5);
    EXPECT_EQ(static_cast<int>(ExitCode::Interrupted), 130);
}

}  // namespace
}  // namespace plumbline
