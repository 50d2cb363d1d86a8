#include "engine/core/actions.h"

#include <gtest/gtest.h>

#include <set>

namespace plumbline {
namespace {

TEST(Actions, EveryNameLeadsBackToItsAction) {
    std::set<std::string_view> names;
    for (std::size_t i = 0; i < kActionCount; ++i) {
        const auto action = static_cast<Action>(i);
        EXPECT_EQ(action_from_name(action_name(action)), action);
        EXPECT_TRUE(names.insert(action_name(action)).second) << action_name(action);
    }
    EXPECT_EQ(names.size(), kActionCount);
}

TEST(Actions, NamesThatAreNotThereAreNone) {
    EXPECT_EQ(action_from_name(""), std::nullopt);
    EXPECT_EQ(action_from_name("Jump"), std::nullopt);
    EXPECT_EQ(action_from_name("jump "), std::nullopt);
}

// The table's rows are in the order of the enumeration: a row too many or too few would show here.
TEST(Actions, GroupsBeginAndEndWhereTheContractSays) {
    EXPECT_EQ(action_name(Action::Forward), "forward");
    EXPECT_EQ(group_of(Action::MoveMode), ActionGroup::Walk);
    EXPECT_EQ(action_name(Action::Select9), "select_9");
    EXPECT_EQ(group_of(Action::Select1), ActionGroup::Things);
    EXPECT_EQ(action_name(Action::UndoDrop), "undo_drop");
    EXPECT_EQ(group_of(Action::UndoDrop), ActionGroup::Things);
    EXPECT_EQ(group_of(Action::Flashlight), ActionGroup::View);
    EXPECT_EQ(group_of(Action::RotateRight), ActionGroup::View);
    EXPECT_EQ(group_of(Action::AimSpot), ActionGroup::Light);
    EXPECT_EQ(group_of(Action::CameraReload), ActionGroup::CameraPath);
    EXPECT_EQ(group_of(Action::Pause), ActionGroup::Time);
    EXPECT_EQ(action_name(Action::BackOut), "back_out");
    EXPECT_EQ(group_of(Action::BackOut), ActionGroup::Menu);
    EXPECT_EQ(group_name(ActionGroup::CameraPath), "camera_path");
}

}  // namespace
}  // namespace plumbline
