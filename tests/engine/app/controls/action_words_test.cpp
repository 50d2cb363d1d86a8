// What actions are called where people read.
#include "engine/app/controls/action_words.h"

#include <gtest/gtest.h>

#include <set>

namespace plumbline::app {
namespace {

TEST(ActionWords, EveryActionHasItsOwn) {
    std::set<std::string_view> words;
    for (std::size_t i = 0; i < kActionCount; ++i) {
        const auto action = static_cast<Action>(i);
        EXPECT_FALSE(action_words(action).empty()) << action_name(action);
        EXPECT_TRUE(words.insert(action_words(action)).second) << action_words(action);
    }
    EXPECT_EQ(action_words(Action::Drop), "Drop the selected object");
}

TEST(ActionWords, EveryGroupHasItsOwn) {
    std::set<std::string_view> words;
    for (std::size_t i = 0; i < kActionCount; ++i)
        words.insert(group_words(group_of(static_cast<Action>(i))));
    EXPECT_EQ(words,
              (std::set<std::string_view>{
                  "Movement", "Objects", "View", "Light", "Camera path", "Simulation", "Menu"}));
}

TEST(ActionWords, WhatAModelByItselfTakesIsNoPlayAndTheOtherWayRound) {
    for (std::size_t i = 0; i < kActionCount; ++i) {
        const auto action = static_cast<Action>(i);
        const bool of_models = action_words(action).starts_with("Model viewer:");
        EXPECT_EQ(is_for_play(action), !of_models) << action_name(action);
        EXPECT_TRUE(!of_models || is_for_models(action)) << action_name(action);
        EXPECT_TRUE(group_of(action) != ActionGroup::Things || !is_for_models(action))
            << action_name(action);
    }
    EXPECT_FALSE(is_for_models(Action::Jump));
    EXPECT_TRUE(is_for_models(Action::Forward)) << "nearer";
    EXPECT_FALSE(is_offered(Action::Select8));
    EXPECT_TRUE(is_offered(Action::Select7));
}

}  // namespace
}  // namespace plumbline::app
