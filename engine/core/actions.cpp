#include "engine/core/actions.h"

#include "engine/core/assert.h"

namespace plumbline {
namespace {

struct ActionRow {
    std::string_view name;
    ActionGroup group;
    std::string_view words;
};
#define PL_ROW(action, name, group, words) ActionRow{name, ActionGroup::group, words},
constexpr std::array<ActionRow, kActionCount> kRows{PL_ACTIONS(PL_ROW)};
#undef PL_ROW

struct GroupRow {
    std::string_view name;
    std::string_view words;
};
constexpr std::array<GroupRow, 7> kGroups{{{"walk", "Movement"},
                                           {"things", "Objects"},
                                           {"view", "View"},
                                           {"light", "Light"},
                                           {"camera_path", "Camera path"},
                                           {"time", "Simulation"},
                                           {"menu", "Menu"}}};

const ActionRow& row_of(Action action) {
    PL_ASSERT(action < Action::Count, "an action");
    return kRows[index_of(action)];
}

}  // namespace

std::string_view action_name(Action action) {
    return row_of(action).name;
}

std::optional<Action> action_from_name(std::string_view name) {
    for (std::size_t i = 0; i < kRows.size(); ++i) {
        if (kRows[i].name == name) return static_cast<Action>(i);
    }
    return std::nullopt;
}

ActionGroup group_of(Action action) {
    return row_of(action).group;
}

std::string_view action_words(Action action) {
    return row_of(action).words;
}

std::string_view group_name(ActionGroup group) {
    return kGroups[static_cast<std::size_t>(group)].name;
}

std::string_view group_words(ActionGroup group) {
    return kGroups[static_cast<std::size_t>(group)].words;
}

}  // namespace plumbline
