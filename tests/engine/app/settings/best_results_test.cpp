// Best times outlive the program, and nothing that is there is lost.
#include "engine/app/settings/best_results.h"

#include "engine/core/io/files.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

namespace plumbline::app {
namespace {

class BestResultsTest : public testing::Test {
protected:
    std::filesystem::path file() const { return folder_.path() / "best_results"; }

private:
    test::TemporaryFolder folder_;
};

TEST_F(BestResultsTest, TheShortestTimeIsKept) {
    {
        BestResults results(file());
        EXPECT_FALSE(results.of("cans"));
        results.note("cans", 40.25);
        results.note("cans", 52);
        results.note("tower", 61.5);
        EXPECT_EQ(results.of("cans"), 40.25);
    }
    BestResults again(file());
    EXPECT_EQ(again.of("cans"), 40.25);
    EXPECT_EQ(again.of("tower"), 61.5);
    again.note("cans", 31);
    EXPECT_EQ(BestResults(file()).of("cans"), 31.0);
}

TEST_F(BestResultsTest, WhatIsNotReadableIsLeftAsItIs) {
    for (const char* text : {"cans", "cans fast\n", "cans nan\n", "cans -3\n", "\x01\x02\n"}) {
        ASSERT_TRUE(write_file_atomically(file(), text).ok());
        BestResults results(file());
        results.note("tower", 20);
        EXPECT_EQ(results.of("tower"), 20.0) << "for as long as the program runs";
        EXPECT_EQ(*read_file(file(), 1000), text);
    }
}

TEST_F(BestResultsTest, WithoutAPlaceNothingIsKept) {
    BestResults results({});
    results.note("cans", 40);
    EXPECT_EQ(results.of("cans"), 40.0);
    results.note("two words", 3);
    results.note("", 3);
    EXPECT_FALSE(results.of("two words"));
}

}  // namespace
}  // namespace plumbline::app
