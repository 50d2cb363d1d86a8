// The table in the program, and the shipped file that says the same.
#include "tests/engine/input/loaded.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace plumbline::input {
namespace {

TEST(BuiltInBindings, EveryActionOfTheBuiltInTableIsBound) {
    const Bindings bindings = built_in_bindings();
    for (std::size_t i = 0; i < kActionCount; ++i) {
        // Throwing and turning what is held do these two until a profile gives them keys.
        const auto action = static_cast<Action>(i);
        if (action == Action::TurnModel || action == Action::ShiftModel) continue;
        EXPECT_FALSE(bindings.inputs[i].empty()) << action_name(action);
    }
    EXPECT_EQ(joined_words(bindings, Action::Forward), "w up pad.left_y-");
    EXPECT_EQ(joined_words(bindings, Action::Drop), "q pad.right_bumper");
    EXPECT_EQ(joined_words(bindings, Action::Throw), "mouse.left pad.right_trigger");
    EXPECT_EQ(joined_words(bindings, Action::Grab), "e mouse.right pad.x");
}

TEST(BuiltInBindings, TheBuiltInTableHasNoInputTwiceInADomain) {
    const Bindings bindings = built_in_bindings();
    for (std::size_t a = 0; a < kActionCount; ++a) {
        for (std::size_t b = a + 1; b < kActionCount; ++b) {
            const bool is_menu_a = group_of(static_cast<Action>(a)) == ActionGroup::Menu;
            const bool is_menu_b = group_of(static_cast<Action>(b)) == ActionGroup::Menu;
            if (is_menu_a != is_menu_b) continue;
            for (const Input& input : bindings.inputs[a])
                EXPECT_EQ(std::ranges::count(bindings.inputs[b], input), 0) << input.word;
        }
    }
}

TEST(BuiltInBindings, TheShippedFileSaysWhatTheBuiltInTableSays) {
    Diagnostics faults;
    const BindingSources sources =
        find_binding_sources(std::filesystem::path{PL_SOURCE_DIR} / "config", {}, {}, faults);
    const Bindings shipped = load_bindings(sources.layers, {}, faults);
    const Bindings built_in = built_in_bindings();
    EXPECT_TRUE(faults.list().empty());
    for (std::size_t i = 0; i < kActionCount; ++i) {
        EXPECT_EQ(shipped.inputs[i], built_in.inputs[i]) << action_name(static_cast<Action>(i));
        EXPECT_EQ(shipped.hold_mode[i], built_in.hold_mode[i]);
        EXPECT_TRUE(shipped.origin[i].starts_with("config/bindings.toml:"));
    }
    EXPECT_EQ(shipped.tuning.mouse_deg_per_count, built_in.tuning.mouse_deg_per_count);
    EXPECT_EQ(shipped.tuning.pad_look_deg_per_s, built_in.tuning.pad_look_deg_per_s);
    EXPECT_EQ(shipped.tuning.free_pointer, built_in.tuning.free_pointer);
    EXPECT_EQ(shipped.tuning.pad_inner_dead_zone, built_in.tuning.pad_inner_dead_zone);
}

}  // namespace
}  // namespace plumbline::input
