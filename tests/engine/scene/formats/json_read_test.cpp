#include "engine/scene/formats/json_read.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <string>

namespace plumbline::scene {
namespace {

std::string nested(std::size_t levels) {
    return std::string(levels, '[') + std::string(levels, ']');
}

TEST(ReadJson, TakesTheDepthThatIsAllowedAndNoMore) {
    EXPECT_NO_THROW(read_json<nlohmann::json>(nested(kJsonDepth)));
    EXPECT_THROW(read_json<nlohmann::json>(nested(kJsonDepth + 1)), std::exception);
    EXPECT_THROW(read_json<nlohmann::json>(nested(1'000'000)), std::exception);
    EXPECT_THROW(read_json<nlohmann::json>(std::string(1'000'000, '[')), std::exception);
    EXPECT_THROW(read_json<nlohmann::json>(std::string(1'000'000, '{')), std::exception);
}

TEST(ReadJson, BracketsInTextsAreNoDepth) {
    const std::string text = "{\"a\": \"\\\"" + std::string(100, '[') + "\"}";
    EXPECT_EQ(read_json<nlohmann::json>(text).at("a").get<std::string>().size(), 101U);
}

TEST(ReadJson, ManySideBySideAreNoDepth) {
    std::string text = "[";
    for (int i = 0; i < 1000; ++i) text += "[],";
    EXPECT_EQ(read_json<nlohmann::json>(text + "[]]").size(), 1001U);
}

}  // namespace
}  // namespace plumbline::scene
