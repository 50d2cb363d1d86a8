// How deep a JSON text nests, before anybody parses it.
#include "engine/core/text/json_depth.h"

#include <gtest/gtest.h>

#include <string>

namespace plumbline {
namespace {

TEST(JsonDepth, CountsWhatLiesWithinOneAnother) {
    EXPECT_EQ(json_depth(""), 0U);
    EXPECT_EQ(json_depth("1"), 0U);
    EXPECT_EQ(json_depth("[]"), 1U);
    EXPECT_EQ(json_depth(R"({"a": [1, {"b": 2}], "c": []})"), 3U);
    EXPECT_EQ(json_depth(std::string(1'000'000, '[')), 1'000'000U);
}

TEST(JsonDepth, BracketsInTextsAndSideBySideAreNoDepth) {
    EXPECT_EQ(json_depth(R"(["[[[", "\"[[", "\\"])"), 1U);
    EXPECT_EQ(json_depth("[[],[],[],[]]"), 2U);
    EXPECT_EQ(json_depth("]]][["), 2U) << "for the parser to refuse";
}

}  // namespace
}  // namespace plumbline
