#include "engine/core/text/csv.h"

#include <gtest/gtest.h>

namespace plumbline {
namespace {

TEST(Csv, OnlyWhatNeedsQuotesHasThem) {
    EXPECT_EQ(csv_field("crate"), "crate");
    EXPECT_EQ(csv_field(""), "");
    EXPECT_EQ(csv_field("a,b"), "\"a,b\"");
    EXPECT_EQ(csv_field("the \"old\" one"), "\"the \"\"old\"\" one\"");
    EXPECT_EQ(csv_field("two\nlines"), "\"two\nlines\"");
}

}  // namespace
}  // namespace plumbline
